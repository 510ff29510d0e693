// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "effect/internal/method_families.hpp"

namespace gloam::effect {
namespace {

using enum Measure;

// GLOAM_MOST_RESOLUTIONS of gloam/methods/mssao.glsl.
constexpr std::uint32_t most_resolutions = 9;

// GLOAM_LAST_AREA_LEVEL of gloam/methods/volumetric_area.glsl.
constexpr std::uint32_t last_area_level = 6;

// Distance in texels of the coarsest level from a pixel to the last texel that affects it: the kernel's 6; 2
// for each interpolation, in texels that shrink by half from level to level (1 + 1/2 + 1/4 ...); and its own.
constexpr int mssao_texels = 11;

// Size of a level; level 1 has half the resolution.
backend::Extent level_size(backend::Extent size, std::uint32_t level) {
    const std::uint32_t texel = 1U << level;
    return {(size.width + texel - 1) / texel, (size.height + texel - 1) / texel};
}

// Size of the image with the layout of gloam/methods/mssao.glsl.
backend::Extent pyramid_size(backend::Extent view, std::uint32_t coarsest) {
    backend::Extent size = level_size(view, coarsest);
    for (std::uint32_t level = 1; level <= coarsest; ++level) {
        size.width += level_size(view, level).width;
        size.height += level_size(view, level).height;
    }
    return size;
}

// Passes: the surfaces of all coarser levels, each from the level before, then their occlusion, coarsest
// level first.
Preparation resolutions(const Settings& settings, backend::Extent view) {
    const std::uint32_t coarsest = std::clamp(settings.own.steps, 1U, most_resolutions) - 1;
    if (coarsest == 0) return {.image = {1, 1}};
    Preparation all{.image = pyramid_size(view, coarsest)};
    for (std::uint32_t level = 1; level <= coarsest; ++level) {
        all.passes.push_back({fmt::format("surface_{}", level), "mssao_surface.comp", level_size(view, level),
                              static_cast<int>(level)});
    }
    for (std::uint32_t level = coarsest; level >= 1; --level) {
        all.passes.push_back({fmt::format("occlusion_{}", level), "mssao_level.comp", level_size(view, level),
                              static_cast<int>(level)});
    }
    all.spread = mssao_texels << coarsest;
    return all;
}

// Passes: moments of blocks, each level from the level before. A sample reads up to one block beyond the
// disc.
Preparation area_moments(const Settings&, backend::Extent view) {
    Preparation all{.image = pyramid_size(view, last_area_level)};
    for (std::uint32_t level = 1; level <= last_area_level; ++level) {
        all.passes.push_back({fmt::format("moments_{}", level), "area_moments.comp", level_size(view, level),
                              static_cast<int>(level)});
    }
    all.spread = 1 << last_area_level;
    return all;
}

std::vector<Preset> area_presets(const MethodInfo& method) {
    return {{"loos-sloan-area",
             "Loos and Sloan's: a pair of area samples, a blur of one pixel, no history",
             blurred(configuration(method, 2), 1),
             {{"method", "area samples"}, {"samples", "1 area sample"}, {"history", "none in the source"}}}};
}

// Pass: each pixel's visibility. It weights the pixel's disc for other pixels within the radius.
Preparation disc_visibility(const Settings& settings, backend::Extent view) {
    return {.image = view,
            .format = backend::vulkan::Format::r32f,
            .passes = {{"disc_visibility", "disc_visibility.comp", view}},
            .spread = 1,
            .reach = settings.radius};
}

}  // namespace

std::vector<MethodInfo> surface_methods() {
    return {
        {.name = "mssao",
         .description = "surface points under discs at several resolutions (Hoang and Low 2012)",
         .falloff = "quadratic",
         .own_settings = "GloamMssao",
         .members = {{"resolutions", "steps"}},
         .adapt = [](Settings& s) { s.own.range = 0.25F, s.own.steps = 5; },
         .prepare = resolutions},
        {.name = "volumetric_area",
         .description =
             "volumetric by samples of areas, their mean and variance prepared (Loos and Sloan 2010)",
         .measure = volume,
         .falloff = "none",
         .unit = SampleUnit::pair,
         .on_a_plane = 0.5,
         .adapt = [](Settings& s) { s.remap_a = 0.5F; },
         .prepare = area_moments,
         .presets = area_presets},
        {.name = "sphere_proxy",
         .description = "pixels as balls (Shanmugam and Arikan 2007)",
         .measure = shape,
         .falloff = "none up to the radius",
         .own_settings = "GloamSphereProxy",
         .members = {{"intensity"}}},
        {.name = "disc_proxy",
         .description = "pixels as discs of their surface (Bunnell 2005)",
         .falloff = "none up to the radius",
         .own_settings = "GloamDiscProxy",
         .members = {{"intensity"}},
         .reads_normals = true},
        {.name = "disc_proxy_two",
         .description = "disc_proxy, each disc by its own visibility from a first pass (Bunnell 2005)",
         .falloff = "none up to the radius",
         .own_settings = "GloamDiscProxy",
         .members = {{"intensity"}},
         .unit = SampleUnit::pair,
         .reads_normals = true,
         .prepare = disc_visibility},
        {.name = "mixture",
         .family = "sphere_proxy",
         .description = "pixels as balls above the biased tangent plane (Song 2010)",
         .measure = shape,
         .falloff = "linear",
         .own_settings = "GloamMixture",
         .members = {{"angle_bias"}, {"intensity"}},
         .adapt = [](Settings& s) { s.own.angle_bias = 0.3F; }},
        {.name = "curvature",
         .description = "the quadric through the pixel's surroundings (after Hattori et al. 2012)",
         .measure = shape,
         .falloff = "none up to the radius",
         .own_settings = "GloamCurvature",
         .members = {{"range"}},
         .unit = SampleUnit::cross,
         .reads_normals = true},
    };
}

}  // namespace gloam::effect
