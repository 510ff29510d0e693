// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// A text as a module from which translators write what a person can read: a parameter that is no output is
// const, so that they need no copies of arguments.
struct Callable {
    Spirv module;
    bool whole = false;               // the text has a main of its own
    std::set<std::string> functions;  // that the text defines
    std::set<std::string> supplied;   // that it declares and the user defines: in the module they have a body
    // Functions that return the constants of the text, and their names: constants have no names in a module.
    std::map<std::string, std::string> constants;
};

// What the bodies of `supplied` read images from, in a language that has no images at file scope.
inline constexpr const char* images_type = "GloamImages";
inline constexpr const char* images_name = "gloam_images";

// Functions of Callable::constants: this and a number.
inline constexpr const char* constant_prefix = "gloam_constant_";

// The module of a text that pack() wrote for Vulkan. Translators write whole modules only, and only what
// main() reaches: for a text without a main, one that calls every function is added.
// with_images: the functions that the user defines use a uniform block GloamImages. Throws CompileError;
// std::invalid_argument for a function with a parameter of an opaque type in a text without a main.
[[nodiscard]] Callable callable(const Source& packed, Stage stage, bool with_images);

}  // namespace gloam::shader::internal
