// SPDX-License-Identifier: MIT
#include "cli/framework/check/check_run.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <ranges>
#include <stdexcept>

#include "backend/gl/device.hpp"
#include "base/number.hpp"
#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"
#include "module/steps.hpp"
#include "record/failures.hpp"

namespace gloam::cli {
namespace {

// The variant with this name; all variants for "all".
std::vector<module::Variant> select_variants(const std::string& name) {
    if (name == "all") return module::variants();
    try {
        return {module::variant(name)};
    } catch (const std::invalid_argument& error) {
        if (name.find(module::step_separator) != std::string::npos) throw;
        throw std::invalid_argument(std::string(error.what()) + ", or all");
    }
}

// The variants that the options ask for, with the steps of each --compiler. OpenGL devices have one variant:
// the others are ways to make a SPIR-V module. Throws std::invalid_argument.
std::vector<module::Variant> variants_of(const CheckOptions& options) {
    const std::vector<module::Variant> bases = select_variants(options.variant);
    std::vector<module::Variant> variants;
    if (options.compilers.empty()) variants = bases;
    for (const std::string& compiler : options.compilers) {
        std::vector<std::string> chains;
        for (const module::Variant& base : bases) chains.push_back(base.name);
        for (const auto part : std::views::split(std::string_view(compiler), module::step_separator)) {
            std::vector<std::string> longer;  // each by each of the steps that the part stands for
            for (const std::string& step : module::steps_from(std::string(part.begin(), part.end())))
                for (const std::string& name : chains)
                    longer.push_back(name + std::string(module::step_separator) + step);
            chains = std::move(longer);
        }
        for (const std::string& name : chains) variants.push_back(module::variant(name));
    }
    if (!is_opengl(options.device)) return variants;
    const std::optional<backend::gl::DeviceName> named = backend::gl::device_name_from(options.device);
    const bool compute = !named || backend::gl::has_compute(named->version);
    const std::string first = variants.front().name;
    std::erase_if(variants, [&](const module::Variant& variant) { return !variant.runs_on_opengl(compute); });
    if (variants.empty())
        throw std::invalid_argument(fmt::format("{}: expected the variant shipped{}, not {}", options.device,
                                                compute ? "" : " without steps", first));
    return variants;
}

// The functions of a user's file, by their names. `outcome` receives what is said of it. Throws
// std::runtime_error if nothing can be checked; then it has printed the notes, if there are several.
std::vector<judge::Question> functions_in_file(const CheckOptions& options, CheckOutcome& outcome) {
    const std::vector<std::string>& words = options.equations;
    const std::string& file = words.front();
    const FileFunctions read = functions_of(file, {words.begin() + 1, words.end()}, options.task.own);
    const subject::OwnFunctions& functions = read.functions;
    const std::string& version = read.file->excerpts.version;
    if (!version.empty() && version != "450" && version != "450 core")
        outcome.notes.push_back(
            fmt::format("{}: #version {} is compiled as #version 450 for Vulkan", file, version));
    std::ranges::move(read.notes(file), std::back_inserter(outcome.notes));
    outcome.complete = read.is_complete(words.size() > 1);
    std::vector<judge::Question> questions;
    for (const subject::OwnFunction& one : functions.found)
        questions.push_back({.name = one.name, .file = one.file, .function = one.function.name});
    if (!questions.empty()) return questions;
    if (functions.left_out.size() > 1)
        for (const std::string& note : outcome.notes) fmt::print("{}\n", note);
    throw nothing_was("checked", file, functions.left_out);
}

// Index and count of "INDEX/COUNT": the share of a list with every element whose position modulo COUNT is
// INDEX. For an empty text it uses the variables of GoogleTest and ctest, or everything without them.
std::pair<std::size_t, std::size_t> shard_from(std::string text) {
    std::string where = "--shard";
    if (text.empty()) {
        const char* index = std::getenv("GTEST_SHARD_INDEX");
        const char* count = std::getenv("GTEST_TOTAL_SHARDS");
        if (index == nullptr && count == nullptr) return {0, 1};
        text = fmt::format("{}/{}", index == nullptr ? "" : index, count == nullptr ? "" : count);
        where = "GTEST_SHARD_INDEX and GTEST_TOTAL_SHARDS";
    }
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto index = base::number_from<std::size_t>(std::string_view(text).substr(0, slash));
    const auto count =
        base::number_from<std::size_t>(std::string_view(text).substr(std::min(slash + 1, text.size())));
    if (index && count && *index < *count) return {*index, *count};
    if (slash == text.size()) text += '/';
    throw std::invalid_argument(where + ": expected INDEX/COUNT with 0 <= INDEX < COUNT, found " + text);
}

}  // namespace

bool is_opengl(const std::string& device) {
    return device == every_opengl || backend::gl::is_device_name(device);
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

std::vector<CheckTask> tasks_of(const CheckOptions& options, CheckOutcome& outcome) {
    const auto [index, count] = shard_from(options.shard);
    CheckTask task = options.task;
    if (is_of_file(options)) task.path = std::filesystem::absolute(options.equations.front()).string();
    const std::vector<judge::Question> questions =
        is_of_file(options) ? functions_in_file(options, outcome) : options.named(options.equations);
    std::vector<CheckTask> tasks;
    std::size_t position = 0;
    for (const module::Variant& variant : variants_of(options)) {
        for (const judge::Question& question : questions) {
            if (question.answers && variant.name != "shipped") continue;  // a pass has no other
            if (position++ % count != index) continue;
            task.identity = {.equation = question.name,
                             .function = question.function,
                             .file = question.file,
                             .variant = variant.name};
            tasks.push_back(task);
        }
    }
    if (count > 1) outcome.shard = fmt::format("{}/{}", index, count);
    if (tasks.empty() && position > 0) {
        outcome.notes.push_back(fmt::format("shard {} has no check: there are {}", outcome.shard, position));
        outcome.complete = false;
    }
    if (position == 0) throw std::invalid_argument("passes: expected the variant shipped, without steps");
    return tasks;
}

std::string command_for(const CheckOptions& options, const record::DeviceSummary& device,
                        const judge::Answer& row) {
    std::string what = record::shell_word(row.equation);
    if (is_of_file(options)) what = record::shell_word(options.equations.front()) + " " + what;
    std::string variant = record::shell_word(row.variant_before_steps());
    if (!row.steps().empty()) variant += " --compiler " + record::shell_word(row.steps());
    const OwnFileOptions& own = options.task.own;
    for (const auto& [option, words] :
         {std::pair{" --range ", &own.ranges}, {" --include ", &own.includes}, {" --define ", &own.defines}})
        for (const std::string& word : *words) what += option + record::shell_word(word);
    std::string command =
        fmt::format("gloam check {} --variant {} --device {} --inputs {} --seed {}", what, variant,
                    record::shell_word(device.name), options.task.run.inputs, options.task.run.seed);
    if (device.manifest.empty())
        command = loader_words(device.name, {}) + command;
    else
        command += " --driver " + record::shell_word(device.manifest);
    return options.validation ? command + " --validation" : command;
}

}  // namespace gloam::cli
