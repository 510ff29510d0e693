// SPDX-License-Identifier: MIT
#include "cli/framework/pack.hpp"

#include <fmt/format.h>

#include <unistd.h>
#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/process.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "cli/environment.hpp"
#include "cli/framework/own_file.hpp"
#include "module/include.hpp"
#include "module/texts.hpp"
#include "record/output.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

// The files, and the functions of them that are packed. Each name is a file by its path or its name inside
// the library, or equations, whose functions are packed.
std::pair<std::vector<fs::path>, std::vector<std::string>> find_all(const PackOptions& options,
                                                                    const std::vector<fs::path>& roots,
                                                                    EquationsNamed* equations) {
    std::vector<fs::path> files;
    std::vector<std::string> functions = options.functions;
    bool whole = false;
    for (const std::string& name : options.files) {
        std::error_code none;
        const bool exists = fs::exists(name, none);
        const bool may_exist = is_shader_file(name) || name.find('/') != std::string::npos;
        if (exists || (may_exist && name.find_first_of("*?") == std::string::npos)) {
            files.push_back(exists ? fs::path(name) : module::resolve_include(name, {}, roots));
            whole = true;
            continue;
        }
        for (const judge::Question& equation : equations({name})) {
            const fs::path file = module::resolve_include(equation.file, {}, roots);
            if (std::ranges::find(files, file) == files.end()) files.push_back(file);
            functions.push_back(equation.function);
        }
    }
    if (whole && functions.size() > options.functions.size())
        throw std::invalid_argument("files and equations together: expected one or the other");
    return {files, functions};
}

// Throws like module::pack(), in one line for what Vulkan alone refuses: uniforms outside blocks.
std::string packed_text(const std::vector<fs::path>& files, const source::PackRequest& request,
                        const std::vector<fs::path>& roots, const std::vector<std::string>& defines) {
    try {
        return module::pack(files, request, roots, defines);
    } catch (const source::CompileError& error) {
        const std::string what = error.what();
        if (what.find("non-opaque uniforms") == std::string::npos) throw;
        throw std::invalid_argument(what.substr(0, what.find('\n')) + "; for OpenGL take --version 430");
    }
}

std::optional<module::Target> target_of(const PackOptions& options) {
    if (options.target.empty()) return std::nullopt;
    const auto target = module::target_from(options.target);
    if (!target)
        throw std::invalid_argument("unknown target \"" + options.target + "\": expected hlsl or msl");
    if (options.version != "450")
        throw std::invalid_argument("--target " + options.target +
                                    " translates GLSL 450; it takes no --version");
    return target;
}

}  // namespace

void pack_files(const PackOptions& options, EquationsNamed* equations) {
    if (options.files.empty())
        throw std::invalid_argument("nothing to pack: give files, or --effect for all passes of the effect");
    const auto language = source::language_from(options.version);
    if (!language)
        throw std::invalid_argument("unknown GLSL version \"" + options.version +
                                    "\": expected 450, 430, 330, 150, 300es, 310es or 320es");
    const std::optional<module::Target> target = target_of(options);
    std::vector<fs::path> roots{glsl_directory()};
    roots.insert(roots.begin(), options.includes.begin(), options.includes.end());
    const auto [files, functions] = find_all(options, roots, equations);
    source::PackRequest request{.language = *language, .functions = functions};
    for (const fs::path& file : files) {
        // As in check and audit, "#include <sub/x.glsl>" may name a file beside the one that is given.
        roots.insert(roots.begin(), fs::absolute(file).parent_path());
        if (!request.stage) request.stage = source::stage_of_file(file);
    }
    const record::OutputFile out(options.out);
    const std::string packed = base::tried(files.front(), [&] {
        const std::string text = packed_text(files, request, roots, options.defines);
        if (source::code_lines(text) <= 1)  // its #version
            throw std::invalid_argument(files.front().string() +
                                        ": nothing was packed: expected a text with more than comments");
        if (!target) return text;
        return module::translated({.name = files.front().string(), .text = text}, *target,
                                  request.stage.value_or(source::Stage::compute));
    });
    const std::string text = with_version(packed, target ? std::nullopt : language);
    if (options.out.empty()) {
        fmt::print("{}", isatty(STDOUT_FILENO) != 0 ? base::for_terminal(text) : text);
    } else {
        out.write(text);
    }
}

std::string line_table(const std::vector<std::string>& files) {
    const fs::path glsl = glsl_directory();
    std::string text = "| file | lines of code |\n| --- | --- |\n";
    std::vector<std::string> all;
    for (const std::string& name : files) {
        std::error_code none;
        const fs::path file =
            fs::is_regular_file(name, none) ? fs::path(name) : module::resolve_include(name, {}, {glsl});
        all.push_back(module::pack({file}, {.functions = {}}, {glsl}));
        text += fmt::format("| `{}` | {} |\n", name, source::code_lines(all.back()));
    }
    return text + fmt::format("| together | {} |\n", source::code_lines(all));
}

std::string with_version(std::string text, std::optional<source::Language> language) {
    using enum source::Language;
    static const std::map<source::Language, const char*> names{{vulkan450, "Vulkan"},
                                                               {gl430, "OpenGL 4.3"},
                                                               {gl330, "OpenGL 3.3"},
                                                               {gl150, "OpenGL 3.2"},
                                                               {es300, "OpenGL ES 3.0 and WebGL2"},
                                                               {es310, "OpenGL ES 3.1"},
                                                               {es320, "OpenGL ES 3.2"}};
    const std::string api = language ? std::string(" for ") + names.at(*language) : "";
    const std::size_t place = text.starts_with("#version") ? text.find('\n') + 1 : 0;
    return text.insert(place, fmt::format("// Packed by gloam {}{}.\n", base::version(), api));
}

std::vector<Option> pack_options(PackOptions& options) {
    return {
        {"file", &options.files,
         "includes or whole shaders, as paths or as gloam/..., or equations (gloam list equations)"},
        {"--function", &options.functions, repeated,
         "only this function and what it uses (default: main, else every function of the files); may be "
         "repeated"},
        include_option(options.includes),
        define_option(options.defines),
        {"--version", &options.version, "450 (Vulkan), 430 (OpenGL), 330, 150, 300es, 310es or 320es"},
        {"--target", &options.target,
         "hlsl or msl: translated to HLSL of shader model 6.0 or to Metal's language"},
        {"--out", &options.out, "file to write (standard output when not given); with --effect the folder"}};
}

}  // namespace gloam::cli
