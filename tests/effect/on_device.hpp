// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "comparisons.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/internal/steps.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"
#include "scene/rasterize.hpp"
#include "scene/scene.hpp"
#include "support/shared_device.hpp"

namespace gloam::effect {

using test::variable;

// What a pass binds there.
inline const gpu::Image& image_of(const Step& pass, std::size_t binding) {
    return std::get<std::reference_wrapper<const gpu::Image>>(pass.resources.at(binding)).get();
}

// The settings with every skip on, or off.
inline Settings with_skips(Settings settings, bool on = true) {
    settings.skip_background = settings.skip_open = settings.skip_closed = on;
    settings.skip_settled = settings.skip_filtered = on;
    return settings;
}
inline Settings without_skips(const Settings& settings) {
    return with_skips(settings, false);
}

// A test of passes on the device that tests run on, under validation: any message fails it.
// Base: testing::Test, or testing::TestWithParam of something.
// lavapipe compiles a pass anew for images whose width or height is a power of two: tests of all methods take
// other sizes where they may choose, so that what one of them has compiled serves the others.
template <class Base>
class OnDevice : public Base {
  protected:
    static void SetUpTestSuite() { shared_.emplace(); }
    static void TearDownTestSuite() { shared_.reset(); }

    void TearDown() override { EXPECT_THAT(device_.take_validation_messages(), testing::IsEmpty()); }

    gpu::Device& device_ = *test::SharedDevice::get();
    const scene::PassLibrary& passes_ = shared_->passes;

    // The same for all tests of a suite, so that pipelines are compiled once; for images of that size until
    // the next call with another. begin() leaves no trace of what it held before
    // (tests/experiment/configuration_study_test.cpp).
    [[nodiscard]] AmbientOcclusion& effect_for(gpu::Extent extent) const {
        if (!shared_->effect) shared_->effect.emplace(device_, passes_, extent);
        AmbientOcclusion& effect = *shared_->effect;
        if (shared_->extent && *shared_->extent != extent) {
            effect.begin(blank(*shared_->extent), {});
            effect.advance(blank(extent));
        }
        shared_->extent = extent;
        return effect;
    }

    [[nodiscard]] scene::GBuffer rasterized(const scene::Scene& scene, gpu::Extent extent,
                                            const scene::RasterizeOptions& options = {}) const {
        return scene::rasterize(device_, passes_, scene, extent, options);
    }
    // A view of a built-in scene, drawn once for all tests of a suite.
    [[nodiscard]] const scene::GBuffer& rasterized(const std::string& scene, gpu::Extent extent,
                                                   const scene::RasterizeOptions& options = {}) const {
        const auto& [frame, motion, ids, color, layers, guard] = options;
        const Drawing drawing{scene, extent.width, extent.height, frame, motion, ids, color, layers, guard};
        const auto known = shared_->drawn.find(drawing);
        if (known != shared_->drawn.end()) return known->second;
        return shared_->drawn.emplace(drawing, rasterized(scene::make_scene(scene), extent, options))
            .first->second;
    }

    // The last of so many frames of one view, each of its passes run `repeat` times.
    [[nodiscard]] Frame run(const scene::GBuffer& view, const Settings& settings, int frames = 1,
                            int repeat = 1) const {
        AmbientOcclusion& effect = effect_for(view.extent);
        effect.begin(view, settings);
        for (int i = 1; i < frames; ++i) (void)effect.next(repeat);
        return effect.next(repeat);
    }

    // A sequence: a frame of each view.
    [[nodiscard]] std::vector<Frame> run(const std::vector<scene::GBuffer>& views,
                                         const Settings& settings) const {
        AmbientOcclusion& effect = effect_for(views.front().extent);
        std::vector<Frame> frames;
        for (const scene::GBuffer& view : views) {
            frames.empty() ? effect.begin(view, settings) : effect.advance(view);
            frames.push_back(effect.next());
        }
        return frames;
    }

  private:
    [[nodiscard]] static scene::GBuffer blank(gpu::Extent extent) {
        scene::GBuffer view{.extent = extent};
        view.depth.assign(std::size_t{extent.width} * extent.height, 1.0F);
        view.camera =
            scene::make_frame({}, static_cast<double>(extent.width) / static_cast<double>(extent.height));
        return view;
    }

    // What is drawn: scene, extent and options.
    using Drawing = std::tuple<std::string, std::uint32_t, std::uint32_t, int, bool, bool, bool, int, double>;

    struct Shared {
        scene::PassLibrary passes{GLOAM_GLSL_DIR, variable("GLOAM_CACHE_DIR")};
        std::optional<AmbientOcclusion> effect;
        std::optional<gpu::Extent> extent;
        std::map<Drawing, scene::GBuffer> drawn;
    };

    inline static std::optional<Shared> shared_;
};

}  // namespace gloam::effect
