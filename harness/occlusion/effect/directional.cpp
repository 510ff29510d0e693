// SPDX-License-Identifier: MIT
#include "effect/directional.hpp"

#include <algorithm>
#include <utility>

#include "effect/internal/executor.hpp"
#include "effect/internal/passes.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

namespace {

using enum backend::vulkan::Format;

// The buffer of direct_light.comp, with its layout.
struct SkyBuffer {
    glm::vec4 zenith;
    glm::vec4 horizon;
    glm::vec4 ground;
};

// The albedo of each pixel, in [0, 1].
std::vector<glm::vec3> albedo_of(const scene::GBuffer& view) {
    if (view.color.empty()) return std::vector(view.depth.size(), glm::vec3(1.0F));
    std::vector<glm::vec3> albedo = view.color;
    for (glm::vec3& color : albedo)
        for (int i = 0; i < 3; ++i) color[i] = color[i] > 0.0F ? std::min(color[i], 1.0F) : 0.0F;
    return albedo;
}

// The light of the frame, without the guard band.
std::vector<glm::vec3> sent(const scene::GBuffer& view, const backend::vulkan::Image& light,
                            const std::vector<glm::vec3>& albedo) {
    std::vector<glm::vec3> radiance = vectors_of(light.download());
    std::ranges::transform(radiance, albedo, radiance.begin(),
                           [](const glm::vec3& a, const glm::vec3& b) { return a * b; });
    return scene::cropped(view, radiance);
}

}  // namespace

struct Directional::Impl {
    Impl(const backend::vulkan::Device& device, const scene::PassLibrary& passes)
        : executor(device, passes), resources(device) {}

    Executor executor;
    Resources resources;

    // Uploads a view; reconstructs missing normals.
    void take(const scene::GBuffer& view, const Settings& settings) {
        validate(settings);
        take_linear(view, resources, executor);
        resources.buffer("method", sizeof(MethodValues)).as<MethodValues>()[0] = settings.own;
    }

    // Runs a pass that writes `out`. read: the images and buffers at its further bindings. interleave: 0
    // where the pass does not use it.
    void shade(const std::string& name, const std::string& out, const std::vector<std::string>& read,
               const scene::GBuffer& view, const Settings& settings, std::uint32_t interleave = 0) {
        std::vector<std::string> bound{"depth", "normal", "method", out};
        bound.insert(bound.end(), read.begin(), read.end());
        Values values = values_of({view.camera, view.extent, view.border}, settings);
        values.set("interleave", interleave);
        executor.run(name, {.file = "study/" + name + ".comp"}, std::move(bound), values,
                     groups_for(view.extent), resources);
    }
};

Directional::Directional(const backend::vulkan::Device& device, const scene::PassLibrary& passes)
    : impl_(base::make_hidden<Impl>(device, passes)) {}

BentNormals Directional::bent_normals(const scene::GBuffer& view, const Settings& settings, int interleave) {
    const auto side = static_cast<std::uint32_t>(interleave);
    impl_->take(view, settings);
    backend::vulkan::Image& bent = impl_->resources.image("bent", view.extent, rgba32f);
    backend::vulkan::Image& gathered = impl_->resources.image("gathered", view.extent, rgba32f);
    impl_->shade("bent_normals", "bent", {}, view, settings, side);
    if (interleave > 1) impl_->shade("bent_gather", "gathered", {"bent"}, view, settings, side);
    const std::vector<float> texels = (interleave > 1 ? gathered : bent).download();
    return {.extent = scene::frame_of(view),
            .direction = scene::cropped(view, vectors_of(texels)),
            .half_angle = scene::cropped(view, channel(texels, 3))};
}

DirectionalLight Directional::light(const scene::GBuffer& view, const Settings& settings, const Sky& sky) {
    Resources& resources = impl_->resources;
    impl_->take(view, settings);
    const std::vector<glm::vec3> color = albedo_of(view);
    resources.image("albedo", view.extent, rgba32f).upload(texels_of(color));
    resources.buffer("sky", sizeof(SkyBuffer)).as<SkyBuffer>()[0] = {
        glm::vec4(sky.zenith, 0.0F), glm::vec4(sky.horizon, 0.0F), glm::vec4(sky.ground, 0.0F)};
    backend::vulkan::Image& direct = resources.image("direct", view.extent, rgba32f);
    backend::vulkan::Image& bounced = resources.image("bounced", view.extent, rgba32f);
    impl_->shade("direct_light", "direct", {"sky"}, view, settings);
    impl_->shade("bounced_light", "bounced", {"albedo", "direct"}, view, settings);
    return {.extent = scene::frame_of(view),
            .direct = sent(view, direct, color),
            .bounced = sent(view, bounced, color)};
}

}  // namespace gloam::effect
