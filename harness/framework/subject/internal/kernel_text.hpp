// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "subject/kernel_code.hpp"

// The parts of generated compute shaders.
namespace gloam::subject::internal {

// GLSL expression of a scalar, from the uint expression of its word.
[[nodiscard]] std::string scalar_of_word(module::Scalar scalar, const std::string& word);

// The whole shader: the interface, the function's file, the definitions of its prototypes, then `rest`, which
// has main(). Every name that is not from the file begins with gloam_kernel_ or GloamGenerated. Macros of the
// file end with the file.
[[nodiscard]] std::string kernel_text(const KernelSource& source, const std::string& rest);

// The GLSL expression of the position of the invocation's input.
[[nodiscard]] const char* input_position(const backend::Team& team);

// The declarations that a kernel has on Vulkan and on OpenGL: the size of its groups, the numbers of a run,
// whose layout is `run`, the storage buffers of inputs, outputs, faults and images, uint gloam_kernel_input()
// and void gloam_kernel_fault(uint image, ivec2 pixel).
[[nodiscard]] std::string storage_interface(const KernelSource& source, std::string_view run);

// The GLSL expression of a word of an image in a storage buffer, for fmt::format: of the image's position and
// the GLSL expression of the word's.
inline constexpr std::string_view word_of_buffer = "gloam_kernel_image{}[{}]";

// What stands behind the interface of a kernel, whatever that is: the function's file, the definitions of its
// prototypes, `rest`. The interface defines void gloam_kernel_fault(uint image, ivec2 pixel).
// `word_of_image`: such an expression.
[[nodiscard]] std::string file_and_rest(const KernelSource& source, std::string_view word_of_image,
                                        const std::string& rest);

// The GLSL expression of an input scalar, given its position among the words of one input.
using InputText = std::function<std::string(module::Scalar scalar, std::size_t word)>;

// Appends statements that set a variable from the input words from `offset` on.
void append_read(std::string& code, const module::Type& type, const std::string& variable,
                 const InputText& input, std::size_t offset);

// The variable of a kernel for a parameter of the function.
[[nodiscard]] std::string argument_name(std::size_t parameter);

// Statements that call the function once and write its results to the outputs, from index
// gloam_kernel_output_at on.
struct Evaluation {
    std::string code;
    std::size_t input_words = 0;
    std::size_t output_words = 0;
};
[[nodiscard]] Evaluation evaluation(const KernelSource& source, const InputText& input);

// The whole main() of a kernel that reads its inputs from a storage buffer.
[[nodiscard]] std::string main_of(const KernelSource& source);

// Throws backend::Unsupported for a team: `what` runs single invocations only.
void require_alone(const KernelSource& source, const char* what);

// Whether OpenGL's precision rules for the module are those of Vulkan, by which the interpreter judges
// (docs/verdicts.md): in GLSL 4.50 and GLSL ES 3.20, whose section 4.7.1 has the same table, and which know
// `precise`; but for built-ins whose precision that section leaves undefined: trigonometric and hyperbolic
// functions, determinant, inverse.
[[nodiscard]] bool has_precision_rules(source::Language language, const module::Spirv& module);

}  // namespace gloam::subject::internal
