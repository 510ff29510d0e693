// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "backend/backend.hpp"
#include "module/compile.hpp"
#include "subject/images.hpp"
#include "subject/signature.hpp"

namespace gloam::subject {

// What a compute shader is generated from.
struct KernelSource {
    std::string file;           // as in #include "file"
    module::Function function;  // as the compiler reports it; of a team: together()
    std::vector<ImagePrototype> images;
    bool preserve_nan =
        false;  // declare SignedZeroInfNanPreserve: NaN, infinity and -0 then mean what they say
    std::string
        text;  // in the place of the #include: an excerpt of the file (source::Excerpt::text); may be empty
    // Functions with derivatives or discard run in quads, those with shared memory, barriers or subgroups in
    // work groups of the file's size, of 64 invocations where it states none.
    backend::Team team = {};

    [[nodiscard]] Signature signature() const { return {function.result, function.parameters, team}; }
};

// The stage of its kernel.
[[nodiscard]] source::Stage stage_of(const backend::Team& team);

using backend::kernel_group_size;
using backend::KernelBinding;
using backend::KernelFaults;
using backend::KernelRun;

// Words before an image's pixels: width, height, border.
inline constexpr std::size_t image_header_words = 3;

// The text of a shader that calls the function once for each input; of a team, once in each invocation.
[[nodiscard]] std::string kernel_code(const KernelSource& source);

// A compiled kernel, as it is passed to a driver or the interpreter. Its `spirv` follows the interface of
// kernel_code().
struct KernelModule : backend::KernelProgram {
    // What it was generated from; of a module made by hand nothing.
    std::shared_ptr<const KernelSource> source = std::make_shared<const KernelSource>();
    // The module before the variant's optimizer and the steps of a compiler, whose rules hold for the
    // results. Empty: there were none.
    module::Spirv before = {};
    bool rounds_to_even = false;              // what runs it rounds each correctly rounded result so
    bool judged_by_rules = true;              // off where the version of GLSL has no precision rules to ask
    backend::SamplerPrecision samplers = {};  // of the device that runs it, as the next
    std::uint32_t subgroup_size = 1;
};
[[nodiscard]] KernelModule kernel_module(const KernelSource& source, module::Spirv spirv);

// The words of each of a kernel's images, in the format of its buffers. Throws std::invalid_argument if a
// prototype has no image or one of another type.
[[nodiscard]] std::vector<std::vector<Word>> image_words(const KernelModule& kernel, const ImageSet& images);

// The modules that evaluated a run's inputs, one after another. A single module evaluated all inputs;
// otherwise each evaluated its fixed_inputs.
using KernelModules = std::vector<std::shared_ptr<const KernelModule>>;

// The text of a compute shader like that of kernel_code(), but with `count` inputs as constants; invocation i
// evaluates input i. `inputs`: each of the same number of words, one after another. They stand in the text as
// literals, in a shader that does not preserve NaN: SPIRV-Tools fold nothing in one that does; or word w is
// the specialization constant w of type uint. Throws backend::Unsupported for a team.
[[nodiscard]] std::string constant_kernel_code(KernelSource source, module::Variant::Constants constants,
                                               std::span<const Word> inputs, std::size_t count);

// The kernel of a function as a device takes it whose kernels are texts in this language
// (backend/gl/kernel.hpp): a compute shader, else a fragment shader. It includes nothing. Throws
// backend::Unsupported for a function that is no text of this language.
[[nodiscard]] std::string gl_kernel_code(source::Language language, const KernelSource& source,
                                         const std::vector<std::filesystem::path>& include_roots);

}  // namespace gloam::subject
