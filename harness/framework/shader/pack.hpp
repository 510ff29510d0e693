// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

struct PackRequest {
    Language language = Language::vulkan450;
    // The requested functions; what they use is included. Empty: main of the texts if there is one, otherwise
    // all functions that the texts define themselves; for texts without functions, all declarations.
    std::vector<std::string> functions;
    std::optional<Stage> stage;  // of a text with a main; empty: usual_stage()
    // Values of specialization constants by their number, as bits. Others keep the value of the text.
    std::map<std::uint32_t, std::uint32_t> constants{};
};

// One text of this version without includes and conditions. Its order: the #version line, licences,
// #extension lines, a comment that says what to call and what to define where there are prototypes without a
// body, and the comment at the head of the texts; then what the user has to supply (those prototypes,
// bindings, specialization constants, structures of the functions' parameters); then the rest. Each
// declaration follows those that it uses.
// Declarations that the functions do not use are dropped, except constants and macros that a kept comment
// names: "FX_STEP", or "FX_FALLOFF_*" for all that begin so. Comments stay with the declaration below them. A
// name counts as a use of every declaration with this name, so the result can contain unused declarations,
// but lacks none. The result has been compiled. Throws CompileError (for the original texts, if the error is
// there), std::invalid_argument for a function that the texts do not have, std::runtime_error for a file that
// cannot be read.
[[nodiscard]] std::string pack(const std::vector<std::filesystem::path>& files, const PackRequest& request,
                               const std::vector<std::filesystem::path>& roots);
[[nodiscard]] std::string pack(const std::vector<Source>& sources, const PackRequest& request,
                               const std::vector<std::filesystem::path>& roots);

// A text without comments, indents and blank lines; and the number of its lines.
[[nodiscard]] std::string code_of(std::string_view text);
[[nodiscard]] std::size_t code_lines(std::string_view text);
// Such lines of all texts that pack() wrote: a function, structure, constant or macro counts once.
[[nodiscard]] std::size_t code_lines(const std::vector<std::string>& packed);

// The stage that the ending of a file names, in small or capital letters: .comp and .cs; .vert, .vs and .vsh;
// .frag, .fs and .fsh. nullopt for any other.
[[nodiscard]] std::optional<Stage> stage_of_file(const std::filesystem::path& file);

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
// add
//   `image_layer`, which the other shader sets. Its format has 32 bits.
// - Other types without values are left out.
// - Specialization constants have their default.
// - Where it may discard, it has a variable `discarded`, bool, which the other shader sets.
// - Of a function of a group, shared variables and the size of the group are as the file has them.
struct Excerpt {
    std::string function;  // its name; overloads have one excerpt
    std::string text;
    std::set<std::string> interface;        // names that it may use and that are left out
    std::vector<BoundVariable> bound = {};  // samplers and images that it may use
    std::map<std::string, Access> globals;  // the plain variables that it may use
    // Each definition of this name in `text`, in order: with its types as the file itself has them, "f(vec2,
    // float[2])"; empty for one of an include.
    std::vector<std::string> definitions;
    std::vector<std::string> comments = {};  // above each of them, and inside its list of parameters
    Needs needs = Needs::nobody;
};

// What stands before the name of a function in an excerpt that has the name and parameters of a built-in one,
// whose redefinition the front end refuses.
inline constexpr std::string_view own_prefix = "gloam_own_";

struct Excerpts {
    std::string version;                // of the file's #version line: "330 core"; empty: there is none
    std::vector<Excerpt> functions;     // that the file itself defines, but for main, in their order
    std::vector<std::string> by_macro;  // "line 7: MAKE(name)": what macros may define is no excerpt
};

// The functions of a text. The text may have any #version and any stage; it is read as GLSL 4.50 for Vulkan,
// and need not be valid. Throws CompileError for what the preprocessor rejects, for example a missing
// include.
[[nodiscard]] Excerpts excerpts(const Source& source, const std::vector<std::filesystem::path>& roots);

// Shading languages other than GLSL.
enum class Target { hlsl, msl };

// "hlsl", "msl"; nullopt for other text.
[[nodiscard]] std::optional<Target> target_from(std::string_view name);

// The suffix of a file: ".hlsl", ".metal".
[[nodiscard]] std::string suffix(Target target);

// A text that pack() wrote for Vulkan, as SPIRV-Cross translates it, with the licences of the text above it:
// HLSL of shader model 6.0, or Metal Shading Language 2.1. The numbers of registers and indices are those of
// the bindings; push constants have the number after the last one. The entry point is main in HLSL, main0 in
// MSL. A text without a main gets one that calls every function, and functions that its user defines get a
// body that returns an undefined `gloam_result`. Throws CompileError if the text does not compile;
// std::invalid_argument for what cannot be translated.
[[nodiscard]] std::string translated(const Source& packed, Target target, Stage stage = Stage::compute);

}  // namespace gloam::shader
