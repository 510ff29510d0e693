// SPDX-License-Identifier: MIT
#include "catalogue/catalogue.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "scene/scene.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::numbers_test {

// Whether one of these is called so; the name may be a glob.
template <class Items>
bool any_named(const Items& items, const std::string& name) {
    return std::ranges::any_of(items,
                               [&](const auto& one) { return catalogue::matches_glob(one.name, name); });
}

// Whether there is what a row of the papers names. Throws for a setting or value that is none.
bool exists(const std::string& thing, const std::set<std::string>& functions, const std::string& commands) {
    const std::string kind = thing.substr(0, thing.find(' '));
    const std::string name = thing.substr(std::min(kind.size() + 1, thing.size()));
    if (thing.starts_with("(") || thing.starts_with("none")) return true;
    if (thing.starts_with("gloam_")) return functions.contains(thing);
    if (kind == "gloam")
        return commands.find("\n  " + name.substr(0, name.find(' ')) + " ") != std::string::npos;
    if (kind == "method") return any_named(effect::methods(), name);
    if (kind == "preset") return any_named(effect::presets(), name);
    if (kind == "scene" || kind == "view") return any_named(scene::all_views(), name);
    const fs::path glsl = GLOAM_GLSL_DIR;
    if (thing.find('/') != std::string::npos)
        return fs::exists(thing.starts_with("docs/") ? glsl.parent_path() / thing : glsl / thing);
    effect::Settings settings;
    const std::size_t end = std::min(thing.find('='), thing.size());
    const effect::Setting& setting = effect::setting_named(thing.substr(0, end));
    if (end < thing.size()) effect::set(settings, setting.name, thing.substr(end + 1));
    return true;
}

TEST(Numbers, WhatARowNamesExists) {
    std::set<std::string> functions;
    for (const catalogue::Entry& entry : catalogue::all_entries(GLOAM_GLSL_DIR))
        functions.insert(entry.description.function);
    const std::string commands = output_of(gloam("--help"));
    for (const catalogue::PrintedRow& row : catalogue::printed_rows())
        for (const std::string& thing : row.has)
            EXPECT_TRUE(exists(thing, functions, commands)) << row.places.front() << ": " << thing;
}

}  // namespace gloam::test::numbers_test
