// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "source/lines.hpp"

namespace gloam::source {

// What a shader may do with a variable of its interface.
enum class Access {
    uniform,  // read it; it has one value for all invocations
    reads,
    buffer,  // anything, and so may all invocations
    any
};

// What a function needs other invocations for.
enum class Needs {
    nobody,
    quad,  // derivatives, samplers whose level follows from them, or discard: it belongs to a fragment
    group  // shared memory, barriers, subgroups, or its place among them
};

// A sampler or an image at file scope.
struct BoundVariable {
    std::string name;
    std::string type;         // is_sampler_type(), "uimage2D"
    std::string format = {};  // of an image: "r32ui"
    bool written = false;     // whether the function may store to the image
};

// The macro for the binding of such a variable of an excerpt, by its position.
[[nodiscard]] std::string binding_macro(std::size_t variable);

// The variable that holds the layer of an invocation in every image.
inline constexpr const char* image_layer = "gloam_image_layer";

// The variable that tells whether an invocation was discarded.
inline constexpr const char* discarded = "gloam_discarded";

// A function of a text from elsewhere, with all that it uses: a text that another shader can contain in the
// place of an #include. It has no comments, no #version and no main. #line directives name the lines of the
// original files.
// - Its uniforms, buffers, stage inputs and stage outputs are plain variables at file scope, which the other
//   shader sets. So are built-in variables of a vertex or fragment stage, with another name: gloam_FragCoord.
//   Of a function of a group, that is so for gl_WorkGroupID and what follows from it.
// - Its samplers and images have a macro for their binding, which the other shader defines (binding_macro()).
// - An image2D is an image2DArray, of which each invocation has a layer: macros for imageLoad() and its like
//   add `image_layer`, which the other shader sets. Its format has 32 bits.
// - Other types without values are left out.
// - Specialization constants have their default.
// - Where it may discard, it has a variable `discarded`, bool, which the other shader sets.
// - Of a function of a group, shared variables and the size of the group are as the file has them.
struct Excerpt {
    std::string function;  // its name; overloads have one excerpt
    std::string text = {};
    std::set<std::string> interface = {};        // names that it may use and that are left out
    std::vector<BoundVariable> bound = {};       // samplers and images that it may use
    std::map<std::string, Access> globals = {};  // the plain variables that it may use
    // Each definition of this name in `text`, in order: with its types as the file itself has them, "f(vec2,
    // float[2])"; empty for one of an include.
    std::vector<std::string> definitions = {};
    std::vector<std::string> comments = {};  // above each of them, and inside its list of parameters
    Needs needs = Needs::nobody;
    bool has_group_size = false;  // `text` states that of its work groups
};

// What stands before the name of a function in an excerpt that has the name and parameters of a built-in one,
// whose redefinition the front end refuses.
inline constexpr std::string_view own_prefix = "gloam_own_";

struct Excerpts {
    std::string version;                     // of the file's #version line: "330 core"; empty: there is none
    std::vector<Excerpt> functions = {};     // that the file itself defines, but for main, in their order
    std::vector<std::string> by_macro = {};  // "line 7: MAKE(name)": what macros may define is no excerpt
};

// The functions of the last text that was given; others before it have definitions. It need not be valid.
[[nodiscard]] Excerpts excerpts(const ActiveText& text);

}  // namespace gloam::source
