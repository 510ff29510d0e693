// SPDX-License-Identifier: MIT
#include "base/threads.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace gloam::base {

unsigned processors() {
    return std::max(1U, std::thread::hardware_concurrency());
}

std::vector<Range> shares_of(std::size_t count, std::size_t most) {
    const std::size_t share = count / most + 1;
    std::vector<Range> shares;
    for (std::size_t begin = 0; begin < count; begin += share)
        shares.push_back({begin, std::min(begin + share, count)});
    return shares;
}

void for_each_index(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                    const std::function<void(double)>& progress) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;
    std::exception_ptr failure;
    double told = 0.0;
    // Does items until none is left, or one has failed.
    const auto run = [&](bool tells) {
        for (std::size_t index = next++; index < count && !failed; index = next++) {
            try {
                work(index);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!failure) failure = std::current_exception();
                failed = true;
            }
            if (!tells) continue;
            told = static_cast<double>(std::min<std::size_t>(next, count)) / static_cast<double>(count);
            if (progress) progress(told);
        }
    };
    {
        const std::size_t wanted = threads > 0 ? threads : processors();
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < std::min(wanted, count); ++i) others.emplace_back(run, false);
        run(true);
    }
    if (failure) std::rethrow_exception(failure);
    if (progress && told < 1.0) progress(1.0);  // the other threads may have taken every item
}

}  // namespace gloam::base
