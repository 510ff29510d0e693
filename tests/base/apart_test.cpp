// SPDX-License-Identifier: MIT
#include "base/process.hpp"
#include "support/test.hpp"

#include <unistd.h>

#include <ctime>

namespace gloam::base::apart_test {

using namespace std::chrono_literals;

constexpr ProcessLimits few{.memory_bytes = std::uint64_t{200} << 20, .cpu = 1s, .patience = 20s};

TEST(Apart, GivesWhatTheWorkReturned) {
    const std::string much(3'000'000, 'x');
    EXPECT_EQ(run_apart([&] { return much; }, few), much);
    EXPECT_EQ(run_apart([] { return std::string(); }, few), "");
}

TEST(Apart, WhatTheWorkThrowsIsThrown) {
    EXPECT_THAT([] { (void)run_apart([]() -> std::string { throw std::out_of_range("beyond"); }, few); },
                ThrowsMessage<WorkError>("beyond"));
}

// A crash, and what takes too much memory: tests/tools/stories/hostile.txt.
TEST(Apart, WhatTheWorkDoesToItsProcessIsAnError) {
    using Work = std::string (*)();
    const auto expect = [](Work work, const testing::Matcher<const std::string&>& message,
                           const ProcessLimits& limits = few) {
        EXPECT_THAT([&] { (void)run_apart(work, limits); }, ThrowsMessage<LimitError>(message));
    };
    expect([]() -> std::string { _exit(0); }, testing::_);
    expect(
        []() -> std::string {
            while (std::clock() < 3600 * CLOCKS_PER_SEC) {
            }
            return "";
        },
        "takes more than 1 s");
    expect(
        []() -> std::string {
            std::this_thread::sleep_for(60s);
            return "";
        },
        testing::_, {.cpu = 1s, .patience = 100ms});
}

}  // namespace gloam::base::apart_test
