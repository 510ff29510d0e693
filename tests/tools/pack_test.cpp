// SPDX-License-Identifier: MIT
#include "base/version.hpp"
#include "module/texts.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::pack_test {

struct OwnPreset {
    const char* name;
    std::size_t passes, fragment_files;  // the latter with tiles.vert
    std::size_t most_lines;
    bool one_api;
};
constexpr OwnPreset own_presets[] = {{"fast", 3, 3, 425, true},
                                     {"balanced", 3, 3, 425, false},
                                     {"quality", 6, 8, 600, false},
                                     {"reference", 6, 8, 600, true}};

struct Api {
    const char* version;
    const char* name;
    const char* glslang;  // options for SPIR-V; none: the text is only read
    bool fragment = false;
};
constexpr Api apis[] = {{"450", "Vulkan", "-V --target-env vulkan1.2 -o /dev/null"},
                        {"430", "OpenGL 4.3", nullptr},
                        {"330", "OpenGL 3.3", nullptr, true},
                        {"300es", "OpenGL ES 3.0 and WebGL2", nullptr, true}};

// Compiled by glslang's own program: each preset for one API, and one of each resolution for each.
using PackEffect = InFolder;
TEST_F(PackEffect, EachPresetIsShortAndCompilesForEachApi) {
    for (const auto& [preset, passes, fragment_files, most_lines, one_api] : own_presets) {
        for (const Api& api : apis) {
            if (one_api && &api != &apis[0]) continue;
            SCOPED_TRACE(std::string(preset) + " " + api.version);
            expect_success(
                gloam("pack --effect --preset {} --version {} --out {}", preset, api.version, path(preset)));
            std::vector<std::string> texts;
            for (const auto& entry : fs::directory_iterator(path(preset))) {
                const std::string text = read_file(entry.path());
                if (entry.path().extension() == ".h") {
                    EXPECT_LE(shader::code_lines(text), 175U);
                    continue;
                }
                texts.push_back(text);
                std::vector<std::string> options;
                if (api.glslang != nullptr) options = words(api.glslang);
                options.push_back(entry.path().string());
                const CommandResult result = run_program("/usr/bin/glslangValidator", options);
                EXPECT_EQ(result.status, 0) << result.out;
                EXPECT_THAT(
                    text, HasSubstr("\n// Packed by gloam " + base::version() + " for " + api.name + ".\n"));
                EXPECT_THAT(text, Not(HasSubstr("#include")));
            }
            EXPECT_EQ(texts.size(), api.fragment ? fragment_files : passes);
            EXPECT_LE(shader::code_lines(texts), most_lines);
            fs::remove_all(path(preset));
        }
    }
}

}  // namespace gloam::test::pack_test
