// SPDX-License-Identifier: MIT
#include "subject/lab.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <random>
#include <utility>

#include "base/threads.hpp"
#include "interpreter/program.hpp"
#include "module/spirv.hpp"
#include "subject/interpreted_kernel.hpp"

namespace gloam::subject {
namespace {

// The value of the memory behind the outputs before and after the dispatch.
constexpr Word guard_pattern = 0xdeadbeefU;

// Adds the outputs of a run's inputs from `first` to `end`. Throws backend::Fault for a canary or a guard
// that is not in order.
void add_outputs(std::size_t first, std::size_t end, Word canary, std::size_t width,
                 std::span<const Word> words, const std::string& name, std::vector<Word>& outputs) {
    for (std::size_t i = 0; i < end - first; ++i) {
        const auto row = words.subspan(i * (width + 1), width + 1);
        const Word expected = canary ^ static_cast<Word>(i);
        if (row.back() != expected) {
            throw backend::Fault(
                fmt::format("{}: the kernel did not finish for input {} of {}: expected the canary 0x{:08x}, "
                            "found 0x{:08x}",
                            name, first + i, end, expected, row.back()));
        }
        outputs.insert(outputs.end(), row.begin(), row.end() - 1);
    }
    const auto guard = words.subspan((end - first) * (width + 1));
    if (std::ranges::any_of(guard, [](Word word) { return word != guard_pattern; })) {
        throw backend::Fault(
            fmt::format("{}: the kernel wrote outside its outputs, behind input {}", name, end - 1));
    }
}

// Adds accesses outside an image, of the inputs from `first` on.
void add_faults(std::size_t first, const KernelFaults& faults, const KernelModule& module,
                const ImageSet& images, std::optional<ImageFault>& all) {
    if (faults.count == 0) return;
    if (all) {
        all->count += faults.count;
        return;
    }
    const ImagePrototype& image = module.source->images.at(faults.image);
    all = ImageFault{.image = image.name,
                     .pixel = {static_cast<int>(faults.x), static_cast<int>(faults.y)},
                     .size = images.at(image.name).size,
                     .count = faults.count,
                     .input = first + faults.input};
}

}  // namespace

std::string to_text(const ImageFault& fault) {
    return fmt::format("{}: pixel ({}, {}) is outside the {} x {} image ({} times, at input {})", fault.image,
                       fault.pixel.x, fault.pixel.y, fault.size.x, fault.size.y, fault.count, fault.input);
}

KernelCore::KernelCore(const backend::Backend& device, KernelModule module)
    : module_(std::make_shared<const KernelModule>(std::move(module))),
      kernel_(device.make_kernel(*module_)) {}

KernelCore::Result KernelCore::run(std::span<const Word> inputs, std::size_t count,
                                   const ImageSet& images) const {
    const std::size_t in = module_->input_words;
    const std::size_t out = module_->output_words;
    if (inputs.size() != count * in) {
        throw std::invalid_argument(fmt::format("{}: {} inputs of {} words need {} words, got {}",
                                                module_->name, count, in, count * in, inputs.size()));
    }
    std::random_device entropy;  // for each dispatch a new canary: memory of an earlier one does not hold it
    Result result;
    if (module_->judged_by_rules) result.modules = {module_};
    result.outputs.reserve(count * out);
    const std::vector<std::vector<Word>> words = image_words(*module_, images);
    for (std::size_t first = 0, part = 0; first < count; first += part) {
        part = std::min(kernel_->most_inputs(), count - first);
        backend::KernelMemory memory{.inputs = inputs.subspan(first * in, part * in),
                                     .outputs = std::vector<Word>(part * (out + 1)),
                                     .images = words};
        memory.outputs.resize(memory.outputs.size() + backend::guard_words, guard_pattern);
        const Word canary = entropy();
        kernel_->run(part, canary, memory);
        add_outputs(first, first + part, canary, out, memory.outputs, module_->name, result.outputs);
        add_faults(first, memory.faults, *module_, images, result.fault);
    }
    return result;
}

namespace {

interpreter::Program decoded(const backend::KernelProgram& program) {
    try {
        return interpreter::Program(program.spirv, program.constants);
    } catch (const interpreter::Error& error) {
        const std::string message = fmt::format("{}: {}", program.name, error.what());
        if (error.kind() == interpreter::Error::Kind::unknown_instruction)
            throw backend::Unsupported(message);
        throw backend::Fault(message);
    }
}

class InterpreterKernel : public backend::Kernel {
  public:
    static constexpr std::uint32_t subgroup_size = 4;

    explicit InterpreterKernel(const backend::KernelProgram& program)
        : program_(decoded(program)), module_{program} {
        module_.subgroup_size = subgroup_size;
    }

    [[nodiscard]] std::size_t most_inputs() const override { return std::numeric_limits<std::size_t>::max(); }

    void run(std::size_t count, Word canary, backend::KernelMemory& memory) const override {
        const auto shares = base::shares_of(count, base::processors());
        std::vector<KernelFaults> faults(shares.size());
        base::for_each_index(shares.size(), 0, [&](std::size_t share) {
            InterpretedKernel<float> kernel(program_, module_, memory.images);
            for (std::size_t i = shares[share].begin; i < shares[share].end; ++i)
                run(kernel, i, canary, memory, faults[share]);
        });
        for (const KernelFaults& share : faults) add(share, memory.faults);
    }

  private:
    void run(InterpretedKernel<float>& kernel, std::size_t i, Word canary, backend::KernelMemory& memory,
             KernelFaults& faults) const {
        const std::size_t row = module_.output_words + 1;
        const std::size_t invocation = module_.fixed_inputs > 0 ? i : 0;
        try {
            kernel.run(memory.inputs.subspan(i * module_.input_words, module_.input_words), invocation);
        } catch (const interpreter::Error& error) {
            const std::string message = fmt::format("{}: input {}: {}", module_.name, i, error.what());
            if (error.is_of_group()) throw interpreter::Error(error.kind(), message);
            if (error.is_of_input()) throw backend::UndefinedResult(message);
            throw backend::Fault(message);
        }
        for (std::size_t w = 0; w < row; ++w) memory.outputs[i * row + w] = kernel.output(w).bits();
        // The interpreter's own canary is 0, xor the invocation.
        memory.outputs[i * row + row - 1] ^= static_cast<Word>(invocation) ^ canary ^ static_cast<Word>(i);
        // Without prototypes an optimised module has no fault buffer.
        if (std::ranges::none_of(module_.images, [](const backend::KernelImage& image) {
                return !image.sampled && image.layered.empty();
            }))
            return;
        KernelFaults fault = kernel.faults();
        fault.input = static_cast<Word>(i);
        add(fault, faults);
    }

    static void add(const KernelFaults& later, KernelFaults& all) {
        const Word count = all.count + later.count;
        if (all.count == 0) all = later;
        all.count = count;
    }

    interpreter::Program program_;
    KernelModule module_;
};

class Interpreter : public backend::Backend {
  public:
    [[nodiscard]] const backend::DeviceInfo& info() const override { return info_; }

    [[nodiscard]] std::unique_ptr<backend::Kernel> make_kernel(
        const backend::KernelProgram& program) const override {
        return std::make_unique<InterpreterKernel>(program);
    }

  private:
    backend::DeviceInfo info_{
        .name = std::string(interpreter_name),
        .type = "interpreter",
        .driver = module::compiler_version(),
        .subgroup_size = InterpreterKernel::subgroup_size,
        .float32 = {
            .preserves_signed_zero_inf_nan = true, .preserves_denormals = true, .rounds_to_even = true}};
};

}  // namespace

std::shared_ptr<backend::Backend> interpreter_backend() {
    return std::make_shared<Interpreter>();
}

std::string why_not_run(KernelSource source, const module::SpirvCache& cache) {
    source.preserve_nan = true;  // as for most devices, whose checks then have it from the cache
    try {
        const interpreter::Program program(
            cache.compile({.name = "kernel of " + source.function.name, .text = kernel_code(source)},
                          {.stage = stage_of(source.team), .variant = {}, .lines = true}));
        const interpreter::Machine<float> machine(program);
    } catch (const interpreter::Error& error) {
        if (error.kind() == interpreter::Error::Kind::unknown_instruction) return error.what();
    } catch (const source::CompileError& error) {  // the check of the function says so
        const std::string what = error.what();
        if (what.find("invalid SPIR-V") != std::string::npos) return what.substr(0, what.find('\n'));
    }
    return {};
}

}  // namespace gloam::subject
