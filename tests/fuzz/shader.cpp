// SPDX-License-Identifier: MIT
// The front end of the framework, as far as it is ours: lines, directives, includes, one text of many.
// (glslang runs apart from the process, see harness/shader/internal/compiler_process.hpp.)
#include "fuzz/fuzz.hpp"
#include "shader/include.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(fuzz::text_of(data, size));
    const auto& file = fuzz::file_of(text, ".glsl");
    const std::vector<std::filesystem::path> roots{file.parent_path()};
    fuzz::read_or_refuse([&] { (void)shader::include_closure(text, roots, file.parent_path()); });
    fuzz::read_or_refuse([&] {
        const std::string once = shader::flatten(std::vector<std::filesystem::path>{file}, roots);
        (void)shader::flatten({.name = "once", .text = once}, roots);
    });
    return 0;
}
