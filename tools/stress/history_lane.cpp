// SPDX-License-Identifier: MIT
#include "stress/history_lane.hpp"

#include <algorithm>
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

}  // namespace gloam::stress
