// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// `gloam demo`: renders three scenes, checks the default device, and makes a page of both. `status` receives
// 0, or 1 when a check failed.
void add_demo(CLI::App& app, int& status);

}  // namespace gloam::cli
