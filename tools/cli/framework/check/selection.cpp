// SPDX-License-Identifier: MIT
#include "cli/framework/check/selection.hpp"

#include <fmt/format.h>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "backend/gl/device.hpp"
#include "cli/environment.hpp"
#include "cli/framework/check/checker.hpp"
#include "cli/framework/check/worker_session.hpp"
#include "cli/framework/open_device.hpp"
#include "module/steps.hpp"

namespace gloam::cli {
namespace {

// The variant with this name; all variants for "all".
std::vector<shader::Variant> select_variants(const std::string& name) {
    if (name == "all") return shader::variants();
    try {
        return {shader::variant(name)};
    } catch (const std::invalid_argument& error) {
        if (name.find(shader::step_separator) != std::string::npos) throw;
        throw std::invalid_argument(std::string(error.what()) + ", or all");
    }
}

std::vector<std::string> divided(const std::string& chain) {
    std::vector<std::string> steps;
    std::size_t begin = 0;
    for (std::size_t bar = 0; bar != std::string::npos; begin = bar + shader::step_separator.size()) {
        bar = chain.find(shader::step_separator, begin);
        steps.push_back(chain.substr(begin, bar - begin));
    }
    return steps;
}

// Each name with each of the steps that the text stands for.
std::vector<std::string> followed(const std::vector<std::string>& names, const std::string& text) {
    std::vector<std::string> longer;
    for (const std::string& step : shader::steps_from(text))
        for (const std::string& name : names)
            longer.push_back(name + std::string(shader::step_separator) + step);
    return longer;
}

}  // namespace

bool is_opengl(const std::string& device) {
    return device == every_opengl || gl::is_device_name(device);
}

// A file of the library by its name there is its equations, unless there is a file of this name.
bool is_of_file(const CheckOptions& options) {
    if (options.equations.empty()) return false;
    const std::string& first = options.equations.front();
    std::error_code none;
    if (std::filesystem::exists(first, none) || !std::filesystem::exists(glsl_directory() / first, none))
        return is_shader_file(first);
    return false;
}

namespace {

// The variants that the options ask for, with the steps of each --compiler. OpenGL devices have one variant:
// the others are ways to make a SPIR-V module. Throws std::invalid_argument.
std::vector<shader::Variant> variants_of(const CheckOptions& options) {
    std::vector<std::string> names;
    std::vector<std::string> bases;
    for (const shader::Variant& variant : select_variants(options.variant)) bases.push_back(variant.name);
    for (const std::string& compiler : options.compilers) {
        std::vector<std::string> chains = bases;
        for (const std::string& step : divided(compiler)) chains = followed(chains, step);
        names.insert(names.end(), chains.begin(), chains.end());
    }
    std::vector<shader::Variant> variants;
    for (const std::string& name : options.compilers.empty() ? bases : names)
        variants.push_back(shader::variant(name));
    if (!is_opengl(options.device)) return variants;
    const std::optional<gl::DeviceName> named = gl::device_name_from(options.device);
    const bool compute = !named || gl::has_compute(named->version);
    const std::string first = variants.front().name;
    std::erase_if(variants, [&](const shader::Variant& variant) { return !variant.runs_on_opengl(compute); });
    if (variants.empty())
        throw std::invalid_argument(fmt::format("{}: expected the variant shipped{}, not {}", options.device,
                                                compute ? "" : " without steps", first));
    return variants;
}

// The selected equations and passes, or the functions of a file by their names.
std::vector<check::Question> questions_of(const CheckOptions& options, CheckOutcome& outcome) {
    if (is_of_file(options)) {
        OwnSelection own =
            own_selection(options.equations, options.ranges, options.includes, options.defines);
        outcome.notes = std::move(own.notes);
        outcome.complete = own.complete;
        std::vector<check::Question> functions;
        for (const std::string& name : own.names) functions.push_back({.name = name});
        return functions;
    }
    return options.named(options.equations);
}

}  // namespace

std::vector<CheckTask> tasks_of(const CheckOptions& options, CheckOutcome& outcome) {
    const Shard shard = shard_from(options.shard);
    const std::vector<check::Question> questions = questions_of(options, outcome);
    const std::string file =
        is_of_file(options) ? std::filesystem::absolute(options.equations.front()).string() : "";
    std::vector<CheckTask> tasks;
    std::size_t position = 0;
    for (const shader::Variant& variant : variants_of(options)) {
        for (const check::Question& question : questions) {
            if (question.answers && variant.name != "shipped") continue;  // a pass has no other
            if (!shard.holds(position++)) continue;
            tasks.push_back({.equation = question.name,
                             .variant = variant.name,
                             .inputs = options.inputs,
                             .seed = options.seed,
                             .coverage = options.coverage,
                             .file = file,
                             .ranges = options.ranges,
                             .includes = options.includes,
                             .defines = options.defines});
        }
    }
    if (position == 0) throw std::invalid_argument("passes: expected the variant shipped, without steps");
    return tasks;
}

std::string command_for(const CheckOptions& options, const record::DeviceSummary& device,
                        const check::Answer& row) {
    std::string what = record::shell_word(row.equation);
    if (is_of_file(options)) what = record::shell_word(options.equations.front()) + " " + what;
    std::string variant = record::shell_word(row.variant_before_steps());
    if (!row.steps().empty()) variant += " --compiler " + record::shell_word(row.steps());
    for (const std::string& range : options.ranges) what += " --range " + record::shell_word(range);
    for (const std::string& folder : options.includes) what += " --include " + record::shell_word(folder);
    for (const std::string& define : options.defines) what += " --define " + record::shell_word(define);
    std::string command = fmt::format("gloam check {} --variant {} --device {} --inputs {} --seed {}", what,
                                      variant, record::shell_word(device.name), options.inputs, options.seed);
    for (const auto& driver : drivers_asked_for())
        command += " --driver " + record::shell_word(driver.string());
    return options.validation ? command + " --validation" : command;
}

std::string step_summary(const std::vector<record::CheckReport>& reports) {
    struct Count {
        std::size_t modules = 0;
        std::size_t changed = 0;
        std::size_t failed = 0;
        std::size_t not_judged = 0;
    };
    std::map<std::string, Count> counts;
    for (const record::CheckReport& report : reports) {
        for (const check::Answer& row : report.rows) {
            if (row.steps().empty()) continue;
            Count& count = counts[row.variant];
            const bool changed = row.reason != check::Reason::unchanged;
            ++count.modules;
            if (changed) ++count.changed;
            if (row.failed()) ++count.failed;
            if (changed && !row.failed() && !row.passed()) ++count.not_judged;
        }
    }
    std::string text;
    for (const auto& [variant, count] : counts)
        text += fmt::format("{:>7} {:>8} {:>7} {:>11}  {}\n", count.modules, count.changed, count.failed,
                            count.not_judged, variant);
    return text.empty() ? text : "modules  changed  failed  not judged  variant\n" + text;
}

}  // namespace gloam::cli
