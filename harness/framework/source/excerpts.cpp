// SPDX-License-Identifier: MIT
#include "source/excerpts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

#include "base/text.hpp"
#include "source/internal/selection.hpp"

namespace gloam::source {
namespace {

using Kind = Declaration::Kind;

// The file whose functions are taken: the last of those given.
const TextFile& own_file(const ActiveText& text) {
    return text.files[text.given - 1];
}

// "f(vec2, float)"
std::string definition_of(const FunctionHead& function) {
    std::string parameters;
    for (const DeclaredParameter& parameter : function.parameters)
        parameters += (parameters.empty() ? "" : ", ") + parameter.type;
    return function.name + "(" + parameters + ")";
}

// The comments above a function and inside its list of parameters: "float x /* in [0, 1] */" counts whole.
std::string comment_of(const Declaration& one, const std::string& file) {
    const std::size_t begin = std::min(one.tokens[one.function->list - 1].begin, file.size());
    const std::size_t end = std::max(one.tokens[one.function->body - 1].begin, begin);
    const std::string list = file.substr(begin, end - begin);
    const bool comments = list.find("/*") != std::string::npos || list.find("//") != std::string::npos;
    return comments ? one.comment + list : one.comment;
}

// What the macros stand for.
using Macros = std::map<std::string, std::set<std::string>>;

Macros macros_of(const Outline& outline) {
    Macros macros;
    for (const Declaration& one : outline.declarations)
        if (one.kind == Kind::macro)
            macros[one.names.front()].insert(one.mentions.begin(), one.mentions.end());
    return macros;
}

bool is_precision(const Token& token) {
    return token == "highp" || token == "mediump" || token == "lowp";
}

// The tokens without layouts and storage qualifiers; an array without a size ("float values[];": as many as
// its buffer holds) gets one.
std::vector<Token> without_qualifiers(Tokens tokens) {
    static const std::set<std::string_view> dropped{
        "uniform",  "buffer",        "in",       "out",   "attribute", "varying",  "flat",     "smooth",
        "centroid", "noperspective", "sample",   "patch", "shared",    "coherent", "volatile", "restrict",
        "readonly", "writeonly",     "invariant"};
    constexpr const char* runtime_array_length = "16";
    std::vector<Token> kept;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i] == "layout" && i + 1 < tokens.size() && tokens[i + 1] == "(") {
            i = behind(tokens, i + 1) - 1;
            continue;
        }
        if (i > 0 && tokens[i] == "]" && tokens[i - 1] == "[") kept.push_back({runtime_array_length});
        if (!dropped.contains(tokens[i].text)) kept.push_back(tokens[i]);
    }
    return kept;
}

// The same list of declarators without their initial values.
std::vector<Token> without_values(Tokens tokens) {
    std::vector<Token> kept;
    bool value = false;
    for (std::size_t i = 0; i < tokens.size(); i = behind(tokens, i)) {
        if (tokens[i] == "=") value = true;
        if (tokens[i] == "," || tokens[i] == ";") value = false;
        if (!value) std::ranges::copy(tokens.subspan(i, behind(tokens, i) - i), std::back_inserter(kept));
    }
    return kept;
}

// Directives between the lines of a declaration, each on its own line.
std::string directives_of(const std::string& text) {
    std::string all;
    for (const Line& line : split_lines(text)) {
        const auto directive = directive_of(line);
        if (directive && directive->keyword != "line") all += std::string(line.text) + "\n";
    }
    return all.empty() ? all : "\n" + all;
}

// The format of a declaration of an image, if its texels have 32 bits; empty for another. An image that is
// only written needs none.
std::string image_format(Tokens tokens, std::string_view type) {
    const std::string suffix = type.starts_with('u') ? "32ui" : type.starts_with("ii") ? "32i" : "32f";
    for (const char* channels : {"r", "rg", "rgba"})
        if (contains(tokens, channels + suffix)) return channels + suffix;
    const bool other = std::ranges::any_of(tokens, [](const Token& token) {
        return token.text.starts_with("r") && token.text.find_first_of("0123456789") != std::string::npos;
    });
    return contains(tokens, "writeonly") && !other ? "rgba" + suffix : std::string();
}

Access access_of(Tokens head) {
    const bool fixed = contains(head, "readonly");
    if (contains(head, "buffer")) return fixed ? Access::uniform : Access::buffer;
    if (contains(head, "out") || contains(head, "varying")) return Access::any;
    return contains(head, "uniform") ? Access::uniform : Access::reads;
}

// The type of a variable: what a macro in its place stands for, if that is a type without values.
std::string type_of(const Token& word, const Macros& macros) {
    if (const auto macro = macros.find(word.text); macro != macros.end())
        if (const auto type = std::ranges::find_if(macro->second, is_opaque); type != macro->second.end())
            return *type;
    return word.text;
}

// The samplers, or images of two dimensions and 32 bits, that a declaration declares, added to those of the
// excerpt; empty for any other declaration, and for arrays of them.
std::string bound_text(const Declaration& one, Tokens words, const Token& word, const std::string& type,
                       Excerpt& excerpt) {
    BoundVariable variable{.name = {}, .type = type, .written = !contains(one.tokens, "readonly")};
    if (type.ends_with("image2D")) variable.format = image_format(up_to(one.tokens, word.text), type);
    const bool image = !variable.format.empty();
    if ((!image && !is_sampler_type(type)) || contains(words, "[")) return {};
    std::string text;
    for (const std::string& name : one.names) {
        text += fmt::format("layout(binding = {}{}{}) uniform highp {}{} {}; ",
                            binding_macro(excerpt.bound.size()), image ? ", " : "", variable.format, type,
                            image ? "Array" : "", name);
        variable.name = name;
        excerpt.bound.push_back(variable);
    }
    return text;
}

// A block whose members are plain variables, or one variable with its structure: the text, and the names.
std::string block_text(Tokens tokens, std::size_t brace, std::vector<std::string>& names) {
    const std::size_t end = behind(tokens, brace);
    const bool structure = contains(tokens.first(brace), "struct");
    const bool instance = end < tokens.size() && tokens[end] != ";";
    if (structure || instance) {
        if (end < tokens.size()) names = {tokens[end].text};
        return (structure ? "" : "struct ") + joined(tokens, " ");
    }
    names.erase(names.begin());  // that of the block
    return joined(tokens.subspan(brace + 1, end - brace - 2), " ");
}

// The text of a declaration of kind `interface` in an excerpt: plain variables in the place of a loose
// uniform, a stage input or output, a block without an instance (each member is one) or with one (it has a
// structure of the block's name). Layouts, storage qualifiers and initial values are dropped. A
// specialization constant becomes a constant. Nothing of other types without values and of references to
// buffers, whose names the excerpt then lists.
std::string interface_text(const Declaration& one, const Macros& macros, Excerpt& excerpt) {
    const bool sizes = contains(one.tokens, "local_size_x");
    if (excerpt.needs == Needs::group && (sizes || contains(one.tokens, "shared"))) {
        excerpt.has_group_size |= sizes;
        return one.text;
    }
    const std::vector<Token> kept = without_qualifiers(one.tokens);
    if (contains(one.tokens, "constant_id")) return joined(kept, " ");
    const std::vector<Token> words = without_values(kept);
    const std::size_t brace = up_to(words, "{").size();
    std::vector<std::string> names = one.names;
    const auto word = std::ranges::find_if_not(words, is_precision);
    bool left_out = names.empty() || names.front().starts_with("gl_") || word == words.end() ||
                    contains(one.tokens, "buffer_reference");
    if (!left_out && brace == words.size()) {
        const std::string type = type_of(*word, macros);
        if (const std::string text = bound_text(one, kept, *word, type, excerpt); !text.empty()) return text;
        left_out = is_opaque(type);
    }
    if (left_out) {
        excerpt.interface.insert(names.begin(), names.end());
        return {};
    }
    const std::string text = directives_of(one.text) +
                             (brace == words.size() ? joined(words, " ") : block_text(words, brace, names));
    const Access access = access_of(up_to(one.tokens, "{"));
    for (const std::string& name : names) {
        excerpt.globals[name] = access;
        if (const auto renamed = macros.find(name); renamed != macros.end())
            for (const std::string& other : renamed->second) excerpt.globals[other] = access;
    }
    return text;
}

// Macros that turn accesses to images of two dimensions into those to the invocation's layer.
std::string image_macros() {
    std::string text = fmt::format("int {};\n#define imageSize(image) imageSize(image).xy\n", image_layer);
    const auto macro = [&](const std::string& name, std::string_view values) {
        text += fmt::format("#define {0}(image, at{1}) {0}(image, ivec3(at, {2}){1})\n", name, values,
                            image_layer);
    };
    macro("imageLoad", "");
    macro("imageStore", ", value");
    for (const char* operation : {"Add", "Min", "Max", "And", "Or", "Xor", "Exchange"})
        macro(std::string("imageAtomic") + operation, ", value");
    macro("imageAtomicCompSwap", ", compare, value");
    return text;
}

// Variables that a function alone in a compute stage has not, or has another value of.
struct BuiltIn {
    const char* name;  // behind "gl_"
    const char* type;
    Access access = Access::reads;
    bool in_group = false;  // it is a plain variable of a group's functions, too
};
constexpr std::array built_ins{BuiltIn{"FragCoord", "vec4"},
                               BuiltIn{"PointCoord", "vec2"},
                               BuiltIn{"FrontFacing", "bool"},
                               BuiltIn{"VertexID", "int"},
                               BuiltIn{"InstanceID", "int"},
                               BuiltIn{"VertexIndex", "int"},
                               BuiltIn{"InstanceIndex", "int"},
                               BuiltIn{"Position", "vec4", Access::any},
                               BuiltIn{"PointSize", "float", Access::any},
                               BuiltIn{"FragColor", "vec4", Access::any},
                               BuiltIn{"FragDepth", "float", Access::any},
                               BuiltIn{"WorkGroupID", "uvec3", Access::uniform, true},
                               BuiltIn{"NumWorkGroups", "uvec3", Access::uniform, true},
                               BuiltIn{"GlobalInvocationID", "uvec3"}};

// What a function calls or mentions that needs other invocations.
Needs needs_of(const std::set<std::string>& mentioned, bool shares, const std::string& file) {
    const auto mentions = [&](auto matches) { return std::ranges::any_of(mentioned, matches); };
    static const std::set<std::string_view> of_group{"barrier", "memoryBarrierShared", "groupMemoryBarrier",
                                                     "gl_WorkGroupSize", "gl_NumSubgroups"};
    static const std::set<std::string_view> of_quad{
        "dFdx", "dFdy", "fwidth", "discard", "demote", "helperInvocationEXT", "terminateInvocation"};
    static const std::set<std::string_view> implicit{
        "texture", "textureProj", "textureOffset", "textureProjOffset", "textureQueryLod", "textureClampARB"};
    const bool group = shares || mentions([](const std::string& name) {
                           return of_group.contains(name) || name.starts_with("subgroup") ||
                                  name.starts_with("gl_LocalInvocation") || name.starts_with("gl_Subgroup");
                       });
    if (group) return Needs::group;
    // Stages without derivatives, where samplers read level 0.
    const std::optional<Stage> stage = stage_of_file(file);
    const bool has_quads = !stage || *stage == Stage::fragment;
    const bool quad = mentions([&](std::string_view name) {
        for (const std::string_view kind : {"Fine", "Coarse"})
            if (name.ends_with(kind)) name.remove_suffix(kind.size());
        return of_quad.contains(name) || (has_quads && implicit.contains(name));
    });
    return quad ? Needs::quad : Needs::nobody;
}

// The plain variables for the built-in ones that are mentioned.
std::string built_in_text(const std::set<std::string>& mentioned, Excerpt& excerpt) {
    const std::string global = "gl_GlobalInvocationID";
    std::string text;
    for (const BuiltIn& one : built_ins) {
        const std::string plain = std::string("gloam_") + one.name;
        const std::string name = std::string("gl_") + one.name;
        const bool in_group = excerpt.needs == Needs::group;
        const bool follows = in_group && plain == "gloam_WorkGroupID" && mentioned.contains(global);
        if ((!mentioned.contains(name) && !follows) || (in_group && !one.in_group)) continue;
        text += std::string(one.type) + " " + plain + ";\n#define " + name + " " + plain + "\n";
        excerpt.globals[plain] = one.access;
    }
    const bool ends = mentioned.contains("discard") || mentioned.contains("terminateInvocation");
    if (excerpt.needs == Needs::quad && ends) {
        text += std::string("bool ") + discarded + ";\n";
        excerpt.globals[discarded] = Access::any;
    }
    if (excerpt.needs == Needs::group && mentioned.contains(global))
        text += "#define " + global + " (gloam_WorkGroupID * gl_WorkGroupSize + gl_LocalInvocationID)\n";
    return text;
}

// Whether a text has "NAME other": NAME is a type there.
bool is_type_in(const Declaration& one, const std::string& name) {
    if (one.kind == Kind::macro || !one.mentions.contains(name)) return false;
    const auto names_type = [&](const Token& token, const Token& next) {
        return token == name && next != "(";
    };
    return std::ranges::adjacent_find(one.tokens, names_type) != one.tokens.end();
}

// What samplers' functions are called in GLSL 1.20 and 1.00, and now.
constexpr const char* legacy_calls =
    "texture2D texture texture2DProj textureProj texture2DLod textureLod texture2DLodEXT textureLod "
    "texture2DProjLod textureProjLod texture2DProjLodEXT textureProjLod texture2DGradEXT textureGrad "
    "texture3D texture texture3DLod textureLod textureCube texture textureCubeLod textureLod "
    "textureCubeLodEXT textureLod textureCubeGradEXT textureGrad texture3DProj textureProj";

// Macros that give these functions the names of today, and those names. GLSL for Vulkan has types with some
// of the old names; where a text declares one, it is not that old.
std::string legacy_text(const Outline& outline, std::set<std::string>& mentioned) {
    std::string text;
    std::istringstream calls(legacy_calls);
    for (std::string old_name, name; calls >> old_name >> name;) {
        if (!mentioned.contains(old_name)) continue;
        const bool has_another_meaning =
            std::ranges::any_of(outline.declarations, [&](const Declaration& one) {
                return is_type_in(one, old_name) || std::ranges::find(one.names, old_name) != one.names.end();
            });
        if (has_another_meaning) continue;
        text += fmt::format("#define {} {}\n", old_name, name);
        mentioned.insert(name);
    }
    return text;
}

// Built-in functions of one, two and three parameters, which have one type or are floats; between blanks.
constexpr std::array<std::string_view, 3> built_in_functions{
    " sinh cosh tanh asinh acosh atanh round trunc roundEven fract sign floor ceil radians degrees exp exp2 "
    "log log2 sqrt inversesqrt abs sin cos tan asin acos isnan isinf length normalize inverse transpose "
    "determinant ",
    " mod min max step pow distance dot cross reflect outerProduct matrixCompMult ",
    " mix clamp fma smoothstep refract faceforward "};

// Whether a function takes the place of a built-in one.
bool is_own_built_in(const Declaration& one) {
    if (one.kind != Kind::function) return false;
    const std::size_t count = one.function->parameters.size();
    if (count == 0 || count > built_in_functions.size()) return false;
    const std::string name = fmt::format(" {} ", one.names.front());
    if (built_in_functions.at(count - 1).find(name) == std::string_view::npos) return false;
    return std::ranges::all_of(one.function->parameters, [](const DeclaredParameter& parameter) {
        return parameter.type == "float" || parameter.type.starts_with("vec") ||
               parameter.type.starts_with("mat");
    });
}

Excerpt excerpt_of(const std::string& function, const ActiveText& active, const Outline& outline) {
    std::vector<const Declaration*> kept = kept_for(outline, function);
    std::erase_if(kept, [](const Declaration* one) { return one->defines("main"); });
    const Macros macros = macros_of(outline);
    Excerpt excerpt{.function = function};
    for (const std::string& extension : outline.extensions) excerpt.text += extension + "\n";
    const std::size_t head = excerpt.text.size();
    std::set<std::string> mentioned;
    std::set<std::string> own;
    bool shares = false;
    for (const Declaration* one : kept) {
        mentioned.insert(one->mentions.begin(), one->mentions.end());
        if (is_own_built_in(*one)) own.insert(one->names.front());
        const bool variable = one->kind == Kind::interface || one->kind == Kind::variable;
        shares |= variable && contains(one->tokens, "shared");
    }
    const std::string legacy = legacy_text(outline, mentioned);
    excerpt.needs = needs_of(mentioned, shares, own_file(active).name);
    excerpt.text += legacy + built_in_text(mentioned, excerpt);
    for (const std::string& name : own)
        excerpt.text += fmt::format("#define {} {}{}\n", name, own_prefix, name);
    for (const Declaration* one : kept) {
        const std::string text =
            one->kind == Kind::interface ? interface_text(*one, macros, excerpt) : one->text;
        if (text.empty()) continue;
        const TextFile& file = active.files[one->file];
        excerpt.text += line_directive(one->line, file.name) + text + "\n";
        if (!one->defines(function)) continue;
        excerpt.definitions.push_back(one->file < active.given ? definition_of(*one->function) : "");
        excerpt.comments.push_back(comment_of(*one, file.text));
    }
    const bool stores = std::ranges::any_of(mentioned, [](const std::string& name) {
        return name == "imageStore" || name.starts_with("imageAtomic");
    });
    for (BoundVariable& variable : excerpt.bound) variable.written = variable.written && stores;
    if (std::ranges::any_of(excerpt.bound, [](const auto& one) { return !one.format.empty(); }))
        excerpt.text.insert(head, image_macros());
    return excerpt;
}

}  // namespace

std::string binding_macro(std::size_t variable) {
    return "GLOAM_BINDING_" + std::to_string(variable);
}

Excerpts excerpts(const ActiveText& active) {
    const Outline outline = source::outline(active, Keep::line_numbers);
    Excerpts all;
    for (const Line& line : own_file(active).lines)
        if (const auto directive = directive_of(line);
            directive && directive->keyword == "version" && all.version.empty())
            all.version = directive->argument;
    for (const Declaration& one : outline.declarations) {
        if (one.by_macro && one.file < active.given)
            all.by_macro.push_back(fmt::format("line {}: {}", one.line, base::one_line(one.text)));
        if (one.kind != Kind::function || one.file >= active.given || one.defines("main")) continue;
        const std::string& name = one.names.front();
        if (std::ranges::find(all.functions, name, &Excerpt::function) == all.functions.end())
            all.functions.push_back(excerpt_of(name, active, outline));
    }
    return all;
}

}  // namespace gloam::source
