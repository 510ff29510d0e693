// SPDX-License-Identifier: MIT
#include "cli/check/smallest_module.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <system_error>

#include "base/files.hpp"
#include "base/process.hpp"
#include "shader/spirv.hpp"
#include "shader/steps.hpp"

namespace gloam::cli {
namespace {

using nlohmann::json;

constexpr const char* subcommand = "module-still-fails";
constexpr const char* kept = "kept.spv";

// The steps of a compiler: those that make the module that it is given are taken already.
std::vector<std::string> of_compiler(const std::vector<std::string>& steps) {
    std::vector<std::string> left;
    std::ranges::copy_if(steps, std::back_inserter(left),
                         [](const std::string& step) { return !shader::is_metamorphic(step); });
    return left;
}

json case_of(const check::Lab& lab, const check::Reproduction& failure) {
    std::vector<int> outputs;
    for (const shader::Scalar scalar : failure.outputs) outputs.push_back(static_cast<int>(scalar));
    const bool interpreted = lab.info().name == check::interpreter_name;
    return {{"device", interpreted ? lab.info().name : std::to_string(lab.info().index)},
            {"steps", of_compiler(failure.steps)},
            {"inputs", failure.inputs},
            {"outputs", outputs}};
}

// Whether the module in a file fails in the case of another file. The last one that does is kept beside the
// case, because spirv-reduce writes none where it is stopped.
bool still_fails(const std::filesystem::path& of, const std::filesystem::path& file) {
    const json object = json::parse(base::read_file(of));
    std::vector<shader::Scalar> outputs;
    for (const int scalar : object.at("outputs").get<std::vector<int>>())
        outputs.push_back(static_cast<shader::Scalar>(scalar));
    const auto inputs = object.at("inputs").get<std::vector<check::Word>>();
    check::KernelModule module{.spirv = shader::taken("= " + file.string(), {.module = {}}),
                               .input_words = inputs.size(),
                               .output_words = outputs.size()};
    const auto steps = object.at("steps").get<std::vector<std::string>>();
    try {
        if (!steps.empty()) {
            shader::Stepped stepped = shader::all_taken(steps, {.module = module.spirv});
            module.before = std::move(stepped.before);
            module.spirv = std::move(stepped.after);
        }
    } catch (const shader::StepError&) {
        return false;
    } catch (const shader::Unchanged&) {
        return false;
    }
    const check::Lab lab({.device = object.at("device").get<std::string>()});
    const bool fails = check::breaks_rules(lab, std::move(module), inputs, outputs);
    if (fails) base::write_file(of.parent_path() / kept, base::read_file(file));
    return fails;
}

}  // namespace

shader::Spirv smallest_module(const check::Lab& lab, const check::Reproduction& failure) {
    if (!failure.failure || !failure.images.empty() || failure.specialized || lab.language() ||
        failure.team.kind != backend::Team::Kind::alone)
        return {};
    const base::TemporaryFolder folder("smallest");
    const auto at = [&folder](const char* name) { return (folder.path() / name).string(); };
    const shader::Spirv& from = failure.before.empty() ? failure.spirv : failure.before;
    base::write_file(at("case.json"), case_of(lab, failure).dump());
    base::write_file(at("from.spv"),
                     {reinterpret_cast<const char*>(from.data()), from.size() * sizeof(from[0])});
    try {
        constexpr std::chrono::seconds most{10};
        const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
        static_cast<void>(
            base::run_process({"spirv-reduce", at("from.spv"), "-o", at("to.spv"),
                               "--temp-file-prefix=" + at("step_"), "--", self, subcommand, at("case.json")},
                              {}, {.patience = most, .group = true}));
        if (!std::filesystem::exists(folder.path() / kept)) return {};
        return shader::taken("= " + at(kept), {.module = from});
    } catch (const std::system_error&) {  // it is not installed
        return {};
    } catch (const shader::StepError&) {
        return {};
    }
}

void add_module_test(CLI::App& app, int& status) {
    auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* command = app.add_subcommand(subcommand, "runs a module for spirv-reduce");
    command->group("");  // not listed
    command->add_option("files", *files)->expected(2);
    command->callback([files, &status] { status = still_fails(files->at(0), files->at(1)) ? 0 : 1; });
}

}  // namespace gloam::cli
