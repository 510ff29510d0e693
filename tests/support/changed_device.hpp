// SPDX-License-Identifier: MIT
#pragma once

#include "backend/backend.hpp"
#include "support/test.hpp"

namespace gloam::test {

// A device that is right but for what a test changes.
class ChangedDevice : public backend::Backend {
  public:
    struct Changes {
        std::function<void(std::vector<std::vector<backend::Word>>& images)> before = {};  // a kernel runs
        std::function<void(std::span<backend::Word> outputs)> after = {};                  // of an input
        std::function<std::vector<backend::Word>(const std::vector<backend::Word>& module)> compiled = {};
    };
    ChangedDevice(std::shared_ptr<backend::Backend> right, Changes changes)
        : right_(std::move(right)), changes_(std::move(changes)) {}

    [[nodiscard]] const backend::DeviceInfo& info() const override { return right_->info(); }
    [[nodiscard]] std::unique_ptr<backend::Kernel> make_kernel(
        const backend::KernelProgram& program) const override {
        backend::KernelProgram changed = program;
        if (changes_.compiled) changed.spirv = changes_.compiled(program.spirv);
        return std::make_unique<Changed>(changes_, right_->make_kernel(changed), program.output_words);
    }

  private:
    struct Changed : backend::Kernel {
        Changed(const Changes& of, std::unique_ptr<backend::Kernel> made, std::size_t output_words)
            : changes(of), right(std::move(made)), words(output_words) {}
        [[nodiscard]] std::size_t most_inputs() const override { return right->most_inputs(); }
        void run(std::size_t count, backend::Word canary, backend::KernelMemory& memory) const override {
            const auto given = memory.images;
            std::vector<std::vector<backend::Word>> images(given.begin(), given.end());
            if (changes.before) changes.before(images);
            memory.images = images;
            right->run(count, canary, memory);
            memory.images = given;
            for (std::size_t i = 0; changes.after && i < count; ++i)
                changes.after(std::span(memory.outputs).subspan(i * (words + 1), words));
        }
        const Changes& changes;
        std::unique_ptr<backend::Kernel> right;
        std::size_t words;
    };

    std::shared_ptr<backend::Backend> right_;
    Changes changes_;
};

}  // namespace gloam::test
