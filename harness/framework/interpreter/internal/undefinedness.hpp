// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/internal/code.hpp"
#include "interpreter/machine.hpp"

namespace gloam::interpreter::internal {

// A fault of the running shader. The machine adds the place.
struct Fault {
    Error::Kind kind;
    std::string message;
};

// " at tone.glsl:12"; empty if the place is unknown.
[[nodiscard]] std::string where_text(const Location& place);

// Why a value that this instruction made is undefined.
[[nodiscard]] std::string cause_of(const Code& code, const Instruction& instruction);

// An operation on an undefined value has an undefined result. An origin is the instruction that made such a
// value, counted from 1; 0: it was never written.
struct Undefinedness {
    bool touched = false;  // the running instruction reads one, with this origin
    bool spread = false;   // to its result
    Word origin = 0;
    std::vector<std::pair<Word, std::uint32_t>> reads = {};  // origins, and which instruction read it first

    // The instruction reads a value with this origin.
    void touch(Word from, std::uint32_t instruction) {
        if (!touched) {
            touched = true;
            spread = false;
            origin = from;
        }
        if (!read_of(from)) reads.emplace_back(from, instruction);
    }
    // Which instruction read a value with this origin first.
    [[nodiscard]] std::optional<std::uint32_t> read_of(Word from) const {
        const auto read = std::ranges::find(reads, from, &std::pair<Word, std::uint32_t>::first);
        if (read == reads.end()) return std::nullopt;
        return read->second;
    }
};

}  // namespace gloam::interpreter::internal
