// SPDX-License-Identifier: MIT
#include "cli/framework/own_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>

#include "base/process.hpp"
#include "base/text.hpp"
#include "cli/environment.hpp"
#include "module/include.hpp"

namespace gloam::cli {

subject::Ranges ranges_from(const std::vector<std::string>& texts) {
    subject::Ranges ranges;
    for (const std::string& text : texts) ranges.insert(subject::range_from(text));
    return ranges;
}

bool has_shader_ending(const std::string& word) {
    const std::string ending = base::lower(std::filesystem::path(word).extension().string());
    const std::set<std::string> known{".glsl", ".comp", ".frag", ".vert",  ".fs", ".vs",
                                      ".cs",   ".fsh",  ".vsh",  ".glslh", ".inc"};
    return known.contains(ending);
}

bool is_shader_file(const std::string& word) {
    std::error_code none;
    const std::string ending = std::filesystem::path(word).extension().string();
    const bool has_ending = ending.size() > 1 && std::isalpha(static_cast<unsigned char>(ending[1])) != 0;
    return has_ending || std::filesystem::is_regular_file(word, none);
}

std::pair<std::string, std::vector<std::string>> file_and_functions(const std::vector<std::string>& words,
                                                                    EquationsNamed* equations) {
    std::string file = path_of_shader(words.front());
    std::error_code none;
    if (is_shader_file(file) || std::filesystem::exists(file, none))
        return {file, {words.begin() + 1, words.end()}};
    std::vector<std::string> functions;
    for (const judge::Question& equation : equations(words)) {
        const std::string other = path_of_shader(equation.file);
        if (functions.empty()) file = other;
        if (file != other)
            throw std::invalid_argument(
                fmt::format("{} and {}: expected equations of one file", file, other));
        functions.push_back(equation.function);
    }
    return {file, functions};
}

subject::Lab lab_of(std::shared_ptr<const subject::OwnFile> file, const std::string& device) {
    return subject::Lab({.device = device, .cache_directory = cache_directory(), .file = std::move(file)});
}

FileFunctions functions_of(const std::filesystem::path& file, const std::vector<std::string>& names,
                           const OwnFileOptions& options) {
    const std::string text = module::read_text(file);
    const subject::Ranges ranges = ranges_from(options.ranges);
    FileFunctions all = base::tried(file.string(), [&] {
        const std::filesystem::path path = std::filesystem::absolute(file);
        FileFunctions read{std::make_shared<const subject::OwnFile>(
                               path, text, include_roots_of(path, options.includes), options.defines),
                           {}};
        for (const std::string& name : names)
            if (has_shader_ending(name))
                throw std::invalid_argument(name + ": expected a function, one file at a time");
        read.functions =
            subject::own_functions({.cache_directory = cache_directory(), .file = read.file}, names);
        return read;
    });
    std::set<std::string> parameters;
    for (const subject::OwnFunction& own : all.functions.found)
        for (const module::Parameter& parameter : own.function.parameters)
            if (parameter.direction != source::Direction::out)
                for (const std::string& name : subject::value_names(parameter.type, parameter.name))
                    parameters.insert(name);
    for (const auto& [name, range] : ranges)
        if (std::ranges::none_of(parameters, [&name](const std::string& one) {
                return one == name || one.starts_with(name + ".");
            }))
            throw std::invalid_argument(fmt::format("--range {}: no input has this name, only: {}", name,
                                                    fmt::join(parameters, ", ")));
    return all;
}

std::vector<std::string> FileFunctions::notes(const std::string& name) const {
    std::vector<std::string> all;
    for (const std::string& made : file->excerpts.by_macro)
        all.push_back(fmt::format(
            "{}: {}: functions that a macro makes are not looked at; write one out to check it", name, made));
    for (const subject::Skipped& function : functions.left_out)
        all.push_back(
            base::one_line(fmt::format("{}: {} was left out: {}", name, function.name, function.why)));
    return all;
}

bool FileFunctions::is_complete(bool named) const {
    return std::ranges::none_of(functions.left_out,
                                [named](const subject::Skipped& one) { return named || one.is_error; });
}

std::runtime_error nothing_was(const char* done, const std::string& file,
                               const std::vector<subject::Skipped>& left_out) {
    std::string why =
        "it defines no function but main in GLSL (HLSL is not read), or its #if conditions leave none";
    if (left_out.size() == 1) why = left_out.front().name + ": " + left_out.front().why;
    if (left_out.size() > 1) why = fmt::format("all {} functions were left out", left_out.size());
    return std::runtime_error(fmt::format("{}: nothing was {}: {}", file, done, why));
}

}  // namespace gloam::cli
