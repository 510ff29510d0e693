// SPDX-License-Identifier: MIT
#include "cli/check/own_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "check/own_function.hpp"
#include "cli/environment.hpp"
#include "shader/include.hpp"

namespace gloam::cli {
namespace {

check::Ranges ranges_from(const std::vector<std::string>& texts) {
    check::Ranges ranges;
    for (const std::string& text : texts) ranges.insert(check::range_from(text));
    return ranges;
}

std::vector<shader::Function> asked_for(std::vector<shader::Function> own,
                                        const std::vector<std::string>& names, const std::string& file) {
    if (names.empty()) return own;
    std::vector<shader::Function> asked;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(own, name, &shader::Function::name);
        if (found == own.end())
            throw std::invalid_argument(
                fmt::format("{} defines no function {} of parameters that can be drawn", file, name));
        asked.push_back(*found);
    }
    return asked;
}

void require_known(const check::Ranges& ranges, const std::vector<shader::Function>& functions) {
    for (const auto& range : ranges) {
        const std::string& name = range.first;
        const bool known = std::ranges::any_of(functions, [&](const shader::Function& function) {
            return std::ranges::find(function.parameters, name, &shader::Parameter::name) !=
                   function.parameters.end();
        });
        if (!known) throw std::invalid_argument(fmt::format("--range {}: no parameter has this name", name));
    }
}

}  // namespace

bool is_shader_file(const std::string& word) {
    const std::string extension = std::filesystem::path(word).extension().string();
    const std::set<std::string> known{".glsl", ".comp", ".frag", ".vert"};
    return known.contains(extension);
}

std::vector<std::string> own_functions(const std::string& file, const std::vector<std::string>& names,
                                       const std::vector<std::string>& ranges,
                                       const std::vector<std::string>& includes) {
    const std::filesystem::path path = std::filesystem::absolute(file);
    static_cast<void>(shader::read_text(file));  // says what is wrong with it
    const check::Ranges known = ranges_from(ranges);
    const shader::CompileOptions options{.include_roots = include_roots_of(path, includes)};
    const std::vector<shader::Function> functions =
        asked_for(check::own_functions(options, path.filename().string()), names, file);
    require_known(known, functions);
    std::vector<std::string> all;
    for (const shader::Function& function : functions) all.push_back(function.name);
    return all;
}

check::Question own_question(const check::Lab& lab, const CheckTask& task) {
    const std::string file = std::filesystem::path(task.file).filename().string();
    const std::vector<shader::Function> asked =
        asked_for(check::own_functions(lab.compile_options(), file), {task.equation}, file);
    return check::question_of(lab, file, asked.front(), ranges_from(task.ranges));
}

}  // namespace gloam::cli
