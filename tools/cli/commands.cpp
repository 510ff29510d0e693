// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "base/number.hpp"
#include "base/text.hpp"
#include "cli/environment.hpp"

namespace gloam::cli {

namespace {

// The type of a value: of an option that may have none, of a list, of another.
template <class T>
T value_of(T*);
template <class T>
T value_of(std::optional<T>*);
template <class T>
T value_of(std::vector<T>*);

// Whether help shows what an option has before.
template <class T>
bool is_shown(const T& value) {
    if constexpr (requires { value.empty(); }) return !value.empty();
    if constexpr (std::is_arithmetic_v<T>) return value != T{} && std::isfinite(static_cast<double>(value));
    return false;
}

// Adds the checks of an option's words, and those of what CLI11 accepts and nobody intends.
template <class Value>
void check_words(CLI::Option& option, const Rules& rules) {
    if constexpr (std::is_arithmetic_v<Value>)
        if (rules.range)
            option.check(
                CLI::Range(static_cast<Value>((*rules.range)[0]), static_cast<Value>((*rules.range)[1])));
    if (rules.positive) option.check(CLI::PositiveNumber);
    if (!rules.one_of.empty()) option.check(CLI::IsMember(rules.one_of));
    if (rules.folder) option.check(CLI::ExistingDirectory);
    option.check([may_lack = !rules.may_lack.empty()](const std::string& word) -> std::string {
        if (std::is_unsigned_v<Value> && word.starts_with('-'))
            return "expected a count, 0 or more, found " + word;
        if (std::is_floating_point_v<Value> && base::lower(word).find("nan") != std::string::npos)
            return "expected a number, found " + word;
        return word.empty() && !may_lack ? "expected a value, found an empty text" : "";
    });
    if (rules.numbers)  // adapt() puts a blank before them
        option.transform(
            [](const std::string& word) { return word.starts_with(" -") ? word.substr(1) : word; });
}

CLI::Option* added(CLI::App& app, const Option& row, bool* target) {
    return app.add_flag(row.names, *target, row.help);
}

CLI::Option* added(CLI::App& app, const Option& row, const std::function<void()>& target) {
    return app.add_flag_callback(row.names, target, row.help);
}

CLI::Option* added(CLI::App& app, const Option& row, const std::function<void(const std::string&)>& target) {
    CLI::Option* option = app.add_option_function<std::vector<std::string>>(
        row.names,
        [target](const std::vector<std::string>& words) { target(words.empty() ? "" : words.front()); },
        row.help);
    option->expected(row.rules.may_lack.empty() ? 1 : 0, 1);
    if (!row.rules.may_lack.empty()) option->type_name(row.rules.may_lack);
    check_words<std::string>(*option, row.rules);
    return option;
}

template <class T>
CLI::Option* added(CLI::App& app, const Option& row, T* target) {
    CLI::Option* option = app.add_option(row.names, *target, row.help);
    check_words<decltype(value_of(target))>(*option, row.rules);
    if (is_shown(*target)) option->capture_default_str();
    return option;
}

CLI::Option& add(CLI::App& app, const Option& row) {
    const Rules& rules = row.rules;
    CLI::Option& option =
        *std::visit([&](const auto& target) { return added(app, row, target); }, row.target);
    option.required(rules.required);
    if (rules.repeated) option.allow_extra_args(false);
    if (rules.commas) option.delimiter(',');
    if (rules.words > 0) option.expected(rules.words);
    if (!rules.shown.empty()) option.default_str(rules.shown);
    return option;
}

void add(CLI::App& app, const Command& command) {
    std::vector<CLI::Option*> added;
    for (const Option& row : command.options) added.push_back(&add(app, row));
    for (std::size_t i = 0; i < added.size(); ++i) {
        const Rules& rules = command.options[i].rules;
        for (const std::string& name : rules.needs) added[i]->needs(app.get_option(name));
        for (const std::string& name : rules.excludes) added[i]->excludes(app.get_option(name));
    }
    for (const Command& one : command.commands) {
        CLI::App* further = app.require_subcommand(0, 1)->add_subcommand(one.name, one.about);
        if (one.about.empty()) further->group("");
        add(*further, one);
    }
    if (!command.examples.empty())
        app.footer("Examples:\n" + command.examples);  // which these do not inherit
}

// What CLI11 has no means for: words behind "--" of which none is an option's, a file in the place of a
// command, and numbers below 0, which get a blank.
void adapt(const Command& command, std::vector<std::string>& words) {
    const auto dashes = std::ranges::find(words, "--");
    if (command.behind_dashes != nullptr && dashes != words.end()) {
        command.behind_dashes->assign(dashes + 1, words.end());
        words.erase(dashes, words.end());
    }
    for (const Command& one : command.commands)
        if (one.name.starts_with("FILE.") && words.size() > 1 && words[1].ends_with(one.name.substr(4)))
            words.insert(words.begin() + 1, one.name);
    if (std::ranges::any_of(command.options, [](const Option& row) { return row.rules.numbers; }))
        for (std::string& word : words)
            if (word.starts_with('-') && base::number_from<double>(word)) word.insert(0, " ");
}

}  // namespace

int run_command(const Command& program, std::vector<std::string> words) {
    for (const Command& one : program.commands)
        if (!words.empty() && words.front() == one.name) adapt(one, words);
    CLI::App app(program.about, program.name);
    app.failure_message(CLI::FailureMessage::simple);
    app.set_version_flag("--version", versions);
    add(app, program);
    const Command* chosen = &program;
    std::string name = program.name;
    const auto choose = [&] {
        for (CLI::App* at = &app; !at->get_subcommands().empty(); name += " " + chosen->name) {
            at = at->get_subcommands().front();
            chosen = &*std::ranges::find(chosen->commands, at->get_name(), &Command::name);
        }
    };
    try {
        std::ranges::reverse(words);  // the order in which CLI11 takes them
        app.parse(std::move(words));
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        choose();
        throw std::invalid_argument(fmt::format("{} ({} --help tells more)", error.what(), name));
    }
    choose();
    for (const Option& row : chosen->options)
        if (row.before) row.before();
    return chosen->run();
}

Rules between(double low, double high) {
    return {.range = {{low, high}}};
}

Rules one_of(std::vector<std::string> words) {
    return {.one_of = std::move(words)};
}

Rules needs(std::string other, Rules rules) {
    rules.needs.push_back(std::move(other));
    return rules;
}

Rules excludes(std::string other, Rules rules) {
    rules.excludes.push_back(std::move(other));
    return rules;
}

Option include_option(std::vector<std::string>& further) {
    return {"--include",
            &further,
            {.folder = true, .repeated = true},
            "folder in which and below which your own file's includes may also lie; may be repeated"};
}

Option define_option(std::vector<std::string>& defines) {
    return {"--define", &defines, repeated,
            "NAME or NAME=VALUE: a macro that holds before your own file begins; may be repeated"};
}

Option device_option(std::string& device) {
    return {"--device", &device, "name or index of the device (gloam devices)"};
}

Option validation_option(bool& validation) {
    return {"--validation", &validation, "Vulkan validation layers on; any message is an error"};
}

}  // namespace gloam::cli
