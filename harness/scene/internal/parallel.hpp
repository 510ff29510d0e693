// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace gloam::scene {

// Calls work(0) ... work(count - 1), each once, on `threads` threads (0: as many as the machine has; the
// calling one is among them). The order is not fixed. `progress` is called on the calling thread with the
// part done, in [0, 1]. An exception of `work` is thrown on, after all threads have ended.
void for_each_index(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                    const std::function<void(double)>& progress = {});

}  // namespace gloam::scene
