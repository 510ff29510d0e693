// SPDX-License-Identifier: MIT
#include "scene/lighting.hpp"

#include "scene/gbuffer.hpp"
#include "scene/mesh.hpp"
#include "scene/support.hpp"
#include "scene/truth.hpp"

namespace gloam::scene::test::depth_field_test {

// A view whose depths are those of planes n . x = c in view space, the nearest first; rounded to float.
struct Plane {
    glm::dvec3 normal;
    double offset;
};

GBuffer view_of(const std::vector<Plane>& planes, gpu::Extent extent, Projection projection,
                bool normals = true) {
    GBuffer view{.extent = extent};
    view.camera = make_frame({.projection = projection, .fovy_rad = 0.9, .view_height = 4.0},
                             1.0 * extent.width / extent.height);
    const PixelPositions positions(view);
    for (std::size_t i = 0; i < std::size_t{extent.width} * extent.height; ++i) {
        const glm::dvec3 near = positions.at(i, 1.0);
        const glm::dvec3 far = positions.at(i, 2.0);
        double depth = infinity;
        glm::dvec3 normal(0.0);
        for (const Plane& plane : planes) {
            // Along the view ray, position = near + t (far - near), depth = 1 + t.
            const double t =
                (plane.offset - glm::dot(plane.normal, near)) / glm::dot(plane.normal, far - near);
            if (!(1.0 + t > 0.0 && 1.0 + t < depth)) continue;
            depth = 1.0 + t;
            normal = plane.normal;
        }
        view.depth.push_back(static_cast<float>(depth));
        if (normals) view.normal.emplace_back(normal);
    }
    return view;
}

const TruthSettings few_rays{.rays = {.radius = 0.5, .rays = 64}};

double largest(const std::vector<float>& values) {
    return double{*std::ranges::max_element(values)};
}

// However the plane is tilted, and whether its normals are given or found.
TEST(DepthField, OfAPlaneIsOpen) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const double tilt : {0.0, 0.5, 1.2, 1.45}) {
            for (const bool normals : {true, false}) {
                const Plane plane{{std::sin(tilt) * 0.6, std::sin(tilt) * 0.8, std::cos(tilt)}, -3.0};
                const GBuffer view = view_of({plane}, {48, 32}, projection, normals);
                const TracedTruth truth = trace_depth(view, few_rays);
                // Depths are floats: a bump of one in 10^7 may meet a ray that grazes it.
                EXPECT_LT(largest(truth.occlusion), 0.02) << tilt << " " << normals;
                const double sum = std::accumulate(truth.occlusion.begin(), truth.occlusion.end(), 0.0);
                EXPECT_LT(sum / (48 * 32), 1e-4) << tilt << " " << normals;
            }
        }
    }
}

// If nothing is hidden, the depth buffer contains all geometry: a wall meets a floor, both completely
// visible.
TEST(DepthField, AgreesWithTheGeometryWhereNothingIsHidden) {
    Scene scene{.name = "edge", .mesh = make_parallelogram({-9, -1, -5}, {0, 0, 9}, {18, 0, 0}, 1.0)};
    append(scene.mesh, make_parallelogram({-9, -1, -5}, {18, 0, 0}, {0, 9, 0}, 1.0));
    scene.camera = {.far = infinity};
    const GBuffer view = view_of({{{0, 1, 0}, -1.0}, {{0, 0, 1}, -5.0}}, {96, 64}, Projection::perspective);
    // The same camera, by default.
    ASSERT_EQ(view.camera.p00_p11(), make_frame(scene.camera, 1.5).p00_p11());
    const TruthSettings settings{.rays = {.radius = 0.5, .rays = 256}};
    const TracedTruth geometry = trace_geometry(scene, 0, view, settings);
    const TracedTruth depth = trace_depth(view, settings);
    EXPECT_EQ(geometry.unmatched, 0U);
    double squares = 0.0;
    int compared = 0;
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        const std::size_t x = i % 96;
        // The border hides what is outside; the row of pixels over the edge spans a rounded corner.
        if (x < 12 || x >= 84 || i / 96 >= 52) continue;
        const double error = double{depth.occlusion[i]} - double{geometry.occlusion[i]};
        squares += error * error;
        ++compared;
    }
    EXPECT_GT(compared, 3000);
    EXPECT_GT(largest(geometry.occlusion), 0.2);
    EXPECT_LT(std::sqrt(squares / compared), 0.02);
}

// A square before a wall, 3 before it: as a solid it shades the wall beside it, as a sheet it is too far
// away.
TEST(DepthField, ThicknessSaysWhatIsBehindTheSurface) {
    GBuffer view = view_of({{{0, 0, 1}, -5.0}}, {64, 64}, Projection::orthographic);
    for (std::size_t i = 0; i < view.depth.size(); ++i)
        if (i % 64 < 32) view.depth[i] = 2.0F;
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
    const GBuffer view = view_of({{{0, 1, 0}, -1.0}}, {32, 64}, Projection::perspective);
    const Mesh sheet = depth_field(view, 0.01);
    const Mesh solid = depth_field(view);
    const auto rows_below = std::ranges::count_if(view.depth, [](float d) { return std::isfinite(d); }) / 32;
    EXPECT_EQ(static_cast<long>(sheet.triangle_count()), 2 * 31 * (rows_below - 1));
    EXPECT_EQ(solid.triangle_count(), sheet.triangle_count());
}

TEST(DepthField, BackgroundIsOpenAndTheEdgeOfAnObjectShadesNothing) {
    GBuffer view = view_of({{{0, 0, 1}, -5.0}}, {32, 32}, Projection::perspective);
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        if (i % 32 >= 8 && i % 32 < 24) continue;
        view.depth[i] = infinity;
        view.normal[i] = glm::vec3(0);
    }
    const TracedTruth truth = trace_depth(view, few_rays);
    EXPECT_LT(largest(truth.occlusion), 1e-3);
    EXPECT_EQ(truth.pixels, 32U * 16);
}

TEST(DepthField, ViewsThatCannotBe) {
    const GBuffer good = view_of({{{0, 0, 1}, -5.0}}, {4, 4}, Projection::perspective);
    GBuffer view = good;
    view.depth.pop_back();
    expect_error<std::invalid_argument>([&] { (void)trace_depth(view, few_rays); }, {"15 depths", "4 x 4"});
    view = good;
    view.normal.pop_back();
    expect_error<std::invalid_argument>([&] { (void)trace_depth(view, few_rays); }, {"15 normals"});
    view = good;
    std::ranges::fill(view.depth, infinity);
    expect_error<std::invalid_argument>([&] { (void)trace_depth(view, few_rays); }, {"no geometry"});
    expect_error<std::invalid_argument>([&] { (void)depth_field(good, 0.0); }, {"thickness"});
    expect_error<std::invalid_argument>([&] { (void)depth_field(good, std::nan("")); }, {"thickness"});
    TruthSettings none = few_rays;
    none.rays.rays = 0;
    expect_error<std::invalid_argument>([&] { (void)trace_depth(good, none); }, {"0 rays"});
}

TEST(DepthField, OfOnePixelIsOpen) {
    for (const gpu::Extent extent : {gpu::Extent{1, 1}, gpu::Extent{1, 5}, gpu::Extent{5, 1}}) {
        const GBuffer view = view_of({{{0, 0, 1}, -5.0}}, extent, Projection::perspective, false);
        EXPECT_EQ(largest(trace_depth(view, few_rays).occlusion), 0.0);
    }
}

}  // namespace gloam::scene::test::depth_field_test
