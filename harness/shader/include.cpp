// SPDX-License-Identifier: MIT
#include "shader/include.hpp"

#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>

#include "shader/internal/dependencies.hpp"
#include "shader/internal/lines.hpp"

namespace gloam::shader {
namespace {

using Path = std::filesystem::path;

// The files to which an include name can refer, in the order in which they are tried.
std::vector<Path> candidates(std::string_view name, const Path& from, const std::vector<Path>& roots) {
    std::vector<Path> files;
    if (!from.empty()) files.push_back((from / name).lexically_normal());
    for (const Path& root : roots) files.push_back((root / name).lexically_normal());
    return files;
}

std::optional<Path> first_file(const std::vector<Path>& files) {
    std::error_code ignored;
    for (const Path& file : files)
        if (std::filesystem::is_regular_file(file, ignored)) return file;
    return std::nullopt;
}

class Closure {
  public:
    explicit Closure(const std::vector<Path>& roots) : roots_(roots) {}

    void visit(std::string_view text, const Path& from) {
        for (const internal::Line& line : internal::split_lines(text))
            if (const auto include = internal::include_of(line))
                mention(include->name, include->system ? Path() : from);
    }

    std::vector<IncludedFile> take() { return std::move(files_); }

  private:
    void mention(const std::string& name, const Path& from) {
        const std::optional<Path> file = first_file(candidates(name, from, roots_));
        if (!file || !seen_.insert(*file).second) return;
        std::string text;
        try {
            text = read_text(*file);
        } catch (const std::runtime_error&) {
            return;
        }
        files_.push_back({*file, text});
        visit(text, file->parent_path());
    }

    const std::vector<Path>& roots_;
    std::set<Path> seen_;
    std::vector<IncludedFile> files_;
};

}  // namespace

std::string read_text(const Path& file) {
    std::error_code error;
    if (std::filesystem::is_directory(file, error))
        throw std::runtime_error(file.string() + ": is a folder, expected a text file");
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) throw std::runtime_error(file.string() + ": cannot read the file");
    internal::note_dependency(file);
    return text;
}

Path resolve_include(std::string_view name, const Path& from, const std::vector<Path>& roots) {
    const std::vector<Path> files = candidates(name, from, roots);
    if (const std::optional<Path> file = first_file(files)) return *file;
    std::string message = "cannot find include \"" + std::string(name) + "\"";
    if (files.empty()) throw std::runtime_error(message + ": no folder to look in");
    message += "; looked for";
    for (const Path& file : files) message.append(" ").append(file.string());
    throw std::runtime_error(message);
}

std::vector<IncludedFile> include_closure(std::string_view text, const std::vector<Path>& roots,
                                          const Path& from) {
    Closure closure(roots);
    closure.visit(text, from);
    return closure.take();
}

}  // namespace gloam::shader
