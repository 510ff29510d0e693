// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gloam::check {

// How much of a function the inputs of a check reach, of it and all that it calls.
struct Coverage {
    std::size_t inputs = 0;  // that were run: until all was reached, and not much longer than a second

    // A line, or a way that a branch of it may go: both of a condition, each case of a switch.
    struct Point {
        std::string file;
        unsigned line = 0;
        std::string text;  // of the line
        std::string way;   // "true", "false, branch 2 of the line", "case 3"; empty: the line itself
        bool reached = false;
    };
    std::vector<Point> points;

    [[nodiscard]] bool is_complete() const;
};

// "lines 12 of 12, branches 7 of 8", and a line for each that was missed.
[[nodiscard]] std::string to_text(const Coverage& coverage);

}  // namespace gloam::check
