// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "check/function.hpp"
#include "stress/run.hpp"

namespace gloam::stress {

// StressSequence of shaders/accumulate.glsl, member by member.
struct Sequence {
    unsigned pattern;
    unsigned seed;
    unsigned first;
    unsigned frames;
    unsigned k;
    unsigned table_size;
    float weight_max;
};

enum Pattern : unsigned { third, alternating, jumping, noise, rare, pattern_count };

constexpr const char* accumulate_file = "accumulate.glsl";
using Accumulate = check::Function<glm::vec4(glm::vec4, Sequence, glm::vec2&)>;

// The contribution of a frame: what stress_contribution returns, to the bit.
[[nodiscard]] double contribution(const Sequence& sequence, std::uint64_t frame);

// One pixel's history on the device, and beside it what it should be, in double.
struct HistoryLane {
    Sequence sequence{};
    glm::vec4 texel{0.0F, 0.0F, 0.0F, 1.0F};  // (occlusion, weight, index, depth)
    glm::vec2 range{1.0F, 0.0F};              // of the occlusion so far
    double mean = 0.0;
    double weight = 0.0;
    std::uint64_t samples = 0;

    // The double beside it, `frames` further (TSSAO-5 as printed).
    void advance(unsigned frames);
};

// All lanes `frames` further, in one dispatch; `frames` below 65,535.
void advance(const Accumulate& kernel, std::vector<HistoryLane>& lanes, unsigned frames);

// The history carried over Context::frames frames on the device, through gloam_history_unpack, gloam_blend,
// gloam_next_index and gloam_history_pack as a pass does it, for constant, alternating, jumping, noisy and
// rare contributions. Compared with the mean in double:
//   farthest from the exact mean, and its average over time (bias); at most E (w_max + k) / k, where E is the
//   error of one frame: that of gloam_blend;
//   weight and index; exact.
[[nodiscard]] Rows long_run(const Context& context);

}  // namespace gloam::stress
