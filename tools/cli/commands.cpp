// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <utility>

#include "cli/names.hpp"
#include "scene/mesh_scene.hpp"
#include "shader/compile.hpp"

namespace gloam::cli {
namespace {

constexpr const char* reader_subcommand = "mesh-reader";

}  // namespace

std::vector<std::string> mesh_reader_command() {
    return {"/proc/self/exe", reader_subcommand};
}

void add_mesh_reader(CLI::App& app, int& status) {
    auto file = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand(reader_subcommand, "reads a mesh for `gloam render`");
    command->group("");  // not listed
    command->add_option("file", *file)->required();
    command->callback([file, &status] { status = scene::run_mesh_reader(*file); });
}

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

namespace {

// Examples by command; the program itself has the empty name.
const std::map<std::string, std::string>& examples() {
    static const std::map<std::string, std::string> table{
        {"",
         "  gloam demo                                  pictures, a check, a page\n"
         "  gloam check --device all --html check.html  every equation on every driver\n"
         "  gloam render mesh.obj --gallery page        a mesh in light, with sliders\n"
         "  gloam site my-site                          checks for any browser\n"
         "  gloam COMMAND --help                        the options of a command\n"},
        {"demo", "  gloam demo --out first-look\n"},
        {"devices", "  gloam devices --json\n"},
        {"list",
         "  gloam list methods\n"
         "  gloam list settings --json\n"
         "  gloam list presets balanced          the settings that it changes\n"},
        {"check",
         "  gloam check                                          every equation on the default device\n"
         "  gloam check 'gloam_linear_depth_*' 'TSSAO-*'         some of them\n"
         "  gloam check --device all --variant all --html r.html every driver, every compiler setting\n"
         "  gloam check --quiet --junit results.xml              for continuous integration\n"
         "  gloam check --failures failures                      each failure ready to report\n"
         "  gloam check shader.frag 'luma(vec3)' --range c=0:1   a function of a file of your own\n"},
        {"report",
         "  gloam report a.json b.json\n"
         "  gloam report a.json b.json --html all.html\n"
         "  gloam report now.json --since last-week.json\n"},
        {"render",
         "  gloam render mesh.obj --frames 8\n"
         "  gloam render mesh.obj --up z --orbit 40,25 --turntable 24 --gallery page\n"
         "  gloam render columns --method all --truth\n"
         "  gloam render --gbuffer FOLDER --radius 0.5\n"},
        {"bench",
         "  gloam bench --method gtao hemisphere --samples 4 16 --scene columns\n"
         "  gloam bench --from results.json --error 0.05\n"},
        {"audit",
         "  gloam audit tone.glsl                              every function, in the domain that it prints "
         "first\n"
         "  gloam audit tone.glsl curve --range x=0:16 --html audit.html\n"
         "  gloam audit tone.glsl --device 0 1                 what two drivers give for the worst inputs\n"},
        {"mutate",
         "  gloam mutate shaders/tone.glsl -- ctest --test-dir build\n"
         "  gloam mutate shaders --count 200 --seed 1 --json faults.json -- ./tests\n\n"
         "COMMAND is run for each fault, without a shell. A status other than 0 means that it noticed the "
         "fault.\n"
         "GLOAM_SHADERS names a copy of the folder of shaders (the first --include, otherwise that of the "
         "files) with\n"
         "the fault, GLOAM_SHADERS_OF that folder, and GLOAM_SHADERS_CHANGED the changed file below it. "
         "gloam and tests\n"
         "that use its framework read the copy by themselves.\n"},
        {"explain", "  gloam explain tone.glsl my_curve 0.5 2         one value for each scalar parameter\n"},
        {"stress",
         "  gloam stress --brief                           seconds instead of minutes\n"
         "  gloam stress --only worst-inputs --equation 'TSSAO-*'\n"},
        {"pack", "  gloam pack gloam/geometry/linear_depth.glsl --version 310es\n"},
        {"site",
         "  gloam site my-site                             then open my-site/index.html\n"
         "  gloam site few 'TSSAO-*' --inputs 2048         some equations, with more inputs\n"
         "  gloam site my-site --measured front.md         with the tables of gloam bench front > "
         "front.md\n"},
        {"completion", "  source <(gloam completion bash)\n"}};
    return table;
}

void add_footer(CLI::App& command, const std::string& name) {
    const auto found = examples().find(name);
    if (found != examples().end()) command.footer("Examples:\n" + found->second);
}

}  // namespace

void add_help_examples(CLI::App& app) {
    add_footer(app, "");
    for (CLI::App* command : app.get_subcommands(nullptr)) add_footer(*command, command->get_name());
}

namespace {

std::string refuse_empty(const std::string& text) {
    return text.empty() ? "expected a value, found an empty text" : "";
}

std::string refuse_nan(const std::string& text) {
    const bool is_nan = CLI::detail::to_lower(text).find("nan") != std::string::npos;
    return is_nan ? "expected a number, found " + text : "";
}

std::string refuse_negative(const std::string& text) {
    return text.starts_with('-') ? "expected a count, 0 or more, found " + text : "";
}

void make_strict(CLI::Option& option) {
    const bool takes_value = option.get_items_expected_max() > 0 && option.get_type_size_max() > 0;
    if (!takes_value) return;  // a flag
    // CLI11 names the type "FLOAT" or "UINT", and appends the descriptions of the option's own checks.
    const std::string type = option.get_type_name();
    const auto add = [&option](std::string (*refuse)(const std::string&)) {
        option.check(CLI::Validator(refuse, ""));
    };
    if (type.starts_with("UINT")) add(refuse_negative);
    if (type.starts_with("FLOAT")) add(refuse_nan);
    if (option.get_items_expected_min() > 0) add(refuse_empty);
}

}  // namespace

void refuse_meaningless_values(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) make_strict(*option);
    for (CLI::App* command : app.get_subcommands({})) refuse_meaningless_values(*command);
}

}  // namespace gloam::cli
