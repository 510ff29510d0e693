// SPDX-License-Identifier: MIT
#include "base/process.hpp"
#include "support/test.hpp"

#include <unistd.h>

#include <csignal>
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

TEST(Apart, ACrashIsAnError) {
    const auto crash = []() -> std::string {
        std::signal(SIGSEGV, SIG_DFL);
        std::raise(SIGSEGV);
        return "";
    };
    expect_error<LimitError>([&] { (void)run_apart(crash, few); }, {"SEGV"});
    EXPECT_THAT([] { (void)run_apart([]() -> std::string { _exit(0); }, few); },
                testing::Throws<LimitError>());
}

TEST(Apart, TimeIsLimited) {
    const auto spin = []() -> std::string {
        while (std::clock() < 3600 * CLOCKS_PER_SEC) {
        }
        return "";
    };
    EXPECT_THAT([&] { (void)run_apart(spin, few); }, ThrowsMessage<LimitError>("takes more than 1 s"));
    const auto sleep = []() -> std::string {
        std::this_thread::sleep_for(60s);
        return "";
    };
    EXPECT_THAT([&] { (void)run_apart(sleep, {.cpu = 1s, .patience = 100ms}); },
                testing::Throws<LimitError>());
}

TEST(Apart, MemoryIsLimited) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer takes all of the address space";
#endif
    const auto take = [] {
        std::vector<char> much(std::size_t{300} << 20, 'x');
        return std::string(1, much[much.size() / 2]);
    };
    EXPECT_THAT([&] { (void)run_apart(take, few); },
                ThrowsMessage<LimitError>("takes more than 200 MiB of memory"));
}

}  // namespace gloam::base::apart_test
