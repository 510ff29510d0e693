// SPDX-License-Identifier: MIT
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace gloam::cli {
namespace {

// "about 40 s", "about 12 min", "about 3 h": a duration to the nearest unit.
std::string rough_duration(std::chrono::duration<double> duration) {
    constexpr double minute = 60.0;
    constexpr double hour = 60.0 * minute;
    const double seconds = duration.count();
    if (seconds < 1.5 * minute) return fmt::format("about {:.0f} s", std::ceil(seconds));
    if (seconds < 1.5 * hour) return fmt::format("about {:.0f} min", seconds / minute);
    return fmt::format("about {:.0f} h", seconds / hour);
}

}  // namespace

std::function<void(double)> progress_bar(std::string what, bool watched) {
    if (!watched || isatty(STDERR_FILENO) == 0) return [](double) {};
    return [what = std::move(what), shown = -1,
            begin = std::chrono::steady_clock::now()](double part) mutable {
        constexpr int steps = 40;
        constexpr double enough = 0.02;  // completed part of the work from which the time left is estimated
        const int percent = part < 0.0 ? -1 : static_cast<int>(100.0 * part);
        if (percent == shown) return;
        shown = percent;
        fmt::print(stderr, "\r\033[K");
        if (percent >= 0 && percent < 100) {
            const int done = static_cast<int>(steps * part);
            fmt::print(stderr, "{} [{:#<{}}{:.<{}}] {} %", what, "", done, "", steps - done, percent);
            const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
            if (part > enough) fmt::print(stderr, ", {} left", rough_duration(spent * ((1.0 - part) / part)));
        }
        std::fflush(stderr);
    };
}

std::string colored(std::string_view text, Ink ink) {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string_view(value == nullptr ? "" : value);
    };
    if (isatty(STDOUT_FILENO) == 0 || !variable("NO_COLOR").empty() || variable("TERM") == "dumb")
        return std::string(text);
    return std::string(ink == Ink::good ? "\033[32m" : "\033[1;31m") + std::string(text) + "\033[0m";
}

}  // namespace gloam::cli
