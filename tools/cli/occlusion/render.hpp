// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "effect/methods.hpp"

namespace CLI {
class App;
}

namespace gloam::cli {

// Placement and view of a mesh, as text of the command line: see scene::MeshView.
struct MeshOptions {
    std::string eye;             // "X,Y,Z"; empty: as near as it can be
    std::string look_at;         // likewise; empty: the middle of the mesh
    std::string orbit;           // "AZIMUTH,ELEVATION"; empty: the default
    std::optional<double> fovy;  // degrees; otherwise that of scene::MeshView
    std::string up = "y";
    bool no_ground = false;

    [[nodiscard]] bool given() const {
        return !eye.empty() || !look_at.empty() || !orbit.empty() || fovy || up != "y" || no_ground;
    }
};

// The options of `gloam render`.
struct RenderOptions {
    std::string source;             // a scene's name or a mesh file; empty with gbuffer
    std::filesystem::path gbuffer;  // folder of an engine's frames
    std::string depth = "linear";   // how they store depth and normals: scene::encoding_named()
    std::string normals = "view";
    std::string method;                           // of one run; empty: the preset's
    std::string preset = effect::default_preset;  // of one run
    std::optional<std::uint32_t> samples;
    std::optional<int> frames;
    int frame = 0;       // of a scene that moves: the first
    bool still = false;  // it is held there
    std::string size = "640x360";
    int antialias = 2;            // samples on each side of a pixel, of lit pictures
    std::optional<float> radius;  // world units; otherwise the view's own
    std::optional<float> bias;    // world units; otherwise a part of the radius
    std::optional<float> guard;   // part of the image on each side
    bool no_filter = false;
    std::vector<std::string> set;      // NAME=VALUE
    bool multi_bounce = false;         // in lit pictures
    bool bent_normals = false;         // and cones
    int bent_interleave = 1;           // side of the blocks that share a pattern
    std::optional<std::string> light;  // white or sky: directional occlusion in it
    int repeat = 1;
    std::string device;
    bool validation = false;
    bool trace_truth = false;  // --truth without a file
    bool truth_every = false;  // trace it for each frame; otherwise for the last alone
    std::string truth;         // PFM; empty: none
    std::string truth_falloff = "linear";
    int truth_rays = 1024;                                             // for each pixel
    double truth_thickness = std::numeric_limits<double>::infinity();  // world units
    std::filesystem::path write_gbuffer;                               // folder
    std::filesystem::path out = "gloam-out";
    MeshOptions mesh;
    std::vector<std::string> methods;  // several: each is run, and a sheet compares them; "all"
    std::vector<std::string> presets;  // likewise; several of one of the two
    bool quiet = false;
};

// Adds the subcommand, which renders, writes the images and render.json, then prints a summary.
void add_render(CLI::App& app, int& status);

}  // namespace gloam::cli
