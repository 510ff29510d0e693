// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace gloam::cli {

// A progress bar with the time left, on a line of standard error. Call the result with the completed part, in
// [0, 1], at any rate; at 1 the line is erased. It prints nothing if standard error is not a terminal.
[[nodiscard]] std::function<void(double)> progress_bar(std::string what);

// A progress line on standard error for `total` equal steps, "checks [120/270], about 4 min left", below the
// text on standard output: wipe() it before output is written, show() it after. It prints nothing if standard
// error is not a terminal.
class ProgressLine {
  public:
    // watched: false: no line.
    ProgressLine(std::string what, std::size_t total, bool watched = true);
    ~ProgressLine() { wipe(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    // Completes one step. `free`: it took no time, and does not affect the estimate of the time left.
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

enum class Ink { good, bad };

// The text in green or red if standard output is a terminal; plain otherwise, and if NO_COLOR is set
// (https://no-color.org) or TERM is "dumb".
[[nodiscard]] std::string colored(std::string_view text, Ink ink);

}  // namespace gloam::cli
