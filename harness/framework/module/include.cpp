// SPDX-License-Identifier: MIT
#include "module/include.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/files.hpp"
#include "module/internal/front_end.hpp"
#include "source/lines.hpp"

namespace gloam::module {
namespace {

using Path = std::filesystem::path;

// Appends the absolute path of a read file to the list in the file that the environment variable
// GLOAM_DEPENDENCIES_OUTPUT names, one path a line, unless it is listed already. Does nothing if the variable
// is not set or the list cannot be written: a list of dependencies must not stop a compilation.
void note_dependency(const Path& file) {
    const char* list = std::getenv("GLOAM_DEPENDENCIES_OUTPUT");
    if (list == nullptr) return;
    std::error_code error;
    const Path absolute = std::filesystem::canonical(file, error);
    std::ifstream listed(list);
    for (std::string line; std::getline(listed, line);)
        if (line == absolute.string()) return;
    if (!error) std::ofstream(list, std::ios::app) << absolute.string() + '\n';
}

// The files to which an include name can refer, in the order in which they are tried.
std::vector<Path> candidates(std::string_view name, const Path& from, const std::vector<Path>& roots) {
    std::vector<Path> files;
    if (!from.empty()) files.push_back((from / name).lexically_normal());
    for (const Path& root : roots) files.push_back((root / name).lexically_normal());
    return files;
}

bool is_file(const Path& file) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored);
}

// Whether an existing file lies below a root. Links are followed on both sides.
bool is_below(const Path& file, const std::vector<Path>& roots) {
    std::error_code error;
    const Path real = std::filesystem::canonical(file, error);
    if (error) return false;
    return std::ranges::any_of(roots, [&](const Path& root) {
        const Path folder = std::filesystem::canonical(root, error);
        return !error && std::ranges::mismatch(folder, real).in1 == folder.end();
    });
}

// Where a file is read from: read_text().
Path overlaid(const Path& file) {
    const char* const copy = std::getenv("GLOAM_SHADERS");
    const char* const original = std::getenv("GLOAM_SHADERS_OF");
    if (copy == nullptr || original == nullptr) return file;
    std::error_code error;
    const Path folder = std::filesystem::canonical(original, error);
    const Path real = error ? Path() : std::filesystem::canonical(file, error);
    if (error || !is_below(real, {folder})) return file;
    Path found = copy / real.lexically_relative(folder);
    return is_file(found) ? found : file;
}

std::optional<Path> first_file(const std::vector<Path>& files, const std::vector<Path>& permitted) {
    for (const Path& file : files)
        if (is_file(file) && is_below(file, permitted)) return file;
    return std::nullopt;
}

std::string listed(const std::vector<Path>& files) {
    std::string list;
    for (const Path& file : files) list += " " + file.string();
    return list;
}

}  // namespace

std::string read_text(const Path& file) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw std::runtime_error(
            file.string() +
            (std::filesystem::is_directory(status) ? ": is a folder" : ": is no regular file") +
            ", expected a text file");
    std::string text = base::read_file(overlaid(file));
    if (text.find('\0') != std::string::npos)
        throw std::runtime_error(file.string() + ": contains a NUL byte, expected a text in UTF-8");
    note_dependency(file);
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    return text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text;
}

namespace internal {

IncludeFolders include_folders(const std::vector<Path>& roots, const std::vector<source::Source>& texts) {
    IncludeFolders folders{.roots = roots, .permitted = roots};
    for (const source::Source& text : texts)
        if (const Path own = Path(text.name).parent_path(); !own.empty()) folders.permitted.push_back(own);
    return folders;
}

Path resolved(std::string_view name, const Path& from, const IncludeFolders& folders) {
    const std::vector<Path> files = candidates(name, from, folders.roots);
    if (const std::optional<Path> file = first_file(files, folders.permitted)) return *file;
    const std::string quoted = "include \"" + std::string(name) + "\"";
    if (std::ranges::any_of(files, is_file))
        throw std::runtime_error(
            quoted + " is outside the include roots, expected a file below" +
            (folders.permitted.empty() ? " one of them, found none" : listed(folders.permitted)));
    if (files.empty()) throw std::runtime_error("cannot find " + quoted + ": no folder to look in");
    throw std::runtime_error("cannot find " + quoted + "; looked for" + listed(files));
}

}  // namespace internal

Path resolve_include(std::string_view name, const Path& from, const std::vector<Path>& roots) {
    return internal::resolved(name, from, {.roots = roots, .permitted = roots});
}

// A chain of includes can be as long as their author wants, so that the open files are a list and not calls
// within calls.
std::vector<IncludedFile> include_closure(const source::Source& source, const std::vector<Path>& roots) {
    struct Name {
        std::string name;
        Path from;
        auto operator<=>(const Name&) const = default;
    };
    const internal::IncludeFolders folders = internal::include_folders(roots, {source});
    std::vector<IncludedFile> files;
    std::vector<Name> waiting;
    std::set<Name> mentioned;
    std::set<Path> seen;
    std::size_t bytes = 0;
    // Puts the includes of a text before those that wait, the last one first. Behind the last "include", in
    // most of a library, there are none, unless lines go on in the next.
    const auto open = [&waiting](std::string_view text, const Path& from) {
        if (text.find('\\') == std::string_view::npos)
            text = text.substr(0, text.find('\n', text.rfind("include") + 1));
        const auto before = static_cast<std::ptrdiff_t>(waiting.size());
        for (const source::Line& line : source::split_lines(text))
            if (const auto include = source::include_of(line))
                waiting.push_back({include->name, include->system ? Path() : from});
        std::reverse(waiting.begin() + before, waiting.end());
    };
    open(source.text, Path(source.name).parent_path());
    while (!waiting.empty()) {
        const Name next = std::move(waiting.back());
        waiting.pop_back();
        if (!mentioned.insert(next).second) continue;  // a repeated name is the same file
        const auto file = first_file(candidates(next.name, next.from, roots), folders.permitted);
        if (!file || !seen.insert(*file).second) continue;
        try {
            files.push_back({*file, read_text(*file)});
        } catch (const std::runtime_error&) {
            continue;
        }
        bytes += files.back().text.size();
        if (bytes > base::largest_text)
            throw std::runtime_error(file->string() + ": the includes together are longer than " +
                                     std::to_string(base::largest_text) + " bytes");
        open(files.back().text, file->parent_path());
    }
    return files;
}

}  // namespace gloam::module
