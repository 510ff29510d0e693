// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.hpp"

namespace gloam::scene::views {

// How a mesh file is shown: copies in rows on a plane, each turned further.
struct Display {
    std::string file;        // in the folder of meshes
    glm::dvec3 up{0, 1, 0};  // of the file
    int copies = 1;          // in a row
    int rows = 1;
    double spacing = 1.2;  // in heights of the mesh
    double radius = 0.2;
};

// Throws std::runtime_error with the file's name and the package that has it if it cannot be read.
[[nodiscard]] Scene make_display(const std::filesystem::path& folder, const Display& display);

}  // namespace gloam::scene::views
