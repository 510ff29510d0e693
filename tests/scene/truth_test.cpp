// SPDX-License-Identifier: MIT
#include "scene/truth.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::truth_test {

GBuffer shot(const Scene& scene, gpu::Extent extent, int frame = 0) {
    return draw(scene, extent, {.frame = frame, .ids = true});
}

TruthSettings settings(double radius, int rays, unsigned threads = 0) {
    return {.rays = {.radius = radius, .rays = rays}, .threads = threads};
}

// A rendered view of the corner against its closed form, pixel by pixel: as often beyond one, two and three
// standard errors as Student's t with 15 degrees of freedom is.
TEST(TruthTest, OfTheCornerIsItsClosedForm) {
    const Scene scene = make_scene("corner");
    const GBuffer view = shot(scene, {64, 48});
    const TracedTruth truth = trace_geometry(scene, 0, view, settings(1.0, 256));
    Tally tally;
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        const glm::dvec3 world = world_of(view, scene.camera, i);
        const double error = std::abs(double{truth.occlusion[i]} - corner_occlusion_at(world, 1.0));
        const double deviation = truth.standard_error[i];
        // Where a ray in a hundred is blocked few parts see one.
        ASSERT_LT(error, 8.0 * deviation + 1e-3) << i;
        if (deviation > 1e-3) tally.add(error, deviation);
    }
    tally.expect_student(1000.0);
    EXPECT_EQ(truth.unmatched, 0U);
}

// A wall comes nearer to a floor that stands still: the floor knew the wall at its former distance, and the
// wall's own points had the floor below them as now.
TEST(TruthTest, OfTheFrameBefore) {
    Scene scene{.name = "slide", .mesh = make_parallelogram({-8, 0, -8}, {0, 0, 16}, {16, 0, 0}, 1.0)};
    scene.objects.push_back({make_parallelogram({0, 0, -8}, {0, 8, 0}, {0, 0, 16}, 1.0),
                             [](int frame) { return rigid_motion({0.25 * frame, 0, 0}); }});
    scene.camera = {.eye = {3, 2, 1}, .target = {0.5, 0.3, 0}, .near = 0.1, .far = 40.0};
    scene.camera_path = [start = scene.camera](int frame) {
        Camera camera = start;
        camera.eye.z += 0.1 * frame;
        return camera;
    };
    const GBuffer view = shot(scene, {48, 27}, 1);
    const std::vector<float> before = trace_before(scene, 1, view, settings(1.0, 1024));
    const std::vector<float> now = trace_geometry(scene, 1, view, settings(1.0, 1024)).occlusion;
    double largest_change = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!is_surface(view.depth[i])) continue;
        const glm::dvec3 at = world_of(view, camera_at(scene, 1), i);
        const double from_other = view.object[i] == 0 ? at.x : at.y;
        EXPECT_NEAR(before[i], corner_occlusion(from_other, 2.0, 1.0), 0.01) << i;
        if (view.object[i] == 1 || at.x > 1.3) {
            EXPECT_NEAR(before[i], now[i], 1e-5) << i;
        }
        largest_change = std::max(largest_change, std::abs(double{now[i]} - double{before[i]}));
    }
    EXPECT_GT(largest_change, 0.15);
}

TEST(TruthTest, IsTheSameForAnyNumberOfThreads) {
    const Scene scene = make_scene("moving");
    const GBuffer view = shot(scene, {48, 27}, 3);
    const TracedTruth one = trace_geometry(scene, 3, view, settings(0.4, 64, 1));
    const TracedTruth depth_one = trace_depth(view, settings(0.4, 64, 1));
    for (const unsigned threads : {2U, 3U, 7U, 0U}) {
        const TracedTruth many = trace_geometry(scene, 3, view, settings(0.4, 64, threads));
        EXPECT_EQ(bits(many.occlusion), bits(one.occlusion));
        EXPECT_EQ(bits(many.standard_error), bits(one.standard_error));
        EXPECT_EQ(bits(trace_depth(view, settings(0.4, 64, threads)).occlusion), bits(depth_one.occlusion));
    }
}

// A hundred kilometres away the same shapes have the same occlusion, to the rays' error.
TEST(TruthTest, FarFromTheOriginIsAsGoodAsNearIt) {
    Scene far = make_scene("far");
    far.camera_path = nullptr;
    Scene near = far;
    const glm::dvec3 shift = -glm::round(far.camera.target);
    near.mesh = placed(far.mesh, 1.0, shift);
    near.camera.eye += shift;
    near.camera.target += shift;
    for (MovingObject& object : near.objects)
        object.transform = [move = object.transform, shift](int frame) {
            return glm::translate(glm::dmat4(1.0), shift) * move(frame);
        };
    const GBuffer far_view = shot(far, {64, 36});
    const GBuffer near_view = shot(near, {64, 36});
    EXPECT_EQ(bits(far_view.depth), bits(near_view.depth));
    const TracedTruth far_truth = trace_geometry(far, 0, far_view, settings(0.4, 64));
    EXPECT_EQ(bits(far_truth.occlusion),
              bits(trace_geometry(near, 0, near_view, settings(0.4, 64)).occlusion));
}

// Every pixel finds its surface again, and no point is shut in by accident: dots that are blocked all around
// between neighbours that are not.
TEST(TruthTest, OfEveryBuiltInSceneHasNoHolesAndNoDots) {
    for (const ViewInfo& info : built_in_scenes()) {
        const Scene scene = make_scene(info.name);
        for (const int frame : {0, 17}) {
            const GBuffer view = shot(scene, {96, 54}, frame);
            const TracedTruth truth = trace_geometry(scene, frame, view, settings(scene.ao_radius, 32));
            EXPECT_LE(truth.unmatched, 3U) << info.name;
            int dots = 0;
            for (std::size_t i = 97; i + 97 < truth.occlusion.size(); ++i) {
                const float around = std::max({truth.occlusion[i - 1], truth.occlusion[i + 1],
                                               truth.occlusion[i - 96], truth.occlusion[i + 96]});
                if (truth.occlusion[i] > 0.97F && around < 0.4F) ++dots;
            }
            EXPECT_EQ(dots, 0) << info.name << ", frame " << frame;
        }
    }
}

// The truth of the scene "moving" in a folder of its own.
class KeptTruth : public InFolder {
  protected:
    KeptTruth() { settings_.cache = folder.path() / "truth"; }

    [[nodiscard]] TracedTruth depth() const { return trace_depth(view_, settings_); }
    [[nodiscard]] std::filesystem::path file() const {
        return *std::filesystem::directory_iterator(settings_.cache);
    }

    const Scene scene_ = make_scene("moving");
    const GBuffer view_ = shot(scene_, {16, 9});
    TruthSettings settings_ = settings(0.4, 64, 1);
};

TEST_F(KeptTruth, IsTracedOnce) {
    int traced = 0;
    settings_.progress = [&](double part) { traced += part == 1.0 ? 1 : 0; };
    const TracedTruth first = trace_geometry(scene_, 0, view_, settings_);
    const TracedTruth again = trace_geometry(scene_, 0, view_, settings_);
    EXPECT_EQ(traced, 1);
    EXPECT_EQ(bits(again.occlusion), bits(first.occlusion));
    EXPECT_EQ(bits(again.standard_error), bits(first.standard_error));
    EXPECT_EQ(again.rays, first.rays);
    EXPECT_EQ(again.pixels, first.pixels);
    // Anything that counts makes it another one.
    (void)trace_geometry(scene_, 1, view_, settings_);
    EXPECT_EQ(traced, 2);
    settings_.rays.rays = 128;
    (void)trace_geometry(scene_, 0, view_, settings_);
    settings_.rays.falloff = Falloff::step;
    (void)trace_geometry(scene_, 0, view_, settings_);
    (void)depth();
    settings_.thickness = 0.3;
    (void)depth();
    EXPECT_EQ(traced, 6);
    (void)depth();
    EXPECT_EQ(traced, 6);
}

// Damaged, cut short, or the whole truth of something else under this name.
TEST_F(KeptTruth, ThatIsDamagedOrExchangedIsTracedAgain) {
    const TracedTruth first = depth();
    const std::filesystem::path kept = file();
    const std::string whole = read_file(kept);
    std::string damaged = whole;
    damaged[whole.size() / 2] ^= 1;
    std::filesystem::rename(kept, path("other"));
    settings_.rays.radius = 0.2;
    ASSERT_NE(bits(depth().occlusion), bits(first.occlusion));
    const std::string other = read_file(file());
    settings_.rays.radius = 0.4;
    std::filesystem::remove(file());
    for (const std::string& bytes : {damaged, whole.substr(0, whole.size() / 2), other}) {
        std::ofstream(kept, std::ios::binary) << bytes;
        EXPECT_EQ(bits(depth().occlusion), bits(first.occlusion));
        EXPECT_EQ(read_file(kept), whole);
    }
}

}  // namespace gloam::scene::test::truth_test
