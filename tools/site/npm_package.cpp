// SPDX-License-Identifier: MIT
#include "site/npm_package.hpp"

#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "site/page_data.hpp"

namespace gloam::site {
namespace {

using nlohmann::ordered_json;

constexpr const char* licence_line = "// SPDX-License-Identifier: MIT\n";

// The class, and the data that it needs, as a module.
std::string index_text(const NpmOptions& options, const std::string& core) {
    return licence_line + std::string("export const effect = ") + core + ";\n" +
           effect_classes(options.files / "effect") + "export {AmbientOcclusion};\n";
}

std::string package_json(const std::string& version) {
    const auto typed = [](const std::string& types, const std::string& module) {
        return ordered_json{{"types", "./" + types}, {"default", "./" + module}};
    };
    const ordered_json json{
        {"name", "gloam"},
        {"version", version},
        {"description", "Screen-space ambient occlusion for WebGL2 and three.js"},
        {"license", "MIT"},
        {"type", "module"},
        {"sideEffects", false},
        {"exports", {{".", typed("index.d.ts", "index.js")}, {"./three", typed("three.d.ts", "three.js")}}},
        {"peerDependencies", {{"three", ">=" + std::string(least_three)}}},
        {"peerDependenciesMeta", {{"three", {{"optional", true}}}}}};
    return json.dump(2) + "\n";
}

}  // namespace

std::map<std::string, std::string> npm_package(const NpmOptions& options) {
    const ShaderFolders folders{options.library, options.files / "shaders"};
    std::map<std::string, std::string> files{{"package.json", package_json(options.version)},
                                             {"index.js", index_text(options, effect_json(folders))},
                                             {"LICENSE", base::read_file(options.licence)}};
    for (const char* name : {"index.d.ts", "three.js", "three.d.ts", "README.md"})
        files[name] = base::read_file(options.files / "npm" / name);
    return files;
}

}  // namespace gloam::site
