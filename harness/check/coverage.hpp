// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gloam::check {

// The part of a function, and of all that it calls, that the inputs of a check reach.
struct Coverage {
    std::size_t inputs = 0;  // inputs that were run: until everything was reached, for about a second at most

    // A line, or one way of a branch in it: each side of a condition, each case of a switch.
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

// "lines 12 of 12, branches 7 of 8", and a line of text for each missed point.
[[nodiscard]] std::string to_text(const Coverage& coverage);

}  // namespace gloam::check
