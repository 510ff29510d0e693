// SPDX-License-Identifier: MIT
#include "interpreter/error.hpp"

#include <fmt/format.h>

namespace gloam::interpreter {

std::string to_text(const Place& place) {
    const std::string function = place.function.empty() ? "the module" : place.function;
    if (place.line == 0) return fmt::format("{} (word {})", function, place.word);
    return fmt::format("{} ({}:{})", function, place.file.empty() ? "?" : place.file, place.line);
}

}  // namespace gloam::interpreter
