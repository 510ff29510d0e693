// SPDX-License-Identifier: MIT
// Projections that move by a part of a pixel from frame to frame, as temporal antialiasing wants them: TAA,
// DLSS, FSR.
#include "effect/errors.hpp"
#include "effect/internal/executor.hpp"
#include "effect/internal/passes.hpp"
#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::moving_frames_test {

constexpr backend::Extent extent{240, 150};
constexpr int frame_count = 32;

double radical_inverse(int index, int base) {
    double sum = 0.0;
    for (double place = 1.0 / base; index > 0; index /= base, place /= base) sum += index % base * place;
    return sum;
}

// From the middle of a pixel to a point of it, in pixels: Halton's.
glm::dvec2 point_of(int frame) {
    return {radical_inverse(frame + 1, 2) - 0.5, radical_inverse(frame + 1, 3) - 0.5};
}

// Depth of a board on a floor before a wall. ray: of a pixel, at depth 1. eye: how far it has moved to the
// right.
double depth_under(glm::dvec2 ray, double eye) {
    const glm::dvec2 board = 3.2 * ray + glm::dvec2(eye, 0.6);
    if (std::abs(board.x) < 0.5 && std::abs(board.y) < 0.4) return 3.2;
    return ray.y < -0.2 ? -1.0 / ray.y : 5.0;
}

// What an engine does with its jitter.
enum class Case { none, left_out, reprojected };

// The jitter of a frame, in view space at depth 1.
glm::dvec2 jitter_of(int frame) {
    const glm::dvec2 scale(wall(extent, 1.0F).camera.p00_p11());
    return 2.0 * point_of(std::max(frame, 0)) / glm::dvec2(extent.width, extent.height) / scale;
}

// To the view space in which the jittered image has its camera in the middle.
glm::dmat4 sheared(glm::dvec2 jitter) {
    glm::dmat4 shear(1.0);
    shear[2] = glm::dvec4(jitter, 1.0, 0.0);
    return shear;
}

// A frame of a camera that moves so far to the right each frame; its normals come from depth.
scene::GBuffer view_of_frame(int frame, double speed, Case jitters) {
    const glm::dvec2 jitter = jitters == Case::none ? glm::dvec2(0.0) : jitter_of(frame);
    scene::GBuffer view =
        view_of(extent, false, [&](glm::dvec2 ray) { return depth_under(ray + jitter, speed * frame); });
    view.normal.clear();
    const glm::dvec2 element = jitter * glm::dvec2(view.camera.p00_p11());
    view.camera.proj_vk[2][0] = static_cast<float>(element.x);
    view.camera.proj_vk[2][1] = static_cast<float>(element.y);
    glm::dmat4 moved(1.0);
    moved[3][0] = speed;
    if (jitters == Case::reprojected) moved = sheared(jitter_of(frame - 1)) * moved * sheared(-jitter);
    view.camera.previous_from_current = glm::mat4(moved);
    return view;
}

using Jitter = OnDevice<testing::Test>;

// Reprojected, or left out of the camera's motion: of the last frame of a sequence.
TEST_F(Jitter, ChangesLittle) {
    for (const char* preset : {"balanced", "fast"})
        for (const double speed : {0.0, 0.004}) {
            const auto last = [&](Case jitters) {
                std::vector<scene::GBuffer> views;
                for (int i = 0; i < frame_count; ++i) views.push_back(view_of_frame(i, speed, jitters));
                return run(views, with_radius(preset_named(preset).settings, 0.5F)).back().filtered;
            };
            const std::vector<float> plain = last(Case::none);
            for (const Case jitters : {Case::left_out, Case::reprojected})
                EXPECT_LT(errors_of(last(jitters), plain).rmse, 0.012) << preset << ' ' << speed;
        }
}

// positions_from_motion.comp: where surface points were, from an engine's motion vectors.

class MotionVectors : public OnDevice<testing::Test> {
  protected:
    // What the pass writes for a view. unit: of the vectors, pixels.
    [[nodiscard]] std::vector<glm::vec3> positions(const scene::GBuffer& view, const scene::GBuffer& previous,
                                                   glm::vec2 unit = {1, 1}) {
        std::vector<float> motion;
        for (const glm::vec3& m : view.motion) {
            const glm::vec2 vector = m.z > 0.5F ? glm::vec2(m) / unit : glm::vec2(nan);
            motion.insert(motion.end(), {vector.x, vector.y, 0, 0});
        }
        Resources resources(device_);
        resources.image("depth", extent, backend::vulkan::Format::r32f).upload(view.depth);
        resources.image("motion", extent, backend::vulkan::Format::rgba32f).upload(motion);
        backend::vulkan::Image& written =
            resources.image("previous_position", extent, backend::vulkan::Format::rgba32f);
        const View now{view.camera, extent, {}};
        const View before{previous.camera, extent, {}};
        Moment moment;
        moment.look(now, before);
        Values values = values_of(moment);
        values.set("motion_unit", unit);
        Executor executor(device_, passes_);
        executor.run("positions_from_motion", {.file = "study/positions_from_motion.comp"},
                     {"depth", "motion", "previous_position"}, values, groups_for(extent), resources);
        return vectors_of(written.download());
    }
};

// The camera and objects move, across the image for the most part. Without a vector only what the camera has
// brought in is known: here it has moved to the right as well.
TEST_F(MotionVectors, GiveThePositionsOfMovingObjects) {
    const scene::GBuffer previous = drawn("moving", extent, {.frame = 20, .motion = true});
    scene::GBuffer view = drawn("moving", extent, {.frame = 21, .motion = true});
    view.previous_depth.clear();  // as of an engine that has none
    view.depth[7] = infinity;
    glm::mat4 change(1.0F);
    change[3].x = 0.5F;
    for (const bool has_vectors : {true, false}) {
        if (!has_vectors) {
            for (glm::vec3& motion : view.motion) motion.z = 0.0F;
            view.camera.previous_from_current = change;
        }
        scene::GBuffer linked = view;
        linked.previous_position.clear();
        link(linked, previous);
        const std::vector<glm::vec3> found = positions(view, previous);
        const std::vector<glm::vec3> scaled =
            positions(view, previous, {-48, 27});  // vectors from -1 to 1, turned
        EXPECT_EQ(found[7], glm::vec3(0)) << "background";
        for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_LE(glm::distance(found[i], linked.previous_position[i]), 2e-4F) << i;
            ASSERT_LE(glm::distance(scaled[i], found[i]), 2e-4F) << i;
        }
        const auto known = std::ranges::count_if(found, [](const auto& p) { return p != glm::vec3(0); });
        EXPECT_GT(known, has_vectors ? static_cast<long>(found.size() * 9 / 10) : 10);
    }
}

// The plan has the pass before all that reads positions, and the engine's image in the place of theirs.
TEST_F(MotionVectors, TakeThePlaceOfPositionsInAPlan) {
    const Plan plan = plan_of({}, {.motion_vectors = true}, passes_);
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

}  // namespace gloam::effect::moving_frames_test
