// SPDX-License-Identifier: MIT
#include "check/lab.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <random>
#include <thread>
#include <utility>

#include "base/threads.hpp"
#include "check/internal/gl_kernel.hpp"
#include "check/internal/kernel_rows.hpp"
#include "check/interpreted_kernel.hpp"
#include "gpu/resources.hpp"
#include "interpreter/program.hpp"

namespace gloam::check::internal {

void add_outputs(const KernelRows& rows, const KernelModule& module, const std::string& name,
                 KernelCore::Result& result) {
    for (std::size_t i = 0; i < rows.count; ++i) {
        const auto values = rows.words.subspan(i * rows.row, module.output_words);
        const Word canary = rows.words[i * rows.row + module.output_words];
        const Word expected = rows.canary ^ static_cast<Word>(i);
        if (canary != expected) {
            throw KernelError(
                fmt::format("{}: the kernel did not finish for input {} of {}: expected the canary 0x{:08x}, "
                            "found 0x{:08x}",
                            name, rows.first + i, rows.first + rows.count, expected, canary));
        }
        result.outputs.insert(result.outputs.end(), values.begin(), values.end());
    }
}

void add_faults(const KernelFaults& faults, std::size_t input, const KernelModule& module,
                const ImageSet& images, KernelCore::Result& result) {
    if (faults.count == 0) return;
    if (result.fault) {
        result.fault->count += faults.count;
        return;
    }
    const ImagePrototype& image = module.images.at(faults.image);
    result.fault = ImageFault{.image = image.name,
                              .pixel = {static_cast<int>(faults.x), static_cast<int>(faults.y)},
                              .size = images.at(image.name).size,
                              .count = faults.count,
                              .input = input};
}

void add_stored(const ImagePrototype& image, std::span<const Word> words, const ImageSet& images,
                KernelCore::Result& result) {
    if (!image.stores) return;
    const auto texels = words.subspan(image_header_words);
    Image stored = images.at(image.name);
    stored.words.assign(texels.begin(), texels.end());
    result.stored.emplace(image.name, std::move(stored));
}

Word new_canary() {
    std::random_device entropy;
    return entropy();
}

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
    std::vector<std::optional<ImageFault>> faults((count + share - 1) / share);
    base::for_each_index(faults.size(), 0, [&](std::size_t i) {
        std::vector<std::vector<Word>> own = words;
        const std::size_t begin = i * share;
        faults[i] = Part(program, *module, inputs, name)
                        .run(begin, std::min(begin + share, count), own, result.outputs);
        if (i == 0) after = std::move(own);  // a module that stores runs in one part
    });
    for (const std::optional<ImageFault>& fault : faults) merge(result.fault, fault);
    for (std::size_t i = 0; i < words.size(); ++i) add_stored(module->images[i], after[i], images, result);
    return result;
}

}  // namespace gloam::check::internal

namespace gloam::check {
namespace {

// The value of the memory behind the outputs before and after the dispatch.
constexpr Word guard_pattern = 0xdeadbeefU;
constexpr std::size_t guard_words = 64;
constexpr std::size_t fault_words = sizeof(KernelFaults) / sizeof(Word);

gpu::ComputePipeline make_pipeline(const gpu::Device& device, const KernelModule& module) {
    gpu::ComputeProgram program{.spirv = module.spirv,
                                .bindings = std::vector(KernelBinding::first_image + module.images.size(),
                                                        gpu::BindingKind::storage_buffer),
                                .push_constant_bytes = sizeof(KernelRun)};
    for (const interpreter::Constant& constant : module.constants)
        program.constants.push_back({.id = constant.id, .bits = constant.bits});
    return {device, program};
}

gpu::Buffer make_buffer(const gpu::Device& device, std::size_t words) {
    return {device, std::max<std::size_t>(words, 1) * sizeof(Word)};
}

gpu::Buffer upload(const gpu::Device& device, const std::vector<Word>& words) {
    gpu::Buffer buffer = make_buffer(device, words.size());
    std::ranges::copy(words, buffer.as<Word>().begin());
    return buffer;
}

}  // namespace

std::string to_text(const ImageFault& fault) {
    return fmt::format("{}: pixel ({}, {}) is outside the {} x {} image ({} times, at input {})", fault.image,
                       fault.pixel.x, fault.pixel.y, fault.size.x, fault.size.y, fault.count, fault.input);
}

struct KernelCore::Batch {
    std::span<const Word> inputs;
    std::size_t count;
    std::size_t first;  // position of its first input in the whole run
    const std::vector<gpu::Buffer>& images;
    const ImageSet& image_set;
    Result& result;
};

KernelCore::KernelCore(const gpu::Device& device, KernelModule module, std::string name)
    : device_(&device),
      module_(std::make_shared<const KernelModule>(std::move(module))),
      pipeline_(make_pipeline(device, *module_)),
      name_(std::move(name)) {}

KernelCore::KernelCore(KernelModule module, std::string name)
    : module_(std::make_shared<const KernelModule>(std::move(module))), name_(std::move(name)) {}

KernelCore::KernelCore(const gl::Device& device, KernelModule module, std::string name)
    : module_(std::make_shared<const KernelModule>(std::move(module))),
      gl_(std::make_shared<const internal::GlKernel>(device, module_, name)),
      name_(std::move(name)) {}

KernelCore::Result KernelCore::run(std::span<const Word> inputs, std::size_t count,
                                   const ImageSet& images) const {
    if (inputs.size() != count * module_->input_words) {
        throw std::invalid_argument(fmt::format("{}: {} inputs of {} words need {} words, got {}", name_,
                                                count, module_->input_words, count * module_->input_words,
                                                inputs.size()));
    }
    if (gl_) return gl_->run(inputs, count, images);
    if (device_ == nullptr) return internal::interpret(module_, inputs, count, images, name_);
    Result result;
    result.modules = {module_};
    result.outputs.reserve(count * module_->output_words);
    std::vector<gpu::Buffer> buffers;
    for (const std::vector<Word>& words : image_words(module_->images, images, name_))
        buffers.push_back(upload(*device_, words));
    const std::size_t widest = std::max(module_->input_words, module_->output_words + 1);
    const std::size_t most = device_->info().max_buffer_bytes / sizeof(Word) / widest - guard_words;
    for (std::size_t first = 0; first < count; first += most) {
        const std::size_t batch = std::min(most, count - first);
        Batch work{inputs.subspan(first * module_->input_words, batch * module_->input_words),
                   batch,
                   first,
                   buffers,
                   images,
                   result};
        run_batch(work);
    }
    for (std::size_t i = 0; i < buffers.size(); ++i)
        internal::add_stored(module_->images[i], buffers[i].as<Word>(), images, result);
    return result;
}

void KernelCore::run_batch(Batch& batch) const {
    const std::size_t row = module_->output_words + 1;
    gpu::Buffer inputs = make_buffer(*device_, batch.inputs.size());
    gpu::Buffer outputs = make_buffer(*device_, batch.count * row + guard_words);
    gpu::Buffer fault_buffer = make_buffer(*device_, fault_words);
    std::ranges::copy(batch.inputs, inputs.as<Word>().begin());
    std::ranges::fill(outputs.as<Word>().subspan(batch.count * row), guard_pattern);
    std::ranges::fill(fault_buffer.as<Word>(), 0U);

    const std::size_t groups = (batch.count + kernel_group_size - 1) / kernel_group_size;
    const std::size_t columns = std::min<std::size_t>(groups, device_->info().max_group_count[0]);
    const std::size_t rows = (groups + columns - 1) / columns;
    const KernelRun run{.count = static_cast<Word>(batch.count),
                        .row_length = static_cast<Word>(columns * kernel_group_size),
                        .canary = internal::new_canary()};
    std::vector<gpu::Resource> resources{std::cref(inputs), std::cref(outputs), std::cref(fault_buffer)};
    for (const gpu::Buffer& image : batch.images) resources.emplace_back(std::cref(image));
    gpu::Commands commands(*device_);
    commands.dispatch(*pipeline_, resources, {static_cast<Word>(columns), static_cast<Word>(rows), 1},
                      std::as_bytes(std::span(&run, 1)));
    commands.submit();

    const std::span<const Word> words = outputs.as<Word>();
    const internal::KernelRows kernel_rows{words, row, batch.count, batch.first, run.canary};
    internal::add_outputs(kernel_rows, *module_, name_, batch.result);
    const auto guard = words.subspan(batch.count * row);
    if (std::ranges::any_of(guard, [](Word word) { return word != guard_pattern; })) {
        throw KernelError(fmt::format("{}: the kernel wrote outside its outputs, behind input {}", name_,
                                      batch.first + batch.count - 1));
    }
    const std::span<const Word> fault = fault_buffer.as<Word>();
    internal::add_faults({fault[0], fault[1], fault[2], fault[3], fault[4]}, batch.first + fault[4], *module_,
                         batch.image_set, batch.result);
}

}  // namespace gloam::check
