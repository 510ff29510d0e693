// SPDX-License-Identifier: MIT
#include "cli/environment.hpp"

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

fs::path from_environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? fs::path{} : fs::path(value);
}

// The first folder that contains `content`: NAME in share beside the installed program, then `source` in the
// source tree.
fs::path data_in(const char* name, const fs::path& source, const char* content) {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none);
    const fs::path installed = program.parent_path().parent_path() / "share" / name;
    for (const fs::path& candidate : {installed, source}) {
        if (fs::exists(candidate / content, none)) return candidate;
    }
    throw std::runtime_error("no files of the program: looked in " + installed.string() + " and " +
                             source.string());
}

}  // namespace

fs::path glsl_directory() {
    return data_in("gloam/glsl", GLOAM_GLSL_DIR, "gloam");
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

fs::path stress_shaders_directory() {
    return data_in("gloam/stress", GLOAM_STRESS_SHADERS, "accumulate.glsl");
}

fs::path site_directory() {
    return data_in("gloam/site", GLOAM_SITE_FILES, "page/live.html");
}

fs::path documents_directory() {
    return data_in("gloam/docs", GLOAM_DOCUMENTS, "drivers.md");
}

fs::path experiments_directory() {
    return data_in("gloam/experiments", GLOAM_EXPERIMENTS, "passes.json");
}

fs::path cache_directory() {
    if (const fs::path own = from_environment("GLOAM_CACHE_DIR"); !own.empty()) return own;
    if (const fs::path cache = from_environment("XDG_CACHE_HOME"); !cache.empty()) return cache / "gloam";
    if (const fs::path home = from_environment("HOME"); !home.empty()) return home / ".cache" / "gloam";
    return {};
}

fs::path truth_cache_directory() {
    const fs::path folder = cache_directory();
    return folder.empty() ? folder : folder / "truth";
}

bool on_terminal() {
    return isatty(STDERR_FILENO) != 0;
}

}  // namespace gloam::cli
