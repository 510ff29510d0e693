// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "interpreter/error.hpp"
#include "interpreter/program.hpp"

namespace gloam::interpreter {

// Counts which instructions of a program ran and which ways its branches took, over all runs that add to it
// (Machine<float>::run). An instruction counts as run if it ran in any copy of its function.
class Coverage {
  public:
    explicit Coverage(const Program& program);

    // One way of a branch in the source: each side of a condition, each case of a switch.
    struct Way {
        Place place;
        std::string way;         // "true", "false", "case 3", "default"
        std::size_t branch = 0;  // position among the branches of that line, from 1
        bool reached = false;
    };
    // All ways, in the order of the module. A conditional operator ?: that selects between two values is a
    // branch as well.
    [[nodiscard]] std::vector<Way> ways() const;

    struct Line {
        Place place;
        bool reached = false;
    };
    // Each line of the source with an instruction, once.
    [[nodiscard]] std::vector<Line> lines() const;

    // Whether every way was taken and every line reached.
    [[nodiscard]] bool is_complete() const;

    // Counts an executed instruction. instruction: its index. next: the instruction executed after it; for a
    // selection between values its condition (of each component, if they have separate conditions).
    void add(std::size_t instruction, std::uint32_t next);

  private:
    Program program_;
    std::vector<char> ran_;                         // by instruction
    std::vector<std::vector<std::uint32_t>> ways_;  // by instruction: targets of a branch, otherwise empty
    std::vector<std::vector<char>> gone_;
};

}  // namespace gloam::interpreter
