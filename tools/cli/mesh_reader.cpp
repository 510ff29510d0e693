// SPDX-License-Identifier: MIT
#include "cli/mesh_reader.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "scene/mesh_reader.hpp"

namespace gloam::cli {
namespace {

constexpr const char* reader_subcommand = "mesh-reader";

}  // namespace

std::vector<std::string> mesh_reader_command() {
    return {"/proc/self/exe", reader_subcommand};
}

void add_mesh_reader(CLI::App& app, int& status) {
    auto file = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand(reader_subcommand, "reads a mesh for `gloam render`");
    command->group("");  // not listed
    command->add_option("file", *file)->required();
    command->callback([file, &status] { status = scene::run_mesh_reader(*file); });
}

}  // namespace gloam::cli
