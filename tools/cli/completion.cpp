// SPDX-License-Identifier: MIT
#include "cli/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/names.hpp"
#include "shader/variant.hpp"

namespace gloam::cli {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::vector<Named>& names, Words words = {}) {
    for (const Named& named : names) words.push_back(named.name);
    return words;
}

// The words that each option accepts, by the option's name.
std::vector<std::pair<std::string, Words>> option_values() {
    Words variants{"all"};
    for (const shader::Variant& variant : shader::variants()) variants.push_back(variant.name);
    Words settings;
    for (const Named& setting : setting_names()) settings.push_back(setting.name + "=");
    return {{"--method", words_of(method_names(), {"all"})},
            {"--preset", words_of(preset_names())},
            {"--scene", words_of(scene_names())},
            {"--set", settings},
            {"--variant", variants},
            {"--view", words_of(view_names())}};
}

// The words that a command accepts besides options and files.
Words positional_words(const CLI::App& command) {
    if (command.get_name() == "render") {
        Words words = words_of(scene_names());
        for (const Named& view : view_names())
            if (std::ranges::count(words, view.name) == 0) words.push_back(view.name);
        return words;
    }
    if (command.get_name() == "list")
        return {"equations", "methods", "presets", "scenes", "settings", "variants", "views"};
    if (command.get_name() == "completion") return {"bash"};
    return {};
}

Words options_of(const CLI::App& command) {
    Words words;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    }
    return words;
}

// Adds a case for the command and each of its subcommands: the words to complete.
void add_cases(const CLI::App& command, const std::string& path, std::string& commands, std::string& cases) {
    Words words = positional_words(command);
    for (const CLI::App* below : command.get_subcommands(nullptr)) {
        if (below->get_group().empty()) continue;
        const std::string name = path + " " + below->get_name();
        words.push_back(below->get_name());
        commands += fmt::format("            '{}') path=\"$next\" ;;\n", name);
        add_cases(*below, name, commands, cases);
    }
    cases += fmt::format("        '{}') options='{}'; words='{}' ;;\n", path,
                         fmt::join(options_of(command), " "), fmt::join(words, " "));
}

std::string bash_script(const CLI::App& app) {
    std::string commands;
    std::string cases;
    add_cases(app, "gloam", commands, cases);
    std::string values;
    for (const auto& [option, words] : option_values())
        values += fmt::format("        {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", option,
                              fmt::join(words, " "));
    return "# bash completion of gloam, printed by `gloam completion bash`\n"
           "_gloam() {\n"
           "    local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD - 1]}\"\n"
           "    local path=gloam next options='' words='' i\n"
           "    for ((i = 1; i < COMP_CWORD; i++)); do\n"
           "        next=\"$path ${COMP_WORDS[i]}\"\n"
           "        case \"$next\" in\n" +
           commands +
           "        esac\n"
           "    done\n"
           "    case \"$before\" in\n" +
           values +
           "    esac\n"
           "    case \"$path\" in\n" +
           cases +
           "    esac\n"
           "    if [[ $word == -* ]]; then\n"
           "        COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
           "        return\n"
           "    fi\n"
           "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\") $(compgen -f -- \"$word\"))\n"
           "}\n"
           "complete -o filenames -o nosort -F _gloam gloam\n";
}

}  // namespace

void add_completion(CLI::App& app) {
    CLI::App* command = app.add_subcommand("completion", "print a script that completes commands in a shell");
    auto shell = std::make_shared<std::string>();
    command->add_option("shell", *shell, "bash")->required()->check(CLI::IsMember({"bash"}));
    command->callback([&app, shell] { fmt::print("{}", bash_script(app)); });
}

}  // namespace gloam::cli
