// SPDX-License-Identifier: MIT
#include "cli/bench/view_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace gloam::cli {

std::vector<scene::ViewInfo> views_named(const std::vector<std::string>& names) {
    std::string known;
    for (const scene::ViewInfo& view : scene::all_views()) known += (known.empty() ? "" : ", ") + view.name;
    std::vector<scene::ViewInfo> views;
    for (const scene::ViewInfo& view : scene::all_views())
        if (names.empty() || std::ranges::count(names, view.name) > 0) views.push_back(view);
    for (const std::string& name : names)
        if (std::ranges::find(views, name, &scene::ViewInfo::name) == views.end())
            throw std::invalid_argument(fmt::format("--view {}: expected {}", name, known));
    return views;
}

void require_scored(int scored, int frames) {
    if (scored > frames)
        throw std::invalid_argument(
            fmt::format("--scored {}: expected at most {}, the frames", scored, frames));
}

}  // namespace gloam::cli
