// SPDX-License-Identifier: MIT
#include "module/steps.hpp"

#include <fmt/ranges.h>
#include <algorithm>
#include <chrono>
#include <sstream>
#include <system_error>

#include "base/files.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "module/spirv.hpp"

namespace gloam::module {
namespace {

constexpr std::string_view optimizer = "spirv-opt";

using Words = std::vector<std::string>;

Words words_of(const std::string& text) {
    std::istringstream in(text);
    Words words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

std::string joined(const Words& words) {
    return fmt::format("{}", fmt::join(words, " "));
}

[[noreturn]] void refuse(const std::string& step, const std::string& expected) {
    throw std::invalid_argument(fmt::format("\"{}\" is no step: expected {}", step, expected));
}

bool is_program(const std::string& step) {
    return step.find("{out}") != std::string::npos;
}

// The step's first word decides. Throws std::invalid_argument unless it is a step.
void require_step(const std::string& step) {
    const Words words = words_of(step);
    if (words.empty()) refuse(step, "a step");
    if (is_program(step)) {
        if (step.find("{in}") == std::string::npos && step.find("{glsl}") == std::string::npos)
            refuse(step, "a program that is given {in} or {glsl}");
    } else if (words[0] == optimizer) {
        const auto unknown = std::find_if_not(words.begin() + 1, words.end(), is_pass);
        if (words.size() == 1) refuse(step, "passes, as in spirv-opt --ccp");
        if (unknown != words.end())
            refuse(step, fmt::format("passes of SPIRV-Tools, and {} is none", *unknown));
    } else {
        refuse(step, "spirv-opt, or a program with {in} and {out}");
    }
}

Spirv module_from(const std::string& bytes, const std::string& from) {
    if (auto module = module_of(bytes)) return std::move(*module);
    throw StepError(fmt::format("{}: {} bytes are no SPIR-V module", from, bytes.size()));
}

const base::ProcessLimits limits{.memory_bytes = std::uint64_t{4} << 30,
                                 .cpu = std::chrono::seconds(60),
                                 .patience = std::chrono::seconds(120)};

// A library that crashes or never ends costs this step alone.
Spirv run_passes(const std::string& step, const StepInput& input) {
    Words passes = words_of(step);
    passes.erase(passes.begin());
    const auto made = [&] { return bytes_of(with_passes(input.module, passes)); };
    return module_from(base::run_apart(made, limits), "the step");
}

Spirv run_program(const std::string& step, const StepInput& input) {
    const base::TemporaryFolder folder("step");
    const auto out = folder.path() / "out.spv";
    Words command = words_of(step);
    for (std::string& word : command) {
        const auto put = [&word](std::string_view name, const std::filesystem::path& path) {
            const std::size_t at = word.find(name);
            if (at != std::string::npos) word.replace(at, name.size(), path.string());
            return at != std::string::npos;
        };
        put("{out}", out);
        if (put("{in}", folder.path() / "in.spv"))
            base::write_file(folder.path() / "in.spv", bytes_of(input.module));
        if (put("{glsl}", folder.path() / "in.comp"))
            base::write_file(folder.path() / "in.comp", input.glsl());
    }
    base::ProcessResult result;
    try {
        result = base::run_process(command, limits);
    } catch (const std::system_error& error) {
        throw StepUnavailable(fmt::format("{} cannot be started: {}", command.front(), error.what()));
    }
    constexpr int not_executable = 126;  // of a shell, and of env
    constexpr int not_found = 127;
    const bool ended = result.end == base::ProcessResult::End::status;
    if (ended && (result.number == not_executable || result.number == not_found))
        throw StepUnavailable(fmt::format("{} {}", command.front(), result.how()));
    if (!result.succeeded())
        throw StepError(base::one_line(fmt::format("{} {}", command.front(), result.how())));
    return module_from(base::read_file(out), out.string());
}

// The passes that the installed program names in its help. Those that need a number get a small one.
Words known_passes() {
    base::ProcessResult help;
    try {
        help = base::run_process({std::string(optimizer), "--help"}, {});
    } catch (const std::system_error& error) {
        throw std::invalid_argument(
            fmt::format("spirv-opt, whose help names its passes, cannot be started: {}", error.what()));
    }
    Words passes{"-O", "-Os"};
    for (std::string word : words_of(help.output)) {
        word = word.substr(0, word.find_first_of("[=,."));
        if (!word.starts_with("--") || std::ranges::find(passes, word) != passes.end()) continue;
        if (!is_pass(word)) word += "=4";
        if (is_pass(word)) passes.push_back(word);
    }
    return passes;
}

}  // namespace

Spirv taken(const std::string& step, const StepInput& input) {
    require_step(step);
    try {
        Spirv module = is_program(step) ? run_program(step, input) : run_passes(step, input);
        validate(module);
        return module;
    } catch (const StepUnavailable& error) {
        throw StepUnavailable(base::one_line(fmt::format("{}: {}", step, error.what())));
    } catch (const std::runtime_error& error) {
        throw StepError(base::one_line(fmt::format("{}: {}", step, error.what())));
    }
}

Spirv all_taken(const std::vector<std::string>& steps, const StepInput& input) {
    Spirv module = input.module;
    for (const std::string& step : steps) module = taken(step, {.module = module, .glsl = input.glsl});
    if (without_names(module) == without_names(input.module)) throw Unchanged();
    return module;
}

std::vector<std::string> parts_of(const std::string& step) {
    Words parts = words_of(step);
    std::erase_if(parts, [](const std::string& word) { return !is_pass(word); });
    return parts;
}

std::string with_parts(const std::string& step, const std::vector<std::string>& parts) {
    Words changed;
    bool put = false;
    for (const std::string& word : words_of(step)) {
        if (!is_pass(word)) {
            changed.push_back(word);
        } else if (!put) {
            changed.push_back(joined(parts));
            put = true;
        }
    }
    return joined(changed);
}

std::vector<std::string> steps_from(const std::string& text) {
    constexpr std::string_view each = "{each}";
    Words steps;
    if (const std::size_t at = text.find(each); at != std::string::npos) {
        for (const std::string& pass : known_passes())
            steps.push_back(std::string(text).replace(at, each.size(), pass));
    } else {
        steps.push_back(joined(words_of(text)));
    }
    for (const std::string& step : steps) require_step(step);
    return steps;
}

}  // namespace gloam::module
