// SPDX-License-Identifier: MIT
#include "cli/pack.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/environment.hpp"
#include "report/output_file.hpp"
#include "shader/include.hpp"
#include "shader/language.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

struct PackOptions {
    std::vector<std::string> files;
    std::string version = "450";
    fs::path out;
};

// A file as given, or by its name inside the library.
fs::path find_file(const std::string& name, const std::vector<fs::path>& roots) {
    std::error_code none;
    if (fs::is_regular_file(name, none)) return name;
    return shader::resolve_include(name, {}, roots);
}

void run_pack(const PackOptions& options) {
    const auto language = shader::language_from(options.version);
    if (!language) {
        throw std::invalid_argument("unknown GLSL version \"" + options.version +
                                    "\": expected 450, 330, 300es or 310es");
    }
    const std::vector<fs::path> roots{glsl_directory()};
    std::vector<fs::path> files;
    for (const std::string& name : options.files) files.push_back(find_file(name, roots));
    const report::OutputFile out(options.out);
    const std::string body = shader::flatten(files, roots);
    shader::check_compiles({.name = "packed text", .text = body}, *language, roots);
    const std::string text = shader::preamble(*language) + body;
    if (options.out.empty()) {
        fmt::print("{}", text);
    } else {
        out.write(text);
    }
}

}  // namespace

void add_pack(CLI::App& app) {
    auto options = std::make_shared<PackOptions>();
    CLI::App* command =
        app.add_subcommand("pack", "flatten shader includes into one self-contained GLSL file");
    command->add_option("file", options->files, "includes, as paths or as gloam/...")->required();
    command->add_option("--version", options->version, "450, 330, 300es or 310es")->capture_default_str();
    command->add_option("--out", options->out, "file to write (standard output when not given)");
    command->callback([options] { run_pack(*options); });
}

}  // namespace gloam::cli
