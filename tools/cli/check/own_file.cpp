// SPDX-License-Identifier: MIT
#include "cli/check/own_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "base/text.hpp"
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

void require_known(const check::Ranges& ranges, const std::vector<check::OwnFunction>& functions) {
    for (const auto& range : ranges) {
        const std::string& name = range.first;
        const bool known = std::ranges::any_of(functions, [&](const check::OwnFunction& own) {
            return std::ranges::find(own.function.parameters, name, &shader::Parameter::name) !=
                   own.function.parameters.end();
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

OwnFile own_file(const std::string& file, const std::vector<std::string>& names,
                 const std::vector<std::string>& ranges, const std::vector<std::string>& includes) {
    const std::filesystem::path path = std::filesystem::absolute(file);
    const std::string text = shader::read_text(file);
    const check::Ranges known = ranges_from(ranges);
    const shader::Excerpts all = shader::excerpts({path.string(), text}, include_roots_of(path, includes));
    OwnFile own{all.version,
                check::own_functions({.cache_directory = cache_directory(), .excerpts = all.functions},
                                     path.filename().string(), names)};
    require_known(known, own.functions.found);
    return own;
}

OwnSelection own_selection(const std::vector<std::string>& words, const std::vector<std::string>& ranges,
                           const std::vector<std::string>& includes) {
    const std::string& file = words.front();
    const OwnFile own = own_file(file, {words.begin() + 1, words.end()}, ranges, includes);
    OwnSelection selection;
    if (!own.version.empty() && own.version != "450" && own.version != "450 core")
        selection.notes.push_back(
            fmt::format("{}: #version {} is compiled as #version 450 for Vulkan", file, own.version));
    const std::vector<check::LeftOut>& left_out = own.functions.left_out;
    for (const check::LeftOut& function : left_out) {
        selection.notes.push_back(
            base::one_line(fmt::format("{}: {} was left out: {}", file, function.name, function.why)));
        selection.complete = selection.complete && !function.is_error && words.size() == 1;
    }
    for (const check::OwnFunction& function : own.functions.found) selection.names.push_back(function.name);
    if (!selection.names.empty()) return selection;
    std::string why = "it defines no function but main, or its #if conditions leave none";
    if (left_out.size() == 1) why = left_out.front().name + ": " + left_out.front().why;
    if (left_out.size() > 1) {
        why = fmt::format("all {} functions were left out", left_out.size());
        for (const std::string& note : selection.notes) fmt::print("{}\n", note);
    }
    throw std::runtime_error(fmt::format("{}: nothing was checked: {}", file, why));
}

check::Question own_question(const check::Lab& lab, const CheckTask& task) {
    const std::string file = std::filesystem::path(task.file).filename().string();
    const check::OwnFunctions own = check::own_functions(lab.options(), file, {task.equation});
    if (own.found.empty())
        throw std::invalid_argument(fmt::format("{}: {}: {}", file, task.equation, own.left_out.front().why));
    return check::question_of(lab, file, own.found.front(), ranges_from(task.ranges));
}

}  // namespace gloam::cli
