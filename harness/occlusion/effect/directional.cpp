// SPDX-License-Identifier: MIT
#include "effect/directional.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include "effect/internal/executor.hpp"
#include "effect/internal/frame_images.hpp"
#include "effect/internal/passes.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

namespace {

using enum gpu::Format;

constexpr int most_interleave = 8;

// The albedo of each pixel, in [0, 1].
std::vector<glm::vec3> albedo_of(const scene::GBuffer& view) {
    if (view.color.empty()) return std::vector(view.depth.size(), glm::vec3(1.0F));
    std::vector<glm::vec3> albedo = view.color;
    for (glm::vec3& color : albedo)
        for (int i = 0; i < 3; ++i) color[i] = color[i] > 0.0F ? std::min(color[i], 1.0F) : 0.0F;
    return albedo;
}

// The light of the frame, without the guard band.
std::vector<glm::vec3> sent(const scene::GBuffer& view, const gpu::Image& light,
                            const std::vector<glm::vec3>& albedo) {
    std::vector<glm::vec3> radiance = vectors_of(light.download());
    std::ranges::transform(radiance, albedo, radiance.begin(),
                           [](const glm::vec3& a, const glm::vec3& b) { return a * b; });
    return scene::cropped(view, radiance);
}

void require(const scene::GBuffer& view, const Settings& settings) {
    validate(settings);
    if (!view.color.empty() && view.color.size() != view.depth.size()) {
        throw std::invalid_argument(
            fmt::format("colours: {} pixels, expected {}", view.color.size(), view.depth.size()));
    }
    require_layers(view, settings);
}

}  // namespace

struct Directional::Impl {
    Impl(const gpu::Device& device, const scene::PassLibrary& passes)
        : executor(device, passes), resources(device) {}

    Executor executor;
    Resources resources;
    View last;                // of the last frame of light
    std::uint64_t count = 0;  // frames since the history of light began
    PassWatcher watcher;      // empty: none

    // Uploads a view; reconstructs missing normals.
    void take(const scene::GBuffer& view, const Settings& settings) {
        require(view, settings);
        take_linear(view, resources, executor, watcher);
        resources.buffer("method", sizeof(MethodValues)).as<MethodValues>()[0] = settings.own;
    }

    // The name of an image that the view may lack.
    static std::string or_nothing(bool exists, const char* name) { return exists ? name : nothing_image; }

    // Runs a pass that writes `out`. read: the images and buffers at its further bindings. interleave: 0
    // where the pass does not use it.
    void shade(const std::string& name, const std::string& out, const std::vector<std::string>& read,
               const scene::GBuffer& view, const Settings& settings, std::uint32_t interleave = 0) {
        std::vector<std::string> bound{"depth", "normal", or_nothing(!view.layers.empty(), "layers"),
                                       "method", out};
        bound.insert(bound.end(), read.begin(), read.end());
        const PlannedPass pass =
            single_pass(name, directional_source(name, settings, interleave), std::move(bound),
                        directional_parameters({view.camera, view.extent, view.border}, settings),
                        groups_for(view.extent));
        executor.run(std::span(&pass, 1), resources, watcher);
    }

    // Decides what the frame keeps of the one before, and sets LightHistory.
    void follow(const scene::GBuffer& view, const Settings& settings, LightFollows follows) {
        const bool fits = last.extent == view.extent;
        const bool linked = follows == LightFollows::same_view ||
                            (follows == LightFollows::last_view && view.camera.previous_from_current);
        if (!fits || !linked || !settings.history) count = 0;
        for (const char* state : {"before", "now"})
            for (const char* part : {"direct_", "bounced_"})
                (void)resources.image(std::string(part) + state, view.extent, rgba32f);
        const bool same = follows == LightFollows::same_view;
        const scene::CameraFrame& previous = count > 0 ? last.camera : view.camera;
        resources.buffer("history_of_light", sizeof(LightHistory)).as<LightHistory>()[0] = {
            .previous_from_current = view.camera.previous_from_current.value_or(glm::mat4(1.0F)),
            .previous_p00_p11 = previous.p00_p11(),
            .kept = count == 0 ? 0U
                    : same     ? 1U
                               : 2U,
            .objects_move = flag(count > 0 && !same && !view.previous_position.empty()),
            .previous_orthographic = flag(previous.orthographic()),
            .first_sample = static_cast<std::uint32_t>(count * settings.samples % settings.table_size),
            .weight_max = settings.weight_max,
            .depth_tolerance = settings.depth_tolerance,
            .invalidation = static_cast<std::uint32_t>(settings.invalidation),
            .change_tolerance = settings.change_tolerance,
            .weight_small = settings.weight_small,
            .confidence_factor = settings.confidence_factor};
        last = {view.camera, view.extent, view.border};
    }

    // Smooths the frame's light, if the settings filter it. Returns the state of it that is displayed.
    [[nodiscard]] const char* smoothed(const Settings& settings) {
        if (!filters(settings)) return "now";
        const FilterParameters parameters = filter_parameters(last, settings);
        const auto along = [&](bool y, const std::string& from, const std::string& to) {
            for (const char* part : {"direct_", "bounced_"})
                (void)resources.image(part + to, last.extent, rgba32f);
            const PassSource source{
                .file = "light_filter.comp",
                .constants = {{.id = 0, .bits = flag(y)},
                              {.id = 1, .bits = flag(last.camera.orthographic())},
                              {.id = 2, .bits = static_cast<std::uint32_t>(settings.filter_half_width)}}};
            return single_pass(
                "light_filter", source,
                {"depth", "direct_" + from, "bounced_" + from, "direct_" + to, "bounced_" + to}, parameters,
                groups_for(last.extent));
        };
        const std::array passes{along(false, "now", "half_filtered"),
                                along(true, "half_filtered", "filtered")};
        executor.run(passes, resources, watcher);
        return "filtered";
    }
};

Directional::Directional(const gpu::Device& device, const scene::PassLibrary& passes)
    : impl_(base::make_hidden<Impl>(device, passes)) {}

void Directional::watch(PassWatcher watcher) {
    impl_->watcher = std::move(watcher);
}

BentNormals Directional::bent_normals(const scene::GBuffer& view, const Settings& settings,
                                      const BentOptions& options) {
    if (options.interleave < 1 || options.interleave > most_interleave) {
        throw std::invalid_argument(
            fmt::format("interleave {}: expected 1 to {}", options.interleave, most_interleave));
    }
    const auto interleave = static_cast<std::uint32_t>(options.interleave);
    impl_->take(view, settings);
    gpu::Image& bent = impl_->resources.image("bent", view.extent, rgba32f);
    gpu::Image& gathered = impl_->resources.image("gathered", view.extent, rgba32f);
    impl_->shade("bent_normals", "bent", {}, view, settings, interleave);
    if (interleave > 1) impl_->shade("bent_gather", "gathered", {"bent"}, view, settings, interleave);
    const std::vector<float> texels = (interleave > 1 ? gathered : bent).download();
    return {.extent = scene::frame_of(view),
            .direction = scene::cropped(view, vectors_of(texels)),
            .half_angle = scene::cropped(view, channel(texels, 3))};
}

DirectionalLight Directional::light(const scene::GBuffer& view, const Settings& settings,
                                    const scene::Environment& environment, LightFollows follows) {
    Resources& resources = impl_->resources;
    impl_->take(view, settings);
    impl_->follow(view, settings, follows);
    const std::vector<glm::vec3> color = albedo_of(view);
    resources.image("albedo", view.extent, rgba32f).upload(texels_of(color));
    resources.image("environment", environment.extent, rgba32f).upload(texels_of(environment.radiance));
    const auto with_history = [&](std::vector<std::string> read) {
        read.insert(read.begin(), {"history_of_light", "direct_before", "bounced_before",
                                   Impl::or_nothing(!view.previous_position.empty(), "previous_position")});
        return read;
    };
    impl_->shade("direct_light", "direct_now", with_history({"environment"}), view, settings);
    impl_->shade("bounced_light", "bounced_now", with_history({"albedo", "direct_now"}), view, settings);
    const std::string shown = impl_->smoothed(settings);
    DirectionalLight result{.extent = scene::frame_of(view),
                            .direct = sent(view, resources.image("direct_" + shown), color),
                            .bounced = sent(view, resources.image("bounced_" + shown), color)};
    const std::array<std::array<std::string, 2>, 2> exchanged{
        {{"direct_before", "direct_now"}, {"bounced_before", "bounced_now"}}};
    resources.exchange(exchanged);
    ++impl_->count;
    return result;
}

}  // namespace gloam::effect
