// SPDX-License-Identifier: MIT
#include "effect/internal/half_resolution.hpp"

#include "effect/internal/frame_images.hpp"

namespace gloam::effect {
namespace {

using enum gpu::BindingKind;

// Of the rays, as gloam_half_shift.
glm::dvec2 shift_of(const View& view) {
    const glm::dvec2 even(1 - vector_of_size(view.extent) % 2);
    return even / (glm::dvec2(vector_of_size(view.extent)) * glm::dvec2(view.camera.p00_p11()));
}

std::uint32_t half_side(std::uint32_t pixels) {
    return (pixels + 1) / 2;
}

std::uint32_t half_band(std::uint32_t pixels) {
    return pixels < 2 ? 0 : pixels / 2 - 1;
}

template <class Program, class Make>
const gpu::ComputePipeline& found_or_made(std::map<Program, gpu::ComputePipeline>& made,
                                          const Program& program, const Make& make) {
    const auto found = made.find(program);
    return found != made.end() ? found->second : made.emplace(program, make()).first->second;
}

}  // namespace

gpu::Extent half_of(gpu::Extent extent) {
    return {half_side(extent.width), half_side(extent.height)};
}

View working_view(const View& view, Resolution resolution) {
    if (resolution == Resolution::full) return view;
    View half = view;
    half.extent = half_of(view.extent);
    half.border = {half_band(view.border.width), half_band(view.border.height)};
    const auto scale = [](std::uint32_t full, std::uint32_t pixels) {
        return static_cast<float>(static_cast<double>(full) / (2.0 * pixels));
    };
    half.camera.proj_vk[0][0] *= scale(view.extent.width, half.extent.width);
    half.camera.proj_vk[1][1] *= scale(view.extent.height, half.extent.height);
    return half;
}

// gloam_half_previous_from_current in the header of a packed effect does the same, to the bit.
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

HalveParameters halve_parameters(const View& view, const View& previous) {
    return {view.camera.p00_p11(), previous.camera.p00_p11(), vector_of_size(view.extent)};
}

UpsampleParameters upsample_parameters(const View& view, const Settings& settings) {
    return {vector_of_size(view.extent), settings.remap_a, settings.remap_b, settings.remap_c};
}

UpsampleProgram upsample_program_for(const Settings& settings, bool filtered, bool orthographic) {
    const bool reads_history = !filtered && !shows_alone(settings);
    return {.history = reads_history ? std::optional(settings.precision) : std::nullopt,
            .output = settings.output,
            .maps = maps(settings),
            .orthographic = orthographic};
}

PassSource halve_source(const HalveProgram& program) {
    return {.file = "halve_inputs.comp",
            .constants = {{.id = 0, .bits = flag(program.orthographic)},
                          {.id = 1, .bits = flag(program.previous_orthographic)},
                          {.id = 2, .bits = flag(program.moving_objects)},
                          {.id = 3, .bits = flag(program.layers)}}};
}

PassSource upsample_source(const UpsampleProgram& program) {
    PassSource source{
        .file = "upsample.comp",
        .defines =
            program.history ? defines_for(*program.history) : std::vector<std::string>{"GLOAM_SOURCE r32f"},
        .constants = {{.id = 0, .bits = flag(program.maps)}, {.id = 1, .bits = flag(program.orthographic)}}};
    if (program.output != OutputFormat::r32f)
        source.defines.emplace_back(program.output == OutputFormat::r8 ? "GLOAM_OUTPUT r8"
                                                                       : "GLOAM_OUTPUT r16f");
    return source;
}

HalfResolution::HalfResolution(const gpu::Device& device, const scene::PassLibrary& library,
                               gpu::Extent extent)
    : inputs(device, extent), device_(&device), library_(library) {}

void HalfResolution::take(const View& view, const View& previous, const Settings& settings,
                          ViewImages& half) {
    const auto like = [&](std::optional<gpu::Image>& image, const std::optional<gpu::Image>& full) {
        image.reset();
        if (full) image.emplace(*device_, half.depth.extent(), full->format());
    };
    like(half.previous_position, inputs.previous_position);
    like(half.layers, inputs.layers);
    halving_ = {.orthographic = view.camera.orthographic(),
                .previous_orthographic = previous.camera.orthographic(),
                .moving_objects = inputs.previous_position.has_value(),
                .layers = inputs.layers.has_value()};
    halve_constants_ = halve_parameters(view, previous);
    upsample_constants_ = upsample_parameters(view, settings);
    const gpu::Format format = format_of(settings.output);
    if (!result_ || result_->format() != format) result_.emplace(*device_, view.extent, format);
}

void HalfResolution::append_inputs(const ViewImages& half, const gpu::Image& nothing,
                                   std::vector<Step>& steps) {
    const auto or_nothing = [&](const std::optional<gpu::Image>& image) -> const gpu::Image& {
        return image ? *image : nothing;
    };
    const auto make = [&] {
        return pipeline_of(*device_, library_, halve_source(halving_),
                           {sampled_image, sampled_image, sampled_image, sampled_image, storage_image,
                            storage_image, storage_image, storage_image},
                           sizeof(HalveParameters));
    };
    steps.push_back({.name = "halve_inputs",
                     .pipeline = &found_or_made(halves_, halving_, make),
                     .resources = {inputs.depth, inputs.normal, or_nothing(inputs.previous_position),
                                   or_nothing(inputs.layers), half.depth, half.normal,
                                   or_nothing(half.previous_position), or_nothing(half.layers)},
                     .parameters = bytes_of(halve_constants_),
                     .groups = groups_for(half.depth.extent())});
}

void HalfResolution::append_result(const ViewImages& half, const gpu::Image& from,
                                   const UpsampleProgram& program, std::vector<Step>& steps) {
    const auto make = [&] {
        return pipeline_of(*device_, library_, upsample_source(program),
                           {sampled_image, sampled_image, sampled_image, storage_image},
                           sizeof(UpsampleParameters));
    };
    steps.push_back({.name = "upsample",
                     .pipeline = &found_or_made(upsamples_, program, make),
                     .resources = {inputs.depth, half.depth, from, *result_},
                     .parameters = bytes_of(upsample_constants_),
                     .groups = groups_for(half.depth.extent())});
}

std::vector<float> expanded(const std::vector<float>& half, gpu::Extent extent) {
    const std::size_t columns = half_side(extent.width);
    std::vector<float> all;
    all.reserve(pixels_of(extent));
    for (std::size_t y = 0; y < extent.height; ++y)
        for (std::size_t x = 0; x < extent.width; ++x) all.push_back(half[y / 2 * columns + x / 2]);
    return all;
}

}  // namespace gloam::effect
