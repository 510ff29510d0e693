// SPDX-License-Identifier: MIT
#include "effect/study/skip_shares.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "effect/presets.hpp"
#include "effect/study/skip_floor.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace {

constexpr int share_frames = 8;
constexpr double roughness = 0.01;  // of the depth

// Targets: the time with all skips divided by that without.
constexpr double nothing_to_skip = 1.03;
constexpr double mostly_sky = 0.25;
constexpr double open_floor = 0.35;
constexpr double all_settled = 0.1;

// A pseudorandom number in [-1, 1).
double noise(std::uint32_t x, std::uint32_t y) {
    std::uint32_t bits = x * 0x9E3779B1U ^ y * 0x85EBCA77U;
    bits = (bits ^ bits >> 15U) * 0x2C1B3C6DU;
    bits = (bits ^ bits >> 12U) * 0x297A2D39U;
    return static_cast<double>(bits >> 8U) / 8388608.0 - 1.0;
}

// Roughens the columns from this share of the width on.
void roughen(scene::GBuffer& view, double from) {
    const auto first = static_cast<std::uint32_t>(std::lround(from * view.extent.width));
    for (std::uint32_t y = 0; y < view.extent.height; ++y) {
        for (std::uint32_t x = first; x < view.extent.width; ++x)
            view.depth[std::size_t{y} * view.extent.width + x] *=
                static_cast<float>(1.0 + roughness * noise(x, y));
    }
}

// Removes all geometry from the columns up to this share of the width.
void clear(scene::GBuffer& view, double until) {
    const auto end = static_cast<std::uint32_t>(std::lround(until * view.extent.width));
    for (std::uint32_t y = 0; y < view.extent.height; ++y) {
        for (std::uint32_t x = 0; x < end; ++x) {
            const std::size_t pixel = std::size_t{y} * view.extent.width + x;
            view.depth[pixel] = std::numeric_limits<float>::infinity();
            view.normal[pixel] = {};
        }
    }
}

class Shares {
  public:
    Shares(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent) {
        const scene::Scene floor = skip_floor();
        settings_ = with_radius(preset_named("paper").settings, static_cast<float>(floor.ao_radius));
        settings_.skip_background = settings_.skip_open = settings_.skip_settled = settings_.skip_filtered =
            true;
        for (int i = 0; i < share_frames; ++i)
            floor_.push_back(scene::rasterize(device, passes, floor, extent, {.frame = i}));
    }

    // Nothing can be skipped, not even by the filter.
    [[nodiscard]] SkipShare nothing() const {
        SkipShare made = background(0.0);
        made.skip_case.name = "nothing";
        made.skip_case.target = nothing_to_skip;
        made.skip_case.settings.c_adaptive = 1.0F;
        return made;
    }

    [[nodiscard]] SkipShare background(double share) const {
        SkipShare made{.share = share,
                       .skip_case = {.name = "background", .views = floor_, .settings = settings_}};
        for (scene::GBuffer& view : made.skip_case.views) {
            roughen(view, 0.0);
            clear(view, share);
        }
        return made;
    }

    [[nodiscard]] SkipShare open(double share) const {
        SkipShare made{.share = share, .skip_case = {.name = "open", .views = floor_, .settings = settings_}};
        for (scene::GBuffer& view : made.skip_case.views) roughen(view, share);
        return made;
    }

    // First a part of the image is empty. When the other part has settled, the first part gets geometry as
    // well.
    [[nodiscard]] SkipShare settled(double share) const {
        scene::GBuffer whole = floor_.front();
        roughen(whole, 0.0);
        whole.camera.previous_from_current = glm::mat4(1.0F);
        scene::GBuffer part = whole;
        clear(part, 1.0 - share);
        SkipShare made{
            .share = share,
            .skip_case = {
                .name = "settled", .views = {part, whole}, .warm = 36, .after = 3, .settings = settings_}};
        made.skip_case.settings.freeze = true;
        return made;
    }

  private:
    std::vector<scene::GBuffer> floor_;
    Settings settings_;
};

}  // namespace

std::vector<SkipShare> skip_shares(const gpu::Device& device, const scene::PassLibrary& passes,
                                   gpu::Extent extent) {
    const Shares shares(device, passes, extent);
    std::vector<SkipShare> made;
    made.push_back(shares.nothing());
    const auto add = [&](SkipShare share, double target) {
        share.skip_case.target = target;
        made.push_back(std::move(share));
    };
    for (const double share : {0.25, 0.5, 0.75, 0.9, 0.95})
        add(shares.background(share), share >= 0.75 ? mostly_sky : 0.0);
    for (const double share : {0.25, 0.5, 0.75, 1.0})
        add(shares.open(share), share == 1.0 ? open_floor : 0.0);
    for (const double share : {0.25, 0.5, 0.75, 1.0})
        add(shares.settled(share), share == 1.0 ? all_settled : 0.0);
    return made;
}

}  // namespace gloam::effect
