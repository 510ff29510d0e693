// SPDX-License-Identifier: MIT
#include "cli/check/own_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "cli/check/checker.hpp"
#include "cli/environment.hpp"

namespace gloam::cli {
namespace {

check::Lab lab_of(const OwnFileRun& run, const shader::Variant& variant) {
    return check::Lab({.device = run.device,
                       .validation = run.validation,
                       .include_roots = {std::filesystem::absolute(run.file).parent_path(), glsl_directory()},
                       .cache_directory = cache_directory(),
                       .variant = variant,
                       .timeout = run.timeout});
}

std::vector<shader::Function> asked_for(const OwnFileRun& run, const check::Lab& lab,
                                        const std::string& file) {
    std::vector<shader::Function> own = check::own_functions(lab, file);
    if (run.functions.empty()) return own;
    std::vector<shader::Function> asked;
    for (const std::string& name : run.functions) {
        const auto found = std::ranges::find(own, name, &shader::Function::name);
        if (found == own.end())
            throw std::invalid_argument(fmt::format(
                "{} defines no function {} of parameters that can be drawn", run.file.string(), name));
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

check::Answer answer_of(const OwnFileRun& run, const check::Lab& lab, const std::string& file,
                        const shader::Function& function, const check::Ranges& ranges) {
    const auto begin = std::chrono::steady_clock::now();
    const std::string& variant = lab.options().variant.name;
    check::Answer row;
    try {
        const check::Question question = check::question_of(lab, file, function, ranges);
        row = check::run(lab, question, {.inputs = run.inputs, .seed = run.seed});
    } catch (const std::exception& error) {
        row = {.equation = function.name,
               .function = function.name,
               .file = file,
               .variant = variant,
               .error = error.what(),
               .reason = reason_of(error)};
    }
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return row;
}

}  // namespace

bool is_shader_file(const std::string& word) {
    const std::string extension = std::filesystem::path(word).extension().string();
    const std::set<std::string> known{".glsl", ".comp", ".frag", ".vert"};
    return known.contains(extension);
}

report::CheckReport check_own_file(const OwnFileRun& run) {
    if (!std::filesystem::exists(run.file))
        throw std::runtime_error(fmt::format("cannot read {}", run.file.string()));
    check::Ranges ranges;
    for (const std::string& text : run.ranges) ranges.insert(check::range_from(text));
    const std::string file = run.file.filename().string();
    report::CheckReport report;
    for (const shader::Variant& variant : run.variants) {
        const check::Lab lab = lab_of(run, variant);
        const std::vector<shader::Function> functions = asked_for(run, lab, file);
        require_known(ranges, functions);
        if (report.rows.empty()) {
            report.device = summary_of(lab.device().info());
            if (run.on_device) run.on_device(report.device);
        }
        for (const shader::Function& function : functions) {
            report.rows.push_back(answer_of(run, lab, file, function, ranges));
            if (run.on_row) run.on_row(report.rows.back());
        }
    }
    return report;
}

}  // namespace gloam::cli
