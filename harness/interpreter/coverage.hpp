// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "interpreter/error.hpp"
#include "interpreter/program.hpp"

namespace gloam::interpreter {

// Which instructions of a program ran, and which ways its branches went, over all runs that were given it
// (Machine<float>::run). What runs only in some copies of a function counts as having run.
class Coverage {
  public:
    explicit Coverage(const Program& program);

    // One way that a branch of the source may go: both of a condition, each case of a switch.
    struct Way {
        Place place;
        std::string way;         // "true", "false", "case 3", "default"
        std::size_t branch = 0;  // position among the branches of that line, from 1
        bool reached = false;
    };
    // In the order of the module. Conditions of ?: that chooses between two values are branches, too.
    [[nodiscard]] std::vector<Way> ways() const;

    struct Line {
        Place place;
        bool reached = false;
    };
    // Each line of the source that has an instruction, once.
    [[nodiscard]] std::vector<Line> lines() const;

    // Whether every way was gone and every line reached.
    [[nodiscard]] bool is_complete() const;

    // Counts an instruction that ran, by its position, and what followed: the next instruction, or, of a
    // choice between values, its condition (of each component, where they have their own).
    void add(std::size_t instruction, std::uint32_t next);

  private:
    Program program_;
    std::vector<char> ran_;                         // by instruction
    std::vector<std::vector<std::uint32_t>> ways_;  // by instruction: targets of a branch, else nothing
    std::vector<std::vector<char>> gone_;
};

}  // namespace gloam::interpreter
