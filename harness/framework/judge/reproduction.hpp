// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/run.hpp"
#include "subject/lab.hpp"

namespace gloam::judge {

// The first of some inputs that fails, with its outputs; nullopt: none does.
using FirstFailing = std::function<std::optional<Sample>(std::span<const std::vector<Word>> inputs)>;

// The simplest input of the domain that is found to fail like `failing`. Values are changed one at a time;
// equal values are also changed together. The simplest change that still fails is kept, until no change does.
// The result is deterministic. Throws std::invalid_argument if `failing` does not fail.
[[nodiscard]] Sample shrink(const Question& question, const Sample& failing,
                            const FirstFailing& first_failing);

// A check of one input, with all that is needed to run it without this framework.
struct Reproduction {
    std::string glsl;  // the generated shader, includes inserted
    module::Spirv spirv;
    // Of a variant with steps: the fewest of them, and the fewest parts of each, that still fail; and the
    // module before those of a compiler, whose rules were asked.
    std::vector<std::string> steps = {};
    module::Spirv before = {};
    backend::Team team = {};  // of a quad, the shader is a fragment shader
    std::string opengl;       // of an OpenGL device: the text that it was given
    std::string assembly;
    std::string scenario;  // of the images; empty without images
    // Buffers behind the kernel's own, in the order of their bindings: the name of an image's prototype, and
    // its size, border and pixels in the layout that the shader reads.
    struct ImageBuffer {
        std::string name;
        std::vector<Word> words;
        // No buffer: an image as in backend/sampled.hpp, for a sampler; without words, of layers that the
        // kernel fills.
        bool bound = false;
    };
    std::vector<ImageBuffer> images;
    std::vector<Word> inputs;  // of each that runs
    std::size_t count = 1;     // of these: several, where it fails only beside others
    std::size_t failing = 0;   // the one that fails
    bool specialized = false;  // the inputs are specialization constants: word i has the constant_id i
    std::vector<module::Scalar> outputs;
    std::vector<Sample::Outcome> outcomes;  // that are allowed; empty if no failing input is known
    std::optional<Sample> failure;          // the failure for these inputs
    std::vector<std::string> rules = {};    // rules_of() its operations; empty: it cannot be explained
};

// The shader and the first input of a check. Nothing is run; use it if the check crashed its driver.
[[nodiscard]] Reproduction reproduce(const subject::Lab& lab, const Question& question,
                                     const RunOptions& options);

// The same with the simplest failing input that shrink() finds, starting from an input that failed in a run
// with these options. An input that fails only beside others comes with its group. Throws
// std::invalid_argument if that does not fail any more either, or if it ran with images that the check does
// not have.
[[nodiscard]] Reproduction reproduce(const subject::Lab& lab, const Question& question,
                                     const RunOptions& options, const Sample& failing);

// The same with an input for which the shader accesses a pixel outside an image, as in a run with these
// options. Throws std::invalid_argument if no input does.
[[nodiscard]] Reproduction reproduce_fault(const subject::Lab& lab, const Question& question,
                                           const RunOptions& options);

// The outcomes that a failing sample does not have: of one that the rules forbid, those that Vulkan permits;
// else one, the budget around `want`, and around the reference's results for the neighbouring inputs that the
// budget covers. Where the function jumps, it includes the values in between.
[[nodiscard]] std::vector<Sample::Outcome> allowed_outcomes(const Question& question,
                                                            const subject::ImageSet& images,
                                                            const Sample& sample);

}  // namespace gloam::judge
