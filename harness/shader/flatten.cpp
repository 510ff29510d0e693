// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "shader/include.hpp"
#include "shader/internal/lines.hpp"

namespace gloam::shader {
namespace {

using internal::Line;
using Path = std::filesystem::path;

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

// "450", "330 core", "300 es" and their like.
bool is_version(std::string_view text) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    text.remove_prefix(digits);
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
    return digits == 3 && (text.empty() || text == "core" || text == "compatibility" || text == "es");
}

// The lines of an include guard around a whole file.
struct Guard {
    std::size_t ifndef_line;
    std::size_t define_line;
    std::size_t endif_line;

    bool holds(std::size_t line) const {
        return line == ifndef_line || line == define_line || line == endif_line;
    }
};

// The #endif of the condition that opens at `first`, if its #if has no other branch.
std::optional<std::size_t> matching_endif(const std::vector<Line>& lines, std::size_t first) {
    int depth = 0;
    for (std::size_t i = first; i < lines.size(); ++i) {
        const auto directive = internal::directive_of(lines[i]);
        if (!directive) continue;
        if (is_one_of(directive->keyword, {"if", "ifdef", "ifndef"})) ++depth;
        if (depth == 1 && is_one_of(directive->keyword, {"else", "elif"})) return std::nullopt;
        if (directive->keyword == "endif" && --depth == 0) return i;
    }
    return std::nullopt;
}

// A #version or an #extension may stand before the guard.
bool is_guardable(const Line& line) {
    const auto directive = internal::directive_of(line);
    return !internal::is_blank(line) &&
           !(directive && is_one_of(directive->keyword, {"version", "extension"}));
}

std::optional<Guard> guard_of(const std::vector<Line>& lines) {
    std::vector<std::size_t> code;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (is_guardable(lines[i])) code.push_back(i);
    if (code.size() < 3) return std::nullopt;
    const auto opening = internal::directive_of(lines[code[0]]);
    const auto define = internal::directive_of(lines[code[1]]);
    if (!opening || !define || opening->keyword != "ifndef" || define->keyword != "define")
        return std::nullopt;
    if (opening->argument != define->argument || matching_endif(lines, code[0]) != code.back())
        return std::nullopt;
    return Guard{code[0], code[1], code.back()};
}

class Flattener {
  public:
    explicit Flattener(const std::vector<Path>& roots) : roots_(roots) {}

    void add(const Path& file) {
        const Path path = file.lexically_normal();
        const auto open = std::find(open_.begin(), open_.end(), path);
        if (open != open_.end()) throw std::runtime_error("include cycle: " + chain(open) + path.string());
        if (!done_.insert(path).second) return;
        open_.push_back(path);
        add_text(path, read_text(path));
        open_.pop_back();
    }

    void add(const Source& source) { add_text(source.name, source.text); }

    std::string take() {
        std::string text;
        for (const std::string& line : top_) text += line + "\n";
        if (!top_.empty() && !body_.empty()) text += "\n";
        return text + body_;
    }

  private:
    // The text of a file waits until the includes that come before its first code are out.
    struct Pending {
        std::string text;
        bool has_code = false;
    };

    void add_text(const Path& path, const std::string& text) {
        const std::vector<Line> lines = internal::split_lines(text);
        const std::optional<Guard> guard = guard_of(lines);
        Pending pending;
        int conditions = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (guard && guard->holds(i))
                drop(lines[i], pending);
            else
                add_line(path, lines[i], conditions, pending);
        }
        emit(pending);
    }

    void add_line(const Path& path, const Line& line, int& conditions, Pending& pending) {
        const auto directive = internal::directive_of(line);
        const std::string keyword = directive ? directive->keyword : "";
        if (is_one_of(keyword, {"if", "ifdef", "ifndef"})) ++conditions;
        if (keyword == "endif") --conditions;
        if (const auto include = internal::include_of(line)) {
            const std::string place = path.string() + ":" + std::to_string(line.number) + ": ";
            if (conditions > 0)
                throw std::runtime_error(place + "#include \"" + include->name +
                                         "\" under a condition cannot be made part of one text");
            add_include(place, path.parent_path(), *include, pending);
        } else if (keyword == "extension" && conditions == 0) {
            if (!directive->argument.starts_with("GL_GOOGLE_include_directive"))
                lift("#extension " + directive->argument);
        } else if (internal::is_blank(line) &&
                   line.text.find("SPDX-License-Identifier:") != std::string_view::npos && !line.crosses) {
            lift(std::string(line.text.substr(0, line.text.find_last_not_of(" \t\r\n") + 1)));
            return;
        } else if (keyword == "version") {
            if (!is_version(directive->argument))
                throw std::runtime_error(path.string() + ":" + std::to_string(line.number) + ": #version " +
                                         directive->argument +
                                         ": expected a version of GLSL, such as 450 or 300 es");
        } else {
            pending.has_code = pending.has_code || !internal::is_blank(line);
            pending.text += line.text;
            return;
        }
        drop(line, pending);
    }

    void add_include(const std::string& place, const Path& from, const internal::IncludeName& include,
                     Pending& pending) {
        if (pending.has_code) emit(pending);
        Path file;
        try {
            file = resolve_include(include.name, include.system ? Path() : from, roots_);
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(place + error.what());
        }
        add(file);
    }

    // Of a dropped line stays only a block comment that it shares with its neighbours.
    static void drop(const Line& line, Pending& pending) {
        if (!line.crosses) return;
        const std::string comments = internal::comments_of(line);
        pending.text.append(comments, 0, comments.find_last_not_of(" \t\r\n") + 1).append("\n");
    }

    void lift(std::string line) {
        if (std::find(top_.begin(), top_.end(), line) == top_.end()) top_.push_back(std::move(line));
    }

    // Blank lines at either end go; one stands between two files.
    void emit(Pending& pending) {
        const std::string text = std::exchange(pending, {}).text;
        const auto first = text.find_first_not_of(" \t\r\n");
        if (first == std::string::npos) return;
        const auto line = text.rfind('\n', first);
        const auto begin = line == std::string::npos ? 0 : line + 1;
        const auto end = text.find_last_not_of(" \t\r\n") + 1;
        if (!body_.empty()) body_ += "\n";
        body_.append(text, begin, end - begin).append("\n");
    }

    std::string chain(std::vector<Path>::const_iterator from) const {
        std::string text;
        for (; from != open_.end(); ++from) text += from->string() + " -> ";
        return text;
    }

    const std::vector<Path>& roots_;
    std::set<Path> done_;
    std::vector<Path> open_;
    std::vector<std::string> top_;
    std::string body_;
};

}  // namespace

std::string flatten(const std::vector<Path>& files, const std::vector<Path>& roots) {
    Flattener flattener(roots);
    for (const Path& file : files) flattener.add(file);
    return flattener.take();
}

std::string flatten(const Source& source, const std::vector<Path>& roots) {
    std::string version;
    for (const Line& line : internal::split_lines(source.text)) {
        const auto directive = internal::directive_of(line);
        if (directive && directive->keyword == "version") version = "#version " + directive->argument + "\n";
    }
    Flattener flattener(roots);
    flattener.add(source);
    return version + flattener.take();
}

}  // namespace gloam::shader
