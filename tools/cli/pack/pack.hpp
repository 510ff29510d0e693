// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace gloam::cli {

// `gloam pack FILE...`: one self-contained GLSL file on standard output.
void add_pack(CLI::App& app);

}  // namespace gloam::cli
