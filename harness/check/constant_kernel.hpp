// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "check/lab.hpp"

namespace gloam::check {

// A kernel whose inputs are constants of the shader: literals or specialization constants, as the lab's
// Variant::constants requires. It shows whether the compiler or the driver folds constants to the values that
// the device calculates. Words in and out are those of KernelCore::run(). Every 16 inputs form a module of
// their own and cost one compilation, so use few inputs.
//
// A check uses it in place of Lab::kernel() if lab.options().variant.constants is not `none`. It then takes
// the first most_inputs inputs, and judges NaN, infinity and -0 only if preserves_nan() is true:
//     const ConstantKernel kernel(lab, file, function, signature);
//     const KernelCore::Result result = kernel.run(words, count, images);
class ConstantKernel {
  public:
    // The most inputs that one run takes.
    static constexpr std::size_t most_inputs = 64;

    // Throws like Lab::kernel; std::invalid_argument if the lab's variant has no constants. The lab must
    // outlive this object.
    ConstantKernel(const Lab& lab, const std::string& file, const std::string& function,
                   const Signature& signature);

    // Evaluates `count` inputs (count x input_words words) in order. Later modules read what earlier ones
    // stored to images. Throws like KernelCore::run; std::invalid_argument for more than most_inputs;
    // shader::CompileError.
    [[nodiscard]] KernelCore::Result run(std::span<const Word> inputs, std::size_t count,
                                         const ImageSet& images = {}) const;

    // Whether the shader declares SignedZeroInfNanPreserve, as far as the device supports it. With literals
    // it does not, because SPIRV-Tools folds nothing under this mode; results for NaN, infinity and -0 are
    // then undefined.
    [[nodiscard]] bool preserves_nan() const { return source_.preserve_nan; }

    [[nodiscard]] std::size_t input_words() const { return input_words_; }
    [[nodiscard]] std::size_t output_words() const { return output_words_; }

  private:
    [[nodiscard]] KernelCore module_of(std::span<const Word> inputs, std::size_t count) const;

    const Lab* lab_;
    KernelSource source_;
    std::size_t input_words_;
    std::size_t output_words_;
};

}  // namespace gloam::check
