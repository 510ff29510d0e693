// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "gpu/compute.hpp"
#include "gpu/image.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// What a pass is compiled from, whatever the device.
struct PassSource {
    std::string file;  // in glsl/passes
    std::vector<std::string> defines;
    std::vector<scene::PassLibrary::Replacement> replaced;
    std::vector<gpu::SpecializationConstant> constants;
};

// An image that passes read or write.
struct PlannedImage {
    enum class Origin {
        engine,   // written before the passes, each frame
        history,  // kept from frame to frame; zeros where there is none
        once,     // written by passes of Turn::once
        frame     // written by the passes, each frame
    };
    std::string name;
    std::string meaning;
    gpu::Format format = gpu::Format::rgba32f;
    Origin origin = Origin::frame;
    gpu::Extent extent;  // for the view of the plan
    std::uint32_t divisor =
        1;  // of the view's sides, rounded up; 0: it has that extent for any view, or only for this one
};

struct PlannedBuffer {
    std::string name;
    std::string meaning;
    std::size_t bytes = 0;            // for the view of the plan
    std::size_t bytes_a_tile = 0;     // of them, for each tile of 8 x 8 pixels
    std::vector<std::byte> contents;  // at its beginning; the rest is zeros
    bool refilled = false;            // before each frame, not at the beginning alone
};

// When a pass runs.
enum class Turn {
    once,   // before the first frame
    moved,  // in frames whose view is not that of the last frame
    always
};

struct PlannedPass {
    std::string name;  // as Frame::times has it
    PassSource source;
    Turn turn = Turn::always;
    std::vector<std::string> resources;  // at binding 0, 1, ...: names of images and buffers
    // Push constants, and those of every second frame, in which the pairs of `exchanged` are swapped.
    std::vector<std::byte> parameters;
    std::vector<std::byte> odd_parameters;
    std::vector<bool> of_view;              // for each of their bytes: it is the view's, not the settings'
    std::array<std::uint32_t, 2> pixels{};  // of the view that a group takes, along x and y
    std::array<std::uint32_t, 3> groups{};  // where `pixels` is 0
    std::optional<std::size_t> list;        // instead: an indirect dispatch in the buffer tile_lists, bytes
};

// Bound where the settings need no image or buffer.
inline constexpr const char* nothing_image = "nothing";
inline constexpr const char* nothing_buffer = "no_buffer";

// The passes of a frame, in their order, with all they need.
struct Plan {
    std::vector<PlannedImage> images;
    std::vector<PlannedBuffer> buffers;
    std::vector<PlannedPass> passes;
    // Which two are exchanged after each frame.
    std::vector<std::array<std::string, 2>> exchanged;
    std::string result;        // image whose first channel is the occlusion
    float result_unit = 1.0F;  // occlusion of 1 of it
};

struct PlanOptions {
    gpu::Extent view{1920, 1080};
    bool moving_objects = false;  // the engine gives the previous positions of surface points
    bool orthographic = false;
    bool tiles = false;   // passes run over lists of tiles (docs/skips.md); else over the whole image
    bool normals = true;  // the engine has them; else they are made from depth
};

// How the effect of these settings runs. Throws std::invalid_argument like validate().
[[nodiscard]] Plan plan_of(const Settings& settings, const PlanOptions& options);

}  // namespace gloam::effect
