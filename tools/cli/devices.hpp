// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// `gloam devices`: the Vulkan devices here and what they report of their float arithmetic.
void add_devices(CLI::App& app);

}  // namespace gloam::cli
