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

}  // namespace

fs::path glsl_directory() {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none);
    const fs::path installed = program.parent_path().parent_path() / "share" / "gloam" / "glsl";
    for (const fs::path& candidate : {installed, fs::path(GLOAM_GLSL_DIR)}) {
        if (fs::is_directory(candidate / "gloam", none)) return candidate;
    }
    throw std::runtime_error("no shader library: looked in " + installed.string() + " and " + GLOAM_GLSL_DIR);
}

fs::path cache_directory() {
    if (const fs::path own = from_environment("GLOAM_CACHE_DIR"); !own.empty()) return own;
    if (const fs::path cache = from_environment("XDG_CACHE_HOME"); !cache.empty()) return cache / "gloam";
    if (const fs::path home = from_environment("HOME"); !home.empty()) return home / ".cache" / "gloam";
    return {};
}

bool on_terminal() {
    return isatty(STDERR_FILENO) != 0;
}

}  // namespace gloam::cli
