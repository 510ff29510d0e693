// SPDX-License-Identifier: MIT
#pragma once

#include "base/image_files.hpp"
#include "scene/analytic_scene.hpp"
#include "scene/draw.hpp"
#include "scene/read_gbuffer.hpp"
#include "support/environment.hpp"
#include "support/files.hpp"

namespace gloam::scene::test {

inline constexpr std::array projections{Projection::perspective, Projection::orthographic};

inline std::vector<float> components(const std::vector<glm::vec3>& vectors) {
    std::vector<float> values;
    for (const glm::vec3& v : vectors) values.insert(values.end(), {v.x, v.y, v.z});
    return values;
}

// Of texels that come with their rows from the top.
inline std::string pfm_text(backend::Extent extent, const std::vector<float>& texels) {
    const int channels = texels.size() == std::size_t{extent.width} * extent.height ? 1 : 3;
    return base::to_pfm(texels, extent.width, extent.height, channels);
}

// Writes a frame as an engine would.
inline void write_frame(const TemporaryDirectory& folder, int frame, const GBuffer& gbuffer) {
    const std::string prefix = frame_prefix(frame);
    folder.write(prefix + ".json", frame_json(gbuffer, frame));
    const auto write = [&](const std::string& name, const std::vector<float>& texels) {
        if (!texels.empty()) folder.write(prefix + name + ".pfm", pfm_text(gbuffer.extent, texels));
    };
    write("_depth", gbuffer.depth);
    write("_normal", components(gbuffer.normal));
    write("_motion", components(gbuffer.motion));
    write("_previous_depth", gbuffer.previous_depth);
    for (std::size_t i = 0; i < gbuffer.layers.size(); ++i)
        write("_layer" + std::to_string(i + 1), gbuffer.layers[i]);
}

// A floor before a wall, all of it visible, 33 x 33 pixels.
inline GBuffer floor_and_wall(Projection projection = Projection::perspective) {
    const std::vector<ClosedFormView> views = closed_form_views(projection);
    const auto view =
        std::ranges::find_if(views, [](const auto& v) { return v.scene.name.starts_with("wall"); });
    GBuffer buffer = draw(*view, 33);
    buffer.border = {};
    return buffer;
}

// The point of the world that a pixel shows.
inline glm::dvec3 world_of(const GBuffer& view, const Camera& camera, std::size_t pixel) {
    return camera.eye +
           glm::transpose(view_rotation(camera)) * PixelPositions(view).at(pixel, double{view.depth[pixel]});
}

// Of a triangle, by its normal; its length is twice the area.
inline glm::dvec3 area_of(const Mesh& mesh, std::size_t triangle) {
    const std::uint32_t* corner = &mesh.indices[3 * triangle];
    const glm::dvec3 a = mesh.positions[corner[0]];
    return glm::cross(glm::dvec3(mesh.positions[corner[1]]) - a, glm::dvec3(mesh.positions[corner[2]]) - a);
}

// Unit normals, indices in range, and each triangle winds counter-clockwise around its normals.
inline void expect_whole(const Mesh& mesh) {
    ASSERT_GT(mesh.triangle_count(), 0U);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
    for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0F, 1e-5F);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        ASSERT_GE(glm::dot(area_of(mesh, i / 3), glm::dvec3(mesh.normals[mesh.indices[i]])), -1e-9) << i;
}

}  // namespace gloam::scene::test
