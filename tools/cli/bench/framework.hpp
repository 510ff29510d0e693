// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the subcommand `framework`: what the shader-test framework itself costs on a device. Evaluations a
// second of a cheap and an expensive equation, also as a fraction of the rate of a bare dispatch that copies
// the same bytes, timed in turn; opening the device; and a kernel and its first result, without and with
// caches. `status` receives the exit status: 0, or 1 if the validation layers reported messages.
void add_framework(CLI::App& bench, int& status);

}  // namespace gloam::cli
