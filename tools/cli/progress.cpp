// SPDX-License-Identifier: MIT
#include "cli/progress.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "cli/environment.hpp"

namespace gloam::cli {

std::function<void(double)> progress_bar(std::string what) {
    if (!on_terminal()) return [](double) {};
    return [what = std::move(what), shown = -1](double part) mutable {
        constexpr int steps = 40;
        const int percent = static_cast<int>(100.0 * part);
        if (percent == shown) return;
        shown = percent;
        const int done = static_cast<int>(steps * part);
        fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {} %\033[K", what, "", done, "", steps - done, percent);
        if (percent >= 100) fmt::print(stderr, "\r\033[K");
        std::fflush(stderr);
    };
}

}  // namespace gloam::cli
