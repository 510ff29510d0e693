// SPDX-License-Identifier: MIT
#include "cli/environment.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "base/text.hpp"
#include "base/version.hpp"
#include "module/compile.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

struct DataFolder {
    std::string_view name;
    const char* source;
    const char* content;  // by which it is known
};
constexpr DataFolder data_folders[]{{"glsl", GLOAM_GLSL_DIR, "gloam"},
                                    {"stress", GLOAM_STRESS_SHADERS, "accumulate.glsl"},
                                    {"site", GLOAM_SITE_FILES, "page/live.html"},
                                    {"docs", GLOAM_DOCUMENTS, "drivers.md"},
                                    {"experiments", GLOAM_EXPERIMENTS, "passes.json"}};

}  // namespace

fs::path data_directory(std::string_view name) {
    const DataFolder& folder = *std::ranges::find(data_folders, name, &DataFolder::name);
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none);
    const fs::path installed = program.parent_path().parent_path() / "share/gloam" / name;
    for (const fs::path& candidate : {installed, fs::path(folder.source)})
        if (fs::exists(candidate / folder.content, none)) return candidate;
    throw std::runtime_error(std::string("no files of the program: looked in ") + installed.string() +
                             " and " + folder.source);
}

fs::path glsl_directory() {
    return data_directory("glsl");
}

std::string path_of_shader(const std::string& file) {
    const fs::path ours = glsl_directory() / file;
    std::error_code none;
    return !fs::exists(file, none) && fs::exists(ours, none) ? ours.string() : file;
}

std::vector<fs::path> include_roots_of(const fs::path& file, const std::vector<std::string>& further) {
    std::vector<fs::path> roots{fs::absolute(file).parent_path()};
    for (const std::string& folder : further) roots.push_back(fs::absolute(folder));
    roots.push_back(glsl_directory());
    return roots;
}

fs::path cache_directory() {
    for (const auto& [variable, below] :
         {std::pair("GLOAM_CACHE_DIR", ""), {"XDG_CACHE_HOME", "gloam"}, {"HOME", ".cache/gloam"}})
        if (const char* folder = std::getenv(variable); folder != nullptr && *folder != '\0')
            return fs::path(folder) / below;
    return {};
}

fs::path truth_cache_directory() {
    const fs::path folder = cache_directory();
    return folder.empty() ? folder : folder / "truth";
}

std::string versions() {
    return "gloam " + base::version() + ", " + base::one_line(module::compiler_version());
}

}  // namespace gloam::cli
