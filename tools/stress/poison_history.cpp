// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "stress/history_lane.hpp"
#include "stress/poison_parts.hpp"
#include "stress/views.hpp"

namespace gloam::stress {
namespace {

constexpr Sequence sequence_of(unsigned k, float weight_max) {
    return {.pattern = third,
            .seed = 0,
            .first = 0,
            .frames = 1,
            .k = k,
            .table_size = 2048,
            .weight_max = weight_max,
            .stored_half = false};
}

constexpr Sequence sequence = sequence_of(32, 500.0F);
constexpr glm::vec4 good{0.5F, 500.0F, 64.0F, 3.0F};
constexpr glm::vec4 empty{0.0F, 0.0F, 0.0F, 3.0F};

// Whether a texel remembers anything, as gloam_history_unpack states it.
bool usable(const glm::vec4& texel) {
    const auto positive = [](float x) { return std::isfinite(x) && x > 0.0F; };
    return texel.x >= 0.0F && texel.x <= 1.0F && positive(texel.y) && positive(texel.w);
}

// Subnormals may be flushed, so what is made of them is not judged here beyond its range.
bool subnormal(float x) {
    return std::fpclassify(x) == FP_SUBNORMAL;
}

// A texel that the next frame can go on with.
bool safe(const glm::vec4& texel) {
    const bool depth = texel.w > 0.0F;  // +infinity for background
    return texel.x >= 0.0F && texel.x <= 1.0F && texel.y >= 0.0F && texel.y <= sequence.weight_max &&
           texel.z >= 0.0F && texel.z < static_cast<float>(sequence.table_size) && depth;
}

using Frame = check::Kernel<glm::vec4(glm::vec4, float, Sequence)>;

// Each channel of a good history made bad; one frame.
Rows texels(const Frame& frame) {
    const glm::vec4 fresh = frame(empty, 0.25F, sequence);
    std::size_t unsafe = 0;
    std::size_t not_fresh = 0;
    for (const BadValue& bad : bad_values()) {
        for (int channel = 0; channel < 4; ++channel) {
            glm::vec4 texel = good;
            texel[channel] = bad.value;
            const glm::vec4 after = frame(texel, 0.25F, sequence);
            unsafe += safe(after) ? 0 : 1;
            if (usable(texel) || subnormal(bad.value)) continue;
            not_fresh += after == fresh ? 0 : 1;
        }
    }
    const std::string varied = "history texel, one channel";
    return {{poison_name, varied, "unsafe after one frame", static_cast<double>(unsafe), 0.0},
            {poison_name, varied, "not healed (a fresh start) after one frame",
             static_cast<double>(not_fresh), 0.0}};
}

// Bad contributions: NaN and infinities leave the history as it is, others count as the nearer end of [0, 1].
Rows contributions(const Frame& frame) {
    std::size_t unsafe = 0;
    std::size_t wrong = 0;
    for (const BadValue& bad : bad_values()) {
        const glm::vec4 after = frame(good, bad.value, sequence);
        unsafe += safe(after) ? 0 : 1;
        const float read = std::isfinite(bad.value) ? glm::clamp(bad.value, 0.0F, 1.0F) : 0.0F;
        const float expected = std::isfinite(bad.value) ? frame(good, read, sequence).x : good.x;
        wrong += subnormal(bad.value) || after.x == expected ? 0 : 1;
    }
    const std::string varied = "contribution of one frame";
    return {{poison_name, varied, "unsafe after one frame", static_cast<double>(unsafe), 0.0},
            {poison_name, varied, "damage other than stated", static_cast<double>(wrong), 0.0}};
}

// Frames until a history that is plausible but wrong (occlusion 1, full weight) is right within 1/255.
Row healing(const Accumulate& accumulate, unsigned k, float weight_max) {
    const double alpha = k / (double{weight_max} + k);
    const double stated = std::ceil(std::log(255.0) / -std::log1p(-alpha));
    Sequence all = sequence_of(k, weight_max);
    const double right = contribution(all, 0);
    const auto healed = [&](unsigned frames) {
        all.frames = frames;
        const auto [texel, range] =
            accumulate(glm::vec4(1.0F, weight_max, 0.0F, 3.0F), all, glm::vec2(1.0F, 0.0F));
        return std::abs(double{texel.x} - right) < 1.0 / 255.0;
    };
    unsigned low = 0;
    unsigned high = 60'000;
    if (!healed(high)) return {poison_name, "wrong history", "frames to heal", INFINITY, stated};
    while (high - low > 1) {
        const unsigned middle = (low + high) / 2;
        (healed(middle) ? high : low) = middle;
    }
    return {poison_name, fmt::format("wrong but plausible history, k {}, w_max {}", k, weight_max),
            "frames until right within 1/255", static_cast<double>(high), stated};
}

}  // namespace

Rows poisoned_history(const Context& context) {
    context.progress(fmt::format("{}: history", poison_name));
    const Frame frame(context.lab, accumulate_file, "stress_frame");
    const Accumulate accumulate(context.lab, accumulate_file, "stress_accumulate");
    Rows rows = texels(frame);
    for (const Row& row : contributions(frame)) rows.push_back(row);
    rows.push_back(healing(accumulate, 32, 500.0F));
    rows.push_back(healing(accumulate, 8, 1500.0F));
    return rows;
}

}  // namespace gloam::stress
