// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// `gloam completion bash`: prints a bash script that completes commands, options, and the names that options
// accept. It is generated from the commands that `app` has when it runs, without hidden ones.
void add_completion(CLI::App& app);

}  // namespace gloam::cli
