// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/resources.hpp"
#include "effect/settings.hpp"
#include "scene/camera.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

struct Step;

// Called before a pass runs, by itself, and after: tests of single passes read what its bindings hold
// (internal/steps.hpp).
using PassWatcher = std::function<void(const Step& pass, bool after)>;

// The source of a pass, the same for every device.
struct PassSource {
    std::string file;  // in glsl/passes
    std::vector<std::string> defines;
    std::vector<scene::PassLibrary::Replacement> replaced;
    std::vector<backend::vulkan::SpecializationConstant> constants;
    bool unrolls = false;  // loops have few rounds: drivers are asked to unroll them
};

// An image that passes read or write.
struct PlannedImage {
    enum class Origin {
        engine,   // written before the passes, each frame
        history,  // kept from frame to frame; zeros where there is none
        frame     // written by the passes, each frame
    };
    std::string name;
    backend::vulkan::Format format = backend::vulkan::Format::rgba32f;
    Origin origin = Origin::frame;
    backend::Extent extent;  // for the view of the plan
    std::uint32_t levels = 1;
};

// What a pass names to bind an image: "IMAGE", one level of it, "IMAGE/LEVEL", or "IMAGE/linear", sampled so.
struct ImageName {
    std::string image;
    std::optional<std::uint32_t> level;
    bool linear = false;
};
[[nodiscard]] ImageName image_name_of(const std::string& resource);

struct PlannedBuffer {
    std::string name;
    std::vector<std::byte> contents;
};

struct PlannedPass {
    std::string name;  // as in Frame::times
    PassSource source;
    std::vector<std::string> resources;  // at binding 0, 1, ...: names of images and buffers, or IMAGE/LEVEL
    std::vector<std::byte> parameters;   // push constants
    std::array<std::uint32_t, 3> groups{};  // for the view of the plan
    std::string groups_from;                // buffer that has them, in their place; empty: none
    std::uint32_t groups_at = 0;            // bytes before them
};

// Name of the image that is bound where the settings need none.
inline constexpr const char* nothing_image = "nothing";

// The passes of a frame, in their order, with all resources that they need.
struct Plan {
    std::vector<PlannedImage> images;
    std::vector<PlannedBuffer> buffers;
    std::vector<PlannedPass> passes;
    // Pairs of images that are swapped after each frame.
    std::vector<std::array<std::string, 2>> exchanged;
    std::string result;  // image whose first channel is the occlusion
};

struct PlanOptions {
    backend::Extent view{1920, 1080};
    bool moving_objects = false;  // the engine gives the previous positions of surface points
    bool orthographic = false;
    bool first = false;        // the first frame of AmbientOcclusion
    bool normals = true;       // the engine has normals; otherwise they are reconstructed from depth
    scene::Encoding encoding;  // of the engine's depth and normals
};

// The plan of a frame with these settings. Throws std::invalid_argument like validate(), std::logic_error for
// a constant of a pass that has no value.
[[nodiscard]] Plan plan_of(const Settings& settings, const PlanOptions& options,
                           const scene::PassLibrary& library);

// The module of a pass. storage_inputs: as drivers that run on the CPU get it (scene::Inputs).
[[nodiscard]] module::Spirv module_of(const PassSource& source, const scene::PassLibrary& library,
                                      bool storage_inputs = false);

}  // namespace gloam::effect
