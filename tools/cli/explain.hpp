// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds `gloam explain FILE FUNCTION VALUE...`: the operations of a shader function on one input.
void add_explain(CLI::App& app);

}  // namespace gloam::cli
