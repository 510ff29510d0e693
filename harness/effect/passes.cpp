// SPDX-License-Identifier: MIT
#include "effect/internal/passes.hpp"

#include <fmt/format.h>

#include <cctype>
#include <limits>
#include <stdexcept>
#include <utility>

#include "effect/internal/sample_table.hpp"
#include "effect/methods.hpp"
#include "effect/preparation.hpp"
#include "effect/setting_table.hpp"

namespace gloam::effect {
namespace {

using enum gpu::BindingKind;

std::string method_include(const std::string& method) {
    return "gloam/methods/" + method + ".glsl";
}

std::string upper_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

std::string filter_include(Filter filter) {
    if (filter == Filter::none) throw std::invalid_argument("no filter has no pass");
    Settings settings;
    settings.filter = filter;
    return "filters/" + std::get<std::string>(setting_named("filter").get(settings)) + ".glsl";
}

constexpr std::uint32_t listed_constant = 10;
constexpr std::uint32_t list_constant = 11;
constexpr std::uint32_t open_tiles_constant = 13;

// Constants of a pass that runs over a list of tiles, or over the whole image.
std::vector<gpu::SpecializationConstant> constants_of(std::optional<TileLists> list) {
    return {{.id = listed_constant, .bits = flag(list.has_value())},
            {.id = list_constant, .bits = static_cast<std::uint32_t>(list.value_or(TileLists::shaded))}};
}

// How ambient_occlusion.comp counts on a device. The buffers of counts are in the CPU's memory.
Counting counting_on(const gpu::Device& device) {
    return runs_on_cpu(device) ? Counting::each_invocation : Counting::each_group;
}

// Open tiles of one group. A CPU runs a group's invocations one after another; fewer invocations have less
// cost of their own.
std::uint32_t open_tiles_each_on(const gpu::Device& device) {
    return runs_on_cpu(device) ? 8U : 1U;
}

// Whether the loops over samples have a length that is a constant, and so few rounds that their code stays
// small. Points that each sample computes itself have loops of their own.
bool has_short_loops(const Program& program) {
    constexpr std::uint32_t few = 32;
    return program.samples == program.samples_converged && program.samples <= few && !program.fewer_samples &&
           program.sample_table;
}

// To what a displacement is rounded: so little that rounding two of them stays far below what counts as a
// change.
float displacement_unit(const Settings& settings) {
    return settings.change_tolerance / 32.0F;
}

// Convergence from which the filter leaves a pixel unchanged; infinite if it changes all.
float c_filter(const Settings& settings) {
    const bool leaves = settings.skip_filtered && settings.filter == Filter::convergence;
    return leaves ? settings.c_adaptive : std::numeric_limits<float>::infinity();
}

}  // namespace

HistoryPrecision bound_precision(const Settings& settings) {
    return shows_alone(settings) ? HistoryPrecision::float32 : settings.precision;
}

Program program_for(const Settings& settings) {
    return {.method = settings.method,
            .precision = bound_precision(settings),
            .layers = settings.layers,
            .reject_taps = settings.reject_taps,
            .sample_table = tabulates_samples(settings),
            .table_size = settings.table_size,
            .fewer_samples = settings.samples_distance > 0.0F || settings.samples_radius > 0.0F,
            .caps_radius = no_radius_cap > settings.radius_cap,
            .smooths = settings.smoothing > 0.0F,
            .skip_closed = settings.skip_closed && method_named(settings.method).ends_marches,
            .keeps_history = settings.history,
            .shows_alone = shows_alone(settings),
            .samples = settings.samples,
            .samples_converged = settings.samples_converged,
            .steps = settings.own.steps};
}

FilterProgram filter_program_for(const Settings& settings, std::optional<TileLists> list) {
    return {.filter = settings.filter,
            .precision = settings.precision,
            .half_width = settings.filter_half_width,
            .list = list};
}

std::vector<std::string> defines_for(HistoryPrecision precision) {
    switch (precision) {
        case HistoryPrecision::float16:
            return {"GLOAM_HISTORY rgba16f"};
        case HistoryPrecision::packed:
            return {"GLOAM_PACKED_HISTORY"};
        default:
            return {};
    }
}

std::vector<std::string> defines_for(HistoryPrecision precision, gpu::Format prepared) {
    std::vector<std::string> defines = defines_for(precision);
    if (prepared == gpu::Format::r32f) defines.emplace_back("GLOAM_PREPARED r32f");
    return defines;
}

NormalParameters normal_parameters(const View& view) {
    return {view.camera.p00_p11(), vector_of_size(view.extent), flag(view.camera.orthographic())};
}

InputParameters input_parameters(const View& view) {
    return {.view_from_world = glm::mat3x4(glm::mat3(view.camera.view)),
            .p22_p32 = {view.camera.proj_vk[2][2], view.camera.proj_vk[3][2]},
            .size = vector_of_size(view.extent)};
}

OcclusionParameters occlusion_parameters(const View& view, const Settings& settings) {
    return {.p00_p11 = view.camera.p00_p11(),
            .size = vector_of_size(view.extent),
            .border = vector_of_size(view.border),
            .radius = settings.radius,
            .bias = settings.bias,
            .c_spatial = settings.c_spatial,
            .weight_max = settings.weight_max,
            .c_rot = settings.c_rot,
            .least_radius = settings.least_radius,
            .shade_border = flag(settings.guard_history),
            .skip_background = flag(settings.skip_background),
            .invalidation = static_cast<std::uint32_t>(settings.invalidation),
            .change_tolerance = settings.change_tolerance,
            .weight_small = settings.weight_small,
            .confidence_factor = settings.confidence_factor,
            .still = 0,
            .freeze = flag(settings.freeze),
            .samples_distance = settings.samples_distance,
            .samples_radius = settings.samples_radius,
            .samples_least = settings.samples_least,
            .radius_cap = settings.radius_cap,
            .smoothing = settings.smoothing,
            .c_filter = c_filter(settings),
            .bias_depth = settings.bias_depth,
            .displacement_unit = displacement_unit(settings)};
}

ReprojectionParameters reprojection_parameters(const View& view, const View& previous,
                                               const Settings& settings) {
    return {.previous_from_current = view.camera.previous_from_current.value_or(glm::mat4(1.0F)),
            .p00_p11 = view.camera.p00_p11(),
            .previous_p00_p11 = previous.camera.p00_p11(),
            .size = vector_of_size(view.extent),
            .tolerance = settings.depth_tolerance,
            .displacement_unit = displacement_unit(settings)};
}

FilterParameters filter_parameters(const View& view, const Settings& settings) {
    return {.p00_p11 = view.camera.p00_p11(),
            .size = vector_of_size(view.extent),
            .sigma_pixels = 0.25F * static_cast<float>(2 * settings.filter_half_width + 1),
            .depth_scale = settings.filter_depth,
            .c_adaptive = settings.c_adaptive,
            .weight_max = settings.weight_max,
            .cap = settings.filter_cap};
}

RemapParameters remap_parameters(const View& view, const Settings& settings) {
    return {vector_of_size(view.extent), settings.remap_a, settings.remap_b, settings.remap_c};
}

PassSource normals_source() {
    return {.file = "normals_from_depth.comp"};
}

PassSource input_source(const InputProgram& program) {
    const scene::Encoding& encoding = program.encoding;
    return {.file = "take_inputs.comp",
            .constants = {{.id = 0, .bits = flag(encoding.depth_buffer)},
                          {.id = 1, .bits = flag(program.orthographic)},
                          {.id = 2, .bits = flag(encoding.world)},
                          {.id = 3, .bits = flag(encoding.octahedral)},
                          {.id = 4, .bits = flag(encoding.unorm)},
                          {.id = 5, .bits = flag(program.has_normals)}}};
}

PassSource occlusion_source(const Program& program, Counting counts, std::uint32_t open_tiles_each) {
    std::vector<std::string> defines = defines_for(program.precision, prepared_format(program.method));
    const MethodInfo& method = method_named(program.method);
    defines.push_back("METHOD(position, normal, camera, kernel, values) " + call_of(method));
    if (program.sample_table) {
        defines.emplace_back("GLOAM_SAMPLE_TABLE 11");
        defines.push_back(sample_point_of(method.points));
        defines.push_back(fmt::format("GLOAM_SAMPLING_{}_POINT_GLSL", upper_case(method.points)));
    }
    return {.file = "ambient_occlusion.comp",
            .defines = std::move(defines),
            .replaced = {{method_include("hemisphere"), method_include(program.method)}},
            .constants = {{.id = 0, .bits = static_cast<std::uint32_t>(counts)},
                          {.id = 1, .bits = flag(program.moving_objects)},
                          {.id = 2, .bits = program.layers},
                          {.id = 3, .bits = flag(program.reject_taps)},
                          {.id = 4, .bits = flag(program.shows)},
                          {.id = 5, .bits = program.table_size},
                          {.id = 6, .bits = flag(program.fewer_samples)},
                          {.id = 7, .bits = flag(program.caps_radius)},
                          {.id = 8, .bits = flag(program.smooths)},
                          {.id = 9, .bits = flag(program.orthographic)},
                          {.id = 12, .bits = flag(program.skip_closed)},
                          {.id = 14, .bits = flag(program.keeps_history)},
                          {.id = 15, .bits = program.samples},
                          {.id = 16, .bits = program.samples_converged},
                          {.id = 17, .bits = program.steps},
                          {.id = 18, .bits = unit_of(method, program.steps)},
                          {.id = 19, .bits = flag(method.unit == SampleUnit::pair)},
                          {.id = 20, .bits = flag(program.shows_alone)},
                          {.id = listed_constant, .bits = flag(program.listed)},
                          {.id = list_constant, .bits = static_cast<std::uint32_t>(program.list)},
                          {.id = open_tiles_constant, .bits = open_tiles_each}},
            .unrolls = has_short_loops(program)};
}

PassSource further_view_source(const Program& program, bool other_orthographic) {
    const MethodInfo& method = method_named(program.method);
    return {.file = "further_view.comp",
            .defines = {"METHOD(position, normal, camera, kernel, values) " + call_of(method)},
            .replaced = {{method_include("hemisphere"), method_include(program.method)}},
            .constants = {{.id = 0, .bits = flag(program.orthographic)},
                          {.id = 1, .bits = flag(other_orthographic)},
                          {.id = 2, .bits = samples_taken(method, program.samples, program.steps)},
                          {.id = 3, .bits = program.steps},
                          {.id = 4, .bits = flag(program.reject_taps)}}};
}

PassSource reprojection_source(const ReprojectionProgram& program) {
    return {.file = "reproject.comp",
            .defines = defines_for(program.precision),
            .constants = {{.id = 0, .bits = flag(program.moving_objects)},
                          {.id = 1, .bits = static_cast<std::uint32_t>(program.taps)},
                          {.id = 2, .bits = flag(program.nearest_index)},
                          {.id = 3, .bits = flag(program.orthographic)},
                          {.id = 4, .bits = flag(program.previous_orthographic)},
                          {.id = 5, .bits = flag(program.keeps_displacement)},
                          {.id = listed_constant, .bits = flag(program.listed)}}};
}

PassSource filter_source(const FilterProgram& program) {
    PassSource source{.file = "spatial_filter.comp",
                      .defines = defines_for(program.precision),
                      .replaced = {{filter_include(Filter::convergence), filter_include(program.filter)}},
                      .constants = constants_of(program.list)};
    source.defines.push_back(fmt::format("GLOAM_HALF_WIDTH {}", program.half_width));
    source.constants.push_back({.id = 0, .bits = flag(program.along_y)});
    source.constants.push_back({.id = 1, .bits = flag(program.orthographic)});
    return source;
}

PassSource remap_source(std::optional<HistoryPrecision> history, std::optional<TileLists> list,
                        OutputFormat output) {
    PassSource source{
        .file = "remap.comp",
        .defines = history ? defines_for(*history) : std::vector<std::string>{"GLOAM_SOURCE r32f"},
        .constants = constants_of(list)};
    if (output != OutputFormat::r32f)
        source.defines.emplace_back(output == OutputFormat::r8 ? "GLOAM_OUTPUT r8" : "GLOAM_OUTPUT r16f");
    return source;
}

PassSource selection_source(std::uint32_t open_tiles_each) {
    return {.file = "tiles/select.comp", .constants = {{.id = open_tiles_constant, .bits = open_tiles_each}}};
}

gpu::ComputePipeline normals_from_depth(const gpu::Device& device, const scene::PassLibrary& library) {
    return pipeline_of(device, library, normals_source(), {sampled_image, storage_image},
                       sizeof(NormalParameters));
}

gpu::ComputePipeline take_inputs(const gpu::Device& device, const scene::PassLibrary& library,
                                 const InputProgram& program) {
    return pipeline_of(device, library, input_source(program),
                       {sampled_image, sampled_image, storage_image, storage_image}, sizeof(InputParameters));
}

gpu::ComputePipeline ambient_occlusion(const gpu::Device& device, const scene::PassLibrary& library,
                                       const Program& program) {
    return pipeline_of(
        device, library, occlusion_source(program, counting_on(device), open_tiles_each_on(device)),
        {sampled_image, sampled_image, sampled_image, storage_image, storage_buffer, sampled_image,
         storage_buffer, sampled_image, sampled_image, storage_buffer, storage_image, sampled_image},
        sizeof(OcclusionParameters));
}

gpu::ComputePipeline reproject(const gpu::Device& device, const scene::PassLibrary& library,
                               const ReprojectionProgram& program) {
    return pipeline_of(
        device, library, reprojection_source(program),
        {sampled_image, sampled_image, sampled_image, storage_image, storage_buffer, storage_image},
        sizeof(ReprojectionParameters));
}

gpu::ComputePipeline spatial_filter(const gpu::Device& device, const scene::PassLibrary& library,
                                    const FilterProgram& program) {
    return pipeline_of(
        device, library, filter_source(program),
        {sampled_image, sampled_image, storage_image, sampled_image, storage_buffer, sampled_image},
        sizeof(FilterParameters));
}

gpu::ComputePipeline remap(const gpu::Device& device, const scene::PassLibrary& library,
                           std::optional<HistoryPrecision> history, std::optional<TileLists> list,
                           OutputFormat output) {
    return pipeline_of(device, library, remap_source(history, list, output),
                       {sampled_image, sampled_image, storage_image, storage_buffer},
                       sizeof(RemapParameters));
}

gpu::ComputePipeline select_tiles(const gpu::Device& device, const scene::PassLibrary& library) {
    return pipeline_of(device, library, selection_source(open_tiles_each_on(device)),
                       {sampled_image, storage_buffer, storage_buffer, storage_buffer, storage_buffer},
                       sizeof(SelectParameters));
}

gpu::ComputePipeline bound_tiles(const gpu::Device& device, const scene::PassLibrary& library) {
    return pipeline_of(device, library, {.file = "tiles/bound.comp"}, {sampled_image, storage_buffer},
                       sizeof(BoundParameters));
}

gpu::ComputePipeline merge_bounds(const gpu::Device& device, const scene::PassLibrary& library) {
    return pipeline_of(device, library, {.file = "tiles/merge_bounds.comp"}, {storage_buffer},
                       sizeof(MergeParameters));
}

gpu::ComputePipeline open_tiles(const gpu::Device& device, const scene::PassLibrary& library) {
    return pipeline_of(device, library, {.file = "tiles/open.comp"},
                       {sampled_image, sampled_image, storage_buffer, storage_buffer},
                       sizeof(OpenParameters));
}

gpu::ComputePipeline select_filtered_tiles(const gpu::Device& device, const scene::PassLibrary& library) {
    return pipeline_of(device, library, {.file = "tiles/select_filtered.comp"},
                       {storage_buffer, storage_buffer}, sizeof(SelectFilteredParameters));
}

std::array<std::uint32_t, 3> groups_for(gpu::Extent extent) {
    const auto groups = [](std::uint32_t side) { return (side + tile_side - 1) / tile_side; };
    return {groups(extent.width), groups(extent.height), 1};
}

std::array<std::uint32_t, 3> filter_groups_for(gpu::Extent extent) {
    const auto [columns, rows, layers] = groups_for(extent);
    return {(columns + filter_tiles - 1) / filter_tiles, rows, layers};
}

}  // namespace gloam::effect
