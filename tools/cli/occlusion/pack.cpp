// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/version.hpp"
#include "cli/environment.hpp"
#include "cli/framework/pack.hpp"
#include "cli/occlusion/names.hpp"
#include "cli/occlusion/render.hpp"
#include "cli/occlusion/settings.hpp"
#include "effect/methods.hpp"
#include "module/include.hpp"
#include "module/texts.hpp"
#include "record/output.hpp"
#include "site/site.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

// The options of files, and more: of the effect's passes, or of its one pass.
struct PackCommand : PackOptions {
    bool lines = false;
    bool effect = false;
    bool one_pass = false;
    fs::path npm;  // folder of the package; empty: none
    std::string preset = effect::default_preset;
    std::vector<std::string> set;  // NAME=VALUE
    bool orthographic = false;
    bool visibility = false;       // is what is shown; otherwise occlusion
    bool plain_uniforms = false;   // in the place of a block of OpenGL
    std::string normals = "view";  // scene::encoding_named(), or none: from depth
    std::uint32_t taps = 8;        // of one pass, for each pixel
};

effect::Settings settings_of(const PackCommand& options) {
    const std::string expected =
        "preset " + options.preset + ": expected fast, balanced, quality or reference";
    const bool is_known = options.preset.ends_with(".json") ||
                          std::ranges::count(effect::presets(), options.preset, &effect::Preset::name) > 0;
    if (!is_known) throw std::invalid_argument(expected + ", or a file NAME.json");
    const effect::Settings settings =
        settings_for({.preset = options.preset, .radius = 1.0F, .set = options.set}, {});
    if (settings.passes == effect::Passes::frame) return settings;
    throw std::invalid_argument(expected + "; of others pack the function: gloam pack " +
                                file_of(effect::method_named(settings.method)));
}

source::Language language_of(const std::string& version) {
    const auto language = source::language_from(version);
    if (version == "310es" || version == "320es")
        throw std::invalid_argument(
            "--effect --version " + version +
            ": its compute shaders cannot write images of 16 bits; it takes the fragment shaders of 300es");
    if (!language)
        throw std::invalid_argument("--effect --version " + version +
                                    ": expected 450, 430, 330, 150 or 300es");
    return *language;
}

effect::PlanOptions plan_options(const PackCommand& options) {
    const bool none = options.normals == "none";
    try {
        return {.orthographic = options.orthographic,
                .normals = !none,
                .encoding = scene::encoding_named("buffer", none ? "view" : options.normals)};
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(error.what() + std::string("; or none"));
    }
}

// The header of the library with the format of what is shown, and the preset.
std::string header_of(const std::string& preset, const effect::Settings& settings, bool orthographic) {
    std::string header = module::read_text(glsl_directory() / "passes/frame/gloam_frame.h");
    if (settings.output != effect::OutputFormat::r8) {
        constexpr std::string_view shown = " * shown        R8  ";
        const std::string format = settings.output == effect::OutputFormat::r16f ? "R16F" : "R32F";
        header.replace(header.find(shown) + shown.size() - 4, 4, format);
    }
    std::string name = preset;
    std::ranges::replace_if(name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return fmt::format(
        "#pragma once\n{}\nstatic const gloam_preset gloam_{} = {{gloam_{}, {:#}f, {:#}f, {:#}f, {:d}, "
        "{:d}}};"
        " /* of gloam {} */\n",
        header, name, effect::text_of(effect::setting_named("resolution").get(settings)), settings.mark,
        settings.history_range, settings.history_sharpness, orthographic, settings.deep || orthographic,
        base::version());
}

// Writes the passes of a frame and gloam_frame.h with the preset into a folder, all or none. Throws
// std::invalid_argument for invalid options, std::runtime_error for a folder that cannot be written to.
void pack_effect(const PackCommand& options) {
    const effect::Settings settings = settings_of(options);
    const source::Language language = language_of(options.version);
    const bool compute = source::usual_stage(language) == source::Stage::compute;
    if (settings.bent_normals && !compute)
        throw std::invalid_argument(
            "--effect --bent-normals: compute shaders have them; expected --version 450 or 430");
    if (settings.bent_normals && language == source::Language::gl430 &&
        settings.resolution == effect::Resolution::tiles)
        throw std::invalid_argument(
            "--effect --bent-normals --version 430: OpenGL 4.3 has too few images for tiles; expected --set "
            "resolution=full or half, or --version 450");
    if (options.plain_uniforms && language == source::Language::vulkan450)
        throw std::invalid_argument("--uniforms plain: Vulkan has blocks alone; expected another --version");
    const scene::PassLibrary library(glsl_directory());
    record::OutputFolder folder(options.out);
    for (effect::PlannedPass& pass : plan_of(settings, plan_options(options), library).passes) {
        const std::string file = pass.name + (compute ? ".comp" : ".frag");
        if (!compute) pass.source.file.replace(pass.source.file.size() - 5, 5, ".frag");
        if (options.visibility && (pass.name == "filter" || pass.name == "join"))
            pass.source.constants.push_back({.id = 10, .bits = 1});
        if (language != source::Language::vulkan450 && !options.plain_uniforms)
            pass.source.defines.emplace_back("GLOAM_PARAMETER_BLOCK");
        if (!compute)  // there are no lists
            std::erase_if(pass.source.defines,
                          [](const auto& one) { return one.starts_with("GLOAM_TILES"); });
        folder.write(file, with_version(text_of(pass, library, language), language));
    }
    if (!compute && settings.resolution == effect::Resolution::tiles)
        for (const char* file : {"halve.frag", "tiles.vert"})
            folder.write(file, with_version(library.text(std::string("frame/") + file, {}, {}, {}, language),
                                            language));
    folder.write("gloam_frame.h", header_of(options.preset, settings, options.orthographic));
    folder.keep();
}

// The same for the effect as one pass and its blur in two, of glsl/passes/one_pass.
void pack_one_pass(const PackCommand& options) {
    if (options.normals != "none" && options.normals != "view")
        throw std::invalid_argument("--one-pass --normals " + options.normals + ": expected view or none");
    const bool own_version = options.version != "none";
    const auto language = source::language_from(own_version ? options.version : "330");
    if (!language || *language == source::Language::vulkan450)
        throw std::invalid_argument("--one-pass --version " + options.version +
                                    ": expected 430, 330, 150, 300es or none");
    const scene::PassLibrary library(glsl_directory());
    record::OutputFolder folder(options.out);
    const auto write = [&](const char* name, const char* pass, std::uint32_t constant, std::uint32_t value) {
        std::vector<std::string> defines;
        if (options.normals == "none") defines.emplace_back("GLOAM_NORMALS_FROM_DEPTH");
        const std::string text =
            with_version(library.text(pass, defines, {}, {{constant, value}}, *language), *language);
        folder.write(name, own_version ? text : text.substr(text.find('\n') + 1));
    };
    write("occlusion.frag", "one_pass/occlusion.frag", 6, options.taps / 2);  // both sides of a slice
    write("blur_x.frag", "one_pass/blur.frag", 10, 0);
    write("blur_y.frag", "one_pass/blur.frag", 10, 1);
    folder.keep();
}

// The table of all methods: their functions, and the passes that take the samples with their usual settings.
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
    const scene::PassLibrary library(glsl);
    for (const effect::MethodInfo& method : effect::methods()) {
        const effect::Plan plan = plan_of(effect::with_method(effect::Settings{}, method.name), {}, library);
        functions.push_back(
            module::pack({glsl / file_of(method)}, {.functions = {"gloam_" + method.name}}, {glsl}));
        passes.push_back(text_of(
            *std::ranges::find(plan.passes, "ambient_occlusion", &effect::PlannedPass::name), library));
        text += fmt::format("| {} | {} | {} |\n", method.name, source::code_lines(functions.back()),
                            source::code_lines(passes.back()));
    }
    return text +
           fmt::format("| together | {} | {} |\n", source::code_lines(functions), source::code_lines(passes));
}

void run_pack(const PackCommand& options) {
    if (!options.npm.empty()) {
        record::OutputFolder folder(options.npm);
        for (const auto& [name, text] : site::npm_package(glsl_directory(), data_directory("site"),
                                                          data_directory("docs").parent_path() / "LICENSE"))
            folder.write(name, text);
        return folder.keep();
    }
    if (options.effect || options.one_pass) {
        const std::string name = options.effect ? "--effect" : "--one-pass";
        if (!options.target.empty()) throw std::invalid_argument(name + " takes no --target");
        if (!options.defines.empty()) throw std::invalid_argument(name + " takes no --define");
        if (options.out.empty()) throw std::invalid_argument(name + ": give --out, the folder to write");
        return options.effect ? pack_effect(options) : pack_one_pass(options);
    }
    if (options.normals != PackCommand{}.normals)
        throw std::invalid_argument("--normals requires --effect or --one-pass");
    if (!options.lines) return pack_files(options, equations_named);
    if (!options.target.empty())
        throw std::invalid_argument("--lines counts lines of GLSL: it takes no --target");
    fmt::print("{}", options.files.empty() ? method_table(glsl_directory()) : line_table(options.files));
}

std::vector<Option> effect_options(PackCommand& options) {
    return {
        {"--effect", &options.effect,
         "the passes of the effect, and a C header of what they are given, into the folder --out"},
        {"--preset", &options.preset, needs("--effect"),
         "fast, balanced, quality or reference: gloam list presets"},
        {"--set", &options.set, needs("--effect", repeated),
         "NAME=VALUE: a setting (gloam list settings); may be repeated"},
        {"--bent-normals", [&options] { options.set.emplace_back("bent_normals=on"); }, needs("--effect"),
         "the mean open direction of each pixel, too"},
        {"--multi-bounce", [&options] { options.set.emplace_back("bounce_albedo=0.5"); }, needs("--effect"),
         "with light that bounces among blockers of one albedo, gloam_frame::filter.albedo"},
        {"--orthographic", &options.orthographic, needs("--effect"),
         "the camera is orthographic; else perspective"},
        {"--shown", [&options](const std::string& what) { options.visibility = what == "visibility"; },
         needs("--effect", one_of({"occlusion", "visibility"})),
         "occlusion, 1 where blocked, or visibility, 1 where open: what the image shown holds"},
        {"--uniforms", [&options](const std::string& kind) { options.plain_uniforms = kind == "plain"; },
         needs("--effect", one_of({"block", "plain"})),
         "of OpenGL: block, or plain: members of a uniform structure `parameters`"},
        {"--normals", &options.normals,
         "the engine's: view or world space, and behind it -octahedral, -unorm or both; none: from depth"},
        {"--one-pass", &options.one_pass, excludes("--effect"),
         "the effect as one fragment shader and a blur of two, for programs that take no more, into the "
         "folder --out"},
        {"--taps", &options.taps, needs("--one-pass", one_of({"4", "8", "16"})),
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
        .run =
            [] {
                run_pack(options);
                return 0;
            },
        .examples = "  gloam pack gloam/geometry/linear_depth.glsl --version 310es\n"};
}

}  // namespace gloam::cli
