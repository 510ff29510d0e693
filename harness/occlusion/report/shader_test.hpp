// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/amber.hpp"

namespace gloam::report {

// One run of a generated OpenGL kernel for a single input.
struct ShaderReplay {
    std::string glsl;  // a compute shader; or a fragment shader that draws green if the results are allowed
    bool compute = true;
    std::string version;       // of the interface, as piglit requires it: "GL >= 4.5", "GL ES >= 3.0"
    std::string glsl_version;  // "GLSL >= 4.50", "GLSL ES >= 3.00"
    KernelReplay kernel;       // its comments, inputs, images and outputs
};

// A script for piglit's shader_runner (https://piglit.freedesktop.org). With a compute shader it probes that
// each output lies in its range, ends included; with a fragment shader that the picture is green. Run it with
// `shader_runner -auto -fbo -ignore-missing-uniforms FILE`, or shader_runner_gles3 for OpenGL ES.
[[nodiscard]] std::string to_shader_test(const ShaderReplay& replay);

}  // namespace gloam::report
