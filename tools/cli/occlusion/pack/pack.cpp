// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
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
        "(`ambient_occlusion.comp`). Together: each function once. "
        "This page is written by `gloam pack --lines`.\n\n"
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

void pack_npm(const PackCommand& options) {
    record::OutputFolder folder(options.npm);
    for (const auto& [name, text] :
         site::npm_package({.library = glsl_directory(),
                            .files = site_directory(),
                            .licence = documents_directory().parent_path() / "LICENSE",
                            .version = base::version()}))
        folder.write(name, text);
    folder.keep();
}

void run_pack(PackCommand& options) {
    if (!options.npm.empty()) return pack_npm(options);
    if (options.effect || options.one_pass) {
        const std::string name = options.effect ? "--effect" : "--one-pass";
        options.of_effect.out = options.out;
        if (!options.target.empty()) throw std::invalid_argument(name + " takes no --target");
        if (!options.defines.empty()) throw std::invalid_argument(name + " takes no --define");
        options.of_effect.version = options.version;
        return options.effect ? pack_effect(options.of_effect) : pack_one_pass(options.of_effect);
    }
    if (options.of_effect.normals != EffectPackOptions{}.normals)
        throw std::invalid_argument("--normals requires --effect or --one-pass");
    if (options.lines) {
        if (!options.target.empty())
            throw std::invalid_argument("--lines counts lines of GLSL: it takes no --target");
        fmt::print("{}", options.files.empty() ? method_table(glsl_directory()) : line_table(options.files));
        return;
    }
    pack_files(options, equations_named);
}

void add_effect_options(CLI::App& command, PackCommand& options) {
    EffectPackOptions& of_effect = options.of_effect;
    CLI::Option* effect = command.add_flag(
        "--effect", options.effect,
        "the passes of the effect, and a C header of what they are given, into the folder --out");
    const auto only = [effect](CLI::Option* option) { option->needs(effect); };
    only(command
             .add_option("--preset", of_effect.preset,
                         "fast, balanced, quality or reference: gloam list presets")
             ->capture_default_str());
    only(command
             .add_option("--set", of_effect.set,
                         "NAME=VALUE: a setting (gloam list settings); may be repeated")
             ->allow_extra_args(false));
    only(command.add_flag_callback(
        "--bent-normals", [&of_effect] { of_effect.set.emplace_back("bent_normals=on"); },
        "the mean open direction of each pixel, too"));
    only(command.add_flag_callback(
        "--multi-bounce", [&of_effect] { of_effect.set.emplace_back("bounce_albedo=0.5"); },
        "with light that bounces among blockers of one albedo, gloam_frame::filter.albedo"));
    only(command.add_flag("--orthographic", of_effect.orthographic,
                          "the camera is orthographic; else perspective"));
    only(command
             .add_option_function<std::string>(
                 "--shown",
                 [&of_effect](const std::string& what) { of_effect.visibility = what == "visibility"; },
                 "occlusion, 1 where blocked, or visibility, 1 where open: what the image shown holds")
             ->check(CLI::IsMember({"occlusion", "visibility"})));
    only(command
             .add_option_function<std::string>(
                 "--uniforms",
                 [&of_effect](const std::string& kind) { of_effect.plain_uniforms = kind == "plain"; },
                 "of OpenGL: block, or plain: members of a uniform structure `parameters`")
             ->check(CLI::IsMember({"block", "plain"})));
}

void add_one_pass_options(CLI::App& command, PackCommand& options) {
    EffectPackOptions& of_effect = options.of_effect;
    command
        .add_option("--normals", of_effect.normals,
                    "the engine's: view or world space, and behind it -octahedral, -unorm or both; "
                    "none: from depth")
        ->capture_default_str();
    CLI::Option* one_pass = command
                                .add_flag("--one-pass", options.one_pass,
                                          "the effect as one fragment shader and a blur of two, for programs "
                                          "that take no more, into the folder --out")
                                ->excludes("--effect");
    command.add_option("--taps", of_effect.taps, "of each pixel in one pass")
        ->check(CLI::IsMember({4, 8, 16}))
        ->capture_default_str()
        ->needs(one_pass);
}

// The package has its presets and methods all together, so no other option belongs to it.
void add_npm(CLI::App& command, PackCommand& options) {
    const std::vector<CLI::Option*> others =
        command.get_options([](const CLI::Option* option) { return option->get_name() != "--help"; });
    CLI::Option* npm = command.add_option(
        "--npm", options.npm,
        "folder for a package of npm: the effect in WebGL2 as a module with types, and passes for three.js, "
        "Babylon.js and PlayCanvas");
    for (CLI::Option* other : others) npm->excludes(other);
}

}  // namespace

void add_pack(CLI::App& app) {
    auto options = std::make_shared<PackCommand>();
    CLI::App* command = app.add_subcommand(
        "pack", "one self-contained file of what is used, in GLSL or another language, or the whole effect");
    add_pack_options(*command, *options);
    command->add_flag(
        "--lines", options->lines,
        "a table of the lines of code of each file as packed, comments not counted (default: all methods)");
    add_effect_options(*command, *options);
    add_one_pass_options(*command, *options);
    add_npm(*command, *options);
    command->callback([options] { run_pack(*options); });
}

}  // namespace gloam::cli
