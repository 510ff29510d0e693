// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/plan.hpp"

namespace gloam::effect {

// Compiles a pass to a pipeline with the bindings and the push constants of its module. Images that it only
// reads are sampled or storage images, as the library says. kinds: of bindings that its shader declares and
// does not use, by number; empty where it uses all.
[[nodiscard]] backend::vulkan::ComputePipeline pipeline_of(
    const backend::vulkan::Device& device, const scene::PassLibrary& library, const PassSource& source,
    std::vector<backend::vulkan::BindingKind> kinds = {});

// A pass that is ready to be recorded. The objects that it refers to must live until it has run.
struct Step {
    std::string name;
    const backend::vulkan::ComputePipeline* pipeline = nullptr;
    std::vector<backend::vulkan::Resource> resources;
    std::span<const std::byte> parameters;
    std::array<std::uint32_t, 3> groups{};
    const backend::vulkan::Buffer* groups_from = nullptr;  // has them
    std::uint32_t groups_at = 0;                           // behind so many bytes
};

template <class Parameters>
std::span<const std::byte> bytes_of(const Parameters& parameters) {
    return std::as_bytes(std::span(&parameters, 1));
}

// Runs the passes in order, `repeat` times. Returns the median time of each pass, NaN with a watcher. Throws
// like backend::vulkan::Commands::submit().
[[nodiscard]] std::vector<PassTime> run(const backend::vulkan::Device& device, std::span<const Step> passes,
                                        int repeat, const PassWatcher& watcher = {});

// One channel of an image of four: element `which` of each texel.
[[nodiscard]] std::vector<float> channel(std::span<const float> texels, std::size_t which);

// The texels (x, y, z, 0) of an image of four channels, and back.
using scene::vectors_of;
[[nodiscard]] std::vector<float> texels_of(std::span<const glm::vec3> vectors);

// Bytes of all images and buffers that the passes use, each counted once.
[[nodiscard]] std::uint64_t memory_of(std::span<const Step> passes);

}  // namespace gloam::effect
