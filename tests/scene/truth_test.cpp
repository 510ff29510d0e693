// SPDX-License-Identifier: MIT
#include "scene/truth.hpp"
#include "scene/draw.hpp"
#include "scene/mesh.hpp"
#include "scene/picture_light.hpp"
#include "scene/scene.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::truth_test {

using scene::GBuffer;
using scene::PictureLight;

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
    const PixelPositions positions(view);
    const glm::dmat3 turn = glm::transpose(view_rotation(scene.camera));
    double judged = 0.0;
    std::array<double, 3> beyond{};
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        const glm::dvec3 world = scene.camera.eye + turn * positions.at(i, double{view.depth[i]});
        const double error = std::abs(double{truth.occlusion[i]} - corner_occlusion_at(world, 1.0));
        const double deviation = truth.standard_error[i];
        ASSERT_LT(error, 8.0 * deviation + 1e-3)
            << i;  // where a ray in a hundred is blocked few parts see one
        if (!(deviation > 1e-3)) continue;
        judged += 1.0;
        for (std::size_t k = 0; k < 3; ++k)
            beyond[k] += error > static_cast<double>(k + 1) * deviation ? 1 : 0;
    }
    std::printf("%.0f pixels; beyond 1, 2, 3 standard errors: %.4f %.4f %.4f\n", judged, beyond[0] / judged,
                beyond[1] / judged, beyond[2] / judged);
    EXPECT_GT(judged, 1000.0);
    EXPECT_NEAR(beyond[0] / judged, 0.333, 0.05);
    EXPECT_NEAR(beyond[1] / judged, 0.064, 0.03);
    EXPECT_LT(beyond[2] / judged, 0.02);
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
    const std::vector<float> before = TruthCache("").before(scene, 1, view, settings(1.0, 1024));
    const std::vector<float> now = trace_geometry(scene, 1, view, settings(1.0, 1024)).occlusion;
    const glm::dmat3 turn = glm::transpose(view_rotation(camera_at(scene, 1)));
    double largest_change = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!is_surface(view.depth[i])) continue;
        const glm::dvec3 at =
            camera_at(scene, 1).eye + turn * PixelPositions(view).at(i, double{view.depth[i]});
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
    Scene near = far;
    const glm::dvec3 shift = -glm::round(far.camera.target);
    near.mesh = placed(far.mesh, 1.0, shift);
    near.camera.eye += shift;
    near.camera.target += shift;
    near.camera_path = nullptr;
    far.camera_path = nullptr;
    for (MovingObject& object : near.objects) {
        object.transform = [move = object.transform, shift](int frame) {
            glm::dmat4 matrix = move(frame);
            matrix[3] += glm::dvec4(shift, 0.0);
            return matrix;
        };
    }
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

TEST(TruthTest, TellsHowFarItIs) {
    const Scene scene = make_scene("corner");
    const GBuffer view = shot(scene, {32, 18});
    TruthSettings watched = settings(0.5, 32, 2);
    std::vector<double> told;
    watched.progress = [&](double part) { told.push_back(part); };
    (void)trace_geometry(scene, 0, view, watched);
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_LE(told.back(), 1.0);
    EXPECT_GT(told.front(), 0.0);
}

TEST(TruthTest, OfWhatCannotBeTraced) {
    Scene scene = make_scene("corner");
    GBuffer view = shot(scene, {8, 8});
    expect_error<std::invalid_argument>([&] { (void)trace_geometry(scene, 0, view, settings(0.5, 0)); },
                                        {"0 rays", "32"});
    expect_error<std::invalid_argument>([&] { (void)trace_geometry(scene, 0, view, settings(-1.0, 64)); },
                                        {"radius"});
    scene.mesh.positions[3].y = nan;
    expect_error<std::invalid_argument>([&] { (void)trace_geometry(scene, 0, view, settings(0.5, 64)); },
                                        {"corner", "vertex 3", "finite"});
    scene = {.name = "void"};
    expect_error<std::invalid_argument>([&] { (void)trace_geometry(scene, 0, view, settings(0.5, 64)); },
                                        {"void", "no triangles"});
    scene = make_scene("corner");
    view.normal.clear();
    expect_error<std::invalid_argument>([&] { (void)trace_geometry(scene, 0, view, settings(0.5, 64)); },
                                        {"0 normals", "64 pixels"});
}

TEST(TruthTest, IsKept) {
    const TemporaryDirectory folder;
    const TruthCache cache(folder.path() / "truth");
    const Scene scene = make_scene("moving");
    const GBuffer view = shot(scene, {16, 9});
    int traced = 0;
    TruthSettings watched = settings(0.4, 64, 1);
    watched.progress = [&](double part) { traced += part == 1.0 ? 1 : 0; };
    const TracedTruth first = cache.geometry(scene, 0, view, watched);
    const TracedTruth again = cache.geometry(scene, 0, view, watched);
    EXPECT_EQ(traced, 1);
    EXPECT_EQ(bits(again.occlusion), bits(first.occlusion));
    EXPECT_EQ(bits(again.standard_error), bits(first.standard_error));
    EXPECT_EQ(again.rays, first.rays);
    EXPECT_EQ(again.pixels, first.pixels);
    // Anything that counts makes it another one.
    (void)cache.geometry(scene, 1, view, watched);
    EXPECT_EQ(traced, 2);
    watched.rays.rays = 128;
    (void)cache.geometry(scene, 0, view, watched);
    watched.rays.falloff = Falloff::step;
    (void)cache.geometry(scene, 0, view, watched);
    (void)cache.depth(view, watched);
    watched.thickness = 0.3;
    (void)cache.depth(view, watched);
    EXPECT_EQ(traced, 6);
    (void)cache.depth(view, watched);
    EXPECT_EQ(traced, 6);
}

TEST(TruthTest, ThatIsDamagedIsTracedAgain) {
    const TemporaryDirectory folder;
    const TruthCache cache(folder.path());
    const Scene scene = make_scene("moving");
    const GBuffer view = shot(scene, {16, 9});
    const TracedTruth first = cache.depth(view, settings(0.4, 64));
    const auto file = *std::filesystem::directory_iterator(folder.path());
    const std::string whole = read_file(file.path());
    for (const std::size_t place : {std::size_t{0}, whole.size() / 2, whole.size() - 1}) {
        std::string damaged = whole;
        damaged[place] ^= 1;
        std::ofstream(file.path(), std::ios::binary) << damaged;
        EXPECT_EQ(bits(cache.depth(view, settings(0.4, 64)).occlusion), bits(first.occlusion));
        EXPECT_EQ(read_file(file.path()), whole);
    }
    std::filesystem::resize_file(file.path(), whole.size() / 2);
    EXPECT_EQ(bits(cache.depth(view, settings(0.4, 64)).occlusion), bits(first.occlusion));
}

// A whole file of the same size is the truth of something else, under another's name.
TEST(TruthTest, ThatWasExchangedIsTracedAgain) {
    const TemporaryDirectory folder;
    const TruthCache cache(folder.path());
    const Scene scene = make_scene("moving");
    const GBuffer view = shot(scene, {16, 9});
    const TracedTruth one = cache.depth(view, settings(0.4, 64));
    const auto file = std::filesystem::directory_iterator(folder.path())->path();
    const std::string whole = read_file(file);
    std::filesystem::remove(file);
    const TracedTruth other = cache.depth(view, settings(0.2, 64));
    ASSERT_NE(bits(other.occlusion), bits(one.occlusion));
    const auto other_file = std::filesystem::directory_iterator(folder.path())->path();
    std::ofstream(other_file, std::ios::binary) << whole;
    EXPECT_EQ(bits(cache.depth(view, settings(0.2, 64)).occlusion), bits(other.occlusion));
}

// The light of pictures at several samples of a pixel: which pixel a sample shows, and the mean of the
// samples.

constexpr float background = infinity;

// A view of walls that face the eye, with these depths.
GBuffer walls(gpu::Extent extent, const std::vector<float>& depth) {
    GBuffer view{.extent = extent, .depth = depth, .camera = scene::make_frame({}, 1.0)};
    view.normal.assign(depth.size(), glm::vec3(0, 0, 1));
    return view;
}

// 2 x 2 pixels of 2 x 2 samples: a near wall on the left ends in the middle of the second column of samples.
PictureLight edge() {
    const GBuffer view = walls({2, 2}, {1, 4, 1, 4});
    const GBuffer fine = walls({4, 4}, {1, 4, 4, 4, 1, 4, 4, 4, 1, 1, 4, background, 1, 1, 4, 4});
    return scene::picture_light(view, fine, 2, nullptr);
}

TEST(PictureLight, ASampleShowsThePixelWhosePlaneItLiesOn) {
    EXPECT_EQ(edge().pixel, (std::vector<std::uint32_t>{0, 1, 1, 1, 0, 1, 1, 1, 2, 2, 3, 3, 2, 2, 3, 3}));
    EXPECT_EQ(edge().spread({0.1F, 0.2F, 0.3F, 0.4F}),
              (std::vector<float>{0.1F, 0.2F, 0.2F, 0.2F, 0.1F, 0.2F, 0.2F, 0.2F, 0.3F, 0.3F, 0.4F, 0.4F,
                                  0.3F, 0.3F, 0.4F, 0.4F}));
}

TEST(PictureLight, ATiltedPlaneIsOnePixelsOwn) {
    // The plane z = -4 + 2 x: depths of samples differ by far more than the tolerance, and each lies on it.
    GBuffer view = walls({2, 2}, std::vector<float>(4));
    GBuffer fine = walls({4, 4}, std::vector<float>(16));
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-2, 0, 1));
    for (GBuffer* one : {&view, &fine}) {
        one->normal.assign(one->depth.size(), glm::vec3(normal));
        const scene::PixelPositions positions(*one);
        for (std::size_t i = 0; i < one->depth.size(); ++i) {
            const glm::dvec3 ray = positions.at(i, 1.0);
            one->depth[i] = static_cast<float>(4.0 / (1.0 + 2.0 * ray.x));
        }
    }
    EXPECT_EQ(scene::picture_light(view, fine, 2, nullptr).pixel,
              (std::vector<std::uint32_t>{0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 3, 3, 2, 2, 3, 3}));
}

TEST(PictureLight, ThePictureIsTheMeanOfItsSamples) {
    std::vector<glm::vec3> samples;
    for (int i = 0; i < 16; ++i) samples.emplace_back(static_cast<float>(i));
    const std::vector<glm::vec3> means = edge().mean(samples);
    ASSERT_EQ(means.size(), 4U);
    const float expected[] = {2.5F, 4.5F, 10.5F, 12.5F};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(means[i], glm::vec3(expected[i]));
}

TEST(PictureLight, OneSampleIsThePixelItself) {
    const GBuffer view = walls({2, 1}, {1, 4});
    const PictureLight one = scene::picture_light(view, view, 1, nullptr);
    EXPECT_EQ(one.pixel, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(one.light.direct, scene::light_of(view, nullptr).direct);
}

TEST(PictureLight, OtherSizesAreRefused) {
    const GBuffer view = walls({2, 1}, {1, 4});
    EXPECT_THROW((void)scene::picture_light(view, view, 2, nullptr), std::invalid_argument);
    EXPECT_THROW((void)edge().spread({0.0F}), std::invalid_argument);
    EXPECT_THROW((void)edge().mean({glm::vec3(0)}), std::invalid_argument);
}

}  // namespace gloam::scene::test::truth_test
