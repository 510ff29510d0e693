// SPDX-License-Identifier: MIT
#include "scene/truth.hpp"

#include "effect/surface_views.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::truth_test {

GBuffer shot(const Scene& scene, backend::Extent extent, int frame = 0) {
    return draw(scene, extent, {.frame = frame});
}

TruthSettings settings(double radius, int rays) {
    return {.rays = {.radius = radius, .rays = rays}};
}

// Of the geometry and of the depth buffer, in which nothing of it is hidden but what is beside the image: a
// rendered view of the corner against its closed form, pixel by pixel.
TEST(TruthTest, OfTheCornerIsItsClosedForm) {
    const Scene scene = make_scene("corner");
    const GBuffer view = shot(scene, {96, 64});
    const TracedTruth geometry = trace_geometry(scene, 0, view, settings(0.5, 256));
    const TracedTruth depth = trace_depth(view, settings(0.5, 256));
    double squares = 0.0;
    double compared = 0.0;
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        const double known = corner_occlusion_at(world_of(view, scene.camera, i), 0.5);
        // Where a ray in a hundred is blocked few parts of the rays see one.
        ASSERT_NEAR(geometry.occlusion[i], known, 8.0 * geometry.standard_error[i] + 1e-3) << i;
        const std::size_t x = i % 96;
        if (x < 12 || x >= 84 || i / 96 < 12 || i / 96 >= 52) continue;
        squares += std::pow(double{depth.occlusion[i]} - known, 2.0);
        compared += 1.0;
    }
    EXPECT_LT(std::sqrt(squares / compared), 0.02);
    EXPECT_EQ(geometry.unmatched, 0U);
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

// Every pixel finds its surface again, and no point is shut in by accident: dots that are blocked all around
// between neighbours that are not.
TEST(TruthTest, OfEveryBuiltInSceneHasNoHolesAndNoDots) {
    for (const ViewInfo& info : all_views()) {
        if (info.kind != "scene") continue;
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

const TruthSettings few_rays{.rays = {.radius = 0.5, .rays = 64}};

double largest(const std::vector<float>& values) {
    return double{*std::ranges::max_element(values)};
}

// However the plane is tilted, and whether its normals are given (rows 0) or found, with rows down or up.
TEST(DepthField, OfAPlaneIsOpen) {
    for (const Projection projection : projections) {
        for (const double tilt : {0.0, 0.5, 1.2, 1.45}) {
            for (const float rows : {0.0F, 1.0F, -1.0F}) {
                const glm::dvec3 normal{std::sin(tilt) * 0.6, std::sin(tilt) * 0.8, std::cos(tilt)};
                GBuffer view = effect::plane({48, 32}, projection == Projection::orthographic, normal);
                if (rows != 0.0F) view.normal.clear();
                if (rows < 0.0F) view.camera.proj_vk[1][1] *= rows;
                for (std::size_t i = 0; const glm::dvec3 found : depth_field(view).normals)
                    ASSERT_LE(glm::dot(found, PixelPositions(view).ray(i++).direction), 0.0) << rows;
                const TracedTruth truth = trace_depth(view, few_rays);
                // Depths are floats: a bump of one in 10^7 may meet a ray that grazes it.
                EXPECT_LT(largest(truth.occlusion), 0.02) << tilt << " " << rows;
                EXPECT_LT(std::accumulate(truth.occlusion.begin(), truth.occlusion.end(), 0.0), 0.15) << tilt;
            }
        }
    }
}

// A square before a wall, 3 before it: as a solid it shades the wall beside it, as a sheet it is too far
// away.
TEST(DepthField, ThicknessSaysWhatIsBehindTheSurface) {
    const GBuffer view =
        effect::view_of({64, 64}, true, [](glm::dvec2 at) { return at.x < 0.0 ? 2.0 : 5.0; });
    TruthSettings settings = few_rays;
    const std::size_t beside = 32 * 64 + 33;
    const TracedTruth solid = trace_depth(view, settings);
    EXPECT_GT(solid.occlusion[beside], 0.15F);
    settings.thickness = 1.0;
    const TracedTruth sheet = trace_depth(view, settings);
    EXPECT_EQ(sheet.occlusion[beside], 0.0F);
    EXPECT_EQ(sheet.occlusion[32 * 64 + 10], 0.0F);
}

// A floor to the horizon jumps by metres from pixel to pixel and is a plane all the same.
TEST(DepthField, ASlopeIsNoJump) {
    const GBuffer view = effect::view_of(
        {32, 64}, false, [](glm::dvec2 at) { return at.y < 0.0 ? -1.0 / at.y : double{infinity}; });
    const Mesh sheet = depth_field(view, 0.01);
    const Mesh solid = depth_field(view);
    const auto rows_below = std::ranges::count_if(view.depth, [](float d) { return std::isfinite(d); }) / 32;
    EXPECT_EQ(static_cast<long>(sheet.triangle_count()), 2 * 31 * (rows_below - 1));
    EXPECT_EQ(solid.triangle_count(), sheet.triangle_count());
}

TEST(DepthField, BackgroundIsOpenAndTheEdgeOfAnObjectShadesNothing) {
    GBuffer view = effect::wall({32, 32}, 5.0F);
    for (std::size_t i = 0; i < view.depth.size(); ++i)
        if (i % 32 < 8 || i % 32 >= 24) view.depth[i] = infinity;
    const TracedTruth truth = trace_depth(view, few_rays);
    EXPECT_LT(largest(truth.occlusion), 1e-3);
    EXPECT_EQ(truth.pixels, 32U * 16);
}

TEST(DepthField, OfNothingIsRefusedAndOfOnePixelIsOpen) {
    const GBuffer sky = effect::wall({4, 4}, infinity);
    expect_error<std::invalid_argument>([&] { (void)trace_depth(sky, few_rays); }, {"no geometry"});
    for (const backend::Extent extent :
         {backend::Extent{1, 1}, backend::Extent{1, 5}, backend::Extent{5, 1}}) {
        GBuffer view = effect::wall(extent, 5.0F);
        view.normal.clear();
        EXPECT_EQ(largest(trace_depth(view, few_rays).occlusion), 0.0);
    }
}

using KeptTruth = InFolder;

// tests/module has kept files that are damaged.
TEST_F(KeptTruth, IsTracedOnce) {
    const Scene scene = make_scene("moving");
    const GBuffer view = shot(scene, {16, 9});
    TruthSettings kept = settings(0.4, 64);
    kept.cache = folder.path() / "truth";
    int traced = 0;
    kept.progress = [&](double part) { traced += part == 1.0 ? 1 : 0; };
    const TracedTruth first = trace_geometry(scene, 0, view, kept);
    const TracedTruth again = trace_geometry(scene, 0, view, kept);
    EXPECT_EQ(traced, 1);
    EXPECT_EQ(bits(again.occlusion), bits(first.occlusion));
    EXPECT_EQ(bits(again.standard_error), bits(first.standard_error));
    EXPECT_EQ(again.rays, first.rays);
    EXPECT_EQ(again.pixels, first.pixels);
    // Anything that counts makes it another one.
    const std::function<void()> changes[] = {[&] { kept.rays.rays = 128; },
                                             [&] { kept.rays.falloff = Falloff::step; },
                                             [&] { kept.thickness = 0.3; }};
    for (const auto& change : changes) {
        change();
        for (int i = 0; i < 2; ++i) (void)trace_depth(view, kept);
    }
    (void)trace_geometry(scene, 1, view, kept);
    EXPECT_EQ(traced, 5);
}

}  // namespace gloam::scene::test::truth_test
