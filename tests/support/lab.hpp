// SPDX-License-Identifier: MIT
#pragma once

#include "judge/function.hpp"
#include "module/include.hpp"
#include "module/texts.hpp"
#include "support/shared_device.hpp"

namespace gloam::test {

// A lab on the shared device with the shader library, and the fixtures of the test's own folder, when it has
// some; its shaders compiled in that variant.
inline subject::Lab make_lab(const std::filesystem::path& fixtures = {},
                             const module::Variant& variant = {}) {
    subject::LabOptions options{.device = variable("GLOAM_TEST_DEVICE"),
                                .validation = true,
                                .include_roots = {GLOAM_GLSL_DIR},
                                .cache_directory = cache_directory(),
                                .variant = variant};
    if (!fixtures.empty()) options.include_roots.push_back(fixtures);
    return {std::move(options), SharedDevice::get()};
}

// The options of a lab for the functions that a fixture's file defines, as `gloam check FILE` takes them.
inline subject::LabOptions options_for(const std::filesystem::path& fixtures, const std::string& name,
                                       const module::Variant& variant = {}) {
    const std::filesystem::path file = fixtures / name;
    return {.device = variable("GLOAM_TEST_DEVICE"),
            .cache_directory = cache_directory(),
            .variant = variant,
            .file = std::make_shared<const subject::OwnFile>(file, module::read_text(file),
                                                             std::vector<std::filesystem::path>{fixtures})};
}

}  // namespace gloam::test
