// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace gloam::scene::views {

// A view: what it is called, and how it is made.
struct ViewMaker {
    std::string name;
    std::string kind;
    std::string description;
    std::function<Scene(const std::filesystem::path& meshes)> make;
};

// All views, in their order.
[[nodiscard]] const std::vector<ViewMaker>& view_table();

}  // namespace gloam::scene::views
