// SPDX-License-Identifier: MIT
#pragma once

#include "backend/backend.hpp"
#include "support/test.hpp"

namespace gloam::test {

// A device that is right but for what a test changes: before a kernel runs, or in its outputs.
class ChangedDevice : public backend::Backend {
  public:
    using Before = std::function<void(std::vector<std::vector<backend::Word>>& images)>;
    using After = std::function<void(std::span<backend::Word> row)>;  // the outputs of an input

    ChangedDevice(std::shared_ptr<backend::Backend> right, Before before, After after)
        : right_(std::move(right)), before_(std::move(before)), after_(std::move(after)) {}

    [[nodiscard]] const backend::DeviceInfo& info() const override { return right_->info(); }
    [[nodiscard]] std::unique_ptr<backend::Kernel> make_kernel(
        const backend::KernelProgram& program) const override {
        return std::make_unique<Changed>(*this, right_->make_kernel(program), program.output_words);
    }

  private:
    struct Changed : backend::Kernel {
        Changed(const ChangedDevice& of, std::unique_ptr<backend::Kernel> made, std::size_t output_words)
            : device(of), right(std::move(made)), words(output_words) {}
        [[nodiscard]] std::size_t most_inputs() const override { return right->most_inputs(); }
        void run(std::size_t count, backend::Word canary, backend::KernelMemory& memory) const override {
            if (device.before_) {
                std::vector<std::vector<backend::Word>> images = memory.images;
                device.before_(images);
                backend::KernelMemory other{.inputs = memory.inputs,
                                            .outputs = std::move(memory.outputs),
                                            .faults = memory.faults,
                                            .images = images};
                right->run(count, canary, other);
                memory.outputs = std::move(other.outputs);
            } else {
                right->run(count, canary, memory);
            }
            for (std::size_t i = 0; device.after_ && i < count; ++i)
                device.after_(std::span(memory.outputs).subspan(i * (words + 1), words));
        }
        const ChangedDevice& device;
        std::unique_ptr<backend::Kernel> right;
        std::size_t words;
    };

    std::shared_ptr<backend::Backend> right_;
    Before before_;
    After after_;
};

}  // namespace gloam::test
