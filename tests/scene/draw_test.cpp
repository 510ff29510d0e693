// SPDX-License-Identifier: MIT
// Views by rays: against all triangles on the ray of each pixel.
#include "scene/support.hpp"

namespace gloam::scene::test::draw_test {

// A floor through the near plane, a box that stands still, and one that turns and moves, under a moving
// camera.
constexpr glm::dvec3 low{-0.5, -0.3, -0.4};
const glm::dvec3 still_at{-0.9, 0.2, -4.0};

Camera camera_of(const Camera& like, int frame) {
    Camera camera = like;
    camera.eye = {0.1 + 0.05 * frame, 0.9, 0.02 * frame};
    camera.target = {0.0, 0.1, -4.0};
    return camera;
}

glm::dmat4 motion_of(int frame) {
    return rigid_motion({0.9 - 0.04 * frame, 0.5, -5.0}, 0.3 + 0.1 * frame, {0.6, 0.8, 0});
}

Scene boxes(const Camera& like) {
    Scene scene{.name = "boxes", .mesh = make_parallelogram({-30, -0.5, 30}, {60, 0, 0}, {0, 0, -60}, 7.0)};
    append(scene.mesh, make_box(still_at + low, still_at - low, 0.3));
    scene.objects.push_back({make_box(low, -low, 0.3), motion_of});
    scene.camera_path = [like](int frame) { return camera_of(like, frame); };
    scene.ao_radius = 0.75;
    return scene;
}

// A surface on a ray. depth: along the view axis. normal: against the ray, view space.
struct Surface {
    double depth;
    glm::dvec3 normal;
    std::uint32_t object;
    bool behind;  // seen from within the box
};

// All triangles of a view-space mesh on a ray between two depths, nearest first, by the equation of their
// planes, with the normals of flat faces. moving: the first triangle of the moving object.
std::vector<Surface> along(const Mesh& mesh, std::size_t moving, const PixelPositions::Ray& ray,
                           const Camera& camera) {
    std::vector<Surface> found;
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
        const glm::dvec3 normal = glm::normalize(area_of(mesh, i));
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(mesh.positions[mesh.indices[3 * i + k % 3]]);
        };
        const double slope = glm::dot(normal, ray.direction);
        const double depth = glm::dot(normal, corner(0) - ray.origin) / slope;
        if (!(depth > camera.near && depth < camera.far)) continue;
        const glm::dvec3 at = ray.origin + depth * ray.direction;
        bool inside = true;
        for (const std::size_t k : {0U, 1U, 2U})
            inside &= glm::dot(glm::cross(corner(k + 1) - corner(k), at - corner(k)), normal) >= 0.0;
        const glm::dvec3 outward(mesh.normals[mesh.indices[3 * i]]);
        if (inside)
            found.push_back({depth, slope > 0.0 ? -outward : outward, i >= moving ? 1U : 0U, slope > 0.0});
    }
    std::ranges::sort(found, {}, &Surface::depth);
    return found;
}

struct Row {
    Camera like;
    int frame = 0;
    double guard = 0.0;
};

constexpr auto orthographic = Projection::orthographic;
const std::vector<Row> rows{{{}},
                            {{.far = double{infinity}, .reversed_z = true}, 1},
                            {{.far = double{infinity}}, 7, 0.2},
                            {{.far = 5.0, .reversed_z = true}, 2},
                            {{.projection = orthographic}, 3},
                            {{.projection = orthographic, .far = 6.0, .reversed_z = true}, 4, 0.1}};

// Whether the same surfaces are seen a hundredth of a pixel aside: no edge is there.
bool alike(const std::vector<Surface>& a, const std::vector<Surface>& b) {
    return std::ranges::equal(a, b, [](const Surface& x, const Surface& y) {
        return x.object == y.object && x.behind == y.behind && glm::dot(x.normal, y.normal) > 0.999;
    });
}

void expect_surface(const GBuffer& view, std::size_t i, const std::vector<Surface>& want) {
    EXPECT_NEAR(view.depth[i] / want[0].depth, 1.0, 1e-6) << i;
    EXPECT_LT(glm::distance(glm::dvec3(view.normal[i]), want[0].normal), 1e-6) << i;
    EXPECT_EQ(view.object[i], want[0].object) << i;
    for (std::size_t k = 0; k < view.layers.size(); ++k) {
        const double depth = k + 1 < want.size() ? want[k + 1].depth : double{infinity};
        const double sign = k + 1 < want.size() && want[k + 1].behind ? -1.0 : 1.0;
        EXPECT_NEAR(sign / view.layers[k][i], 1.0 / depth, 1e-6 / depth) << i << ' ' << k;
    }
}

// Where the point was, and the motion there: by the box's and the camera's own motion, calculated apart.
void expect_motion(const GBuffer& view, std::size_t i, const Camera& like, int frame) {
    const Camera now = camera_of(like, frame);
    const Camera before = camera_of(like, std::max(frame - 1, 0));
    const PixelPositions positions(view);
    glm::dvec3 world = world_of(view, now, i);
    if (view.object[i] > 0)
        world = motion_of(std::max(frame - 1, 0)) * glm::inverse(motion_of(frame)) * glm::dvec4(world, 1.0);
    const glm::dvec3 then = view_rotation(before) * (world - before.eye);
    EXPECT_LT(glm::distance(then, glm::dvec3(view.previous_position[i])), 2e-6 * view.depth[i]) << i;
    const glm::dvec2 moved = positions.center(i) - positions.pixel_of(then);
    const bool inside = positions.contains(positions.pixel_of(then));
    EXPECT_LT(glm::distance(glm::dvec2(view.motion[i]), frame > 0 ? moved : glm::dvec2(0)), 1e-3) << i;
    EXPECT_EQ(view.motion[i].z, frame > 0 && inside ? 1.0F : 0.0F) << i;
}

TEST(Draw, ShowsTheTrianglesOnEachRay) {
    for (const auto& [like, frame, guard] : rows) {
        SCOPED_TRACE(frame);
        const Scene scene = boxes(like);
        const GBuffer view =
            draw(scene, {65, 37}, {.frame = frame, .motion = true, .layers = 4, .guard = guard});
        EXPECT_EQ(view.ao_radius, 0.75);
        EXPECT_EQ(view.extent, with_border({65, 37}, guard_border({65, 37}, guard)));
        EXPECT_EQ(view.camera.previous_view.has_value(), frame > 0);
        const Camera camera = camera_of(like, frame);
        const Mesh mesh = view_space_mesh(scene, frame);
        const auto under = [&](std::size_t pixel, double aside) {
            return along(mesh, scene.mesh.triangle_count(), PixelPositions(view).ray(pixel, {aside, aside}),
                         camera);
        };
        std::array<std::size_t, 6> seen{};  // pixels without an edge, by the number of surfaces
        for (std::size_t i = 0; i < view.depth.size(); ++i) {
            const std::vector<Surface> want = under(i, 0.0);
            if (!alike(want, under(i, 0.01)) || !alike(want, under(i, -0.01))) continue;
            ++seen.at(want.size());
            if (want.empty()) {
                EXPECT_EQ(view.depth[i], infinity) << i;
                EXPECT_EQ(view.normal[i], glm::vec3(0));
                EXPECT_EQ(view.motion[i], glm::vec3(0));
                EXPECT_EQ(view.previous_position[i], glm::vec3(0));
                EXPECT_EQ(view.object[i], 0U);
                continue;
            }
            expect_surface(view, i, want);
            expect_motion(view, i, like, frame);
        }
        EXPECT_GT(static_cast<double>(std::accumulate(seen.begin(), seen.end(), std::size_t{0})),
                  0.9 * static_cast<double>(view.depth.size()));
        EXPECT_GT(seen[1], 100U);
        EXPECT_GT(seen[2] + seen[3], 50U);  // two where the floor behind a box is beyond the far plane
    }
}

// Smooth normals at the rim of a coarse sphere tip away from the viewer; none may be handed on like that.
// They point from the centre outwards, as far as a coarse sphere goes. Normals on the far side are turned to
// the viewer; without a direction they are the triangle's.
TEST(Draw, NormalsFaceTheViewer) {
    for (const Projection projection : projections) {
        Scene scene{.name = "sphere", .mesh = make_sphere({0, 0, 0}, 1.0, 6)};
        scene.camera = {
            .eye = {0.5, 1, 3}, .target = {0, 0, 0}, .projection = projection, .view_height = 2.4};
        const GBuffer g = draw(scene, {64, 64});
        const PixelPositions positions(g);
        const glm::dvec3 center = g.camera.view * glm::vec4(0, 0, 0, 1);
        for (std::size_t i = 0; i < g.depth.size(); ++i) {
            if (!is_surface(g.depth[i])) continue;
            const glm::dvec3 n = g.normal[i];
            ASSERT_NEAR(glm::length(n), 1.0, 1e-6);
            ASSERT_LT(glm::dot(n, positions.ray(i).direction), 0.0) << i;
            EXPECT_GT(glm::dot(n, glm::normalize(positions.at(i, double{g.depth[i]}) - center)), 0.8) << i;
        }
        EXPECT_GT(std::ranges::count_if(g.depth, is_surface), 1000);
    }
    for (const glm::vec3& given : {glm::vec3(0), glm::vec3(nan), glm::vec3(0, -1, -1)}) {
        Scene scene{.name = "slope", .mesh = make_parallelogram({-9, -9, 4}, {18, 0, 0}, {0, 18, -18}, 50.0)};
        std::ranges::fill(scene.mesh.normals, given);
        for (const glm::vec3& normal : draw(scene, {16, 16}).normal)
            EXPECT_LT(glm::distance(normal, glm::normalize(glm::vec3(0, 1, 1))), 1e-6F);
    }
}

// What is asked for changes nothing else, and what coincides is one surface.
TEST(Draw, LayersAndOtherImages) {
    const Scene once = boxes({});
    Scene twice = once;
    append(twice.mesh, once.mesh);
    const GBuffer plain = draw(once, {64, 36}, {.frame = 9});
    const GBuffer full = draw(once, {64, 36}, {.frame = 9, .motion = true, .color = true, .layers = 4});
    EXPECT_EQ(bits(plain.depth), bits(full.depth));
    EXPECT_EQ(plain.normal, full.normal);
    EXPECT_EQ(full.color.back(), default_color);
    EXPECT_EQ(draw(twice, {64, 36}, {.frame = 9, .layers = 4}).layers, full.layers);
    // Below a box that stands on it the floor goes on, as one layer that is seen from the front.
    Scene scene{.name = "box", .mesh = make_parallelogram({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}, 1.0)};
    append(scene.mesh, make_box({-1, 0, -1}, {1, 1, 1}, 1.0));
    scene.camera = {.eye = {1.3, 4, 2}, .target = {0.1, 0.5, 0.1}, .fovy_rad = 0.1};
    const GBuffer below = draw(scene, {9, 9}, {.layers = 3});
    EXPECT_THAT(below.layers[0], Each(testing::Gt(0.0F)));
    EXPECT_THAT(below.layers[1], Each(infinity));
}

// Boxes and columns stand on a floor and against walls; on a plate the view grazes the floor at a slant. An
// eye that is moved by a few ULP changes the last bits of every ray and corner; it must see the same surfaces
// from the same sides.
TEST(Draw, LastBitsDecideNothing) {
    Scene plate{.name = "plate", .mesh = make_parallelogram({-60, 0, 60}, {120, 0, 0}, {0, 0, -120}, 3.0)};
    append(plate.mesh, make_box({-5, 0, -21}, {5, 0.05, -3}, 1.0));
    plate.camera = {.eye = {0.1, 0.1, 1}, .target = {7.1, 5, -12}, .up = {1, 1, 0.2}, .fovy_rad = 1.1};
    for (Scene scene : {make_scene("moving"), make_scene("stairs"), make_scene("crypt"), plate}) {
        scene.camera_path = nullptr;
        const glm::dvec3 eye = scene.camera.eye;
        const auto seen = [&](double aside) {
            scene.camera.eye = eye + aside;
            GBuffer view = draw(scene, {83, 45}, {.layers = 4});
            view.layers.push_back(view.depth);
            return view.layers;
        };
        const std::vector<std::vector<float>> still = seen(0.0);
        for (const double aside : {-3e-7, -1e-7, 1e-7, 3e-7}) {
            const std::vector<std::vector<float>> moved = seen(aside);
            int others = 0;
            for (std::size_t k = 0; k < still.size(); ++k)
                for (std::size_t i = 0; i < still[k].size(); ++i)
                    if (moved[k][i] != still[k][i] && !(std::abs(moved[k][i] / still[k][i] - 1.0F) < 1e-4F))
                        ++others;
            EXPECT_EQ(others, 0) << scene.name << ' ' << aside;
        }
    }
}

}  // namespace gloam::scene::test::draw_test
