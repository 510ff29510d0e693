// SPDX-License-Identifier: MIT
#include "base/process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

namespace gloam::base {
namespace patience_test {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

void wait_for(const Patience& patience) {
    std::this_thread::sleep_until(patience.next_look());
}

TEST(Patience, EndsNoEarlierThanItsLimit) {
    Patience patience(10s, [] { return nanoseconds(0); });
    EXPECT_FALSE(patience.is_over());
    EXPECT_GT(patience.next_look() - Patience::Clock::now(), 5s);
}

TEST(Patience, EndsAtItsLimitForAProcessThatComputesNothing) {
    Patience patience(20ms, [] { return nanoseconds(0); });
    wait_for(patience);
    EXPECT_TRUE(patience.is_over());
}

TEST(Patience, EndsAtItsLimitForAProcessThatHasUsedIt) {
    nanoseconds used = 5s;  // before the wait: does not count
    Patience patience(20ms, [&] { return used; });
    used += 20ms;
    wait_for(patience);
    EXPECT_TRUE(patience.is_over());
}

TEST(Patience, GoesOnWhileAProcessGetsOnlyAShareOfTheProcessor) {
    nanoseconds used = 0s;
    Patience patience(20ms, [&] { return used; });
    for (int look = 0; look < 3; ++look) {
        used += 5ms;
        wait_for(patience);
        EXPECT_FALSE(patience.is_over()) << look;
    }
    used += 5ms;
    wait_for(patience);
    EXPECT_TRUE(patience.is_over());
}

TEST(Patience, EndsForAProcessThatStopsComputing) {
    nanoseconds used = 0s;
    Patience patience(20ms, [&] { return used; });
    used += 10ms;
    wait_for(patience);
    EXPECT_FALSE(patience.is_over());
    wait_for(patience);
    EXPECT_TRUE(patience.is_over());
}

TEST(ProcessorTime, GrowsWithWorkAndIsZeroForAProcessThatHasEnded) {
    const nanoseconds before = processor_time_of(getpid());
    while (processor_time_of(getpid()) < before + 20ms) {
    }
    const pid_t child = fork();
    if (child == 0) _exit(0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(processor_time_of(child), 0s);
}

}  // namespace patience_test
}  // namespace gloam::base
