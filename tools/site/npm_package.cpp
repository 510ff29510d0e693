// SPDX-License-Identifier: MIT
#include "site/npm_package.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "base/version.hpp"
#include "site/page_data.hpp"

namespace gloam::site {
namespace {

using nlohmann::ordered_json;

// An engine that has a module of the package, and the first version of it that the module was tried with.
struct Engine {
    const char *module, *package, *least;
};
constexpr std::array<Engine, 3> engines{{{"three", "three", "0.180.0"},  // ExternalTexture
                                         {"babylon", "@babylonjs/core", "8.0.0"},
                                         {"playcanvas", "playcanvas", "2.22.0"}}};

std::string package_json() {
    ordered_json exports;
    const auto add = [&](const std::string& name, const std::string& module) {
        exports[name] = {{"types", "./" + module + ".d.ts"}, {"default", "./" + module + ".js"}};
    };
    add(".", "index");
    ordered_json peers;
    ordered_json optional;
    for (const auto& [module, package, least] : engines) {
        add(std::string("./") + module, module);
        peers[package] = std::string(">=") + least;
        optional[package] = {{"optional", true}};
    }
    const ordered_json json{
        {"name", "gloam"},
        {"version", base::version()},
        {"description", "Screen-space ambient occlusion for WebGL2, three.js, Babylon.js and PlayCanvas"},
        {"license", "MIT"},
        {"type", "module"},
        {"sideEffects", false},
        {"exports", exports},
        {"peerDependencies", peers},
        {"peerDependenciesMeta", optional}};
    return json.dump(2) + "\n";
}

}  // namespace

std::map<std::string, std::string> npm_package(const std::filesystem::path& library,
                                               const std::filesystem::path& files,
                                               const std::filesystem::path& licence) {
    // The class, and the data that it needs, as a module.
    const std::string index =
        "// SPDX-License-Identifier: MIT\nexport const effect = " + effect_json(library, files) + ";\n" +
        effect_classes(files) + "export {AmbientOcclusion};\n";
    std::map<std::string, std::string> all{
        {"package.json", package_json()}, {"index.js", index}, {"LICENSE", base::read_file(licence)}};
    const auto add = [&](const std::string& name) { all[name] = base::read_file(files / "npm" / name); };
    add("index.d.ts");
    add("README.md");
    for (const auto& engine : engines)
        for (const char* ending : {".js", ".d.ts"}) add(std::string(engine.module) + ending);
    return all;
}

}  // namespace gloam::site
