// SPDX-License-Identifier: MIT
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

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

// What assimp says, in one line.
std::string one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text.empty() ? "cannot be read" : text;
}

void check_finite(const fs::path& file, const aiMesh& mesh) {
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const glm::vec3 p = to_vec3(mesh.mVertices[i]);
        if (is_finite(p)) continue;
        fail_to_load(file,
                     fmt::format("vertex {} is ({}, {}, {}), expected finite numbers", i, p.x, p.y, p.z));
    }
}

// What assimp could not give a normal (vertices of degenerate triangles only) gets one of its triangles', or
// up.
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

}  // namespace

Mesh load_mesh(const fs::path& file) {
    std::error_code none;
    if (!fs::exists(file, none)) fail_to_load(file, "no such file");
    if (!fs::is_regular_file(file, none)) fail_to_load(file, "not a file");
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (scene == nullptr) fail_to_load(file, one_line(importer.GetErrorString()));
    // Before assimp calculates with them.
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) check_finite(file, *scene->mMeshes[i]);
    if (scene->mNumMeshes == 0) fail_to_load(file, "has no triangle");
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_PreTransformVertices |
                                         aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices |
                                         aiProcess_SortByPType);
    Mesh mesh;
    for (unsigned i = 0; scene != nullptr && i < scene->mNumMeshes; ++i) {
        check_finite(file, *scene->mMeshes[i]);  // transformed
        append(mesh, convert(*scene->mMeshes[i]));
    }
    if (mesh.triangle_count() == 0) fail_to_load(file, "has no triangle");
    mend_normals(mesh);
    return mesh;
}

}  // namespace gloam::scene
