// SPDX-License-Identifier: MIT
#include "site/npm_package.hpp"

#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "base/version.hpp"
#include "site/page_data.hpp"

namespace gloam::site {

std::map<std::string, std::string> npm_package(const std::filesystem::path& library,
                                               const std::filesystem::path& files,
                                               const std::filesystem::path& licence) {
    // The class, and the data that it needs, as a module.
    const std::string index =
        "// SPDX-License-Identifier: MIT\nexport const effect = " + effect_json(library, files) + ";\n" +
        effect_classes(files) + "export {AmbientOcclusion};\n";
    std::map<std::string, std::string> all{{"index.js", index}, {"LICENSE", base::read_file(licence)}};
    for (const auto& file : std::filesystem::directory_iterator(files / "npm"))
        all[file.path().filename().string()] = base::read_file(file.path());
    auto package = nlohmann::ordered_json::parse(all.at("package.json"));
    package["version"] = base::version();
    all["package.json"] = package.dump(2) + "\n";
    return all;
}

}  // namespace gloam::site
