// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/version.hpp"
#include "cli/environment.hpp"
#include "cli/framework/pack.hpp"
#include "cli/occlusion/names.hpp"
#include "cli/occlusion/pack/effect.hpp"
#include "effect/methods.hpp"
#include "module/include.hpp"
#include "module/texts.hpp"
#include "record/output.hpp"
#include "site/npm_package.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

// The pass of a method's frame with its usual settings that takes the samples.
std::string sampling_pass(const fs::path& glsl, const std::string& method) {
    const effect::Settings settings = effect::with_method(effect::Settings{}, method);
    const scene::PassLibrary library(glsl);
    for (const effect::PlannedPass& pass : plan_of(settings, {}, library).passes)
        if (pass.name == "ambient_occlusion") return text_of(pass, library);
    throw std::logic_error("a frame without the pass ambient_occlusion");
}

// The table of all methods: their functions, and the passes of each one's effect.
std::string method_table(const fs::path& glsl) {
    std::string text =
        "# Lines of code\n\n"
        "Lines of each method as `gloam pack` writes it, without blank lines and comments. Function: the "
        "method alone\n"
        "(`gloam pack gloam/methods/FILE.glsl --function gloam_NAME`). Pass: the one that blends it into a "
        "history\n"
        "(`ambient_occlusion.comp`). Together: each function once. This page is written by `gloam pack "
        "--lines`.\n\n"
        "| method | function | pass |\n| --- | --- | --- |\n";
    std::vector<std::string> functions;
    std::vector<std::string> passes;
    for (const effect::MethodInfo& method : effect::methods()) {
        functions.push_back(
            shader::pack({glsl / file_of(method)}, {.functions = {"gloam_" + method.name}}, {glsl}));
        passes.push_back(sampling_pass(glsl, method.name));
        text += fmt::format("| {} | {} | {} |\n", method.name, shader::code_lines(functions.back()),
                            shader::code_lines(passes.back()));
    }
    return text +
           fmt::format("| together | {} | {} |\n", shader::code_lines(functions), shader::code_lines(passes));
}

struct PackCommand : PackOptions {
    bool lines = false;
    bool effect = false;
    bool one_pass = false;
    fs::path npm;  // folder of the package; empty: none
    EffectPackOptions of_effect;
};

int pack_npm(const PackCommand& options) {
    record::OutputFolder folder(options.npm);
    for (const auto& [name, text] :
         site::npm_package({.library = glsl_directory(),
                            .files = data_directory("site"),
                            .licence = data_directory("docs").parent_path() / "LICENSE",
                            .version = base::version()}))
        folder.write(name, text);
    folder.keep();
    return 0;
}

int run_pack(PackCommand& options) {
    if (!options.npm.empty()) return pack_npm(options);
    if (options.effect || options.one_pass) {
        const std::string name = options.effect ? "--effect" : "--one-pass";
        options.of_effect.out = options.out;
        if (!options.target.empty()) throw std::invalid_argument(name + " takes no --target");
        if (!options.defines.empty()) throw std::invalid_argument(name + " takes no --define");
        options.of_effect.version = options.version;
        (options.effect ? pack_effect : pack_one_pass)(options.of_effect);
        return 0;
    }
    if (options.of_effect.normals != EffectPackOptions{}.normals)
        throw std::invalid_argument("--normals requires --effect or --one-pass");
    if (options.lines) {
        if (!options.target.empty())
            throw std::invalid_argument("--lines counts lines of GLSL: it takes no --target");
        fmt::print("{}", options.files.empty() ? method_table(glsl_directory()) : line_table(options.files));
        return 0;
    }
    pack_files(options, equations_named);
    return 0;
}

// Of the effect's passes, or of its one pass.
std::vector<Option> effect_options(PackCommand& options) {
    EffectPackOptions& of_effect = options.of_effect;
    const std::vector<std::string> effect{"--effect"};
    return {
        {"--effect", &options.effect,
         "the passes of the effect, and a C header of what they are given, into the folder --out"},
        {"--preset", &of_effect.preset, needs("--effect"),
         "fast, balanced, quality or reference: gloam list presets"},
        {"--set", &of_effect.set, needs("--effect", repeated),
         "NAME=VALUE: a setting (gloam list settings); may be repeated"},
        {"--bent-normals", [&of_effect] { of_effect.set.emplace_back("bent_normals=on"); }, needs("--effect"),
         "the mean open direction of each pixel, too"},
        {"--multi-bounce", [&of_effect] { of_effect.set.emplace_back("bounce_albedo=0.5"); },
         needs("--effect"),
         "with light that bounces among blockers of one albedo, gloam_frame::filter.albedo"},
        {"--orthographic", &of_effect.orthographic, needs("--effect"),
         "the camera is orthographic; else perspective"},
        {"--shown", [&of_effect](const std::string& what) { of_effect.visibility = what == "visibility"; },
         needs("--effect", one_of({"occlusion", "visibility"})),
         "occlusion, 1 where blocked, or visibility, 1 where open: what the image shown holds"},
        {"--uniforms", [&of_effect](const std::string& kind) { of_effect.plain_uniforms = kind == "plain"; },
         needs("--effect", one_of({"block", "plain"})),
         "of OpenGL: block, or plain: members of a uniform structure `parameters`"},
        {"--normals", &of_effect.normals,
         "the engine's: view or world space, and behind it -octahedral, -unorm or both; none: from depth"},
        {"--one-pass", &options.one_pass, excludes("--effect"),
         "the effect as one fragment shader and a blur of two, for programs that take no more, into the "
         "folder --out"},
        {"--taps", &of_effect.taps, needs("--one-pass", one_of({"4", "8", "16"})),
         "of each pixel in one pass"}};
}

std::vector<Option> options_of(PackCommand& options) {
    std::vector<Option> all = pack_options(options);
    all.push_back(
        {"--lines", &options.lines,
         "a table of the lines of code of each file as packed, comments not counted (default: all methods)"});
    std::ranges::move(effect_options(options), std::back_inserter(all));
    Option npm{"--npm", &options.npm,
               "folder for a package of npm: the effect in WebGL2 as a module with types, and passes for "
               "three.js, Babylon.js and PlayCanvas"};
    // The package has its presets and methods all together, so no other option belongs to it.
    for (const Option& other : all) npm.rules.excludes.push_back(other.names);
    all.push_back(npm);
    return all;
}

}  // namespace

Command pack_command() {
    static PackCommand options;
    return {
        .name = "pack",
        .about = "one self-contained file of what is used, in GLSL or another language, or the whole effect",
        .options = options_of(options),
        .run = [] { return run_pack(options); },
        .examples = "  gloam pack gloam/geometry/linear_depth.glsl --version 310es\n"};
}

}  // namespace gloam::cli
