// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "source/lines.hpp"
#include "source/text.hpp"
#include "source/tokens.hpp"

// What a GLSL text declares at file scope: one list, which packing, excerpts, mutations and the compiler's
// front end read.
namespace gloam::source {

// A parameter as it is written, with the parts that SPIR-V does not keep.
struct DeclaredParameter {
    Direction direction = Direction::in;
    std::string type;  // without qualifiers, with every array size: "float[2][3]"
    std::string name;  // may be empty
};

// The head of a function definition or prototype.
struct FunctionHead {
    std::string name;
    std::string result;  // as written, qualifiers included
    std::string text;    // "float f ( vec2 uv )"
    std::vector<DeclaredParameter> parameters;
    bool defined = false;  // a body follows
    std::size_t list = 0;  // the token of the declaration behind the '(' of its parameters
    std::size_t body = 0;  // and behind the ')'
};

// A declaration at file scope, a directive between two of them, or a comment that belongs to none of them.
struct Declaration {
    enum class Kind {
        comment,    // to what follows in its file, as far as the next one
        macro,      // #define, #undef
        function,   // with its body
        prototype,  // without
        structure,
        interface,  // uniform, buffer, in, out, a specialization constant, a layout
        variable,   // or constant
        other       // what has no name: a pragma, precision, a lone semicolon
    };
    Kind kind = Kind::other;
    std::size_t file = 0;       // of ActiveText::files
    int line = 1;               // of the file, where the text begins
    std::string comment;        // right above it
    std::string text;           // as written, its comment above it, without the newline at the end
    std::vector<Token> tokens;  // of the text, but for directives
    std::optional<FunctionHead> function;
    std::vector<std::string> names;   // that it declares: of a block without a name its members'
    std::set<std::string> mentions;   // names that it uses, maybe: what stands behind a '.' is none
    std::set<std::string> variables;  // of these, what a function has as variables, maybe its own
    bool by_macro = false;            // a macro that may make functions is called: "MAKE(name)"
    std::size_t paragraph = 0;        // those without a blank line between them have the same

    // Whether it is a function of this name, with its body.
    [[nodiscard]] bool defines(const std::string& name) const;
    // What stands between the parentheses of a function's parameters.
    [[nodiscard]] Tokens parameter_list() const;
};

struct Outline {
    std::vector<std::string> licences;      // lines that say SPDX-License-Identifier, each once
    std::vector<std::string> extensions;    // #extension lines, each once, but for that of #include
    std::vector<std::string> heads;         // comments at the head of the files given
    std::vector<Declaration> declarations;  // in the order of the text
};

// Whether the texts of declarations have their comments, or #line directives where lines of the file are left
// out, so that the compiler numbers the other lines as the file does.
enum class Keep { comments, line_numbers };

// The declarations of a text. The text need not be valid: anything else becomes one of kind `other`.
[[nodiscard]] Outline outline(const ActiveText& text, Keep keep = Keep::comments);

// "#line 12 "file"": the next line is that line of the file.
[[nodiscard]] std::string line_directive(int line, const std::string& file);

// Kind, names and mentions of a declaration.
[[nodiscard]] Declaration declaration_of(std::vector<Token> tokens);

// "MAKE(name)", "MAKE(name);" and "MAKE(name) { ... }": a macro stands for the declaration.
[[nodiscard]] bool is_macro_call(Tokens tokens);

// That of a #define or #undef; any other directive becomes one without a name.
[[nodiscard]] Declaration macro_of(const Directive& directive);

// The functions that a GLSL text defines and declares, in its order. The text is preprocessed: lines that
// begin with # are ignored.
[[nodiscard]] std::vector<FunctionHead> function_heads(std::string preprocessed);

// One for each function: of those that are defined first, then of those that are only declared.
[[nodiscard]] std::vector<FunctionHead> each_once(std::vector<FunctionHead> functions);

// The text with a body for each function without one, and with an empty main if there is none, because SPIR-V
// contains complete programs only.
[[nodiscard]] std::string completed(std::string text, const std::vector<FunctionHead>& functions);

}  // namespace gloam::source
