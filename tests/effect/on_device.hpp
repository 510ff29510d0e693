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

// Fails unless the images of two frames have the same bits.
inline void expect_same_images(const Frame& left, const Frame& right, const std::string& what = "") {
    for (const auto image : {&Frame::occlusion, &Frame::filtered, &Frame::convergence, &Frame::kept})
        EXPECT_TRUE(same_bits(left.*image, right.*image, left.extent.width)) << what;
}

// Fails unless the images of each frame of two sequences have the same bits.
inline void expect_same_images(const std::vector<Frame>& left, const std::vector<Frame>& right) {
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i)
        expect_same_images(left[i], right[i], "of frame " + std::to_string(i));
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

// Changes settings by words NAME=VALUE, in their order; preset, method and radius as commands name them.
inline Settings with(Settings settings, const std::string& changes) {
    std::istringstream words(changes);
    for (std::string word; words >> word;) {
        const std::string name = word.substr(0, word.find('='));
        const std::string value = word.substr(name.size() + 1);
        if (name == "preset") {
            settings = preset_named(value).settings;
        } else if (name == "method") {
            settings = with_method(settings, value);
        } else if (name == "radius") {
            settings = with_radius(settings, std::stof(value));
        } else {
            set(settings, name, value);
        }
    }
    return settings;
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

    backend::vulkan::Device& device_ = *test::SharedDevice::get();
    const scene::PassLibrary& passes_ = shared_->passes;

    // The same for all tests of a suite, so that pipelines are compiled once. begin() leaves no trace of what
    // it held before (tests/experiment/configuration_study_test.cpp).
    [[nodiscard]] static AmbientOcclusion& shared_effect() { return shared_->effect; }

    [[nodiscard]] scene::GBuffer drawn(const scene::Scene& scene, backend::Extent extent,
                                       const scene::DrawOptions& options = {}) const {
        return scene::draw(scene, extent, options);
    }
    // A view of a built-in scene, drawn once for all tests of a suite.
    [[nodiscard]] const scene::GBuffer& drawn(const std::string& scene, backend::Extent extent,
                                              const scene::DrawOptions& options = {}) const {
        const auto& [frame, motion, color, layers, guard] = options;
        const Drawing drawing{scene, extent.width, extent.height, frame, motion, color, layers, guard};
        const auto known = shared_->drawn.find(drawing);
        if (known != shared_->drawn.end()) return known->second;
        return shared_->drawn[drawing] = drawn(scene::make_scene(scene), extent, options);
    }

    // So many frames of a scene, from that of the options on.
    template <class Scene>
    [[nodiscard]] std::vector<scene::GBuffer> sequence_of(const Scene& scene, backend::Extent extent,
                                                          int frames, scene::DrawOptions options = {}) const {
        std::vector<scene::GBuffer> views;
        for (; frames > 0; --frames, ++options.frame) views.push_back(drawn(scene, extent, options));
        return views;
    }

    // The last of so many frames of one view, each of its passes run `repeat` times.
    [[nodiscard]] Frame run(const scene::GBuffer& view, const Settings& settings, int frames = 1,
                            int repeat = 1) const {
        AmbientOcclusion& effect = shared_effect();
        effect.begin(view, settings);
        for (int i = 1; i < frames; ++i) (void)effect.next(repeat);
        return effect.next(repeat);
    }

    // A sequence: a frame of each view.
    [[nodiscard]] std::vector<Frame> run(const std::vector<scene::GBuffer>& views,
                                         const Settings& settings) const {
        AmbientOcclusion& effect = shared_effect();
        std::vector<Frame> frames;
        for (const scene::GBuffer& view : views) {
            frames.empty() ? effect.begin(view, settings) : effect.advance(view);
            frames.push_back(effect.next());
        }
        return frames;
    }

  private:
    // What is drawn: scene, extent and options.
    using Drawing = std::tuple<std::string, std::uint32_t, std::uint32_t, int, bool, bool, int, double>;

    struct Shared {
        scene::PassLibrary passes{GLOAM_GLSL_DIR, variable("GLOAM_CACHE_DIR")};
        AmbientOcclusion effect{*test::SharedDevice::get(), passes};
        std::map<Drawing, scene::GBuffer> drawn;
    };

    inline static std::optional<Shared> shared_;
};

}  // namespace gloam::effect
