// SPDX-License-Identifier: MIT
#include "scene/pass_library.hpp"

#include <stdexcept>

#include "shader/include.hpp"
#include "shader/pack.hpp"

namespace gloam::scene {
namespace {

shader::Stage stage_of(const std::filesystem::path& file) {
    const std::string suffix = file.extension().string();
    if (suffix == ".comp") return shader::Stage::compute;
    if (suffix == ".vert") return shader::Stage::vertex;
    if (suffix == ".frag") return shader::Stage::fragment;
    throw std::invalid_argument("pass " + file.string() + ": expected the suffix .comp, .vert or .frag");
}

std::string lines_of(const std::vector<std::string>& defines) {
    std::string lines;
    for (const std::string& name : defines) lines += "#define " + name + "\n";
    return lines;
}

// Inserts the definitions behind the #version line, which must remain the first.
std::string with_defines(const std::string& text, const std::vector<std::string>& defines) {
    if (defines.empty()) return text;
    const std::size_t version = text.find("#version");
    const std::size_t end = version == std::string::npos ? std::string::npos : text.find('\n', version);
    if (end == std::string::npos) throw std::invalid_argument("a pass without a #version line");
    return text.substr(0, end + 1) + lines_of(defines) + text.substr(end + 1);
}

std::string with_include(std::string text, const PassLibrary::Replacement& replacement) {
    const std::string line = "#include \"" + replacement.include + "\"";
    const std::size_t at = text.find(line);
    if (at == std::string::npos) throw std::invalid_argument("a pass without the line " + line);
    return text.replace(at, line.size(), "#include \"" + replacement.instead + "\"");
}

}  // namespace

PassLibrary::PassLibrary(std::filesystem::path glsl, const std::filesystem::path& cache,
                         shader::Optimization optimization)
    : glsl_(std::move(glsl)), cache_(cache), optimization_(optimization) {}

PassLibrary PassLibrary::with(shader::Optimization optimization) const {
    PassLibrary other = *this;
    other.optimization_ = optimization;
    return other;
}

PassLibrary PassLibrary::reading(Inputs inputs) const {
    PassLibrary other = *this;
    other.inputs_ = inputs;
    return other;
}

PassLibrary PassLibrary::unrolled() const {
    return optimization_ == shader::Optimization::hoisting ? with(shader::Optimization::unrolling) : *this;
}

shader::Source PassLibrary::source(const std::string& name, const std::vector<std::string>& defines,
                                   const std::vector<Replacement>& replacements) const {
    const std::filesystem::path file = glsl_ / "passes" / name;
    std::string text = with_defines(shader::read_text(file), defines);
    for (const Replacement& replacement : replacements) text = with_include(std::move(text), replacement);
    return {.name = file.string(), .text = text};
}

std::string PassLibrary::text(const std::string& name, const std::vector<std::string>& defines,
                              const std::vector<Replacement>& replacements,
                              const std::map<std::uint32_t, std::uint32_t>& constants,
                              shader::Language language) const {
    return shader::pack({{.name = "defines", .text = lines_of(defines)}, source(name, {}, replacements)},
                        {.language = language, .stage = stage_of(name), .constants = constants}, {glsl_});
}

shader::Spirv PassLibrary::compile(const std::string& name, const std::vector<std::string>& defines,
                                   const std::vector<Replacement>& replacements) const {
    return cache_.compile(
        source(name, defines, replacements),
        {.stage = stage_of(name), .include_roots = {glsl_}, .variant = {.optimization = optimization_}});
}

}  // namespace gloam::scene
