// SPDX-License-Identifier: MIT
#include "cli/occlusion/pack/effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "base/version.hpp"
#include "cli/environment.hpp"
#include "cli/framework/pack.hpp"
#include "cli/occlusion/render.hpp"
#include "cli/occlusion/settings.hpp"
#include "effect/methods.hpp"
#include "module/include.hpp"
#include "record/output.hpp"

namespace gloam::cli {
namespace {

effect::Settings settings_of(const EffectPackOptions& options) {
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

shader::Language language_of(const std::string& version) {
    const auto language = shader::language_from(version);
    if (version == "310es" || version == "320es")
        throw std::invalid_argument(
            "--effect --version " + version +
            ": its compute shaders cannot write images of 16 bits; it takes the fragment shaders of 300es");
    if (!language)
        throw std::invalid_argument("--effect --version " + version +
                                    ": expected 450, 430, 330, 150 or 300es");
    return *language;
}

effect::PlanOptions plan_options(const EffectPackOptions& options) {
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
    std::string header = shader::read_text(glsl_directory() / "passes/frame/gloam_frame.h");
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

}  // namespace

std::string text_of(const effect::PlannedPass& pass, const scene::PassLibrary& library,
                    shader::Language language) {
    const effect::PassSource& source = pass.source;
    std::map<std::uint32_t, std::uint32_t> constants;
    for (const gpu::SpecializationConstant& one : source.constants) constants[one.id] = one.bits;
    return library.text(source.file, source.defines, source.replaced, constants, language);
}

void pack_effect(const EffectPackOptions& options) {
    if (options.out.empty()) throw std::invalid_argument("--effect: give --out, the folder to write");
    const effect::Settings settings = settings_of(options);
    const shader::Language language = language_of(options.version);
    const bool compute = shader::usual_stage(language) == shader::Stage::compute;
    if (settings.bent_normals && !compute)
        throw std::invalid_argument(
            "--effect --bent-normals: compute shaders have them; expected --version 450 or 430");
    if (settings.bent_normals && language == shader::Language::gl430 &&
        settings.resolution == effect::Resolution::tiles)
        throw std::invalid_argument(
            "--effect --bent-normals --version 430: OpenGL 4.3 has too few images for tiles; expected --set "
            "resolution=full or half, or --version 450");
    if (options.plain_uniforms && language == shader::Language::vulkan450)
        throw std::invalid_argument("--uniforms plain: Vulkan has blocks alone; expected another --version");
    const scene::PassLibrary library(glsl_directory());
    record::OutputFolder folder(options.out);
    for (effect::PlannedPass& pass : plan_of(settings, plan_options(options), library).passes) {
        const std::string file = pass.name + (compute ? ".comp" : ".frag");
        if (!compute) pass.source.file.replace(pass.source.file.size() - 5, 5, ".frag");
        if (options.visibility && (pass.name == "filter" || pass.name == "join"))
            pass.source.constants.push_back({.id = 10, .bits = 1});
        if (language != shader::Language::vulkan450 && !options.plain_uniforms)
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

void pack_one_pass(const EffectPackOptions& options) {
    if (options.out.empty()) throw std::invalid_argument("--one-pass: give --out, the folder to write");
    if (options.normals != "none" && options.normals != "view")
        throw std::invalid_argument("--one-pass --normals " + options.normals + ": expected view or none");
    const bool own_version = options.version != "none";
    const auto language = shader::language_from(own_version ? options.version : "330");
    if (!language || *language == shader::Language::vulkan450)
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

}  // namespace gloam::cli
