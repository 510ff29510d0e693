// SPDX-License-Identifier: MIT
// positions_from_motion.comp: where surface points were, from an engine's motion vectors.
#include <cmath>
#include <limits>

#include "effect/internal/executor.hpp"
#include "effect/internal/frame_images.hpp"
#include "effect/internal/passes.hpp"
#include "effect/plan.hpp"
#include "on_device.hpp"

namespace gloam::effect::motion_vectors_test {

constexpr gpu::Extent extent{96, 54};
constexpr int first_frame = 20;

class MotionVectors : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] scene::GBuffer frame(int number) const {
        return rasterized("moving", extent, {.frame = first_frame + number, .motion = true});
    }

    // What the pass writes for a view. unit: of the vectors, pixels.
    [[nodiscard]] std::vector<glm::vec3> positions(const scene::GBuffer& view, const scene::GBuffer& previous,
                                                   glm::vec2 unit = {1, 1}) {
        constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
        std::vector<float> motion;
        for (const glm::vec3& m : view.motion) {
            const bool valid = m.z > 0.5F;
            motion.insert(motion.end(),
                          {valid ? m.x / unit.x : unknown, valid ? m.y / unit.y : unknown, 0, 0});
        }
        Resources resources(device_);
        resources.image("depth", extent, gpu::Format::r32f).upload(view.depth);
        resources.image("motion", extent, gpu::Format::rgba32f).upload(motion);
        gpu::Image& written = resources.image("previous_position", extent, gpu::Format::rgba32f);
        const View now{view.camera, extent, {}};
        const View before{previous.camera, extent, {}};
        MotionParameters parameters = motion_parameters(now, before);
        parameters.motion_unit = unit;
        const PlannedPass pass =
            single_pass("positions_from_motion", motion_source(now, before),
                        {"depth", "motion", "previous_position"}, parameters, groups_for(extent));
        Executor(device_, passes_).run(std::span(&pass, 1), resources, {});
        return vectors_of(written.download());
    }
};

// The camera and objects move, across the image for the most part.
TEST_F(MotionVectors, GiveThePositionsOfMovingObjects) {
    const scene::GBuffer previous = frame(0);
    scene::GBuffer view = frame(1);
    view.previous_depth.clear();  // as of an engine that has none
    scene::GBuffer linked = view;
    linked.previous_position.clear();
    link(linked, previous);
    const std::vector<glm::vec3> found = positions(view, previous);
    const std::vector<glm::vec3> scaled =
        positions(view, previous, {-48, 27});  // vectors from -1 to 1, turned
    std::size_t known = 0;
    std::size_t close = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_LE(glm::distance(found[i], linked.previous_position[i]), 2e-4F) << i;
        ASSERT_LE(glm::distance(scaled[i], found[i]), 2e-4F) << i;
        if (found[i] == glm::vec3(0)) continue;
        ++known;
        close += glm::distance(found[i], view.previous_position[i]) < 0.01F ? 1 : 0;
    }
    EXPECT_GT(known, found.size() * 9 / 10);
    EXPECT_GT(close, known * 95 / 100) << "of the points themselves, whose depth has changed as well";
}

TEST_F(MotionVectors, WithoutAVectorOnlyWhatTheCameraBroughtInIsKnown) {
    const scene::GBuffer previous = frame(0);
    scene::GBuffer view = frame(1);
    view.previous_depth.clear();
    glm::mat4 change(1.0F);  // the eye has moved to the right, and what was beyond the right edge comes in
    change[3].x = 0.5F;
    view.camera.previous_from_current = change;
    for (glm::vec3& motion : view.motion) motion.z = 0.0F;
    std::size_t entered = 0;
    const scene::PixelPositions then(previous);
    for (const glm::vec3& position : positions(view, previous)) {
        if (position == glm::vec3(0)) continue;
        ++entered;
        const glm::dvec2 place = then.pixel_of(position);
        const bool inside = place.x > 0 && place.y > 0 && place.x < extent.width && place.y < extent.height;
        ASSERT_FALSE(inside);
    }
    EXPECT_GT(entered, 10U);
}

// The plan has the pass before all that reads positions, and the engine's image in the place of theirs.
TEST(MotionVectorsOfAPlan, TakeThePlaceOfPositions) {
    const Plan plan = plan_of({}, {.motion_vectors = true});
    const auto image = [&](const char* name) {
        return std::ranges::find(plan.images, name, &PlannedImage::name)->origin;
    };
    EXPECT_EQ(image("motion"), PlannedImage::Origin::engine);
    EXPECT_EQ(image("previous_position"), PlannedImage::Origin::frame);
    const auto place = [&](const char* name) {
        return std::ranges::find(plan.passes, name, &PlannedPass::name);
    };
    ASSERT_NE(place("positions_from_motion"), plan.passes.end());
    EXPECT_LT(place("positions_from_motion"), place("reproject"));
    EXPECT_EQ(place("reproject")->resources.at(1), "previous_position");
}

}  // namespace gloam::effect::motion_vectors_test
