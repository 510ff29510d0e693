// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds `gloam explain FILE FUNCTION VALUE...`: what a shader function does with one input, operation by
// operation.
void add_explain(CLI::App& app);

}  // namespace gloam::cli
