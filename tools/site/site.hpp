// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "check/lab.hpp"
#include "effect/methods.hpp"
#include "report/output.hpp"

namespace gloam::site {

// Captions of the pictures that were rendered into the site's folder; empty: there are none.
struct SitePictures {
    // Of room-with.png, which stands for the site elsewhere, room-without.png, room-truth.png and
    // room-occlusion.png (page/index.html).
    std::string room;
    std::string methods;  // of method-NAME.png, each
};

struct SiteOptions {
    catalogue::Entries entries;  // whose checks the page runs, if they have an accuracy
    std::size_t inputs = 128;    // of each check
    std::uint64_t seed = 1;
    std::filesystem::path files;              // folder of the pages and the shaders
    std::filesystem::path documents;          // folder of methods.md
    std::vector<effect::MethodInfo> methods;  // that the page of methods shows
    SitePictures pictures;
    std::string address;   // of the published site, for previews of its pages; can be empty
    std::string versions;  // of this program, for the results file
};

// Size of method-NAME.png, pixels.
inline constexpr int method_picture_width = 320;
inline constexpr int method_picture_height = 180;

// A figure of time against error: each preset as `gloam bench presets` has measured it.
[[nodiscard]] std::string presets_plot();

// A guide of docs, which the pages link as text.
struct Guide {
    const char* name;  // of its file, without the extension
    const char* title;
};
inline constexpr Guide guides[] = {
    {"copy-a-shader", "Copy a shader"}, {"testing", "Test a function"}, {"judge-a-driver", "Judge a driver"}};

// Writes them as NAME.txt.
void write_guides(const std::filesystem::path& documents, report::OutputFolder& folder);

// What was written.
struct SiteSummary {
    std::size_t checks = 0;
    std::size_t left_out = 0;     // equations that have no accuracy to judge
    std::size_t unsupported = 0;  // functions that are no GLSL ES 3.00
};

// Writes the files of the site. `told` is called with the part of the checks that is prepared. Throws
// std::runtime_error with the file's name for one that cannot be read or written.
SiteSummary write_site(const check::Lab& lab, const SiteOptions& options, report::OutputFolder& folder,
                       const std::function<void(double)>& told);

}  // namespace gloam::site
