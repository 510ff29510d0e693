// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// `gloam pack FILE...`: one self-contained GLSL file on standard output.
void add_pack(CLI::App& app);

}  // namespace gloam::cli
