// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "report/output.hpp"

namespace gloam::cli {

// The pictures of a site.
struct GalleryOptions {
    bool pictures = true;  // without: the gallery is empty and says so
    std::string device;    // name or index; empty: the default
};

struct SiteGallery {
    std::string json;       // what page/gallery.js reads
    std::size_t bytes = 0;  // of the pictures
};

// Renders the scenes of the gallery and writes their pictures into the folder. Without a Vulkan device the
// gallery is empty and says why.
[[nodiscard]] SiteGallery write_site_gallery(const GalleryOptions& options, report::OutputFolder& folder);

}  // namespace gloam::cli
