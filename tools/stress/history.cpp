// SPDX-License-Identifier: MIT
// Long runs of one pixel's history, and bad values in it.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "judge/function.hpp"
#include "reference/temporal.hpp"
#include "stress/run.hpp"

namespace gloam::stress {
namespace {

// StressSequence of shaders/accumulate.glsl, member by member.
struct Sequence {
    unsigned pattern = 0;
    unsigned seed = 0;
    unsigned first = 0;
    unsigned frames = 1;
    unsigned k = 32;
    unsigned table_size = 2048;
    float weight_max = 500.0F;
};

enum Pattern : unsigned { third, alternating, jumping, noise, rare, pattern_count };

constexpr const char* accumulate_file = "accumulate.glsl";
using Accumulate = judge::Function<glm::vec4(glm::vec4, Sequence, glm::vec2&)>;

constexpr glm::vec2 no_range{1.0F, 0.0F};

std::uint32_t hash(std::uint32_t x) {
    x = (x ^ (x >> 16U)) * 0x7FEB352DU;
    x = (x ^ (x >> 15U)) * 0x846CA68BU;
    return x ^ (x >> 16U);
}

// The contribution of a frame: what stress_contribution returns, to the bit.
double contribution(const Sequence& sequence, std::uint32_t frame) {
    if (sequence.pattern == third) return 5'592'405.0 * 0x1p-24;
    if (sequence.pattern == alternating) return frame & 1U;
    if (sequence.pattern == jumping) return (frame >> 12U) & 1U;
    const std::uint32_t random = hash(frame ^ (sequence.seed * 0x9E3779B9U));
    if (sequence.pattern == noise) return (random >> 8U) * 0x1p-24;
    return random < 0x08000000U ? 1.0 : 0.0;
}

// One pixel's history on the device, and beside it what it should be, in double.
struct Lane {
    Sequence sequence{};
    glm::vec4 texel{0.0F, 0.0F, 0.0F, 1.0F};  // (occlusion, weight, index, depth)
    glm::vec2 range = no_range;               // of the occlusion so far
    double mean = 0.0;
    double weight = 0.0;
    std::uint64_t samples = 0;
};

// All lanes `frames` further, in one dispatch; `frames` below 65,535.
void advance(const Accumulate& kernel, std::vector<Lane>& lanes, unsigned frames) {
    std::vector<Accumulate::Inputs> inputs;
    for (Lane& lane : lanes) {
        lane.sequence.frames = frames;
        inputs.emplace_back(lane.texel, lane.sequence, lane.range);
    }
    const std::vector<Accumulate::Output> outputs = kernel(inputs);
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        Lane& lane = lanes[i];
        std::tie(lane.texel, lane.range) = outputs[i];
        const double k = lane.sequence.k;  // the double beside it: TSSAO-5 as printed
        for (unsigned n = 0; n < frames; ++n) {
            const double fresh = contribution(lane.sequence, lane.sequence.first + n);
            lane.mean = (lane.weight * lane.mean + k * fresh) / (lane.weight + k);
            lane.weight = std::min(lane.weight + k, double{lane.sequence.weight_max});
        }
        lane.sequence.first += frames;
        lane.samples += std::uint64_t{frames} * lane.sequence.k;
    }
}

constexpr double blend_error = 1e-7;  // of gloam_blend, as its comment states
constexpr unsigned seeds = 3;         // lanes of each pattern

// What was seen of the lanes of one accumulation.
struct Accumulation {
    unsigned k;
    float weight_max;
    unsigned table_size;
    double farthest = 0.0;  // from the exact mean
    double signed_sum = 0.0;
    double readings = 0.0;
    double weight = 0.0;  // difference from the exact one
    double index = 0.0;
    double outside = 0.0;  // how far the occlusion left [0, 1]

    void look(const Lane& lane) {
        const double difference = double{lane.texel.x} - lane.mean;
        farthest = worse(farthest, std::abs(difference));
        if (lane.sequence.pattern == noise) {
            signed_sum += difference;
            readings += 1.0;
        }
        const auto expected = static_cast<double>(lane.samples % table_size);
        weight = worse(weight, std::abs(double{lane.texel.y} - lane.weight));
        index = worse(index, std::abs(double{lane.texel.z} - expected));
        outside = std::max({outside, -double{lane.range.x}, double{lane.range.y} - 1.0});
    }

    void report(const Context& context) const {
        const std::string text = fmt::format("k {}, w_max {}", k, weight_max);
        const double bound = blend_error * (double{weight_max} + k) / k;
        context.add(text, "farthest from the exact mean", farthest, bound);
        context.add(text, "bias under noise", std::abs(signed_sum) / readings, bound);
        context.add(text, "farthest outside [0, 1]", outside, 0.0);
        context.add(text, "weight off, samples", weight, 0.0);
        context.add(text, "index off, samples", index, 0.0);
    }
};

}  // namespace

void long_run(const Context& context) {
    const Accumulate kernel(context.lab, accumulate_file, "stress_accumulate");
    std::vector<Accumulation> all{
        {32, 500, 65'536},           {8, 1500, 1'500}, {1, 1500, 1U << 24U},
        {16, 8'388'608, 16'777'213}, {1, 1, 7},        {65'536, 8'388'608, 1U << 24U}};
    std::vector<Lane> lanes;
    for (const Accumulation& a : all)
        for (unsigned i = 0; i < pattern_count * seeds; ++i)
            lanes.push_back(
                {.sequence = {.pattern = i / seeds,
                              .seed = static_cast<unsigned>(context.scope.seed) * seeds + i % seeds,
                              .k = a.k,
                              .table_size = a.table_size,
                              .weight_max = a.weight_max}});
    constexpr std::uint64_t longest = 9'973;  // a prime: readings fall on every phase of the patterns
    const std::uint64_t step = std::clamp<std::uint64_t>(context.scope.frames / 4, 1, longest);
    for (std::uint64_t done = 0; done < context.scope.frames; done += step) {
        advance(kernel, lanes, static_cast<unsigned>(std::min(step, context.scope.frames - done)));
        for (std::size_t i = 0; i < lanes.size(); ++i) all[i / (pattern_count * seeds)].look(lanes[i]);
        context.progress(fmt::format("frame {} of {}", done, context.scope.frames));
    }
    for (const Accumulation& a : all) a.report(context);
}

namespace {

constexpr Sequence sequence;
constexpr glm::vec4 good{0.5F, 500.0F, 64.0F, 3.0F};
constexpr glm::vec4 empty{0.0F, 0.0F, 0.0F, 3.0F};

// Subnormals may be flushed, so what is made of them is not judged here beyond its range.
bool subnormal(float x) {
    return std::fpclassify(x) == FP_SUBNORMAL;
}

// A texel that the next frame can go on with; its depth may be +infinity, the background.
bool safe(const glm::vec4& texel) {
    return texel.x >= 0.0F && texel.x <= 1.0F && texel.y >= 0.0F && texel.y <= sequence.weight_max &&
           texel.z >= 0.0F && texel.z < static_cast<float>(sequence.table_size) && texel.w > 0.0F;
}

using OneFrame = judge::Function<glm::vec4(glm::vec4, float, Sequence)>;

// Each channel of a good history made bad; one frame.
void poison_texels(const Context& context, const OneFrame& frame) {
    const glm::vec4 fresh = frame(empty, 0.25F, sequence);
    double unsafe = 0;
    double not_fresh = 0;
    for (const float bad : bad_values) {
        for (int channel = 0; channel < 4; ++channel) {
            glm::vec4 texel = good;
            texel[channel] = bad;
            const glm::vec4 after = frame(texel, 0.25F, sequence);
            unsafe += safe(after) ? 0 : 1;
            const bool remembers = reference::gloam_history_unpack(glm::dvec4(texel)).weight > 0.0;
            not_fresh += remembers || subnormal(bad) || after == fresh ? 0 : 1;
        }
    }
    const char* const varied = "history texel, one channel";
    context.add(varied, "unsafe after one frame", unsafe, 0.0);
    context.add(varied, "not healed (a fresh start) after one frame", not_fresh, 0.0);
}

// Bad contributions: NaN and infinities leave the history as it is, others count as the nearer end of [0, 1].
void poison_contributions(const Context& context, const OneFrame& frame) {
    double unsafe = 0;
    double wrong = 0;
    for (const float bad : bad_values) {
        const glm::vec4 after = frame(good, bad, sequence);
        const float expected =
            std::isfinite(bad) ? frame(good, glm::clamp(bad, 0.0F, 1.0F), sequence).x : good.x;
        unsafe += safe(after) ? 0 : 1;
        wrong += subnormal(bad) || after.x == expected ? 0 : 1;
    }
    const char* const varied = "contribution of one frame";
    context.add(varied, "unsafe after one frame", unsafe, 0.0);
    context.add(varied, "damage other than stated", wrong, 0.0);
}

// Frames until a history that is plausible but wrong (occlusion 1, full weight) is right within 1/255.
void heal(const Context& context, const Accumulate& accumulate, unsigned k, float weight_max) {
    const double stated = std::ceil(std::log(255.0) / -std::log1p(-1.0 * k / (double{weight_max} + k)));
    unsigned low = 0;
    unsigned high = 60'000;
    while (high - low > 1) {
        const unsigned middle = (low + high) / 2;
        const Sequence all{.frames = middle, .k = k, .weight_max = weight_max};
        const glm::vec4 texel =
            std::get<0>(accumulate(glm::vec4(1.0F, weight_max, 0.0F, 3.0F), all, no_range));
        (std::abs(double{texel.x} - contribution(all, 0)) < 1.0 / 255.0 ? high : low) = middle;
    }
    context.add(fmt::format("wrong but plausible history, k {}, w_max {}", k, weight_max),
                "frames until right within 1/255", static_cast<double>(high), stated);
}

}  // namespace

void poisoned_history(const Context& context) {
    context.progress("history");
    const OneFrame frame(context.lab, accumulate_file, "stress_frame");
    const Accumulate accumulate(context.lab, accumulate_file, "stress_accumulate");
    poison_texels(context, frame);
    poison_contributions(context, frame);
    heal(context, accumulate, 32, 500.0F);
    heal(context, accumulate, 8, 1500.0F);
}

}  // namespace gloam::stress
