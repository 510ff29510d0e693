// SPDX-License-Identifier: MIT
#include "check/constant_kernel.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "check/constant_code.hpp"

namespace gloam::check {
namespace {

using Constants = shader::Variant::Constants;

constexpr std::size_t module_inputs = 4;

void add(KernelCore::Result& all, KernelCore::Result part, std::size_t first) {
    all.outputs.insert(all.outputs.end(), part.outputs.begin(), part.outputs.end());
    all.modules.insert(all.modules.end(), part.modules.begin(), part.modules.end());
    for (auto& [name, image] : part.stored) all.stored.insert_or_assign(name, std::move(image));
    if (!part.fault) return;
    part.fault->input += first;
    part.fault->count += all.fault ? all.fault->count : 0;
    all.fault = part.fault;
}

}  // namespace

ConstantKernel::ConstantKernel(const Lab& lab, const std::string& file, const std::string& function,
                               const Signature& signature)
    : lab_(&lab),
      source_(lab.source(file, function, signature)),
      input_words_(signature.input_words()),
      output_words_(signature.output_words()) {
    if (lab.options().variant.constants == Constants::none) {
        throw std::invalid_argument(
            fmt::format("{}: inputs as constants need a variant that has them, not \"{}\"", function,
                        lab.options().variant.name));
    }
    if (lab.options().variant.constants == Constants::literals) source_.preserve_nan = false;
}

KernelCore::Result ConstantKernel::run(std::span<const Word> inputs, std::size_t count,
                                       const ImageSet& images) const {
    const std::string& name = source_.function.name;
    if (count > most_inputs) {
        throw std::invalid_argument(
            fmt::format("{}: {} inputs as constants, at most {} at once", name, count, most_inputs));
    }
    if (inputs.size() != count * input_words_) {
        throw std::invalid_argument(fmt::format("{}: {} inputs of {} words need {} words, got {}", name,
                                                count, input_words_, count * input_words_, inputs.size()));
    }
    KernelCore::Result result;
    ImageSet current = images;
    for (std::size_t first = 0; first < count; first += module_inputs) {
        const std::size_t part = std::min(module_inputs, count - first);
        const KernelCore core = module_of(inputs.subspan(first * input_words_, part * input_words_), part);
        add(result, core.run({}, part, current), first);
        for (const auto& [image, stored] : result.stored) current.insert_or_assign(image, stored);
    }
    return result;
}

KernelCore ConstantKernel::module_of(std::span<const Word> inputs, std::size_t count) const {
    const bool literals = lab_->options().variant.constants == Constants::literals;
    const shader::Source text{.name = fmt::format("kernel of {} with {}", source_.function.name,
                                                  literals ? "literals" : "specialization constants"),
                              .text = literals ? literal_kernel_code(source_, inputs, count)
                                               : specialized_kernel_code(source_, count)};
    KernelModule module{.spirv = lab_->compile_kernel(text),
                        .output_words = output_words_,
                        .images = source_.images,
                        .fixed_inputs = count};
    for (std::size_t word = 0; !literals && word < inputs.size(); ++word)
        module.constants.push_back({.id = static_cast<std::uint32_t>(word), .bits = inputs[word]});
    return lab_->core(std::move(module), source_.function.name);
}

}  // namespace gloam::check
