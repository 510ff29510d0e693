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

}  // namespace gloam::test
