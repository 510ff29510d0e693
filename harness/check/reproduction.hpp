// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/run.hpp"
#include "numeric/bounds.hpp"

namespace gloam::check {

// A check of one input, with all that is needed to run it without this framework.
struct Reproduction {
    std::string glsl;  // the generated compute shader, its includes in it
    shader::Spirv spirv;
    std::string assembly;
    std::string scenario;  // of the images; empty without
    // Buffers behind the kernel's own, in the order of their bindings: an image's prototype, and its size,
    // border and pixels as the shader reads them.
    struct ImageBuffer {
        std::string name;
        std::vector<Word> words;
    };
    std::vector<ImageBuffer> images;
    std::vector<Word> inputs;
    bool specialized = false;  // the inputs are specialization constants: word i has the constant_id i
    std::vector<shader::Scalar> outputs;
    // The results that each output word may have; nothing when no input is known to fail.
    std::vector<numeric::Bounds> allowed;
    std::optional<Sample> failure;  // of these inputs
};

// The shader and the first input of a check, without running anything: for one that crashed its driver.
[[nodiscard]] Reproduction reproduce(const Lab& lab, const Question& question, const RunOptions& options);

// The same with the simplest input that is found to fail (see shrink()), from one that did in a run with
// these options. Throws std::invalid_argument when it does not fail any more, or ran with images that the
// check does not have.
[[nodiscard]] Reproduction reproduce(const Lab& lab, const Question& question, const RunOptions& options,
                                     const Sample& failing);

// The same with an input for which the shader reaches outside an image, as it did in a run with these
// options. Throws std::invalid_argument when none does.
[[nodiscard]] Reproduction reproduce_fault(const Lab& lab, const Question& question,
                                           const RunOptions& options);

// The results that the rules allow each output word, where the reference wants `want`: what Vulkan permits,
// or the budget around `want`, and around what the reference gives for the neighbouring inputs that the
// budget speaks of. One range for each word: where the function jumps, also what lies between.
[[nodiscard]] std::vector<numeric::Bounds> allowed_outputs(const Question& question, const ImageSet& images,
                                                           const Sample& sample);

}  // namespace gloam::check
