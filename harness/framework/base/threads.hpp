// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace gloam::base {

// Calls work(0) ... work(count - 1), each once, in any order, on `threads` threads including the calling one
// (0: one for each processor). `progress` is called on the calling thread with the completed part, in [0, 1].
// An exception of `work` is rethrown after all threads have ended.
void for_each_index(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                    const std::function<void(double)>& progress = {});

}  // namespace gloam::base
