// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::effect {

// The item with this name. Throws std::invalid_argument that lists the names.
template <class Item>
const Item& named(const std::vector<Item>& items, std::string_view name, const char* what) {
    for (const Item& item : items)
        if (item.name == name) return item;
    std::string names;
    for (const Item& item : items) names += (names.empty() ? "" : ", ") + item.name;
    throw std::invalid_argument("unknown " + std::string(what) + " \"" + std::string(name) + "\": expected " +
                                names);
}

}  // namespace gloam::effect
