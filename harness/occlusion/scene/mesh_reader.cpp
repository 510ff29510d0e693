// SPDX-License-Identifier: MIT
#include "scene/mesh_scene.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <map>
#include <span>
#include <stdexcept>

#include "base/process.hpp"
#include "base/text.hpp"
#include "scene/internal/bytes.hpp"

namespace gloam::scene {
namespace {

namespace fs = std::filesystem;

// Limits of memory and time for a file: a constant part, and a part that grows with its size.
base::ProcessLimits limits_for(const fs::path& file) {
    const std::uint64_t bytes = fs::file_size(file);
    constexpr std::uint64_t memory = std::uint64_t{1} << 30;
    constexpr std::uint64_t memory_for_byte = 64;
    const auto cpu = std::chrono::seconds(3 + 2 * (bytes >> 20));
    return {.memory_bytes = memory + memory_for_byte * bytes, .cpu = cpu, .patience = 20 * cpu};
}

// Throws without the file's name; read_mesh() adds it.
template <class... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> what, Values&&... values) {
    throw std::runtime_error(fmt::format(what, std::forward<Values>(values)...));
}

glm::vec3 to_vec3(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Mesh convert(const aiMesh& source) {
    Mesh mesh;
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
        mesh.positions.push_back(to_vec3(source.mVertices[i]));
        mesh.normals.push_back(source.HasNormals() ? to_vec3(source.mNormals[i]) : glm::vec3(0));
    }
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
        const aiFace& face = source.mFaces[i];
        if (face.mNumIndices != 3) continue;
        mesh.indices.insert(mesh.indices.end(), face.mIndices, face.mIndices + 3);
    }
    return mesh;
}

constexpr unsigned most_corners = 4096;  // of a face: taking one apart costs their square
constexpr int deepest_node = 256;        // assimp recurses

// Checks properties that assimp's later steps require and its readers do not ensure.
void check_faces(const aiMesh& mesh) {
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices < 1 || face.mNumIndices > most_corners || face.mIndices == nullptr)
            refuse("face {} has {} corners, expected 1 to {}", i, face.mNumIndices, most_corners);
        for (const unsigned index : std::span(face.mIndices, face.mNumIndices))
            if (index >= mesh.mNumVertices)
                refuse("face {} has the vertex {}, but there are {} vertices", i, index, mesh.mNumVertices);
    }
}

void check_node(const aiScene& scene, const aiNode& node, int depth) {
    if (depth > deepest_node) refuse("its parts are nested more than {} deep", deepest_node);
    for (const unsigned mesh : std::span(node.mMeshes, node.mNumMeshes))
        if (mesh >= scene.mNumMeshes)
            refuse("a part has the mesh {}, but there are {} meshes", mesh, scene.mNumMeshes);
    for (const aiNode* child : std::span(node.mChildren, node.mNumChildren))
        check_node(scene, *child, depth + 1);
}

void check_finite(const aiMesh& mesh) {
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D& p = mesh.mVertices[i];
        if (!is_finite(to_vec3(p)))
            refuse("vertex {} is ({}, {}, {}), expected finite numbers", i, p.x, p.y, p.z);
    }
}

// By the normal of a triangle; its length is twice the area.
glm::vec3 area_of(const Mesh& mesh, std::size_t triangle) {
    const std::uint32_t* corner = &mesh.indices[3 * triangle];
    const glm::vec3 origin = mesh.positions[corner[0]];
    return glm::cross(mesh.positions[corner[1]] - origin, mesh.positions[corner[2]] - origin);
}

// Replaces unusable normals (of vertices of triangles without area, and invalid ones of the file) by that of
// one of the vertex' triangles, or by up.
void mend_normals(Mesh& mesh) {
    const auto usable = [](const glm::vec3& n) { return is_finite(n) && glm::dot(n, n) > 1e-12F; };
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const glm::vec3 across = area_of(mesh, i / 3);
        glm::vec3& normal = mesh.normals[mesh.indices[i]];
        if (usable(across) && !usable(normal)) normal = across;
    }
    for (glm::vec3& normal : mesh.normals)
        normal = usable(normal) ? glm::normalize(normal) : glm::vec3(0, 1, 0);
}

// Checks the scene before assimp calculates with it.
void check_scene(const aiScene& scene) {
    if (scene.mNumMeshes == 0 || scene.mRootNode == nullptr) refuse("has no triangle");
    for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
        if (mesh->mNumVertices > 0 && mesh->mVertices == nullptr) refuse("has vertices without positions");
        check_finite(*mesh);
        check_faces(*mesh);
    }
    check_node(scene, *scene.mRootNode, 0);
}

glm::vec3 unit_or_zero(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0F && std::isfinite(length) ? v / length : glm::vec3(0);
}

// The angle of a triangle at a corner (an index of mesh.indices), in radians.
float angle_at(const Mesh& mesh, std::size_t corner) {
    const std::size_t first = corner - corner % 3;
    const auto position = [&](std::size_t k) {
        return mesh.positions[mesh.indices[first + (corner + k) % 3]];
    };
    const glm::vec3 a = unit_or_zero(position(1) - position(0));
    const glm::vec3 b = unit_or_zero(position(2) - position(0));
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// If faces meet at a larger angle than this, in degrees, there is an edge between them; otherwise the surface
// is smooth.
constexpr float crease_degrees = 45.0F;

// The triangles of a mesh with normals calculated from them alone. The normal at a corner is the mean,
// weighted by the angles there, of the faces that meet and whose normals differ from the corner's own face by
// at most crease_degrees. A vertex where faces meet at a larger angle is split. Triangles without area get
// the normal 0.
Mesh with_crease_normals(const Mesh& mesh) {
    std::vector<glm::vec3> normals;  // of the triangles
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) normals.push_back(unit_or_zero(area_of(mesh, i)));
    std::map<std::array<float, 3>, std::vector<std::size_t>> corners;  // by position, over all vertices there
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const glm::vec3& p = mesh.positions[mesh.indices[i]];
        corners[{p.x, p.y, p.z}].push_back(i);
    }
    const float least_cosine = std::cos(glm::radians(crease_degrees));
    Mesh result;
    std::map<std::array<float, 6>, std::uint32_t> vertices;  // by position and normal
    for (std::size_t i = 0; i < normals.size() * 3; ++i) {
        const glm::vec3& p = mesh.positions[mesh.indices[i]];
        glm::vec3 sum(0);
        for (const std::size_t corner : corners.at({p.x, p.y, p.z})) {
            const glm::vec3& normal = normals[corner / 3];
            if (glm::dot(normals[i / 3], normal) >= least_cosine) sum += angle_at(mesh, corner) * normal;
        }
        const glm::vec3 n = unit_or_zero(sum);
        const auto next = static_cast<std::uint32_t>(result.positions.size());
        const auto [vertex, added] = vertices.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, next);
        if (added) {
            result.positions.push_back(p);
            result.normals.push_back(n);
        }
        result.indices.push_back(vertex->second);
    }
    return result;
}

Mesh loaded(const fs::path& file) {
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (scene == nullptr) {
        const std::string reason = base::one_line(importer.GetErrorString());
        refuse("{}", reason.empty() ? "cannot be read" : reason);
    }
    check_scene(*scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_PreTransformVertices |
                                         aiProcess_JoinIdenticalVertices | aiProcess_SortByPType);
    Mesh mesh;
    for (unsigned i = 0; scene != nullptr && i < scene->mNumMeshes; ++i) {
        check_finite(*scene->mMeshes[i]);  // transformed
        const Mesh part = convert(*scene->mMeshes[i]);
        append(mesh, scene->mMeshes[i]->HasNormals() ? part : with_crease_normals(part));
    }
    if (mesh.triangle_count() == 0) refuse("has no triangle");
    mend_normals(mesh);
    return mesh;
}

}  // namespace

Mesh read_mesh(const fs::path& file) {
    const auto read = [&] {
        const Mesh mesh = loaded(file);
        return bytes_of(mesh.positions, mesh.normals, mesh.indices);
    };
    try {
        Mesh mesh;
        read_bytes(base::run_apart(read, limits_for(file)), mesh.positions, mesh.normals, mesh.indices);
        return mesh;
    } catch (const base::LimitError& error) {
        throw std::runtime_error(
            fmt::format("mesh {}: cannot be read: its reader {}", file.string(), error.what()));
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("mesh {}: {}", file.string(), error.what()));
    }
}

}  // namespace gloam::scene
