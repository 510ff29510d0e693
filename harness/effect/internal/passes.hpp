// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "effect/internal/tiles.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "gpu/compute.hpp"
#include "scene/camera.hpp"
#include "scene/encoding.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

constexpr std::uint32_t tile_side = 8;
constexpr std::uint32_t filter_tiles = 8;  // tiles of one group of the filter, as in tiles/list.glsl

// A size and a choice as shaders take them.
[[nodiscard]] inline glm::ivec2 vector_of_size(gpu::Extent extent) {
    return {static_cast<int>(extent.width), static_cast<int>(extent.height)};
}
[[nodiscard]] inline std::uint32_t flag(bool value) {
    return value ? 1U : 0U;
}

// Push constants, with the layout that each pass declares.
struct NormalParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    std::uint32_t orthographic;
};

// Of take_inputs.comp.
struct InputParameters {
    glm::mat3x4 view_from_world;
    glm::vec2 p22_p32;
    glm::ivec2 size;
};

struct OcclusionParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    glm::ivec2 border;
    float radius;
    float bias;
    float c_spatial;
    float weight_max;
    float c_rot;
    float least_radius;
    std::uint32_t shade_border;
    std::uint32_t skip_background;
    std::uint32_t invalidation;
    float change_tolerance;
    float weight_small;
    float confidence_factor;
    std::uint32_t still;
    std::uint32_t freeze;
    float samples_distance;
    float samples_radius;
    std::uint32_t samples_least;
    float radius_cap;
    float smoothing;
    float c_filter;
    float bias_depth;
    float displacement_unit;
};

struct ReprojectionParameters {
    glm::mat4 previous_from_current;
    glm::vec2 p00_p11;
    glm::vec2 previous_p00_p11;
    glm::ivec2 size;
    float tolerance;
    float displacement_unit;
};

struct FilterParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    float sigma_pixels;
    float depth_scale;
    float c_adaptive;
    float weight_max;
    float cap;
};

struct RemapParameters {
    glm::ivec2 size;
    float a;
    float b;
    float c;
};

// Of further_view.comp.
struct FurtherViewParameters {
    glm::mat4 other_from_this;
    glm::vec2 p00_p11;
    glm::vec2 other_p00_p11;
    glm::ivec2 size;
    glm::ivec2 other_size;
    float radius;
    float bias;
    float bias_depth;
    float remap_a;
    float remap_b;
    float remap_c;
};

// Of the passes that include directional/points.glsl.
struct DirectionalParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    float radius;
    float bias;
    std::uint32_t samples;
    std::uint32_t orthographic;
    glm::mat3x4 world_from_view;
};

// The buffer of the passes that include directional/history.glsl, with its layout.
struct LightHistory {
    glm::mat4 previous_from_current{1.0F};
    glm::vec2 previous_p00_p11{1.0F};
    std::uint32_t kept = 0;
    std::uint32_t objects_move = 0;
    std::uint32_t previous_orthographic = 0;
    std::uint32_t first_sample = 0;
    float weight_max = 1.0F;
    float depth_tolerance = 0.0F;
    std::uint32_t invalidation = 0;
    float change_tolerance = 0.0F;
    float weight_small = 0.0F;
    float confidence_factor = 0.0F;
};

// The part of a view that is the same in all of its frames.
struct View {
    scene::CameraFrame camera;
    gpu::Extent extent;  // with the guard band
    gpu::Extent border;
};

[[nodiscard]] NormalParameters normal_parameters(const View& view);
[[nodiscard]] InputParameters input_parameters(const View& view);
[[nodiscard]] OcclusionParameters occlusion_parameters(const View& view, const Settings& settings);
[[nodiscard]] ReprojectionParameters reprojection_parameters(const View& view, const View& previous,
                                                             const Settings& settings);
[[nodiscard]] FilterParameters filter_parameters(const View& view, const Settings& settings);

[[nodiscard]] RemapParameters remap_parameters(const View& view, const Settings& settings);

// What the pipeline of the occlusion pass is compiled for.
struct Program {
    std::string method;
    HistoryPrecision precision = HistoryPrecision::float32;
    bool moving_objects = false;
    std::uint32_t layers = 1;
    bool reject_taps = false;
    bool listed = false;  // runs over a list of tiles
    TileLists list = TileLists::shaded;
    bool shows = false;  // a filter over lists of tiles follows
    bool sample_table = false;
    std::uint32_t table_size = 0;
    bool fewer_samples = false;  // with distance or with small projected radius
    bool caps_radius = false;
    bool smooths = false;
    bool skip_closed = false;
    bool keeps_history = true;
    bool shows_alone = false;
    std::uint32_t samples = 0;
    std::uint32_t samples_converged = 0;
    std::uint32_t steps = 0;
    bool orthographic = false;

    friend auto operator<=>(const Program&, const Program&) = default;
};

// Precision of the history that is bound: of an image in its place where there is none.
[[nodiscard]] HistoryPrecision bound_precision(const Settings& settings);

// The members that the settings determine; the others keep their defaults.
[[nodiscard]] Program program_for(const Settings& settings);

// What the pipeline of the reprojection pass is compiled for.
struct ReprojectionProgram {
    HistoryPrecision precision = HistoryPrecision::float32;
    bool moving_objects = false;
    bool listed = false;  // runs over the shaded tiles
    HistoryTaps taps = HistoryTaps::validated;
    bool nearest_index = true;
    bool orthographic = false;
    bool previous_orthographic = false;
    bool keeps_displacement = false;

    friend auto operator<=>(const ReprojectionProgram&, const ReprojectionProgram&) = default;
};

// What the pipeline of a filter's pass along one axis is compiled for.
struct FilterProgram {
    Filter filter = Filter::convergence;
    HistoryPrecision precision = HistoryPrecision::float32;
    int half_width = 2;
    bool along_y = false;
    bool orthographic = false;
    std::optional<TileLists> list;  // of the tiles that it runs on; none: the whole image

    friend auto operator<=>(const FilterProgram&, const FilterProgram&) = default;
};

// The members that the settings determine, and `list`.
[[nodiscard]] FilterProgram filter_program_for(const Settings& settings, std::optional<TileLists> list);

// What the pipeline of the pass over an engine's depth and normals is compiled for.
struct InputProgram {
    scene::Encoding encoding;
    bool orthographic = false;
    bool has_normals = true;

    friend auto operator<=>(const InputProgram&, const InputProgram&) = default;
};

// Preprocessor definitions of a pass that reads or writes a history.
[[nodiscard]] std::vector<std::string> defines_for(HistoryPrecision precision);
// The same for a pass that also reads or writes a prepared image of this format.
[[nodiscard]] std::vector<std::string> defines_for(HistoryPrecision precision, gpu::Format prepared);

// How passes count the work of their tiles (tiles/tally.glsl).
enum class Counting : std::uint32_t { none, each_invocation, each_group };

// The shaders of the passes, with their definitions and constants. `counts`: how the passes count on their
// device. `open_tiles_each`: open tiles of one group.
[[nodiscard]] PassSource normals_source();
[[nodiscard]] PassSource input_source(const InputProgram& program);
[[nodiscard]] PassSource occlusion_source(const Program& program, Counting counts,
                                          std::uint32_t open_tiles_each);
[[nodiscard]] PassSource further_view_source(const Program& program, bool other_orthographic);
[[nodiscard]] PassSource reprojection_source(const ReprojectionProgram& program);
[[nodiscard]] PassSource filter_source(const FilterProgram& program);
[[nodiscard]] PassSource remap_source(std::optional<HistoryPrecision> history, std::optional<TileLists> list,
                                      OutputFormat output = OutputFormat::r32f);
[[nodiscard]] PassSource selection_source(std::uint32_t open_tiles_each);

// Whether the device is a driver on the CPU.
[[nodiscard]] bool runs_on_cpu(const gpu::Device& device);

// Compiles a pass to a pipeline with these bindings. sampled_image: an image that the pass only reads; on
// some devices that becomes a storage image (scene::Inputs).
[[nodiscard]] gpu::ComputePipeline pipeline_of(const gpu::Device& device, const scene::PassLibrary& library,
                                               const PassSource& source,
                                               std::vector<gpu::BindingKind> bindings,
                                               std::size_t push_constant_bytes);

// The pipelines of glsl/passes.
[[nodiscard]] gpu::ComputePipeline normals_from_depth(const gpu::Device& device,
                                                      const scene::PassLibrary& library);
[[nodiscard]] gpu::ComputePipeline take_inputs(const gpu::Device& device, const scene::PassLibrary& library,
                                               const InputProgram& program);
[[nodiscard]] gpu::ComputePipeline ambient_occlusion(const gpu::Device& device,
                                                     const scene::PassLibrary& library,
                                                     const Program& program);  // counts its work
[[nodiscard]] gpu::ComputePipeline reproject(const gpu::Device& device, const scene::PassLibrary& library,
                                             const ReprojectionProgram& program);
// `filter`: throws std::invalid_argument for Filter::none.
[[nodiscard]] gpu::ComputePipeline spatial_filter(const gpu::Device& device,
                                                  const scene::PassLibrary& library,
                                                  const FilterProgram& program);

// `history`: precision of the history that the pass reads; none: it reads the filter's result. `list`: the
// list of tiles on which it runs; none: the whole image.
[[nodiscard]] gpu::ComputePipeline remap(const gpu::Device& device, const scene::PassLibrary& library,
                                         std::optional<HistoryPrecision> history,
                                         std::optional<TileLists> list, OutputFormat output);

// Passes that select the tiles for the others.
[[nodiscard]] gpu::ComputePipeline select_tiles(const gpu::Device& device, const scene::PassLibrary& library);
[[nodiscard]] gpu::ComputePipeline bound_tiles(const gpu::Device& device, const scene::PassLibrary& library);
[[nodiscard]] gpu::ComputePipeline merge_bounds(const gpu::Device& device, const scene::PassLibrary& library);
[[nodiscard]] gpu::ComputePipeline open_tiles(const gpu::Device& device, const scene::PassLibrary& library);
[[nodiscard]] gpu::ComputePipeline select_filtered_tiles(const gpu::Device& device,
                                                         const scene::PassLibrary& library);

// Groups of 8 x 8 invocations that cover an image.
[[nodiscard]] std::array<std::uint32_t, 3> groups_for(gpu::Extent extent);

// Groups of the filter that cover an image, each of filter_tiles tiles along x.
[[nodiscard]] std::array<std::uint32_t, 3> filter_groups_for(gpu::Extent extent);

}  // namespace gloam::effect
