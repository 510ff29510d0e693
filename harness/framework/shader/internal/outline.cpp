// SPDX-License-Identifier: MIT
#include "shader/internal/outline.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "shader/internal/declarations.hpp"

namespace gloam::shader::internal {
namespace {

using Kind = Piece::Kind;

bool is_name(const std::string& token) {
    const char c = token.front();
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool opens(const std::string& token) {
    return token == "(" || token == "[" || token == "{";
}

// The declared names of "a, b[2], c = f(1)": each the last name outside brackets, before a '=' or the end.
void add_declared(Tokens list, std::vector<std::string>& names) {
    std::string last;
    bool named = false;
    const auto add = [&] {
        if (!last.empty()) names.push_back(last);
        last.clear();
        named = false;
    };
    for (std::size_t i = 0; i < list.size();) {
        if (list[i] == "=") named = !last.empty();
        if (list[i] == "," || list[i] == ";") add();
        if (!named && is_name(list[i])) last = list[i];
        i = opens(list[i]) ? behind_bracket(list, i) : i + 1;
    }
    add();
}

void add_mentions(Tokens tokens, Piece& piece) {
    for (const std::string& token : tokens)
        if (is_name(token)) piece.mentions.insert(token.substr(0, token.find('.')));
}

// Names that are assigned to, indexed or read, and never called: no function of that name is meant.
void add_variables(Tokens tokens, Piece& piece) {
    std::set<std::string> called;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (!is_name(tokens[i])) continue;
        const std::string name = tokens[i].substr(0, tokens[i].find('.'));
        const std::string& next = tokens[i + 1];
        if (name == tokens[i] && next == "(") called.insert(name);
        // A macro may take the name of a function.
        if (name != tokens[i] || (next != "(" && next != ")" && next != ",")) piece.variables.insert(name);
    }
    std::erase_if(piece.variables, [&](const std::string& name) { return called.contains(name); });
}

// A name of a parameter hides what has it at file scope.
void take_function(Tokens tokens, std::size_t open, Piece& piece) {
    const std::size_t end = behind_bracket(tokens, open);
    piece.kind = contains(tokens.subspan(end), "{") ? Kind::function : Kind::prototype;
    piece.names = {tokens[open - 1]};
    add_variables(tokens.subspan(end), piece);
    const Tokens list = tokens.subspan(open + 1, end - open - 2);
    std::vector<std::string> parameters;
    add_declared(list, parameters);
    for (const std::string& token : list) {
        if (!is_name(token)) continue;
        piece.parameter_types.push_back(token);
    }
    for (const std::string& name : parameters) {
        const bool only_once = std::ranges::count(list, name) == 1;
        const auto at = std::ranges::find(list, name) - list.begin();
        const bool has_type = at > 0 && (is_name(list[static_cast<std::size_t>(at) - 1]) ||
                                         list[static_cast<std::size_t>(at) - 1] == "]");
        if (only_once && has_type) piece.mentions.erase(name);
    }
}

constexpr std::array<std::string_view, 6> storage{"uniform", "buffer", "in", "out", "attribute", "varying"};

// Qualifiers up to the name of the block or the type of the variable.
bool is_interface(Tokens head) {
    for (std::size_t i = 0; i < head.size();) {
        if (head[i] == "=") break;
        if (std::ranges::find(storage, head[i]) != storage.end()) return true;
        const bool layout = head[i] == "layout" && i + 1 < head.size() && head[i + 1] == "(";
        const std::size_t end = layout ? behind_bracket(head, i + 1) : i + 1;
        if (layout && contains(head.subspan(i, end - i), "constant_id")) return true;
        i = end;
    }
    return false;
}

// "struct Name { ... } variables;" and "uniform Name { ... } instance;".
void take_braces(Tokens tokens, std::size_t open, Piece& piece) {
    const std::size_t end = behind_bracket(tokens, open);
    if (open > 0 && is_name(tokens[open - 1])) piece.names.push_back(tokens[open - 1]);
    const std::size_t declared = piece.names.size();
    add_declared(tokens.subspan(end), piece.names);
    const bool block = !contains(tokens.first(open), "struct");
    piece.kind = is_interface(tokens.first(open)) ? Kind::interface
                 : declared < piece.names.size()  ? Kind::variable
                                                  : Kind::structure;
    if (block && declared == piece.names.size() && end > open + 1)
        add_declared(tokens.subspan(open + 1, end - open - 2), piece.names);
}

// Nothing of "layout(local_size_x = 8) in;", "precision highp float;", "invariant gl_Position;" has a name.
bool declares_nothing(Tokens tokens) {
    constexpr std::array<std::string_view, 3> statements{"precision", "invariant", ";"};
    if (std::ranges::find(statements, tokens.front()) != statements.end()) return true;
    if (tokens.front() != "layout" || tokens.size() < 3) return false;
    const Tokens rest = tokens.subspan(behind_bracket(tokens, 1));
    return std::ranges::all_of(rest, [](const std::string& token) {
        return token == ";" || std::ranges::find(storage, token) != storage.end();
    });
}

// "MAKE(name)", "MAKE(name);" and "MAKE(name) { ... }": a macro stands for the declaration.
bool is_macro_call(Tokens tokens) {
    if (tokens.size() < 3 || !is_name(tokens[0]) || tokens[0] == "layout" || tokens[1] != "(") return false;
    const std::size_t end = behind_bracket(tokens, 1);
    return end == tokens.size() || tokens[end] == "{" || tokens[end] == ";";
}

}  // namespace

Piece piece_of(std::string_view code) {
    const std::vector<std::string> all = tokens_of(code);
    Piece piece;
    if (all.empty()) return piece;
    add_mentions(all, piece);
    const Tokens tokens = Tokens(all).subspan(behind_macro_lines(all));
    if (is_macro_call(tokens)) {
        piece.by_macro = true;
        return piece;
    }
    if (declares_nothing(tokens)) {
        piece.kind = tokens.front() == "layout" ? Kind::interface : Kind::other;
        return piece;
    }
    const auto brace = static_cast<std::size_t>(std::ranges::find(tokens, "{") - tokens.begin());
    const auto equals = static_cast<std::size_t>(std::ranges::find(tokens, "=") - tokens.begin());
    if (const auto open = parameter_list(tokens)) {
        take_function(tokens, *open, piece);
    } else if (brace < tokens.size() && !(equals < brace && !is_interface(tokens.first(brace)))) {
        take_braces(tokens, brace, piece);
    } else {
        piece.kind = is_interface(tokens) ? Kind::interface : Kind::variable;
        add_declared(tokens, piece.names);
    }
    return piece;
}

Piece macro_of(const Directive& directive) {
    Piece piece;
    if (directive.keyword != "define" && directive.keyword != "undef") return piece;
    std::string text = directive.argument;
    std::ranges::replace(text, '\n', ' ');
    const std::vector<std::string> tokens = tokens_of(text);
    if (tokens.empty()) return piece;
    piece.kind = Kind::macro;
    piece.names = {tokens.front()};
    add_mentions(Tokens(tokens).subspan(1), piece);
    return piece;
}

namespace {

constexpr const char* blanks = " \t\r\n\v\f";

std::string without_end(std::string text) {
    return text.erase(text.find_last_not_of(blanks) + 1);
}

void add_once(std::vector<std::string>& lines, std::string line) {
    if (std::ranges::find(lines, line) == lines.end()) lines.push_back(std::move(line));
}

bool is_licence(const Line& line) {
    return is_blank(line) && !line.crosses &&
           line.text.find("SPDX-License-Identifier:") != std::string_view::npos;
}

// Comment lines that wait for what follows them.
struct Waiting {
    std::size_t file = 0;
    std::string text;
    bool blank_after = false;  // a blank line, or another file, ended it
};

// Reads the lines one after the other; a declaration lasts from one to the next.
class Reader {
  public:
    Reader(const ActiveText& text, Keep keep) : text_(text), keep_(keep) {}

    Outline run() {
        for (const ActiveText::Place& place : text_.lines) read(place);
        if (!code_.empty()) finish();  // the compiler has to say what is missing
        release_comments(true);
        return std::move(outline_);
    }

  private:
    void read(const ActiveText::Place& place) {
        const Line& line = text_.at(place);
        if (place.file != file_) change_file(place.file);
        seen_.insert(place.file);
        if (code_.empty() && is_licence(line))
            return add_once(outline_.licences, without_end(std::string(line.text)));
        if (const auto directive = directive_of(line)) return read_directive(line, *directive);
        if (code_.empty() && is_blank(line)) return read_comment(line);
        read_code(line);
    }

    void change_file(std::size_t file) {
        end_paragraph();
        file_ = file;
    }

    void end_paragraph() {
        if (!waiting_.empty()) waiting_.back().blank_after = true;
        if (code_.empty()) broken_ = true;
    }

    void read_comment(const Line& line) {
        const bool blank = line.text.find_first_not_of(blanks) == std::string_view::npos;
        if (blank && !line.crosses) return end_paragraph();
        if (keep_ == Keep::line_numbers) return;
        if (line.crosses && crossing_ && !outline_.pieces.empty()) {
            // The end of a comment that began behind a declaration.
            outline_.pieces.back().text += "\n" + without_end(std::string(line.text));
            return;
        }
        if (waiting_.empty() || waiting_.back().blank_after || waiting_.back().file != file_)
            waiting_.push_back({file_, "", false});
        waiting_.back().text += without_end(std::string(line.text)) + "\n";
    }

    void read_directive(const Line& line, const Directive& directive) {
        if (directive.keyword == "extension") {
            if (!directive.argument.starts_with("GL_GOOGLE_include_directive"))
                add_once(outline_.extensions, "#extension " + directive.argument);
            return;
        }
        if (directive.keyword == "line") return;  // lines are numbered as they stand in their files
        if (!code_.empty()) {                     // within a declaration
            inner_.push_back(macro_of(directive));
            return append(line, 0, line.text.size());
        }
        Piece piece = macro_of(directive);
        const bool guard = directive.argument.find_first_of(" \t(") == std::string::npos;
        if (!guard) open();  // a comment above one is the file's
        add_text(line, 0, line.text.size());
        piece.text = without_end(std::move(text_so_far_));
        put(std::move(piece));
        crossing_ = line.crosses;
    }

    // Declarations end at a ';', or at the '}' of a body, outside of all brackets.
    void read_code(const Line& line) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < line.code.size(); ++i) {
            const char c = line.code[i];
            if (c == '\0' || std::string_view(blanks).find(c) != std::string_view::npos) continue;
            if (code_.empty()) open();
            append(line, begin, i + 1);
            begin = i + 1;
            if (!ends_with(c)) continue;
            const bool rest_is_blank =
                line.code.find_first_not_of(std::string(blanks) + '\0', begin) == std::string::npos;
            if (rest_is_blank) {
                append(line, begin, line.text.size());
                begin = line.text.size();
            }
            finish();
            crossing_ = line.crosses;
        }
        if (!code_.empty()) append(line, begin, line.text.size());
        if (depth_ == 0 && last_ == ')' && calls_maker()) finish();
    }

    // Whether the declaration so far is the call of a macro with a body, which ends without a ';'.
    bool calls_maker() const {
        const std::vector<std::string> tokens = tokens_of(code_);
        if (!is_macro_call(tokens) || behind_bracket(tokens, 1) != tokens.size()) return false;
        return std::ranges::any_of(outline_.pieces, [&](const Piece& piece) {
            return piece.kind == Kind::macro && piece.names.front() == tokens.front() &&
                   piece.text.find('{') != std::string::npos;
        });
    }

    // Whether the character, the last that was appended, ends the declaration.
    bool ends_with(char c) {
        if (c == '{' && depth_ == 0) is_body_ = last_ == ')';
        if (c == '(' || c == '[' || c == '{') ++depth_;
        if (c == ')' || c == ']' || c == '}') --depth_;
        last_ = c;
        return depth_ <= 0 && (c == ';' || (c == '}' && is_body_));
    }

    // Adds a part of a line to the text of the piece.
    void add_text(const Line& line, std::size_t begin, std::size_t end) {
        if (text_so_far_.empty()) {
            first_line_ = line.number;
        } else if (keep_ == Keep::line_numbers && begin == 0 && line.number != next_line_) {
            if (!text_so_far_.ends_with('\n')) text_so_far_ += '\n';
            text_so_far_ += line_directive(line.number, text_.files[file_].name);
        }
        next_line_ = line.number + static_cast<int>(std::ranges::count(line.text, '\n'));
        text_so_far_ += keep_ == Keep::comments ? std::string(line.text.substr(begin, end - begin))
                                                : code_of(line, begin, end);
    }

    // A part of a line without comments, but with its continuations.
    static std::string code_of(const Line& line, std::size_t begin, std::size_t end) {
        std::string code = line.code.substr(begin, end - begin);
        for (std::size_t i = 0; i < code.size(); ++i)
            if (code[i] == '\0') code[i] = line.text[begin + i];
        return code;
    }

    void append(const Line& line, std::size_t begin, std::size_t end) {
        add_text(line, begin, end);
        std::string code = line.code.substr(begin, end - begin);
        std::ranges::replace(code, '\0', ' ');
        code_ += directive_of(line) ? std::string(code.size(), ' ') : code;
    }

    // A declaration begins: the comment right above it is its own, those before are not.
    void open() {
        std::string own;
        if (!waiting_.empty() && !waiting_.back().blank_after && waiting_.back().file == file_) {
            own = std::move(waiting_.back().text);
            waiting_.pop_back();
        }
        release_comments(false);
        if (std::exchange(broken_, false)) ++paragraph_;
        if (opened_file_ != file_) ++paragraph_;
        opened_file_ = file_;
        text_so_far_ = keep_ == Keep::comments ? std::move(own) : std::string();
        crossing_ = false;
    }

    // Comments at the head of a file that was given stand at the head of the result.
    void release_comments(bool at_end) {
        for (Waiting& comment : waiting_) {
            const bool first = comment.file < text_.given && !begun_.contains(comment.file);
            if (first || at_end) {
                outline_.heads.push_back(without_end(std::move(comment.text)));
                continue;
            }
            outline_.pieces.push_back({.kind = Piece::Kind::comment,
                                       .file = comment.file,
                                       .text = without_end(std::move(comment.text)),
                                       .paragraph = ++paragraph_});
            ++paragraph_;
        }
        waiting_.clear();
        begun_ = seen_;
    }

    void finish() {
        Piece piece = piece_of(code_);
        piece.text = without_end(std::move(text_so_far_));
        for (const Piece& inner : inner_) {
            piece.names.insert(piece.names.end(), inner.names.begin(), inner.names.end());
            piece.mentions.insert(inner.mentions.begin(), inner.mentions.end());
        }
        put(std::move(piece));
        inner_.clear();
        code_.clear();
        depth_ = 0;
        last_ = ' ';
        is_body_ = false;
    }

    void put(Piece piece) {
        piece.file = file_;
        piece.line = first_line_;
        piece.paragraph = paragraph_;
        outline_.pieces.push_back(std::move(piece));
        text_so_far_.clear();
    }

    const ActiveText& text_;
    Keep keep_;
    Outline outline_;
    std::vector<Waiting> waiting_;
    std::set<std::size_t> seen_;   // files of which a line was read
    std::set<std::size_t> begun_;  // of which a declaration has followed
    std::size_t file_ = 0;
    std::size_t opened_file_ = 0;
    std::size_t paragraph_ = 0;
    int first_line_ = 1;     // of text_so_far_
    int next_line_ = 1;      // of the file, behind text_so_far_
    bool broken_ = false;    // a blank line since the last declaration
    bool crossing_ = false;  // a comment leaves the line of the last declaration
    std::string text_so_far_;
    std::string code_;
    std::vector<Piece> inner_;
    int depth_ = 0;
    char last_ = ' ';
    bool is_body_ = false;
};

}  // namespace

Outline outline(const ActiveText& text, Keep keep) {
    return Reader(text, keep).run();
}

std::string line_directive(int line, const std::string& file) {
    std::string name = file;
    std::ranges::replace_if(
        name, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '"' || c == '\\'; }, '?');
    return "#line " + std::to_string(line) + " \"" + name + "\"\n";
}

}  // namespace gloam::shader::internal
