// SPDX-License-Identifier: MIT
#include "stress/long_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gloam::stress {
namespace {

constexpr double one = 16'777'216.0;

std::uint32_t hash(std::uint32_t x) {
    x = (x ^ (x >> 16U)) * 0x7FEB352DU;
    x = (x ^ (x >> 15U)) * 0x846CA68BU;
    return x ^ (x >> 16U);
}

}  // namespace

double contribution(const Sequence& sequence, std::uint64_t frame) {
    const auto number = static_cast<std::uint32_t>(frame);
    const std::uint32_t random = hash(number ^ (sequence.seed * 0x9E3779B9U));
    switch (sequence.pattern) {
        case third:
            return 5'592'405.0 / one;
        case alternating:
            return number & 1U;
        case jumping:
            return (number >> 12U) & 1U;
        case noise:
            return (random >> 8U) / one;
        default:
            return random < 0x08000000U ? 1.0 : 0.0;
    }
}

void HistoryLane::advance(unsigned frames) {
    const double k = sequence.k;
    const double cap = double{sequence.weight_max};
    for (unsigned i = 0; i < frames; ++i) {
        const double fresh = contribution(sequence, std::uint64_t{sequence.first} + i);
        mean = (weight * mean + k * fresh) / (weight + k);
        weight = std::min(weight + k, cap);
    }
    sequence.first += frames;
    samples += std::uint64_t{frames} * sequence.k;
}

void advance(const Accumulate& kernel, std::vector<HistoryLane>& lanes, unsigned frames) {
    std::vector<Accumulate::Inputs> inputs;
    for (HistoryLane& lane : lanes) {
        lane.sequence.frames = frames;
        inputs.emplace_back(lane.texel, lane.sequence, lane.range);
    }
    const std::vector<Accumulate::Output> outputs = kernel(inputs);
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        std::tie(lanes[i].texel, lanes[i].range) = outputs[i];
        lanes[i].advance(frames);
    }
}

namespace {

constexpr const char* long_run_name = "long-run";
constexpr double blend_error = 1e-7;  // of gloam_blend, as its comment states
constexpr unsigned seeds = 3;         // lanes of each pattern

struct Accumulation {
    unsigned k;
    float weight_max;
    unsigned table_size;

    [[nodiscard]] std::string text() const { return fmt::format("k {}, w_max {}", k, weight_max); }
};

const std::vector<Accumulation>& accumulations() {
    static const std::vector<Accumulation> all{
        {32, 500, 65'536},           {8, 1500, 1'500}, {1, 1500, 1U << 24U},
        {16, 8'388'608, 16'777'213}, {1, 1, 7},        {65'536, 8'388'608, 1U << 24U}};
    return all;
}

// What was seen of the lanes of one accumulation.
struct Seen {
    double farthest = 0.0;  // from the exact mean
    double signed_sum = 0.0;
    double readings = 0.0;
    double weight = 0.0;  // difference from the exact one
    double index = 0.0;
    double outside = 0.0;  // how far the occlusion left [0, 1]
};

void look(const HistoryLane& lane, Seen& seen) {
    const double difference = double{lane.texel.x} - lane.mean;
    // Not std::max, which would lose a NaN.
    if (!(std::abs(difference) <= seen.farthest)) seen.farthest = std::abs(difference);
    if (lane.sequence.pattern == noise) {
        seen.signed_sum += difference;
        seen.readings += 1.0;
    }
    const auto index = static_cast<double>(lane.samples % lane.sequence.table_size);
    seen.weight = std::max(seen.weight, std::abs(double{lane.texel.y} - lane.weight));
    seen.index = std::max(seen.index, std::abs(double{lane.texel.z} - index));
    seen.outside = std::max({seen.outside, -double{lane.range.x}, double{lane.range.y} - 1.0});
}

std::vector<HistoryLane> lanes_of(const Accumulation& a, std::uint64_t seed) {
    std::vector<HistoryLane> lanes;
    for (unsigned pattern = 0; pattern < pattern_count; ++pattern) {
        for (unsigned i = 0; i < seeds; ++i) {
            lanes.push_back({.sequence = {.pattern = pattern,
                                          .seed = static_cast<unsigned>(seed) * seeds + i,
                                          .first = 0,
                                          .frames = 0,
                                          .k = a.k,
                                          .table_size = a.table_size,
                                          .weight_max = a.weight_max}});
        }
    }
    return lanes;
}

std::vector<Seen> accumulate(const Context& context) {
    const Accumulate kernel(context.lab, accumulate_file, "stress_accumulate");
    std::vector<HistoryLane> lanes;
    for (const Accumulation& a : accumulations()) {
        const std::vector<HistoryLane> more = lanes_of(a, context.seed);
        lanes.insert(lanes.end(), more.begin(), more.end());
    }
    std::vector<Seen> seen(accumulations().size());
    constexpr std::uint64_t longest = 9'973;  // a prime: readings fall on every phase of the patterns
    const std::uint64_t step = std::clamp<std::uint64_t>(context.frames / 4, 1, longest);
    for (std::uint64_t done = 0; done < context.frames;) {
        const std::uint64_t frames = std::min(step, context.frames - done);
        advance(kernel, lanes, static_cast<unsigned>(frames));
        done += frames;
        for (std::size_t i = 0; i < lanes.size(); ++i) look(lanes[i], seen[i / (pattern_count * seeds)]);
        context.progress(fmt::format("{}: frame {} of {}", long_run_name, done, context.frames));
    }
    return seen;
}

void append_rows(const Accumulation& a, const Seen& seen, Rows& rows) {
    const double bound = blend_error * (double{a.weight_max} + a.k) / a.k;
    const double bias = std::abs(seen.signed_sum) / seen.readings;
    rows.push_back({long_run_name, a.text(), "farthest from the exact mean", seen.farthest, bound});
    rows.push_back({long_run_name, a.text(), "bias under noise", bias, bound});
    rows.push_back({long_run_name, a.text(), "farthest outside [0, 1]", seen.outside, 0.0});
    rows.push_back({long_run_name, a.text(), "weight off, samples", seen.weight, 0.0});
    rows.push_back({long_run_name, a.text(), "index off, samples", seen.index, 0.0});
}

}  // namespace

Rows long_run(const Context& context) {
    Rows rows;
    const std::vector<Seen> seen = accumulate(context);
    for (std::size_t i = 0; i < seen.size(); ++i) append_rows(accumulations()[i], seen[i], rows);
    return rows;
}

}  // namespace gloam::stress
