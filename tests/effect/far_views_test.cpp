// SPDX-License-Identifier: MIT
// The frame where the eye stands many radii away from what it sees, and a radius still has many pixels:
// orthographic cameras, and narrow ones.
#include "effect/errors.hpp"
#include "on_device.hpp"
#include "scene/truth.hpp"
#include "surface_views.hpp"

namespace gloam::effect::far_views_test {

constexpr backend::Extent extent{110, 72};
constexpr double radius = 0.5;

class FarViews : public OnDevice<testing::TestWithParam<Preset>> {
  protected:
    [[nodiscard]] static Settings settings() {
        return with(with_radius(GetParam().settings, radius), "output=r32f");
    }
};

// An orthographic eye further away. The stored depth has steps of at most 1/1000 of the radius.
struct Away {
    const char* depth;
    bool reversed;
    double units;
    int bits;
};
constexpr Away standpoints[] = {{"linear", false, 30.0, 32},   {"linear", false, 700.0, 32},
                                {"linear", false, 3900.0, 32}, {"buffer", false, 700.0, 32},
                                {"buffer", true, 3900.0, 32},  {"buffer", false, 1e5, 24},
                                {"buffer", true, 1e5, 24},     {"buffer", false, -9.0, 32}};

TEST_P(FarViews, AnOrthographicPictureIsTheSameFromEverywhere) {
    for (const Away& away : standpoints) {
        const Engine engine{away.depth, "view", away.reversed, 20.0, scene::Projection::orthographic,
                            away.bits};
        scene::GBuffer view = drawn(seen_by(engine), extent);
        const std::vector<float> near = run(view, settings(), 3).filtered;
        EXPECT_GT(mean_of(near), 0.02);
        Engine moved = engine;
        moved.before_near = -away.units;
        store(moved, view);
        if (!view.stored->encoding.depth_buffer)
            for (float& depth : view.stored->depth) depth += static_cast<float>(away.units);
        const std::vector<float> far = run(view, settings(), 3).filtered;
        EXPECT_LE(errors_of(far, near).mean, 1.0 / 255.0) << away.depth << ' ' << away.units;
        EXPECT_LE(largest_difference(far, near), 4.0 / 255.0) << away.depth << ' ' << away.units;
    }
}

// Steps of a quarter of a radius: no stripes, whatever else is lost.
TEST_P(FarViews, APlaneInCoarseStepsIsOpen) {
    scene::GBuffer view = plane(extent, true, {0.3, 0.9, 1});
    for (float& depth : view.depth) depth += 30000.0F;
    EXPECT_LE(std::ranges::max(run(view, settings(), 3).filtered), 0.02F);
}

// Of a full vertical angle in degrees, as far away as shows the same.
scene::Camera narrowed(scene::Camera camera, double degrees) {
    const double angle = glm::radians(degrees);
    camera.eye =
        camera.target + (camera.eye - camera.target) * (std::tan(camera.fovy_rad / 2) / std::tan(angle / 2));
    camera.far = 50.0 + glm::distance(camera.eye, camera.target);
    camera.fovy_rad = angle;
    return camera;
}

scene::Scene seen_at(double degrees) {
    scene::Scene scene = floor_and_wall(true);
    scene.camera.fovy_rad = glm::radians(60.0);
    scene.camera = narrowed(scene.camera, degrees);
    return scene;
}

// Before an orthographic camera, which sees the same as one of 1 degree.
scene::Scene seen_in_parallel() {
    scene::Scene scene = seen_at(1.0);
    scene::Camera& camera = scene.camera;
    camera.projection = scene::Projection::orthographic;
    camera.view_height = 2.0 * glm::distance(camera.eye, camera.target) * std::tan(camera.fovy_rad / 2.0);
    return scene;
}

TEST_P(FarViews, ANarrowViewIsAsRightAsAUsualOne) {
    static std::map<std::pair<double, scene::Projection>, Truth> truths;  // for all presets
    const auto error = [&](const scene::Scene& scene, const char* depth, const char* changes = "") {
        scene::GBuffer view = drawn(scene, extent);
        Truth& truth = truths[{scene.camera.fovy_rad, scene.camera.projection}];
        const scene::TruthSettings traced{.rays = {.radius = radius, .rays = 256}};
        if (truth.empty()) truth = truth_from(view, scene::trace_geometry(scene, 0, view, traced).occlusion);
        store({depth, "view", scene.camera.reversed_z, scene.camera.far}, view);
        return errors_of(run(view, with(settings(), changes)).filtered, truth).rmse;
    };
    const double parallel = error(seen_in_parallel(), "linear");
    EXPECT_LE(error(seen_at(1.0), "linear"), 1.02 * parallel);
    scene::Scene reversed = seen_at(1.0);
    reversed.camera.reversed_z = true;
    EXPECT_LE(error(reversed, "buffer"), 1.02 * parallel);
    // 16 bits serve it.
    EXPECT_LE(error(seen_at(25.0), "buffer"), 1.1 * error(seen_at(25.0), "buffer", "deep=on"));
}

// Of a standard buffer, a quarter of its steps are above the tangent plane: no stripes.
TEST_P(FarViews, ANarrowPlaneIsOpen) {
    scene::Scene scene = seen_at(1.0);
    scene.mesh = scene::make_parallelogram({-4, 0, -3}, {0, 0, 7}, {8, 0, 0}, 0.5);
    scene.objects.clear();
    scene::GBuffer view = drawn(scene, extent);
    store({"buffer", "view", false, scene.camera.far}, view);
    EXPECT_LE(std::ranges::max(run(view, settings(), 3).filtered), 0.02F);
}

// The images stay what they are, and the history follows.
TEST_P(FarViews, AZoomChangesThePictureSmoothly) {
    constexpr int frame_count = 60;
    scene::Scene scene{.name = "test"};
    scene.mesh = scene::make_parallelogram({-60, 0, -60}, {0, 0, 120}, {120, 0, 0}, 0.5);
    for (int i = 0; i < 40 * 40; ++i) {
        const glm::dvec3 corner(i % 40 - 20, 0, i / 40 - 20);
        append(
            scene.mesh,
            scene::make_box(corner, corner + glm::dvec3(0.3 + 0.1 * (i % 5), 0.1 + 0.1 * (i % 7), 0.4), 0.5));
    }
    scene.camera_path = [](int frame) {
        scene::Camera camera{.eye = {0, 16, 14}, .target = {0.1, 0.2, 0}, .far = 200};
        camera.fovy_rad = glm::radians(std::pow(60.0, 1.0 - frame / (frame_count - 1.0)));
        return camera;
    };
    static const std::vector<scene::GBuffer> views = sequence_of(scene, extent, frame_count);
    const Settings deep = with(settings(), "deep=on");
    const std::vector<Frame> frames = run(views, deep);
    std::vector<double> changes;
    for (int i = 1; i < frame_count; ++i)
        changes.push_back(errors_of(frames[i].filtered, frames[i - 1].filtered).mean);
    for (std::size_t i = 0; i + 10 < changes.size(); ++i) {
        std::vector<double> about(changes.begin() + i, changes.begin() + i + 11);
        const double own = about[5];
        std::ranges::nth_element(about, about.begin() + 5);
        EXPECT_LE(own, 1.5 * about[5]) << "frame " << i + 6;
    }
    EXPECT_GT(largest_difference(frames.back().filtered, run(views.back(), deep).filtered), 0.01)
        << "history";
}

INSTANTIATE_TEST_SUITE_P(Names, FarViews, testing::ValuesIn(own_presets()), preset_name);

}  // namespace gloam::effect::far_views_test
