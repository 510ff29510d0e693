// SPDX-License-Identifier: MIT
#include "module/internal/front_end.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>
#include <utility>

#include "base/pattern.hpp"

namespace gloam::module::internal {
namespace {

// Stands for a line of code while the compiler's preprocessor runs: gloam_active_text_at_FILE_LINE_. Its
// output also holds the names of the texts, which are no such marks.
constexpr std::string_view mark = "gloam_active_text_at_";

std::string mark_of(std::size_t file, std::size_t line) {
    return std::string(mark) + std::to_string(file) + "_" + std::to_string(line) + "_";
}

void require_version(const source::TextFile& file, const source::Line& line,
                     const source::Directive& directive) {
    static const base::Pattern version(R"(^\d{3}[ \t]*(core|compatibility|es)?$)");
    if (!version.first(directive.argument).empty()) return;
    throw source::CompileError(file.name + ":" + std::to_string(line.number) + ": #version " +
                               directive.argument + ": expected a version of GLSL, such as 450 or 300 es");
}

// The code of a directive, in one line.
std::string joined(const source::Line& line) {
    std::string code = line.code;
    std::erase(code, '\0');
    std::replace(code.begin(), code.end(), '\n', ' ');
    return code;
}

// The compiler looks beside the first of several texts only.
std::string include_line(const source::TextFile& file, const source::Line& line,
                         const IncludeFolders& folders) {
    const auto include = include_of(line);
    if (!include || include->system) return joined(line);
    try {
        const auto folder = std::filesystem::path(file.name).parent_path();
        // Absolute: the compiler's reader looks for it once more, from the folder of the file.
        const auto found = std::filesystem::absolute(resolved(include->name, folder, folders));
        return "#include \"" + found.string() + "\"";
    } catch (const std::runtime_error&) {
        return joined(line);  // only the compiler knows whether a condition hides it
    }
}

// What the preprocessor is given of a line.
std::string marked_line(const source::TextFile& file, std::size_t number, std::size_t index,
                        const IncludeFolders& folders) {
    const source::Line& line = file.lines[index];
    const auto directive = directive_of(line);
    if (!directive) return mark_of(number, index);
    if (directive->keyword == "version") {
        require_version(file, line, *directive);
        return "";
    }
    if (directive->keyword == "include") return include_line(file, line, folders);
    static const std::set<std::string_view> conditions{"if",   "ifdef", "ifndef", "elif",
                                                       "else", "endif", "error"};
    if (conditions.contains(directive->keyword)) return joined(line);
    const bool defines = directive->keyword == "define" || directive->keyword == "undef";
    return (defines ? joined(line) + "\n" : "") + mark_of(number, index);
}

// The file with marks for its code. Lines keep their numbers, for messages.
std::string marked(const source::TextFile& file, std::size_t number, const IncludeFolders& folders) {
    std::string text;
    int next = 1;  // number that the compiler gives the next line
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        if (next != file.lines[i].number) text += "#line " + std::to_string(file.lines[i].number) + "\n";
        const std::string line = marked_line(file, number, i, folders);
        text += line + "\n";
        next = file.lines[i].number + 1 + static_cast<int>(std::ranges::count(line, '\n'));
    }
    return text;
}

// Lines in which a directive shares its line with a comment of several lines become two or three: the
// directive by itself.
std::vector<source::Line> with_directives_apart(const std::vector<source::Line>& lines) {
    std::vector<source::Line> apart;
    for (const source::Line& line : lines) {
        const std::size_t begin = line.code.find('#');
        if (!line.crosses || !directive_of(line) || begin == std::string::npos) {
            apart.push_back(line);
            continue;
        }
        const std::size_t end = line.code.find_last_not_of(" \t\r\n") + 1;
        const auto add = [&](std::size_t from, std::size_t to, bool crosses) {
            const auto text = line.text.substr(from, to - from);
            if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
            apart.push_back({text, line.code.substr(from, to - from), line.number, crosses});
        };
        add(0, begin, true);
        add(begin, end, false);
        add(end, line.text.size(), true);
    }
    return apart;
}

// Adds a file; returns what the preprocessor is to read instead of it.
std::string added(source::ActiveText& all, source::Source source, const IncludeFolders& folders) {
    source::TextFile& file =
        all.files.emplace_back(source::TextFile{std::move(source.name), std::move(source.text), {}});
    file.lines = with_directives_apart(source::split_lines(file.text));
    return marked(file, all.files.size() - 1, folders);
}

// The number of this file among those given; all.given: it is none of them.
std::size_t given_as(const source::ActiveText& all, const std::filesystem::path& path) {
    const std::string name = std::filesystem::absolute(path).lexically_normal().string();
    std::size_t file = 0;
    while (file < all.given && all.files[file].name != name) ++file;
    return file;
}

// The number at the front, which goes, and the '_' behind it.
std::size_t take_number(std::string_view& text) {
    std::size_t number = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number).ptr;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
    return number;
}

std::vector<source::ActiveText::Location> places_in(std::string_view preprocessed,
                                                    const source::ActiveText& all) {
    std::vector<source::ActiveText::Location> places;
    for (std::size_t at = preprocessed.find(mark); at != std::string_view::npos;
         at = preprocessed.find(mark)) {
        preprocessed.remove_prefix(at + mark.size());
        const std::size_t file = take_number(preprocessed);
        const std::size_t line = take_number(preprocessed);
        if (file < all.files.size() && line < all.files[file].lines.size()) places.push_back({file, line});
    }
    return places;
}

}  // namespace

Client client_of(source::Language language) {
    return language == source::Language::vulkan450 ? Client::vulkan : Client::none;
}

source::ActiveText active_text(const std::vector<source::Source>& given, source::Language language,
                               source::Stage stage, const std::vector<std::filesystem::path>& roots) {
    const IncludeFolders folders = include_folders(roots, given);
    source::ActiveText all;
    all.given = given.size();
    // Errors of the version itself are the first text's.
    std::vector<source::Source> pieces{{given.empty() ? "nothing" : given.back().name, preamble(language)}};
    std::string active;
    for (const source::Source& source : given) {
        pieces.push_back({source.name, added(all, source, folders)});
        active += pieces.back().text;
    }
    const auto reading = [&](const std::filesystem::path& path, std::string text) {
        // A file that another one includes first is still one of those given.
        const std::size_t same = given_as(all, path);
        if (same < all.given) return marked(all.files[same], same, folders);
        return added(all, {path.string(), std::move(text)}, folders);
    };
    // It follows directives alone, and its tables cost a process more than most texts.
    if (active.find('#') != std::string::npos)
        active = preprocessed(pieces, stage, client_of(language), folders, reading);
    all.lines = places_in(active, all);
    return all;
}

}  // namespace gloam::module::internal
