// SPDX-License-Identifier: MIT
#include "check/internal/interpret.hpp"
#include "check/internal/kernel_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <thread>

#include "check/interpreted_kernel.hpp"
#include "interpreter/error.hpp"

namespace gloam::check::internal {
namespace {

// The inputs of a run from `begin` to `end` (excluded), run one after another.
class Part {
  public:
    Part(const interpreter::Program& program, const KernelModule& module, std::span<const Word> inputs,
         const std::string& name)
        : program_(program), module_(module), inputs_(inputs), name_(name) {}

    // `outputs`: of all inputs. `images`: the words of the images; stores change them.
    std::optional<ImageFault> run(std::size_t begin, std::size_t end, std::vector<std::vector<Word>>& images,
                                  std::span<Word> outputs) {
        InterpretedKernel<float> kernel(program_, module_, images);
        for (std::size_t i = begin; i < end; ++i) {
            run(kernel, i);
            for (std::size_t w = 0; w < module_.output_words; ++w)
                outputs[i * module_.output_words + w] = kernel.output(w).bits();
            if (!module_.images.empty()) add_fault(kernel.faults(), i, images);
            for (std::size_t image = 0; image < images.size(); ++image)
                if (module_.images[image].stores) kernel.read_image(image, images[image]);
        }
        return fault_;
    }

  private:
    void run(InterpretedKernel<float>& kernel, std::size_t i) const {
        try {
            if (module_.fixed_inputs > 0) {
                kernel.run({}, i);
            } else {
                kernel.run(inputs_.subspan(i * module_.input_words, module_.input_words));
            }
        } catch (const interpreter::Error& error) {
            throw KernelError(fmt::format("{}: input {}: {}", name_, i, error.what()));
        }
    }

    void add_fault(const KernelFaults& faults, std::size_t i, const std::vector<std::vector<Word>>& images) {
        if (faults.count == 0) return;
        if (!fault_) {
            const std::vector<Word>& words = images.at(faults.image);
            fault_ = ImageFault{.image = module_.images.at(faults.image).name,
                                .pixel = {static_cast<int>(faults.x), static_cast<int>(faults.y)},
                                .size = {static_cast<int>(words[0]), static_cast<int>(words[1])},
                                .count = 0,
                                .input = i};
        }
        fault_->count += faults.count;
    }

    const interpreter::Program& program_;
    const KernelModule& module_;
    std::span<const Word> inputs_;
    const std::string& name_;
    std::optional<ImageFault> fault_;
};

interpreter::Program decoded(const KernelModule& module, const std::string& name) {
    try {
        return interpreter::Program(module.spirv, module.constants);
    } catch (const interpreter::Error& error) {
        throw KernelError(fmt::format("{}: {}", name, error.what()));
    }
}

void merge(std::optional<ImageFault>& all, const std::optional<ImageFault>& later) {
    if (!later) return;
    if (all) {
        all->count += later->count;
    } else {
        all = later;
    }
}

}  // namespace

KernelCore::Result interpret(const std::shared_ptr<const KernelModule>& module, std::span<const Word> inputs,
                             std::size_t count, const ImageSet& images, const std::string& name) {
    const interpreter::Program program = decoded(*module, name);
    const std::vector<std::vector<Word>> words = image_words(module->images, images, name);
    const bool stores = std::ranges::any_of(module->images, &ImagePrototype::stores);
    const std::size_t threads = stores ? 1 : std::max(1U, std::thread::hardware_concurrency());
    const std::size_t share = count / threads + 1;
    KernelCore::Result result;
    result.modules = {module};
    result.outputs.resize(count * module->output_words);
    std::vector<std::vector<Word>> after = words;
    const auto part = [&](std::size_t begin, std::vector<std::vector<Word>>& own) {
        return Part(program, *module, inputs, name)
            .run(begin, std::min(begin + share, count), own, result.outputs);
    };
    std::vector<std::future<std::optional<ImageFault>>> parts;
    for (std::size_t begin = share; begin < count; begin += share)
        parts.push_back(std::async(std::launch::async,
                                   [&part, begin, own = words]() mutable { return part(begin, own); }));
    result.fault = part(0, after);
    for (auto& later : parts) merge(result.fault, later.get());
    for (std::size_t i = 0; i < words.size(); ++i) add_stored(module->images[i], after[i], images, result);
    return result;
}

}  // namespace gloam::check::internal
