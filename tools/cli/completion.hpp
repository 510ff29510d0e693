// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// `gloam completion bash`: prints a bash script that completes commands, options, and the names that options
// take. It is made from the commands that `app` has when the command runs, the hidden ones left out.
void add_completion(CLI::App& app);

}  // namespace gloam::cli
