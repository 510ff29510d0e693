// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "record/output.hpp"
#include "record/page.hpp"

namespace gloam::site {

// Adds the live effect to a page: the class of the npm package in WebGL2 on scenes of gloam, with controls.
// Its scripts and scenes are written beside the page. library: the folder with gloam/ and passes/. files:
// this folder (effect/, page/, shaders/). Throws std::runtime_error for a file that cannot be read, and like
// module::pack().
void add_live_effect(record::Page& page, record::OutputFolder& folder, const std::filesystem::path& library,
                     const std::filesystem::path& files);

}  // namespace gloam::site
