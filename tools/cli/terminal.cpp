// SPDX-License-Identifier: MIT
#include "cli/terminal.hpp"

#include <unistd.h>

#include <cstdlib>

namespace gloam::cli {
namespace {

bool shows_color() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string_view(value == nullptr ? "" : value);
    };
    return isatty(STDOUT_FILENO) != 0 && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
}

}  // namespace

std::string colored(std::string_view text, Ink ink) {
    if (!shows_color()) return std::string(text);
    return std::string(ink == Ink::good ? "\033[32m" : "\033[1;31m") + std::string(text) + "\033[0m";
}

}  // namespace gloam::cli
