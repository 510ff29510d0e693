// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.hpp"

namespace gloam::scene {

// load_mesh() for files of anybody's, by a program of its own, which may crash, hang or take all the memory
// that it is given: memory and processor time are limited by the size of the file. `reader` is its command
// line, to which the file's path is added; it is to do run_mesh_reader(). Throws like load_mesh(), and names
// what became of the reader.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& file, std::vector<std::string> reader);

// What that program does: reads the file and writes the mesh to its standard output. Returns its exit status.
[[nodiscard]] int run_mesh_reader(const std::filesystem::path& file);

// A mesh as bytes, without colours, and back. Throws std::runtime_error for what is none.
[[nodiscard]] std::string mesh_bytes(const Mesh& mesh);
[[nodiscard]] Mesh mesh_from_bytes(std::string_view bytes);

}  // namespace gloam::scene
