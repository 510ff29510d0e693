// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "check/lab.hpp"

namespace gloam::check {

// A kernel whose inputs are constants of the shader, as literals or as specialization constants (what the
// lab's variant says: Variant::constants), so that what the compiler or the driver folds can be compared with
// what the device calculates. Words in and words out are those of KernelCore::run(). Every 16 inputs are a
// module of their own, so that it costs a compilation: meant for a few inputs.
//
// A check takes it in the place of Lab::kernel() when lab.options().variant.constants is not `none`, with its
// first most_inputs inputs, and judges NaN, infinity and -0 as preserves_nan() says:
//     const ConstantKernel kernel(lab, file, function, signature);
//     const KernelCore::Result result = kernel.run(words, count, images);
class ConstantKernel {
  public:
    // The most inputs that one run takes.
    static constexpr std::size_t most_inputs = 64;

    // Throws as Lab::kernel does; std::invalid_argument when the lab's variant has no constants. The lab must
    // live longer.
    ConstantKernel(const Lab& lab, const std::string& file, const std::string& function,
                   const Signature& signature);

    // Evaluates `count` inputs (count x input_words words), in order: what the function stores to an image is
    // what it reads from it for later modules. Throws as KernelCore::run does; std::invalid_argument for more
    // than most_inputs; shader::CompileError.
    [[nodiscard]] KernelCore::Result run(std::span<const Word> inputs, std::size_t count,
                                         const ImageSet& images = {}) const;

    // Whether the shader declares SignedZeroInfNanPreserve, as far as the device has it. With literals it
    // does not: SPIRV-Tools folds nothing under it. The results for NaN, infinity and -0 are then not
    // defined.
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
