// SPDX-License-Identifier: MIT
// gloam-sheet FOLDER: the sheet of `gloam demo` alone. tools/run draws it before the rest of the program is
// compiled, and goes on where it cannot: the program tries each driver apart, this one does not.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "cli/environment.hpp"
#include "cli/occlusion/render.hpp"

int main(int argc, char** argv) {
    using namespace gloam;
    try {
        if (argc != 2) throw std::invalid_argument("expected a folder");
        record::OutputFolder out(argv[1]);
        const backend::vulkan::Device device({.cache_directory = cli::cache_directory()});
        const cli::RenderOptions options = cli::demo_options(true);
        out.write("sheet.png",
                  cli::sheet_of({cli::render(options, open_input(options), device, nullptr).front()}));
        out.keep();
        fmt::print("sheet     {}/sheet.png (one picture; the rest follows)\n", argv[1]);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "gloam-sheet: {}\n", error.what());
        return 2;
    }
}
