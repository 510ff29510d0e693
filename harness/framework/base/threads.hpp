// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace gloam::base {

// Number of processors of this machine, at least 1.
[[nodiscard]] unsigned processors();

// From `begin` to `end` (excluded).
struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
};

// 0 ... count - 1 in consecutive ranges of equal length (the last may be shorter): at most `most`, none
// empty.
[[nodiscard]] std::vector<Range> shares_of(std::size_t count, std::size_t most);

// Calls work(0) ... work(count - 1), each once, in any order, on `threads` threads including the calling one
// (0: one for each processor). `progress` is called on the calling thread with the completed part, in [0, 1],
// and with 1 at the end. An exception of `work` is rethrown after all threads have ended.
void for_each_index(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                    const std::function<void(double)>& progress = {});

}  // namespace gloam::base
