// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/render_pictures.hpp"
#include "report/output_folder.hpp"
#include "report/page.hpp"

namespace gloam::cli {

// Writes the pictures of a run into a page's folder, under names that begin with `prefix`, and adds them to
// the page: the light without and with occlusion behind a slider, then the occlusion alone and its error. A
// turntable has all of its views.
void add_pictures(report::Page& page, report::OutputFolder& folder, const std::string& prefix,
                  const Rendered& run);

// Writes index.html and its pictures: one section for each run, and a table of times and errors if there are
// several.
void write_gallery(report::OutputFolder& folder, const std::vector<Rendered>& runs);

}  // namespace gloam::cli
