// SPDX-License-Identifier: MIT
#include "cli/help_examples.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace gloam::cli {
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
         "  gloam list presets sweep-balanced    the settings that it changes\n"},
        {"check",
         "  gloam check                                          every equation on the default device\n"
         "  gloam check 'gloam_linear_depth_*' 'TSSAO-*'         some of them\n"
         "  gloam check --device all --variant all --html r.html every driver, every compiler setting\n"
         "  gloam check --quiet --junit results.xml              for continuous integration\n"
         "  gloam check --failures failures                      each failure ready to report\n"
         "  gloam check shader.frag 'luma(vec3)' --range c=0:1   a function of a file of your own\n"},
        {"report",
         "  gloam report a.json b.json\n"
         "  gloam report a.json b.json --html all.html\n"},
        {"render",
         "  gloam render mesh.obj --frames 8\n"
         "  gloam render mesh.obj --up z --orbit 40,25 --turntable 24 --gallery page\n"
         "  gloam render columns --method all --truth\n"
         "  gloam render --gbuffer FOLDER --radius 0.5\n"},
        {"tune",
         "  gloam tune --preset sweep-quality --parameter feature_thickness=0.1:10:log\n"
         "  gloam tune --sequence --parameter steps=2:12 --copies 20 --out mine.json --report mine.md\n"},
        {"bench",
         "  gloam bench --method gtao hemisphere --samples 4 16 --scene columns\n"
         "  gloam bench --from results.json --error 0.05\n"},
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

}  // namespace gloam::cli
