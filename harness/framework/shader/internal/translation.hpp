// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "shader/compile.hpp"
#include "shader/internal/outline.hpp"
#include "shader/pack.hpp"

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

// The comments of a GLSL text, found again by the names of what they describe: translators drop comments.
class Comments {
  public:
    explicit Comments(const Outline& glsl);

    // The comment above the function with this name; of several the one whose parameters resemble these most.
    // Ends with a newline; empty if there is none.
    [[nodiscard]] std::string above_function(const Piece& translated) const;

    // The comment above a structure, a block, a constant or a resource.
    [[nodiscard]] std::string above(const std::string& name) const;

    // The comment behind a member of a structure or block, or behind a resource (block: ""): "// text",
    // several lines if the comment goes on below.
    [[nodiscard]] std::string behind(const std::string& block, const std::string& member) const;

    // The names of the variables of a block: "parameters" of "uniform Parameters { ... } parameters;".
    [[nodiscard]] std::vector<std::string> instances(const std::string& block) const;

  private:
    struct OfFunction {
        std::vector<std::string> parameters;  // their types and names
        std::string comment;
    };
    std::multimap<std::string, OfFunction> functions_;
    std::map<std::string, std::string> above_;
    std::map<std::string, std::map<std::string, std::string>> behind_;
    std::map<std::string, std::vector<std::string>> instances_;
};

// What a person would write differently in the texts of SPIRV-Cross. The meaning stays.

// - Numbers with as few digits as name the same float: "1e+18f", not "999999984306749440.0f".
// - "x = a && (b);" where the text has "if (a) { x = b; } else { x = a; }", and the same for ||. HLSL before
// 2021
//   calculates b in any case: there only where b calls no function of the text and reads no array.
// - Specialization constants of HLSL by their names: a macro GLOAM_NAME for the value, not
//   SPIRV_CROSS_CONSTANT_ID_0.
// - In MSL, functions without linkage: "float f()", not "static inline __attribute__((always_inline)) float
// f()".
// - No samplers of images that are only fetched from.
[[nodiscard]] std::string tidy(const std::string& text, Target target);

}  // namespace gloam::shader::internal
