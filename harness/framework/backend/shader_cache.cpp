// SPDX-License-Identifier: MIT
#include "backend/shader_cache.hpp"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace gloam::backend {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t least_space = std::uintmax_t{16} << 20;  // bytes
constexpr const char* disables = "MESA_SHADER_CACHE_DISABLE";

// Where Mesa keeps its cache, in the order in which it looks; empty: nowhere.
fs::path cache_folder() {
    struct Location {
        const char* variable;
        const char* folder;
    };
    for (const Location& place :
         {Location{"MESA_SHADER_CACHE_DIR", ""}, Location{"XDG_CACHE_HOME", ""}, Location{"HOME", ".cache"}})
        if (const char* value = std::getenv(place.variable); value != nullptr && *value != '\0')
            return fs::path(value) / place.folder;
    return {};
}

// Of the disk that holds the folder, or will hold it.
bool is_full(fs::path folder) {
    std::error_code none;
    while (!folder.empty() && folder.has_relative_path() && !fs::exists(folder, none))
        folder = folder.parent_path();
    const fs::space_info space = fs::space(folder, none);
    return !none && space.available < least_space;
}

}  // namespace

void spare_a_full_disk() {
    if (const fs::path folder = cache_folder(); !folder.empty() && is_full(folder))
        ::setenv(disables, "true", 0);
}

}  // namespace gloam::backend
