// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>

#include <unistd.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "base/version.hpp"
#include "cli/check/checker.hpp"
#include "cli/environment.hpp"
#include "cli/names.hpp"
#include "cli/pack/effect.hpp"
#include "effect/methods.hpp"
#include "module/include.hpp"
#include "module/texts.hpp"
#include "report/output.hpp"
#include "site/npm_package.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

std::string of_files(const fs::path& glsl, const std::vector<std::string>& files) {
    std::string text = "| file | lines of code |\n| --- | --- |\n";
    std::vector<std::string> all;
    for (const std::string& name : files) {
        std::error_code none;
        const fs::path file =
            fs::is_regular_file(name, none) ? fs::path(name) : shader::resolve_include(name, {}, {glsl});
        all.push_back(shader::pack({file}, {.functions = {}}, {glsl}));
        text += fmt::format("| `{}` | {} |\n", name, shader::code_lines(all.back()));
    }
    return text + fmt::format("| together | {} |\n", shader::code_lines(all));
}

// The pass of a method's frame with its usual settings that takes the samples.
std::string sampling_pass(const fs::path& glsl, const std::string& method) {
    const effect::Settings settings = effect::with_method(effect::Settings{}, method);
    const scene::PassLibrary library(glsl);
    for (const effect::PlannedPass& pass : plan_of(settings, {}, library).passes)
        if (pass.name == "ambient_occlusion") return text_of(pass, library);
    throw std::logic_error("a frame without the pass ambient_occlusion");
}

}  // namespace

std::string line_table(const fs::path& glsl, const std::vector<std::string>& files) {
    if (!files.empty()) return of_files(glsl, files);
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

namespace {

namespace fs = std::filesystem;

struct PackOptions {
    std::vector<std::string> files;
    std::vector<std::string> functions;
    std::vector<std::string> includes;  // further include roots
    std::string version = "450";
    std::string target;  // empty: GLSL
    fs::path out;
    bool lines = false;
    bool effect = false;
    fs::path npm;  // folder of the package; empty: none
    EffectPackOptions of_effect;
};

// What is packed: whole files, or functions of some.
struct Packed {
    std::vector<fs::path> files;
    std::vector<std::string> functions;
};

// A file by its path, or by its name inside the library; else an equation, of which only the function is
// packed.
void find_one(const std::string& name, const std::vector<fs::path>& roots, Packed& packed) {
    std::error_code none;
    if (fs::exists(name, none))
        return packed.files.emplace_back(name), void();  // reading it says if it is a text
    const bool is_file = is_shader_file(name) || name.find('/') != std::string::npos;
    if (is_file && name.find_first_of("*?") == std::string::npos)
        return packed.files.push_back(shader::resolve_include(name, {}, roots));
    for (const catalogue::Entry& entry : equations_named({name})) {
        const fs::path file = shader::resolve_include(entry.description.file, {}, roots);
        if (std::ranges::find(packed.files, file) == packed.files.end()) packed.files.push_back(file);
        packed.functions.push_back(entry.description.function);
    }
}

Packed find_all(const PackOptions& options, const std::vector<fs::path>& roots) {
    Packed packed{.files = {}, .functions = options.functions};
    bool whole = false;
    for (const std::string& name : options.files) {
        const std::size_t before = packed.functions.size();
        find_one(name, roots, packed);
        whole = whole || packed.functions.size() == before;
    }
    if (whole && packed.functions.size() > options.functions.size())
        throw std::invalid_argument("files and equations together: expected one or the other");
    return packed;
}

// The stage from the suffix of a file's name.
std::optional<shader::Stage> stage_of(const std::vector<fs::path>& files) {
    for (const fs::path& file : files)
        if (const auto stage = shader::stage_of_file(file)) return stage;
    return std::nullopt;
}

// Throws like shader::pack(), in one line for what Vulkan alone refuses: uniforms outside blocks.
std::string packed_text(const std::vector<fs::path>& files, const shader::PackRequest& request,
                        const std::vector<fs::path>& roots) {
    try {
        return shader::pack(files, request, roots);
    } catch (const shader::CompileError& error) {
        const std::string what = error.what();
        if (what.find("non-opaque uniforms") == std::string::npos) throw;
        throw std::invalid_argument(what.substr(0, what.find('\n')) + "; for OpenGL take --version 430");
    }
}

// A GLSL text in the language of --target; the name of its first file names it.
std::string in_language(const std::string& text, const fs::path& file, std::optional<shader::Target> target,
                        std::optional<shader::Stage> stage) {
    if (!target) return text;
    return shader::translated({.name = file.string(), .text = text}, *target,
                              stage.value_or(shader::Stage::compute));
}

std::optional<shader::Target> target_of(const PackOptions& options) {
    if (options.target.empty()) return std::nullopt;
    const auto target = shader::target_from(options.target);
    if (!target)
        throw std::invalid_argument("unknown target \"" + options.target + "\": expected hlsl or msl");
    if (options.version != "450")
        throw std::invalid_argument("--target " + options.target +
                                    " translates GLSL 450; it takes no --version");
    return target;
}

void pack_files(const PackOptions& options) {
    if (options.files.empty())
        throw std::invalid_argument("nothing to pack: give files, or --effect for all passes of the effect");
    const auto language = shader::language_from(options.version);
    if (!language) {
        throw std::invalid_argument("unknown GLSL version \"" + options.version +
                                    "\": expected 450, 430, 330, 300es, 310es or 320es");
    }
    const std::optional<shader::Target> target = target_of(options);
    std::vector<fs::path> roots{glsl_directory()};
    roots.insert(roots.begin(), options.includes.begin(), options.includes.end());
    const auto [files, functions] = find_all(options, roots);
    // As in check and audit, "#include <sub/x.glsl>" may name a file beside the one that is given.
    for (const fs::path& file : files) roots.insert(roots.begin(), fs::absolute(file).parent_path());
    const report::OutputFile out(options.out);
    const shader::PackRequest request{
        .language = *language, .functions = functions, .stage = stage_of(files)};
    const std::string text =
        with_version(in_language(packed_text(files, request, roots), files.front(), target, request.stage),
                     target ? "" : api_of(*language));
    if (options.out.empty()) {
        fmt::print("{}", isatty(STDOUT_FILENO) != 0 ? base::for_terminal(text) : text);
    } else {
        out.write(text);
    }
}

void pack_npm(const PackOptions& options) {
    report::OutputFolder folder(options.npm);
    for (const auto& [name, text] :
         site::npm_package({.library = glsl_directory(),
                            .files = site_directory(),
                            .licence = documents_directory().parent_path() / "LICENSE",
                            .version = base::version()}))
        folder.write(name, text);
    folder.keep();
}

void run_pack(PackOptions& options) {
    if (!options.npm.empty()) return pack_npm(options);
    if (options.effect) {
        options.of_effect.out = options.out;
        if (!options.target.empty()) throw std::invalid_argument("--effect takes no --target");
        options.of_effect.version = options.version;
        return pack_effect(options.of_effect);
    }
    if (options.lines) {
        if (!options.target.empty())
            throw std::invalid_argument("--lines counts lines of GLSL: it takes no --target");
        fmt::print("{}", line_table(glsl_directory(), options.files));
        return;
    }
    pack_files(options);
}

void add_effect_options(CLI::App& command, PackOptions& options) {
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
        "with light that bounces among blockers of one albedo, gloam_frame::last.albedo"));
    only(command.add_flag("--orthographic", of_effect.orthographic,
                          "the camera is orthographic; else perspective"));
    only(command
             .add_option("--normals", of_effect.normals,
                         "the engine's: view or world space, and behind it -octahedral, -unorm or both; "
                         "none: from depth")
             ->capture_default_str());
}

// The package has its presets and methods all together, so no other option belongs to it.
void add_npm(CLI::App& command, PackOptions& options) {
    const std::vector<CLI::Option*> others =
        command.get_options([](const CLI::Option* option) { return option->get_name() != "--help"; });
    CLI::Option* npm = command.add_option(
        "--npm", options.npm,
        "folder for a package of npm: the effect in WebGL2 as a module with types, and a pass for three.js");
    for (CLI::Option* other : others) npm->excludes(other);
}

}  // namespace

void add_pack(CLI::App& app) {
    auto options = std::make_shared<PackOptions>();
    CLI::App* command = app.add_subcommand(
        "pack", "one self-contained file of what is used, in GLSL or another language, or the whole effect");
    command->add_option(
        "file", options->files,
        "includes or whole shaders, as paths or as gloam/..., or equations (gloam list equations)");
    command
        ->add_option("--function", options->functions,
                     "only this function and what it uses (default: main, else every function of the files); "
                     "may be repeated")
        ->allow_extra_args(false);
    add_include_option(*command, options->includes);
    command
        ->add_option("--version", options->version, "450 (Vulkan), 430 (OpenGL), 330, 300es, 310es or 320es")
        ->capture_default_str();
    command->add_option("--target", options->target,
                        "hlsl or msl: translated to HLSL of shader model 6.0 or to Metal's language");
    command->add_option("--out", options->out,
                        "file to write (standard output when not given); with --effect the folder");
    command->add_flag(
        "--lines", options->lines,
        "a table of the lines of code of each file as packed, comments not counted (default: all methods)");
    add_effect_options(*command, *options);
    add_npm(*command, *options);
    command->callback([options] { run_pack(*options); });
}

}  // namespace gloam::cli
