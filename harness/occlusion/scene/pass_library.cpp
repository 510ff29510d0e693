// SPDX-License-Identifier: MIT
#include "scene/pass_library.hpp"

#include <stdexcept>

#include "module/include.hpp"
#include "module/texts.hpp"

namespace gloam::scene {
namespace {

std::string lines_of(const std::vector<std::string>& defines) {
    std::string lines;
    for (const std::string& name : defines) lines += "#define " + name + "\n";
    return lines;
}

}  // namespace

PassLibrary::PassLibrary(std::filesystem::path glsl, const std::filesystem::path& cache)
    : glsl_(std::move(glsl)), cache_(cache) {}

PassLibrary PassLibrary::with(module::Optimization optimization) const {
    PassLibrary other = *this;
    other.optimization_ = optimization;
    return other;
}

PassLibrary PassLibrary::unrolled() const {
    return optimization_ == module::Optimization::hoisting ? with(module::Optimization::unrolling) : *this;
}

source::Source PassLibrary::source(const std::string& name,
                                   const std::vector<Replacement>& replacements) const {
    const std::filesystem::path file = glsl_ / "passes" / name;
    std::string text = module::read_text(file);
    for (const Replacement& replacement : replacements) {
        const std::string line = "#include \"" + replacement.include + "\"";
        const std::size_t at = text.find(line);
        if (at == std::string::npos) throw std::invalid_argument("a pass without the line " + line);
        text.replace(at, line.size(), "#include \"" + replacement.instead + "\"");
    }
    return {.name = file.string(), .text = text};
}

std::string PassLibrary::text(const std::string& name, const std::vector<std::string>& defines,
                              const std::vector<Replacement>& replacements,
                              const std::map<std::uint32_t, std::uint32_t>& constants,
                              source::Language language) const {
    return module::pack({{.name = "defines", .text = lines_of(defines)}, source(name, replacements)},
                        {.language = language, .stage = source::stage_of_file(name), .constants = constants},
                        {glsl_});
}

module::Spirv PassLibrary::compile(const std::string& name, const std::vector<std::string>& defines,
                                   const std::vector<Replacement>& replacements) const {
    source::Source pass = source(name, replacements);
    // The #version line must remain the first.
    pass.text.insert(pass.text.find('\n', pass.text.find("#version")) + 1, lines_of(defines));
    return cache_.compile(pass, {.stage = source::stage_of_file(name).value(),
                                 .include_roots = {glsl_},
                                 .variant = {.optimization = optimization_}});
}

}  // namespace gloam::scene
