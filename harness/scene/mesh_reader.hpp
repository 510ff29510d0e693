// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.hpp"

namespace gloam::scene {

// load_mesh() for untrusted files. A separate process reads the file; it may crash, hang or use up its
// memory. Its memory and processor time are limited by the size of the file. `reader`: its command line, to
// which the file's path is appended; the process must call run_mesh_reader(). Throws like load_mesh(), with
// the reason if the process fails.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& file, std::vector<std::string> reader);

// The task of that process: reads the file and writes the mesh to standard output. Returns its exit status.
[[nodiscard]] int run_mesh_reader(const std::filesystem::path& file);

// A mesh as bytes, without colours, and back. Throws std::runtime_error for bytes that are not a mesh.
[[nodiscard]] std::string mesh_bytes(const Mesh& mesh);
[[nodiscard]] Mesh mesh_from_bytes(std::string_view bytes);

}  // namespace gloam::scene
