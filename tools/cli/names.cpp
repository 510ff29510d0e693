// SPDX-License-Identifier: MIT
#include "cli/names.hpp"

#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {
namespace {

template <class Items>
std::vector<Named> named(const Items& items) {
    std::vector<Named> names;
    for (const auto& item : items) names.push_back({item.name, item.description});
    return names;
}

}  // namespace

std::vector<Named> method_names() {
    return named(effect::methods());
}

std::vector<Named> preset_names() {
    return named(effect::presets());
}

std::vector<Named> scene_names() {
    return named(scene::built_in_scenes());
}

}  // namespace gloam::cli
