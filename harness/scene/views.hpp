// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace gloam::scene {

// The half to which a view belongs. Constants are fitted on `tuning`; what is claimed of them is measured on
// `unseen`.
enum class ViewHalf { tuning, unseen };

struct ViewInfo {
    std::string name;
    std::string kind;  // "interior", "hall", "foliage", "machine", "terrain", "mesh" or "scene"
    std::string description;
    ViewHalf half = ViewHalf::tuning;
};

// The views on which settings are fitted and judged, with moving cameras. A view's half follows from its
// place in this list alone: even places, from 0, are for tuning, odd ones unseen. New views are added at the
// end.
[[nodiscard]] const std::vector<ViewInfo>& all_views();

// The names of a half, in the order of the list.
[[nodiscard]] std::vector<std::string> views_of(ViewHalf half);

[[nodiscard]] std::string_view name_of(ViewHalf half);

// The folder in which Debian's glmark2-data installs its meshes.
[[nodiscard]] std::filesystem::path installed_meshes();

// A view by name, bit-identical every time. meshes: folder of the mesh files that some views show. Throws
// std::invalid_argument that lists the names, and std::runtime_error for a mesh that cannot be read.
[[nodiscard]] Scene make_view(std::string_view name, const std::filesystem::path& meshes);

}  // namespace gloam::scene
