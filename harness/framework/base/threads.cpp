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

namespace {

// Shared by the threads of one call.
struct Queue {
    std::size_t count;
    const std::function<void(std::size_t)>& work;
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;
    std::exception_ptr failure;

    // Does the next item. Returns false if none is left.
    bool step() {
        const std::size_t index = next++;
        if (index >= count || failed) return false;
        try {
            work(index);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            failed = true;
        }
        return true;
    }
};

}  // namespace

void for_each_index(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                    const std::function<void(double)>& progress) {
    Queue queue{.count = count, .work = work};
    const std::size_t wanted = threads > 0 ? threads : processors();
    double told = 0.0;
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < std::min(wanted, count); ++i) {
            others.emplace_back([&queue] {
                while (queue.step()) {
                }
            });
        }
        while (queue.step()) {
            const auto begun = static_cast<double>(std::min<std::size_t>(queue.next, count));
            told = begun / static_cast<double>(count);
            if (progress) progress(told);
        }
    }
    if (queue.failure) std::rethrow_exception(queue.failure);
    if (progress && told < 1.0) progress(1.0);  // the other threads may have taken every item
}

}  // namespace gloam::base
