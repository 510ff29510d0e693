// SPDX-License-Identifier: MIT
#include "cli/pack/line_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/pack/effect.hpp"
#include "effect/methods.hpp"
#include "shader/include.hpp"
#include "shader/pack.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

std::size_t lines_of(const fs::path& file, const fs::path& glsl, const std::vector<std::string>& functions) {
    return shader::code_lines(shader::pack({file}, {.functions = functions}, {glsl}));
}

std::string of_files(const fs::path& glsl, const std::vector<std::string>& files) {
    std::string text = "| file | lines of code |\n| --- | --- |\n";
    for (const std::string& name : files) {
        std::error_code none;
        const fs::path file =
            fs::is_regular_file(name, none) ? fs::path(name) : shader::resolve_include(name, {}, {glsl});
        text += fmt::format("| `{}` | {} |\n", name, lines_of(file, glsl, {}));
    }
    return text;
}

// Lines of the passes of a method's frame with its usual settings.
std::size_t pass_lines(const fs::path& glsl, const std::string& method) {
    const effect::Settings settings = effect::with_method(effect::Settings{}, method);
    std::size_t lines = 0;
    for (const PackedPass& pass : packed_effect(settings, {}, scene::PassLibrary(glsl)).passes)
        if (pass.plan.name == "ambient_occlusion") lines += shader::code_lines(pass.text);
    return lines;
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
        "(`ambient_occlusion.comp` of `gloam pack --effect --method NAME`). This page is written by "
        "`gloam pack --lines`.\n\n"
        "| method | function | pass |\n| --- | --- | --- |\n";
    for (const effect::MethodInfo& method : effect::methods()) {
        text += fmt::format("| {} | {} | {} |\n", method.name,
                            lines_of(glsl / file_of(method), glsl, {"gloam_" + method.name}),
                            pass_lines(glsl, method.name));
    }
    return text;
}

}  // namespace gloam::cli
