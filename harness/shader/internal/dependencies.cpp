// SPDX-License-Identifier: MIT
#include "shader/internal/dependencies.hpp"

#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>

namespace gloam::shader::internal {
namespace {

bool lists(const char* list, const std::string& wanted) {
    std::ifstream stream(list);
    for (std::string line; std::getline(stream, line);)
        if (line == wanted) return true;
    return false;
}

}  // namespace

void note_dependency(const std::filesystem::path& file) {
    const char* list = std::getenv("GLOAM_DEPENDENCIES_OUTPUT");
    if (list == nullptr) return;
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::canonical(file, error);
    if (error || lists(list, absolute.string())) return;
    std::ofstream(list, std::ios::app) << absolute.string() + '\n';
}

}  // namespace gloam::shader::internal
