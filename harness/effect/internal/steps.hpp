// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/pass_watcher.hpp"
#include "gpu/compute.hpp"

namespace gloam::effect {

// A pass, ready to be recorded. What it names must live until it has run.
struct Step {
    std::string name;
    const gpu::ComputePipeline* pipeline = nullptr;
    std::vector<gpu::Resource> resources;
    std::span<const std::byte> parameters;
    std::array<std::uint32_t, 3> groups{};  // 0: as many as the image takes
    const gpu::Buffer* indirect = nullptr;  // where the device finds the groups instead, if anywhere
    std::size_t offset = 0;                 // bytes
};

template <class Parameters>
std::span<const std::byte> bytes_of(const Parameters& parameters) {
    return std::as_bytes(std::span(&parameters, 1));
}

// Runs the passes in order, `repeat` times, each time after `before_each`, each over its own groups or
// `groups`; returns the median time of each, NaN with a watcher. Throws like gpu::Commands::submit().
[[nodiscard]] std::vector<PassTime> run(const gpu::Device& device, std::span<const Step> passes,
                                        const std::array<std::uint32_t, 3>& groups, int repeat,
                                        const std::function<void()>& before_each = {},
                                        const PassWatcher& watcher = {});

// Bytes of all images and buffers that the passes are given, each counted once.
[[nodiscard]] std::uint64_t memory_of(std::span<const Step> passes);

}  // namespace gloam::effect
