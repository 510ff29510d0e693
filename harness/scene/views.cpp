// SPDX-License-Identifier: MIT
#include "scene/views.hpp"

#include <functional>
#include <stdexcept>

#include "scene/views/view_table.hpp"

namespace gloam::scene {

const std::vector<ViewInfo>& all_views() {
    static const std::vector<ViewInfo> infos = [] {
        std::vector<ViewInfo> all;
        for (const views::ViewMaker& view : views::view_table()) {
            const ViewHalf half = all.size() % 2 == 0 ? ViewHalf::tuning : ViewHalf::unseen;
            all.push_back({view.name, view.kind, view.description, half});
        }
        return all;
    }();
    return infos;
}

std::vector<std::string> views_of(ViewHalf half) {
    std::vector<std::string> names;
    for (const ViewInfo& view : all_views())
        if (view.half == half) names.push_back(view.name);
    return names;
}

std::string_view name_of(ViewHalf half) {
    return half == ViewHalf::tuning ? "tuning" : "unseen";
}

std::filesystem::path installed_meshes() {
    return "/usr/share/glmark2/models";
}

Scene make_view(std::string_view name, const std::filesystem::path& meshes) {
    std::string names;
    for (const views::ViewMaker& view : views::view_table()) {
        if (view.name != name) {
            names += (names.empty() ? "" : ", ") + view.name;
            continue;
        }
        Scene scene = view.make(meshes);
        scene.name = view.name;
        return scene;
    }
    throw std::invalid_argument("unknown view \"" + std::string(name) + "\": expected " + names);
}

}  // namespace gloam::scene
