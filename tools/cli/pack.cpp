// SPDX-License-Identifier: MIT
#include "cli/pack.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/apart.hpp"
#include "base/read_file.hpp"
#include "cli/environment.hpp"
#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "effect/setting_table.hpp"
#include "report/output_file.hpp"
#include "scene/pass_library.hpp"
#include "shader/compile.hpp"
#include "shader/include.hpp"
#include "shader/language.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

struct PackOptions {
    std::vector<std::string> files;
    std::string version = "450";
    fs::path out;
    std::string method;
    std::string preset;
};

// A file as given, or by its name inside the library.
fs::path find_file(const std::string& name, const std::vector<fs::path>& roots) {
    std::error_code none;
    if (fs::is_regular_file(name, none)) return name;
    return shader::resolve_include(name, {}, roots);
}

void put_packed(const report::OutputFile& out, const PackOptions& options, const std::string& text) {
    if (options.out.empty()) {
        fmt::print("{}", text);
    } else {
        out.write(text);
    }
}

// Files may be anybody's, and so is what their macros do to a compiler: within limits of time and memory.
std::string within_limits(const std::function<std::string()>& work, const std::string& name) {
    const base::ProcessLimits limits{.memory_bytes = std::uint64_t{2} << 30,
                                     .cpu = std::chrono::seconds(30),
                                     .patience = std::chrono::minutes(5)};
    try {
        return base::run_apart(work, limits);
    } catch (const base::LimitError& error) {
        throw std::runtime_error(fmt::format("{}: packing it {}", name, error.what()));
    }
}

// The text without its #version, which the preamble has; lines stay where they are.
std::string without_version(const std::string& text) {
    static const std::regex version("(^|\n)[ \t]*#[ \t]*version[^\n]*");
    return std::regex_replace(text, version, "$1");
}

std::string packed(const std::vector<fs::path>& files, shader::Language language,
                   const std::vector<fs::path>& roots) {
    std::string body = shader::flatten(files, roots);
    try {
        shader::check_compiles({.name = files.front().string() + " as packed", .text = body}, language,
                               roots);
    } catch (const shader::CompileError&) {
        // The same of a file as it is names its own lines, and those of what it includes.
        for (const fs::path& file : files) {
            const std::string text = without_version(base::read_file(file));
            shader::check_compiles({.name = fs::absolute(file).string(), .text = text}, language, roots);
        }
        throw;
    }
    return shader::preamble(language) + body;
}

// The settings that the pass is given, by the names that `gloam list settings` explains.
std::string settings_comment(const std::string& preset, const std::string& method) {
    effect::Settings settings = effect::preset_named(preset).settings;
    if (method != settings.method) settings = with_method(settings, method);
    std::string text = fmt::format("// The preset {}, lengths for a radius of 1:\n", preset);
    for (const effect::Setting& setting : effect::setting_table())
        text += fmt::format("//   {} = {}\n", setting.name, effect::text_of(setting.get(settings)));
    return text;
}

// ambient_occlusion.comp with one method.
void pack_pass(const PackOptions& options) {
    if (!options.files.empty())
        throw std::invalid_argument("--method and --preset pack a whole pass: give no files with them");
    if (options.version != "450") {
        throw std::invalid_argument(
            fmt::format("--version {}: a whole pass is for Vulkan, expected 450", options.version));
    }
    std::string method = options.method;
    if (method.empty()) method = effect::preset_named(options.preset).settings.method;
    const std::string name = effect::method_named(method).name;
    const report::OutputFile out(options.out);
    const scene::PassLibrary passes(glsl_directory());
    std::string text =
        passes.text("ambient_occlusion.comp", {}, {{"methods/hemisphere.glsl", "methods/" + name + ".glsl"}});
    if (!options.preset.empty()) text += "\n" + settings_comment(options.preset, name);
    (void)shader::compile({.name = "the pass of " + name + " as packed", .text = text},
                          {.stage = shader::Stage::compute});
    put_packed(out, options, text);
}

void run_pack(const PackOptions& options) {
    if (!options.method.empty() || !options.preset.empty()) return pack_pass(options);
    if (options.files.empty())
        throw std::invalid_argument("nothing to pack: give files, --method NAME or --preset NAME");
    const auto language = shader::language_from(options.version);
    if (!language) {
        throw std::invalid_argument("unknown GLSL version \"" + options.version +
                                    "\": expected 450, 330, 300es or 310es");
    }
    const std::vector<fs::path> roots{glsl_directory()};
    std::vector<fs::path> files;
    for (const std::string& name : options.files) files.push_back(find_file(name, roots));
    const report::OutputFile out(options.out);
    put_packed(out, options,
               within_limits([&] { return packed(files, *language, roots); }, files.front().string()));
}

}  // namespace

void add_pack(CLI::App& app) {
    auto options = std::make_shared<PackOptions>();
    CLI::App* command =
        app.add_subcommand("pack", "flatten shader includes into one self-contained GLSL file");
    command->add_option("file", options->files, "includes, as paths or as gloam/...");
    command->add_option("--method", options->method,
                        "instead of files: the whole compute pass of a method (gloam list methods)");
    command->add_option("--preset", options->preset,
                        "that of a preset's method, or of --method, with the preset's settings as a comment");
    command->add_option("--version", options->version, "450, 330, 300es or 310es")->capture_default_str();
    command->add_option("--out", options->out, "file to write (standard output when not given)");
    command->callback([options] { run_pack(*options); });
}

}  // namespace gloam::cli
