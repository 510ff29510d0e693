// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace gloam::cli {

// A bar on a line of standard error and the time left, for work of which the part done is known, in [0, 1]:
// call it as often as you like. Nothing where nobody watches; the line is wiped at 1.
[[nodiscard]] std::function<void(double)> progress_bar(std::string what);

// "about 40 s", "about 12 min", "about 3 h": a duration to the nearest unit.
[[nodiscard]] std::string rough_duration(std::chrono::duration<double> duration);

// A line of standard error for work of `total` equal steps, "checks [120/270], about 4 min left", below what
// standard output shows: wipe() it before output is written, show() it after. Nothing where nobody watches.
class ProgressLine {
  public:
    // watched: whether it is wanted at all.
    ProgressLine(std::string what, std::size_t total, bool watched = true);
    ~ProgressLine() { wipe(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    // One step is done. `free`: it took no time, and says nothing about the time left.
    void step(bool free);
    void show() const;
    void wipe() const;

  private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::size_t timed_ = 0;  // steps that took time
    Clock::time_point begin_ = Clock::now();
    bool watched_;
};

}  // namespace gloam::cli
