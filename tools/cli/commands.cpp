// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <CLI/CLI.hpp>
#include <utility>

#include "base/text.hpp"
#include "base/version.hpp"
#include "module/compile.hpp"

namespace gloam::cli {

std::string versions() {
    return "gloam " + base::version() + ", " + base::one_line(shader::compiler_version());
}

namespace {

// Examples by command; the program itself has the empty name.
constexpr std::pair<const char*, const char*> examples[]{
    {"",
     "  gloam demo                                  pictures, a check, a page\n"
     "  gloam check --device all --html check.html  every equation on every Vulkan device\n"
     "  gloam render mesh.obj                       a mesh in light, with and without\n"
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
     "  gloam check --device all --variant all --html r.html every device, every compiler setting\n"
     "  gloam check --quiet --junit results.xml              for continuous integration\n"
     "  gloam check --failures failures                      each failure ready to report\n"
     "  gloam check shader.frag 'luma(vec3)' --range c=0:1   a function of a file of your own\n"},
    {"report",
     "  gloam report a.json b.json\n"
     "  gloam report a.json b.json --html all.html\n"
     "  gloam report now.json --since last-week.json\n"},
    {"render",
     "  gloam render mesh.obj --frames 8\n"
     "  gloam render mesh.obj --up z --orbit 40,25\n"
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
    {"cost",
     "  gloam cost tone.glsl curve --below 40              a function; status 1 above 40 vector "
     "instructions\n"
     "  gloam cost blur.comp --define RADIUS=3             a whole compute shader\n"
     "  gloam cost --preset balanced --family NAVI31       the passes of a frame\n"},
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
    {"pack", "  gloam pack gloam/geometry/linear_depth.glsl --version 310es\n"}};

}  // namespace

void add_help_examples(CLI::App& app) {
    for (const auto& [name, text] : examples)
        (*name == '\0' ? app : *app.get_subcommand(name)).footer(std::string("Examples:\n") + text);
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
