// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/output.hpp"
#include "site/site.hpp"

namespace gloam::cli {

// Which pictures of a site to render.
struct PictureOptions {
    bool pictures = true;              // without: the gallery is empty and says so
    std::string device;                // name or index; empty: the default
    std::vector<std::string> methods;  // each gets a picture; empty: all
};

struct RenderedPictures {
    site::SitePictures of_site;
    std::size_t bytes = 0;
};

// Renders the pictures of the gallery and of the methods, traces the truth of the scenes that the first page
// shows, and writes all into the folder. Without a Vulkan device there are none, and the gallery says why.
// Throws std::invalid_argument for an unknown method.
[[nodiscard]] RenderedPictures write_site_pictures(const PictureOptions& options,
                                                   report::OutputFolder& folder);

}  // namespace gloam::cli
