// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "source/declarations.hpp"
#include "source/lines.hpp"

namespace gloam::shader::internal {

// A declaration at file scope, a directive between two of them, or a comment that belongs to none of them.
struct Piece {
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
    std::optional<Declaration> function;
    std::vector<std::string> names;            // that it declares: of a block without a name its members'
    std::set<std::string> mentions;            // names that it uses, maybe: what stands behind a '.' is none
    std::set<std::string> variables;           // of these, what a function has as variables, maybe its own
    bool by_macro = false;                     // a macro that may make functions is called: "MAKE(name)"
    std::vector<std::string> parameter_types;  // words of a function's list of parameters
    std::size_t paragraph = 0;                 // pieces without a blank line between them have the same
};

struct Outline {
    std::vector<std::string> licences;    // lines that say SPDX-License-Identifier, each once
    std::vector<std::string> extensions;  // #extension lines, each once, but for that of #include
    std::vector<std::string> heads;       // comments at the head of the files given
    std::vector<Piece> pieces;            // in the order of the text
};

// Whether the texts of pieces have their comments, or #line directives where lines of the file are left out,
// so that the compiler numbers the other lines as the file does.
enum class Keep { comments, line_numbers };

// The declarations of a text. The text need not be valid: anything else becomes a piece of kind `other`.
[[nodiscard]] Outline outline(const ActiveText& text, Keep keep = Keep::comments);

// "#line 12 "file"": the next line is that line of the file.
[[nodiscard]] std::string line_directive(int line, const std::string& file);

// Kind, names and mentions of a declaration.
[[nodiscard]] Piece piece_of(std::vector<Token> tokens);

// "MAKE(name)", "MAKE(name);" and "MAKE(name) { ... }": a macro stands for the declaration.
[[nodiscard]] bool is_macro_call(Tokens tokens);

// The piece of a #define or #undef; any other directive becomes a piece without a name.
[[nodiscard]] Piece macro_of(const Directive& directive);

}  // namespace gloam::shader::internal
