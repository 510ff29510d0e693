// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "source/declarations.hpp"

namespace gloam::source {
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
        for (const ActiveText::Location& place : text_.lines) read(place);
        if (!tokens_.empty()) finish();  // the compiler has to say what is missing
        release_comments(true);
        return std::move(outline_);
    }

  private:
    void read(const ActiveText::Location& place) {
        const Line& line = text_.at(place);
        if (place.file != file_) end_paragraph();
        file_ = place.file;
        seen_.insert(place.file);
        if (tokens_.empty() && is_licence(line))
            return add_once(outline_.licences, without_end(std::string(line.text)));
        if (const auto directive = directive_of(line)) return read_directive(line, *directive);
        if (tokens_.empty() && is_blank(line)) return read_comment(line);
        read_code(line);
    }

    void end_paragraph() {
        if (!waiting_.empty()) waiting_.back().blank_after = true;
        if (tokens_.empty()) broken_ = true;
    }

    void read_comment(const Line& line) {
        const bool blank = line.text.find_first_not_of(blanks) == std::string_view::npos;
        if (blank && !line.crosses) return end_paragraph();
        if (line.crosses && crossing_ && !outline_.declarations.empty()) {
            // The end of a comment that began behind a declaration.
            if (keep_ == Keep::comments)
                outline_.declarations.back().text += "\n" + without_end(std::string(line.text));
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
        if (!tokens_.empty()) {                   // within a declaration
            inner_.push_back(macro_of(directive));
            return add_text(line, 0, line.text.size());
        }
        const bool guard = directive.argument.find_first_of(" \t(") == std::string::npos;
        if (!guard) open();  // a comment above one is the file's
        add_text(line, 0, line.text.size());
        put(macro_of(directive));
        crossing_ = line.crosses;
    }

    // Declarations end at a ';', or at the '}' of a body, outside of all brackets.
    void read_code(const Line& line) {
        std::size_t begin = 0;
        const auto at = static_cast<std::size_t>(line.text.data() - text_.files[file_].text.data());
        for (Token& token : line_tokens(line, text_.files[file_].text)) {
            if (tokens_.empty()) open();
            std::size_t end = token.end() - at;
            const bool ends = ends_with(token);
            tokens_.push_back(std::move(token));
            if (!ends) continue;
            if (line.code.find_first_not_of(std::string(blanks) + '\0', end) == std::string::npos)
                end = line.text.size();
            add_text(line, begin, end);
            begin = end;
            finish();
            crossing_ = line.crosses;
        }
        if (tokens_.empty()) return;
        add_text(line, begin, line.text.size());
        if (depth_ == 0 && tokens_.back() == ")" && calls_maker()) finish();
    }

    // Whether the declaration so far is the call of a macro with a body, which ends without a ';'.
    bool calls_maker() const {
        if (!is_macro_call(tokens_) || behind(tokens_, 1) != tokens_.size()) return false;
        return std::ranges::any_of(outline_.declarations, [&](const Declaration& one) {
            return one.kind == Declaration::Kind::macro && one.names.front() == tokens_.front().text &&
                   one.text.find('{') != std::string::npos;
        });
    }

    // Whether the next token ends the declaration.
    bool ends_with(const Token& token) {
        if (token == "{" && depth_ == 0) is_body_ = !tokens_.empty() && tokens_.back() == ")";
        if (token == "(" || token == "[" || token == "{") ++depth_;
        if (token == ")" || token == "]" || token == "}") --depth_;
        return depth_ <= 0 && (token == ";" || (token == "}" && is_body_));
    }

    // Adds a part of a line to the text of the declaration.
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

    // A declaration begins: the comment right above it is its own, those before are not.
    void open() {
        comment_.clear();
        if (!waiting_.empty() && !waiting_.back().blank_after && waiting_.back().file == file_) {
            comment_ = std::move(waiting_.back().text);
            waiting_.pop_back();
        }
        release_comments(false);
        if (std::exchange(broken_, false)) ++paragraph_;
        text_so_far_ = keep_ == Keep::comments ? comment_ : std::string();
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
            outline_.declarations.push_back({.kind = Declaration::Kind::comment,
                                             .file = comment.file,
                                             .text = without_end(std::move(comment.text)),
                                             .paragraph = ++paragraph_});
            ++paragraph_;
        }
        waiting_.clear();
        begun_ = seen_;
    }

    void finish() {
        Declaration one = declaration_of(std::move(tokens_));
        one.comment = std::move(comment_);
        for (const Declaration& inner : inner_) {
            one.names.insert(one.names.end(), inner.names.begin(), inner.names.end());
            one.mentions.insert(inner.mentions.begin(), inner.mentions.end());
        }
        put(std::move(one));
        inner_.clear();
        tokens_.clear();
        depth_ = 0;
        is_body_ = false;
    }

    void put(Declaration one) {
        one.file = file_;
        one.line = first_line_;
        one.text = without_end(std::move(text_so_far_));
        one.paragraph = paragraph_;
        outline_.declarations.push_back(std::move(one));
        text_so_far_.clear();
    }

    const ActiveText& text_;
    Keep keep_;
    Outline outline_;
    std::vector<Waiting> waiting_;
    std::set<std::size_t> seen_;   // files of which a line was read
    std::set<std::size_t> begun_;  // of which a declaration has followed
    std::size_t file_ = 0;
    std::size_t paragraph_ = 0;
    int first_line_ = 1;     // of text_so_far_
    int next_line_ = 1;      // of the file, behind text_so_far_
    bool broken_ = false;    // a blank line since the last declaration
    bool crossing_ = false;  // a comment leaves the line of the last declaration
    std::string comment_;    // above it
    std::string text_so_far_;
    std::vector<Token> tokens_;
    std::vector<Declaration> inner_;
    int depth_ = 0;
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

}  // namespace gloam::source
