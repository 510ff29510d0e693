// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// `gloam list [KIND]`: equations, methods, presets, scenes, variants.
void add_list(CLI::App& app);

}  // namespace gloam::cli
