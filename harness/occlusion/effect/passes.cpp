// SPDX-License-Identifier: MIT
#include "effect/internal/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "effect/methods.hpp"
#include "effect/settings.hpp"

namespace gloam::effect {
namespace {

// The pass's method in the place of the one that its source names.
PassSource with_method_in(PassSource source, const MethodInfo& method) {
    source.defines.push_back("METHOD(position, normal, camera, kernel, values) " + call_of(method));
    source.replaced = {{file_of(methods().front()), file_of(method)}};
    return source;
}

std::string filter_include(Filter filter) {
    if (filter == Filter::none) throw std::invalid_argument("no filter has no pass");
    Settings settings;
    settings.filter = filter;
    return "filters/" + std::get<std::string>(setting_named("filter").get(settings)) + ".glsl";
}

// Preprocessor definitions of a pass that reads or writes the prepared image.
std::vector<std::string> defines_for(const Moment& moment) {
    if (moment.preparation && moment.preparation->format == gpu::Format::r32f) return {"GLOAM_PREPARED r32f"};
    return {};
}

}  // namespace

void define_output(OutputFormat output, std::vector<std::string>& defines) {
    if (output != OutputFormat::r32f)
        defines.emplace_back(output == OutputFormat::r8 ? "GLOAM_OUTPUT r8" : "GLOAM_OUTPUT r16f");
}

namespace {

bool takes_fewer_samples(const Settings& settings) {
    return settings.samples_distance > 0.0F || settings.samples_radius > 0.0F;
}

}  // namespace

gpu::Extent half_of(gpu::Extent extent) {
    return {(extent.width + 1) / 2, (extent.height + 1) / 2};
}

std::optional<Preparation> preparation_of(const Settings& settings, gpu::Extent view) {
    const MethodInfo& method = method_named(settings.method);
    if (method.prepare == nullptr) return std::nullopt;
    return method.prepare(settings, view);
}

void Moment::look(const View& now, const View& last) {
    view = now;
    before = last;
    preparation = preparation_of(settings, view.extent);
}

PassSource input_source(const Moment& moment) {
    const scene::Encoding encoding = moment.converted.value_or(scene::Encoding{});
    return {.file = "take_inputs.comp",
            .constants = {{.id = 0, .bits = flag(encoding.depth_buffer)},
                          {.id = 1, .bits = flag(moment.view.camera.orthographic())},
                          {.id = 2, .bits = flag(encoding.world)},
                          {.id = 3, .bits = flag(encoding.octahedral)},
                          {.id = 4, .bits = flag(encoding.unorm)},
                          {.id = 5, .bits = flag(moment.has_normals)}}};
}

PassSource occlusion_source(const Moment& moment) {
    const Settings& settings = moment.settings;
    const MethodInfo& method = method_named(settings.method);
    PassSource source =
        with_method_in({.file = "ambient_occlusion.comp", .defines = defines_for(moment)}, method);
    source.constants = {{.id = 1, .bits = flag(moment.watches())},
                        {.id = 2, .bits = static_cast<std::uint32_t>(settings.own.layers)},
                        {.id = 3, .bits = flag(settings.reject_taps)},
                        {.id = 5, .bits = settings.table_size},
                        {.id = 6, .bits = flag(takes_fewer_samples(settings))},
                        {.id = 7, .bits = flag(no_radius_cap > settings.radius_cap)},
                        {.id = 8, .bits = flag(settings.smoothing > 0.0F)},
                        {.id = 9, .bits = flag(moment.view.camera.orthographic())},
                        {.id = 14, .bits = flag(settings.history)},
                        {.id = 15, .bits = settings.samples},
                        {.id = 16, .bits = settings.samples_converged},
                        {.id = 17, .bits = settings.own.steps},
                        {.id = 18, .bits = unit_of(method, settings.own.steps)},
                        {.id = 19, .bits = flag(method.unit == SampleUnit::pair)},
                        {.id = 20, .bits = flag(shows_alone(settings))},
                        {.id = 21, .bits = flag(settings.rotation == Rotation::lattice)}};
    return source;
}

PassSource reprojection_source(const Moment& moment) {
    const Settings& settings = moment.settings;
    return {.file = "reproject.comp",
            .constants = {{.id = 0, .bits = flag(moment.has_positions)},
                          {.id = 1, .bits = static_cast<std::uint32_t>(settings.taps)},
                          {.id = 3, .bits = flag(moment.view.camera.orthographic())},
                          {.id = 4, .bits = flag(moment.before.camera.orthographic())}}};
}

PassSource filter_source(const Moment& moment, bool along_y) {
    const Settings& settings = moment.settings;
    return {.file = "spatial_filter.comp",
            .replaced = {{filter_include(Filter::convergence), filter_include(settings.filter)}},
            .constants = {{.id = 0, .bits = flag(along_y)},
                          {.id = 1, .bits = flag(moment.view.camera.orthographic())},
                          {.id = 2, .bits = static_cast<std::uint32_t>(settings.filter_half_width)}}};
}

PassSource directional_source(const std::string& name, std::uint32_t interleave) {
    PassSource source{.file = name + ".comp"};
    if (interleave > 0) source.constants.push_back({.id = 0, .bits = interleave});
    return source;
}

PassSource motion_source(const View& view, const View& before) {
    return {.file = "positions_from_motion.comp",
            .constants = {{.id = 0, .bits = flag(view.camera.orthographic())},
                          {.id = 1, .bits = flag(before.camera.orthographic())}}};
}

PassSource remap_source(const Settings& settings, bool from_history) {
    PassSource source{.file = "remap.comp"};
    if (!from_history) source.defines.emplace_back("GLOAM_SOURCE r32f");
    define_output(settings.output, source.defines);
    return source;
}

PassSource preparation_source(const Moment& moment, const std::string& file) {
    const Settings& settings = moment.settings;
    return {.file = "preparation/" + file,
            .defines = defines_for(moment),
            .constants = {{.id = 0, .bits = static_cast<std::uint32_t>(settings.own.layers)},
                          {.id = 1, .bits = flag(settings.reject_taps)},
                          {.id = 2, .bits = flag(settings.history)},
                          {.id = 3, .bits = settings.samples},
                          {.id = 4, .bits = settings.samples_converged},
                          {.id = 5, .bits = settings.own.steps},
                          {.id = 6, .bits = flag(settings.rotation == Rotation::lattice)}}};
}

std::array<std::uint32_t, 3> groups_for(gpu::Extent extent) {
    const auto groups = [](std::uint32_t side) { return (side + tile_side - 1) / tile_side; };
    return {groups(extent.width), groups(extent.height), 1};
}

}  // namespace gloam::effect
