// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "module/compile.hpp"

namespace gloam::module::internal {

// The folders in which includes are searched, and those below which they must lie.
struct IncludeFolders {
    std::vector<std::filesystem::path> roots;
    std::vector<std::filesystem::path> permitted;
};

// The roots; includes may also lie below the folder of each text whose name is a path with a folder.
[[nodiscard]] IncludeFolders include_folders(const std::vector<std::filesystem::path>& roots,
                                             const std::vector<source::Source>& texts);

// resolve_include() of these folders. Nothing about `from` is assumed, because #line can name any.
[[nodiscard]] std::filesystem::path resolved(std::string_view name, const std::filesystem::path& from,
                                             const IncludeFolders& folders);

}  // namespace gloam::module::internal
