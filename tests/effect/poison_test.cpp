// SPDX-License-Identifier: MIT
// Bad numbers in one frame of a sequence: nothing but numbers from 0 to 1 is shown, the history of the pixels
// dies, and a few frames later nothing is left of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/presets.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect::poison_test {

constexpr gpu::Extent extent{64, 36};
constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int poisoned_frame = 3;

// A block of pixels amid the view.
bool in_block(std::size_t pixel) {
    const std::size_t x = pixel % extent.width;
    const std::size_t y = pixel / extent.width;
    return x >= 24 && x < 34 && y >= 12 && y < 22;
}

using Change = std::function<void(scene::GBuffer&)>;

class Poison : public OnDevice<testing::Test> {
  protected:
    Poison() {
        for (int i = 0; i < 8; ++i)
            views_.push_back(
                scene::rasterize(device_, passes_, scene_, extent, {.frame = 20 + i, .motion = true}));
    }

    // All frames, one of them changed.
    [[nodiscard]] std::vector<Frame> run(const Change& change) const {
        const Settings settings = with_radius(Settings{}, static_cast<float>(scene_.ao_radius));
        std::vector<scene::GBuffer> views = views_;
        change(views[poisoned_frame]);
        return OnDevice::run(views, settings);
    }

    void expect_sane(const std::vector<Frame>& frames, const std::vector<Frame>& clean,
                     const std::string& what) const {
        for (const Frame& frame : frames) {
            for (const auto* image : {&frame.occlusion, &frame.filtered, &frame.convergence})
                EXPECT_THAT(*image, testing::Each(testing::AllOf(testing::Ge(0.0F), testing::Le(1.0F))))
                    << what;
            EXPECT_THAT(frame.kept,
                        testing::Each(testing::Truly([](float v) { return v >= 0 && v < infinity; })));
        }
        // Later the clean frames have outvoted it.
        double difference = 0.0;
        for (std::size_t i = 0; i < clean.back().occlusion.size(); ++i)
            difference += std::abs(double{frames.back().occlusion[i]} - double{clean.back().occlusion[i]});
        EXPECT_LT(difference / static_cast<double>(clean.back().occlusion.size()), 0.01) << what;
    }

    scene::Scene scene_ = scene::make_scene("moving");
    std::vector<scene::GBuffer> views_;
};

const std::vector<float>& bad_values() {
    static const std::vector<float> all{nan_value, -infinity, 3e38F, 0.0F, 1e-40F};
    return all;
}

TEST_F(Poison, DepthsOfOneFrame) {
    const std::vector<Frame> clean = run([](scene::GBuffer&) {});
    for (const float bad : bad_values()) {
        const std::vector<Frame> frames = run([bad](scene::GBuffer& view) {
            for (std::size_t i = 0; i < view.depth.size(); ++i)
                view.depth[i] = in_block(i) ? bad : view.depth[i];
        });
        expect_sane(frames, clean, "depth " + std::to_string(bad));
        std::size_t kept = 0;
        for (std::size_t i = 0; i < extent.width * extent.height; ++i)
            kept += in_block(i) && frames[poisoned_frame + 1].kept[i] > 0.0F ? 1 : 0;
        EXPECT_LT(kept, 40U) << "of 100 that were another surface; the rim is the neighbours'";
    }
}

TEST_F(Poison, EarlierPositionsOfOneFrame) {
    const std::vector<Frame> clean = run([](scene::GBuffer&) {});
    for (const float bad : bad_values()) {
        const std::vector<Frame> frames = run([bad](scene::GBuffer& view) {
            for (std::size_t i = 0; i < view.depth.size(); ++i) {
                if (in_block(i)) view.previous_position[i] = glm::vec3(bad);
            }
        });
        expect_sane(frames, clean, "position " + std::to_string(bad));
        for (std::size_t i = 0; i < extent.width * extent.height; ++i) {
            if (!in_block(i)) continue;
            EXPECT_EQ(frames[poisoned_frame].kept[i], 0.0F) << bad << " " << i;
        }
    }
}

TEST_F(Poison, NormalsOfOneFrame) {
    const std::vector<Frame> clean = run([](scene::GBuffer&) {});
    for (const float bad : bad_values()) {
        const std::vector<Frame> frames = run([bad](scene::GBuffer& view) {
            for (std::size_t i = 0; i < view.depth.size(); ++i) {
                if (in_block(i)) view.normal[i].y = bad;
            }
        });
        expect_sane(frames, clean, "normal " + std::to_string(bad));
    }
}

TEST_F(Poison, MatricesOfOneFrame) {
    const std::vector<Frame> clean = run([](scene::GBuffer&) {});
    for (const float bad : {nan_value, infinity, 0.0F}) {
        const std::vector<Frame> frames = run([bad](scene::GBuffer& view) {
            view.previous_position.clear();
            view.camera.previous_from_current = glm::mat4(bad);
        });
        expect_sane(frames, clean, "matrix " + std::to_string(bad));
        EXPECT_THAT(frames[poisoned_frame].kept, testing::Each(0.0F)) << bad;
    }
}

// From one kind of projection to the other the surfaces stay what they are.
TEST_F(Poison, AnotherKindOfProjectionIsNone) {
    scene_.camera_path = [start = scene_.camera](int frame) {
        scene::Camera camera = start;
        camera.projection = frame % 2 == 0 ? scene::Projection::perspective : scene::Projection::orthographic;
        camera.view_height = 2.0 * std::tan(0.5 * start.fovy_rad) * 4.0;
        return camera;
    };
    scene_.objects.clear();
    const Settings settings = with_radius(Settings{}, 0.4F);
    AmbientOcclusion effect(device_, passes_, extent);
    for (int i = 0; i < 4; ++i) {
        const scene::GBuffer view = scene::rasterize(device_, passes_, scene_, extent, {.frame = i});
        i == 0 ? effect.begin(view, settings) : effect.advance(view);
        const Frame frame = effect.next();
        const auto kept = std::ranges::count_if(frame.kept, [](float v) { return v > 0.0F; });
        EXPECT_EQ(kept > extent.width * extent.height / 3, i > 0) << "frame " << i << ": " << kept;
        EXPECT_THAT(frame.occlusion, testing::Each(testing::AllOf(testing::Ge(0.0F), testing::Le(1.0F))));
    }
}

}  // namespace gloam::effect::poison_test
