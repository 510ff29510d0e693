// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace gloam::cli {

// The views with these names, in the order of the list; all without names. Throws std::invalid_argument that
// lists the names.
[[nodiscard]] std::vector<scene::ViewInfo> views_named(const std::vector<std::string>& names);

// Throws std::invalid_argument if more frames are scored than there are.
void require_scored(int scored, int frames);

// Adds the options of commands that measure on the views of scene/scene.hpp: what of them is rendered and
// traced.
template <class Options>
void add_view_options(CLI::App& command, Options& options) {
    command.add_option("--size", options.size, "WIDTHxHEIGHT of the images")->capture_default_str();
    command.add_option("--frames", options.frames, "of each view")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--scored", options.scored, "the last ones of these")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--rays", options.rays, "rays of the truth for each pixel")
        ->check(CLI::Range(32, 65'536))
        ->capture_default_str();
    command.add_option("--meshes", options.meshes, "folder of the meshes; without it that of glmark2-data");
}

}  // namespace gloam::cli
