// SPDX-License-Identifier: MIT
#include "effect/preparation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>

namespace gloam::effect {
namespace {

// GLOAM_LAST_TAP_LEVEL of gloam/sampling/tap_pixel.glsl.
constexpr std::uint32_t last_tap_level = 5;

// From a texel of the coarsest level to the last that counts for it: its kernel's 6, 2 for each
// interpolation, whose texels grow to it as 1 + 1/2 + 1/4 ..., and its own.
constexpr int mssao_texels = 11;

// That are worth having in an image; GLOAM_MOST_RESOLUTIONS of preparation/pyramid.glsl.
constexpr std::uint32_t most_resolutions = 9;

// Of a level, 1 being half the resolution.
gpu::Extent level_size(gpu::Extent size, std::uint32_t level) {
    const std::uint32_t texel = 1U << level;
    return {(size.width + texel - 1) / texel, (size.height + texel - 1) / texel};
}

// hbao at half the resolution, the result of every other pixel. A pixel looks at 3 x 3 of them.
Preparation dual_resolution(const Settings&, gpu::Extent view) {
    const gpu::Extent half = level_size(view, 1);
    return {.image = half, .passes = {{"half_resolution", "half_resolution.comp", half}}, .spread = 3};
}

// Each pixel's occlusion along its first direction, which others take over from two standard deviations away.
Preparation separable(const Settings& settings, gpu::Extent view) {
    return {.image = view,
            .format = gpu::Format::r32f,
            .passes = {{"first_direction", "first_direction.comp", view}},
            .spread = 1,
            .reach = 2.0F * settings.epsilon};
}

// As preparation/pyramid.glsl lays it out.
gpu::Extent pyramid_size(gpu::Extent view, std::uint32_t coarsest) {
    gpu::Extent size = level_size(view, coarsest);
    for (std::uint32_t level = 1; level <= coarsest; ++level) {
        size.width += level_size(view, level).width;
        size.height += level_size(view, level).height;
    }
    return size;
}

// All coarser levels' surfaces, each from the one before, then their occlusion from the coarsest on.
Preparation mssao(const Settings& settings, gpu::Extent view) {
    const std::uint32_t coarsest = std::clamp(settings.steps, 1U, most_resolutions) - 1;
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

// As preparation/depth_chain.glsl lays it out.
Preparation sao_chain(const Settings&, gpu::Extent view) {
    const auto level = [view](std::uint32_t l) {
        return gpu::Extent{std::max(view.width >> l, 1U), std::max(view.height >> l, 1U)};
    };
    std::uint32_t column = 0;
    for (std::uint32_t l = 2; l <= last_tap_level; ++l) column += level(l).height;
    return {.image = {level(1).width + level(2).width, std::max(level(1).height, column)},
            .format = gpu::Format::r32f,
            .passes = {{"depth_chain", "depth_chain.comp", level(1)}}};
}

using Prepare = Preparation (*)(const Settings&, gpu::Extent);

const std::map<std::string, Prepare>& preparations() {
    static const std::map<std::string, Prepare> all{{"dual_resolution", dual_resolution},
                                                    {"mssao", mssao},
                                                    {"sao_chain", sao_chain},
                                                    {"separable", separable}};
    return all;
}

}  // namespace

std::optional<Preparation> preparation_of(const Settings& settings, gpu::Extent view) {
    const auto found = preparations().find(settings.method);
    if (found == preparations().end()) return std::nullopt;
    return found->second(settings, view);
}

gpu::Format prepared_format(const std::string& method) {
    Settings settings;
    settings.method = method;
    return preparation_of(settings, {1, 1}).value_or(Preparation{}).format;
}

}  // namespace gloam::effect
