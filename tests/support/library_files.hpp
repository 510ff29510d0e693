// SPDX-License-Identifier: MIT
#pragma once

#include "support/test_name.hpp"

namespace gloam::test {

// Every file of glsl/gloam as an #include names it, sorted: "gloam/gather/pixels.glsl".
inline std::vector<std::string> library_files() {
    const std::filesystem::path root(GLOAM_GLSL_DIR);
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::recursive_directory_iterator(root / "gloam")) {
        if (file.path().extension() == ".glsl")
            names.push_back(file.path().lexically_relative(root).generic_string());
    }
    std::ranges::sort(names);
    return names;
}

// The file's name as the name of a test's parameter: "gather_pixels".
inline std::string library_file_name(const testing::TestParamInfo<std::string>& info) {
    std::filesystem::path path(info.param);
    return test_name(path.replace_extension().lexically_relative("gloam").generic_string());
}

}  // namespace gloam::test
