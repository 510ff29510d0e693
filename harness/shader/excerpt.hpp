// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

// A function of a text from elsewhere, with all that it uses: a text that another shader can contain in the
// place of an #include. It has no comments, no #version and no main, and none of the text's bindings, stage
// inputs and stage outputs. #line directives name the lines of the original files.
struct Excerpt {
    std::string function;  // its name; overloads have one excerpt
    std::string text;
    std::set<std::string> interface;  // names of bindings, stage inputs and outputs that it may use
    // Each definition of this name in `text`, in order: with its types as the file itself has them, "f(vec2,
    // float[2])"; empty for one of an include.
    std::vector<std::string> definitions;
};

struct Excerpts {
    std::string version;             // of the file's #version line: "330 core"; empty: there is none
    std::vector<Excerpt> functions;  // that the file itself defines, but for main, in their order
};

// The functions of a text. The text may have any #version and any stage; it is read as GLSL 4.50 for Vulkan,
// and need not be valid. Throws CompileError for what the preprocessor rejects, for example a missing
// include.
[[nodiscard]] Excerpts excerpts(const Source& source, const std::vector<std::filesystem::path>& roots);

}  // namespace gloam::shader
