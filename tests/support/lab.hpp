// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "check/shader_test.hpp"

namespace gloam::test {

// Where compiled shaders are kept between tests; empty when the environment does not say.
inline std::filesystem::path cache_directory() {
    const char* directory = std::getenv("GLOAM_CACHE_DIR");
    return directory == nullptr ? std::filesystem::path{} : std::filesystem::path(directory);
}

// A lab on the default device (or $GLOAM_TEST_DEVICE) with the validation layers on, the shader library, and
// the fixtures of the test's own folder, when it has some; its shaders compiled in that variant.
inline check::Lab make_lab(const std::filesystem::path& fixtures = {}, const shader::Variant& variant = {}) {
    const char* device = std::getenv("GLOAM_TEST_DEVICE");
    check::LabOptions options{.device = device == nullptr ? "" : device,
                              .validation = true,
                              .include_roots = {GLOAM_GLSL_DIR},
                              .cache_directory = cache_directory(),
                              .variant = variant};
    if (!fixtures.empty()) options.include_roots.push_back(fixtures);
    return check::Lab(std::move(options));
}

}  // namespace gloam::test
