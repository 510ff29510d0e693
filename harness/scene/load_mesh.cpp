// SPDX-License-Identifier: MIT
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "base/text.hpp"
#include "scene/crease_normals.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_load(const fs::path& file, const std::string& what) {
    throw std::runtime_error("mesh " + file.string() + ": " + what);
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

// Assimp's error message, in one line.
std::string reason_of(const Assimp::Importer& importer) {
    const std::string text = base::one_line(importer.GetErrorString());
    return text.empty() ? "cannot be read" : text;
}

constexpr unsigned most_corners = 4096;  // of a face: taking one apart costs their square
constexpr int deepest_node = 256;        // assimp recurses

// Checks properties that assimp's later steps require and its readers do not ensure.
void check_faces(const fs::path& file, const aiMesh& mesh) {
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices < 1 || face.mNumIndices > most_corners || face.mIndices == nullptr)
            fail_to_load(file, fmt::format("face {} has {} corners, expected 1 to {}", i, face.mNumIndices,
                                           most_corners));
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
            if (face.mIndices[k] >= mesh.mNumVertices)
                fail_to_load(file, fmt::format("face {} has the vertex {}, but there are {} vertices", i,
                                               face.mIndices[k], mesh.mNumVertices));
        }
    }
}

void check_node(const fs::path& file, const aiScene& scene, const aiNode& node, int depth) {
    if (depth > deepest_node)
        fail_to_load(file, fmt::format("its parts are nested more than {} deep", deepest_node));
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= scene.mNumMeshes)
            fail_to_load(file, fmt::format("a part has the mesh {}, but there are {} meshes", node.mMeshes[i],
                                           scene.mNumMeshes));
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) check_node(file, scene, *node.mChildren[i], depth + 1);
}

void check_finite(const fs::path& file, const aiMesh& mesh) {
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const glm::vec3 p = to_vec3(mesh.mVertices[i]);
        if (is_finite(p)) continue;
        fail_to_load(file,
                     fmt::format("vertex {} is ({}, {}, {}), expected finite numbers", i, p.x, p.y, p.z));
    }
}

// Replaces unusable normals (of vertices of triangles without area, and invalid ones of the file) by that of
// one of the vertex' triangles, or by up.
void mend_normals(Mesh& mesh) {
    const auto usable = [](const glm::vec3& n) { return is_finite(n) && glm::dot(n, n) > 1e-12F; };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* corner = &mesh.indices[i];
        const glm::vec3 origin = mesh.positions[corner[0]];
        const glm::vec3 normal =
            glm::cross(mesh.positions[corner[1]] - origin, mesh.positions[corner[2]] - origin);
        if (!usable(normal)) continue;
        for (int k = 0; k < 3; ++k) {
            if (!usable(mesh.normals[corner[k]])) mesh.normals[corner[k]] = normal;
        }
    }
    for (glm::vec3& normal : mesh.normals)
        normal = usable(normal) ? glm::normalize(normal) : glm::vec3(0, 1, 0);
}

// Checks the scene before assimp calculates with it.
void check_scene(const fs::path& file, const aiScene& scene) {
    if (scene.mNumMeshes == 0 || scene.mRootNode == nullptr) fail_to_load(file, "has no triangle");
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        if (mesh.mNumVertices > 0 && mesh.mVertices == nullptr)
            fail_to_load(file, "has vertices without positions");
        check_finite(file, mesh);
        check_faces(file, mesh);
    }
    check_node(file, scene, *scene.mRootNode, 0);
}

}  // namespace

Mesh load_mesh(const fs::path& file) {
    std::error_code none;
    if (!fs::exists(file, none)) fail_to_load(file, "no such file");
    if (!fs::is_regular_file(file, none)) fail_to_load(file, "not a file");
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (scene == nullptr) fail_to_load(file, reason_of(importer));
    check_scene(file, *scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_PreTransformVertices |
                                         aiProcess_JoinIdenticalVertices | aiProcess_SortByPType);
    Mesh mesh;
    for (unsigned i = 0; scene != nullptr && i < scene->mNumMeshes; ++i) {
        check_finite(file, *scene->mMeshes[i]);  // transformed
        const Mesh part = convert(*scene->mMeshes[i]);
        append(mesh, scene->mMeshes[i]->HasNormals() ? part : with_crease_normals(part, crease_degrees));
    }
    if (mesh.triangle_count() == 0) fail_to_load(file, "has no triangle");
    mend_normals(mesh);
    return mesh;
}

}  // namespace gloam::scene
