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

// Preprocessor definitions of a pass that reads or writes a history.
std::vector<std::string> defines_for(HistoryPrecision precision) {
    if (precision == HistoryPrecision::packed) return {"GLOAM_PACKED_HISTORY"};
    return {};
}

// The same for a pass that also reads or writes the prepared image.
std::vector<std::string> defines_for(const Moment& moment) {
    std::vector<std::string> defines = defines_for(bound_precision(moment.settings));
    if (moment.preparation && moment.preparation->format == gpu::Format::r32f)
        defines.emplace_back("GLOAM_PREPARED r32f");
    return defines;
}

}  // namespace

void define_output(OutputFormat output, std::vector<std::string>& defines) {
    if (output != OutputFormat::r32f)
        defines.emplace_back(output == OutputFormat::r8 ? "GLOAM_OUTPUT r8" : "GLOAM_OUTPUT r16f");
}

namespace {

// The same for a pass that reads the occlusion, of a history or of one channel, and writes what is displayed.
std::vector<std::string> defines_for(const Settings& settings, bool from_history) {
    std::vector<std::string> defines =
        from_history ? defines_for(settings.precision) : std::vector<std::string>{"GLOAM_SOURCE r32f"};
    define_output(settings.output, defines);
    return defines;
}

bool takes_fewer_samples(const Settings& settings) {
    return settings.samples_distance > 0.0F || settings.samples_radius > 0.0F;
}

std::uint32_t half_side(std::uint32_t pixels) {
    return (pixels + 1) / 2;
}

std::uint32_t half_band(std::uint32_t pixels) {
    return pixels < 2 ? 0 : pixels / 2 - 1;
}

// Of the rays, as gloam_half_shift.
glm::dvec2 shift_of(const View& view) {
    const glm::dvec2 even(1 - vector_of_size(view.extent) % 2);
    return even / (glm::dvec2(vector_of_size(view.extent)) * glm::dvec2(view.camera.p00_p11()));
}

}  // namespace

gpu::Extent half_of(gpu::Extent extent) {
    return {half_side(extent.width), half_side(extent.height)};
}

View working_view(const View& view, Resolution resolution) {
    if (resolution == Resolution::full) return view;
    View half = view;
    half.extent = half_of(view.extent);
    half.border = {half_band(view.border.left), half_band(view.border.top), half_band(view.border.right),
                   half_band(view.border.bottom)};
    const auto scale = [](std::uint32_t full, std::uint32_t pixels) {
        return static_cast<float>(static_cast<double>(full) / (2.0 * pixels));
    };
    half.camera.proj_vk[0][0] *= scale(view.extent.width, half.extent.width);
    half.camera.proj_vk[1][1] *= scale(view.extent.height, half.extent.height);
    return half;
}

// gloam_half_view in the header of a packed effect does the same, to the bit (tests/examples/vulkan.cmake).
glm::mat4 half_previous_from_current(const View& view, const View& previous) {
    glm::dmat4 between(view.camera.previous_from_current.value_or(glm::mat4(1.0F)));
    const glm::dvec2 shift = shift_of(view);
    const glm::dvec2 previous_shift = shift_of(previous);
    const bool orthographic = view.camera.orthographic();
    glm::dvec4& changed = between[orthographic ? 3 : 2];
    for (const int axis : {0, 1}) changed += (orthographic ? -shift[axis] : shift[axis]) * between[axis];
    for (const int axis : {0, 1}) {
        if (previous.camera.orthographic()) {
            between[3][axis] += previous_shift[axis];
        } else {
            for (const int column : {0, 1, 2, 3})
                between[column][axis] -= previous_shift[axis] * between[column][2];
        }
    }
    return glm::mat4(between);
}

std::optional<Preparation> preparation_of(const Settings& settings, gpu::Extent view) {
    const MethodInfo& method = method_named(settings.method);
    if (method.prepare == nullptr) return std::nullopt;
    return method.prepare(settings, view);
}

void Moment::look(const View& now, const View& last) {
    given = now;
    given_before = last;
    view = working_view(now, settings.resolution);
    before = working_view(last, settings.resolution);
    preparation = preparation_of(settings, view.extent);
}

HistoryPrecision bound_precision(const Settings& settings) {
    return shows_alone(settings) ? HistoryPrecision::float32 : settings.precision;
}

PassSource input_source(const Moment& moment) {
    const scene::Encoding encoding = moment.converted.value_or(scene::Encoding{});
    return {.file = "take_inputs.comp",
            .constants = {{.id = 0, .bits = flag(encoding.depth_buffer)},
                          {.id = 1, .bits = flag(moment.given.camera.orthographic())},
                          {.id = 2, .bits = flag(encoding.world)},
                          {.id = 3, .bits = flag(encoding.octahedral)},
                          {.id = 4, .bits = flag(encoding.unorm)},
                          {.id = 5, .bits = flag(moment.has_normals)}}};
}

PassSource halve_source(const Moment& moment) {
    return {.file = "halve_inputs.comp",
            .constants = {{.id = 0, .bits = flag(moment.given.camera.orthographic())},
                          {.id = 1, .bits = flag(moment.given_before.camera.orthographic())},
                          {.id = 2, .bits = flag(moment.has_positions)},
                          {.id = 3, .bits = flag(moment.settings.own.layers > 1)}}};
}

PassSource upsample_source(const Moment& moment, bool filtered) {
    const Settings& settings = moment.settings;
    return {.file = "upsample.comp",
            .defines = defines_for(settings, !filtered && !shows_alone(settings)),
            .constants = {{.id = 0, .bits = flag(maps(settings))},
                          {.id = 1, .bits = flag(moment.given.camera.orthographic())}}};
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
            .defines = defines_for(settings.precision),
            .constants = {{.id = 0, .bits = flag(moment.has_positions)},
                          {.id = 1, .bits = static_cast<std::uint32_t>(settings.taps)},
                          {.id = 3, .bits = flag(moment.view.camera.orthographic())},
                          {.id = 4, .bits = flag(moment.before.camera.orthographic())}}};
}

PassSource filter_source(const Moment& moment, bool along_y) {
    const Settings& settings = moment.settings;
    return {.file = "spatial_filter.comp",
            .defines = defines_for(settings.precision),
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
    return {.file = "remap.comp", .defines = defines_for(settings, from_history)};
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
