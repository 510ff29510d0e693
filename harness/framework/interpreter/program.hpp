// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "backend/backend.hpp"
#include "base/failure.hpp"
#include "module/compile.hpp"

namespace gloam::interpreter {

// The place of an instruction.
struct Location {
    std::string function;  // its name in the module; empty outside of functions
    std::string file;      // of the source; empty if the module does not state it (OpLine)
    unsigned line = 0;     // 0 if the module does not state it
    std::size_t word = 0;  // of the instruction in the module
};

// "blend (gloam/temporal/blend.glsl:12)", or the position in the module if it has no lines.
[[nodiscard]] std::string to_text(const Location& place);

// A module that cannot be run, or a run that cannot continue.
class Error : public base::Failure {
  public:
    enum class Kind {
        unknown_instruction,  // an instruction, type or decoration that the interpreter does not know
        malformed,            // an invalid module
        missing,              // no such entry point, function, buffer or image
        out_of_bounds,        // an access outside an array, a buffer or an image
        too_many_steps,       // more instructions than the limit, for example an endless loop
        undefined,            // a branch or an index depends on a value that is undefined
        race,                 // two invocations use one word, no barrier orders them, and one writes
        divergent_barrier     // some invocations of a group do not reach a barrier at which others wait
    };

    Error(Kind kind, const std::string& message);
    Error(Kind kind, const std::string& message, const Location& place)
        : Error(kind, message + ", in " + to_text(place)) {}

    [[nodiscard]] Kind kind() const { return kind_; }
    // Whether invocations disturb each other: an error of the shader, whatever its inputs are.
    [[nodiscard]] bool is_of_group() const { return kind_ == Kind::race || kind_ == Kind::divergent_barrier; }
    // Whether the input, and not the module, stops the run: its result is undefined.
    [[nodiscard]] bool is_of_input() const {
        return kind_ == Kind::out_of_bounds || kind_ == Kind::too_many_steps || kind_ == Kind::undefined;
    }

  private:
    Kind kind_;
};

namespace internal {
struct Code;
}

using backend::Constant;

// An entry point of a SPIR-V module, decoded once for many runs (Machine). Copies share the decoded code,
// which never changes, so that any number of threads may run it.
class Program {
  public:
    // Decodes the entry point with this name and everything that it calls. Throws Error for a module that is
    // invalid (see module::validate) and for an instruction that the interpreter does not know.
    explicit Program(const module::Spirv& module, std::span<const Constant> constants = {},
                     const std::string& entry_point = "main");

    // Whether the module lets a driver contract or rearrange some float operation, because the operation is
    // not decorated with NoContraction.
    [[nodiscard]] bool may_be_rearranged() const;

    [[nodiscard]] const internal::Code& code() const { return *code_; }

  private:
    std::shared_ptr<const internal::Code> code_;
};

// Counts which instructions of a program ran and which ways its branches took, over all runs that add to it
// (Machine<float>::run). An instruction counts as run if it ran in any copy of its function.
class Coverage {
  public:
    explicit Coverage(const Program& program);

    // A line of the source with an instruction, or one way of a branch: each side of a condition, each case
    // of a switch. A conditional operator ?: that selects between two values is a branch as well.
    struct Point {
        Location place;
        std::string way;         // "true", "false", "case 3", "default"; empty: the line itself
        std::size_t branch = 0;  // position among the branches of that line, from 1
        bool reached = false;
    };
    // Each line once, then all ways in the order of the module.
    [[nodiscard]] std::vector<Point> points() const;

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
