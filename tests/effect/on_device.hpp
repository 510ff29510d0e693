// SPDX-License-Identifier: MIT
// Images and frames beside others.
#pragma once

#include "effect/ambient_occlusion.hpp"
#include "effect/internal/executor.hpp"
#include "effect/methods.hpp"
#include "scene/draw.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"
#include "support/shared_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect {

// Whether two images have the same bits; otherwise the first pixel that differs, of rows of that many.
inline testing::AssertionResult same_bits(const std::vector<float>& left, const std::vector<float>& right,
                                          std::size_t width) {
    if (left.size() != right.size())
        return testing::AssertionFailure() << left.size() << " and " << right.size() << " pixels";
    for (std::size_t i = 0; i < left.size(); ++i)
        if (std::bit_cast<std::uint32_t>(left[i]) != std::bit_cast<std::uint32_t>(right[i]))
            return testing::AssertionFailure()
                   << "pixel " << i % width << ", " << i / width << ": " << left[i] << " and " << right[i];
    return testing::AssertionSuccess();
}

using FrameImage = std::vector<float> Frame::*;

inline const std::vector<std::pair<FrameImage, std::string>> images_of_frame{
    {&Frame::occlusion, "occlusion"},
    {&Frame::filtered, "filtered"},
    {&Frame::convergence, "convergence"},
    {&Frame::kept, "kept"}};

// Fails unless images of two frames have the same bits: all of them, or those that are named.
inline void expect_same_images(const Frame& left, const Frame& right,
                               std::initializer_list<FrameImage> images = {}, const std::string& what = "") {
    for (const auto& [image, name] : images_of_frame) {
        if (images.size() > 0 && std::ranges::find(images, image) == images.end()) continue;
        EXPECT_TRUE(same_bits(left.*image, right.*image, left.extent.width)) << name << ' ' << what;
    }
}

// Fails unless the images of each frame of two sequences have the same bits.
inline void expect_same_images(const std::vector<Frame>& left, const std::vector<Frame>& right,
                               std::initializer_list<FrameImage> images = {}) {
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i)
        expect_same_images(left[i], right[i], images, "of frame " + std::to_string(i));
}

inline double mean_of(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

inline double largest_difference(const std::vector<float>& left, const std::vector<float>& right) {
    double largest = 0.0;
    for (std::size_t i = 0; i < left.size(); ++i)
        largest = std::max(largest, std::abs(double{left[i]} - double{right[i]}));
    return largest;
}

// What a pass binds there.
inline const gpu::Image& image_of(const Step& pass, std::size_t binding) {
    return std::get<std::reference_wrapper<const gpu::Image>>(pass.resources.at(binding)).get();
}

// Gloam's own presets: the frame.
inline std::vector<Preset> own_presets() {
    std::vector<Preset> own = presets();
    std::erase_if(own, &Preset::published);
    return own;
}
// And one that sweeps each pixel.
inline std::vector<Preset> frames_of_all_resolutions() {
    std::vector<Preset> all = own_presets();
    all.push_back(preset_named("reference"));
    all.back().name = "full";
    all.back().settings.resolution = Resolution::full;
    return all;
}
inline std::string preset_name(const testing::TestParamInfo<Preset>& info) {
    return info.param.name;
}

// The study's sweep, one frame of many slices: what the frame estimates, without its noise.
inline Settings many_slices(float radius) {
    Settings many = with_radius(with_method({}, "sweep"), radius);
    many.history = false;
    many.filter = Filter::none;
    many.c_rot = 2.0F;
    many.own.steps = 16;
    many.samples = many.samples_converged = 2 * 16 * 32;
    return many;
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

    void TearDown() override { EXPECT_THAT(device_.take_validation_messages(), IsEmpty()); }

    gpu::Device& device_ = *test::SharedDevice::get();
    const scene::PassLibrary& passes_ = shared_->passes;

    // The same for all tests of a suite, so that pipelines are compiled once; for images of that size until
    // the next call with another. begin() leaves no trace of what it held before
    // (tests/experiment/configuration_study_test.cpp).
    [[nodiscard]] AmbientOcclusion& effect_for(gpu::Extent extent) const {
        if (!shared_->effect) shared_->effect.emplace(device_, passes_, extent);
        AmbientOcclusion& effect = *shared_->effect;
        if (shared_->extent && *shared_->extent != extent) {
            effect.begin(wall(*shared_->extent, 1.0F), {});
            effect.advance(wall(extent, 1.0F));
        }
        shared_->extent = extent;
        return effect;
    }

    [[nodiscard]] scene::GBuffer drawn(const scene::Scene& scene, gpu::Extent extent,
                                       const scene::DrawOptions& options = {}) const {
        return scene::draw(scene, extent, options);
    }
    // A view of a built-in scene, drawn once for all tests of a suite.
    [[nodiscard]] const scene::GBuffer& drawn(const std::string& scene, gpu::Extent extent,
                                              const scene::DrawOptions& options = {}) const {
        const auto& [frame, motion, ids, color, layers, guard] = options;
        const Drawing drawing{scene, extent.width, extent.height, frame, motion, ids, color, layers, guard};
        const auto known = shared_->drawn.find(drawing);
        if (known != shared_->drawn.end()) return known->second;
        return shared_->drawn.emplace(drawing, drawn(scene::make_scene(scene), extent, options))
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
