// SPDX-License-Identifier: MIT
#include "shader/internal/dependencies.hpp"

#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>

namespace gloam::shader::internal {
namespace {

constexpr const char* list_variable = "GLOAM_DEPENDENCIES_OUTPUT";

bool lists(const char* list, const std::string& wanted) {
    std::ifstream stream(list);
    for (std::string line; std::getline(stream, line);)
        if (line == wanted) return true;
    return false;
}

}  // namespace

std::string dependency_list() {
    const char* list = std::getenv(list_variable);
    return list == nullptr ? "" : list;
}

void use_dependency_list(const std::string& list) {
    if (list.empty()) {
        ::unsetenv(list_variable);
    } else {
        ::setenv(list_variable, list.c_str(), 1);
    }
}

void note_dependency(const std::filesystem::path& file) {
    const char* list = std::getenv(list_variable);
    if (list == nullptr) return;
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::canonical(file, error);
    if (error || lists(list, absolute.string())) return;
    std::ofstream(list, std::ios::app) << absolute.string() + '\n';
}

}  // namespace gloam::shader::internal
