// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace gloam::interpreter {

// The place of an instruction.
struct Place {
    std::string function;  // its name in the module; empty outside of functions
    std::string file;      // of the source; empty if the module does not state it (OpLine)
    unsigned line = 0;     // 0 if the module does not state it
    std::size_t word = 0;  // of the instruction in the module
};

// "blend (gloam/temporal/blend.glsl:12)", or the position in the module if it has no lines.
[[nodiscard]] std::string to_text(const Place& place);

// A module that cannot be run, or a run that cannot continue.
class Error : public std::runtime_error {
  public:
    enum class Kind {
        unknown_instruction,  // an instruction, type or decoration that the interpreter does not know
        malformed,            // an invalid module
        missing,              // no such entry point, function, buffer or image
        out_of_bounds,        // an access outside an array, a buffer or an image
        too_many_steps        // more instructions than the limit, for example an endless loop
    };

    Error(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    Error(Kind kind, const std::string& message, const Place& place)
        : std::runtime_error(message + ", in " + to_text(place)), kind_(kind) {}

    [[nodiscard]] Kind kind() const { return kind_; }

  private:
    Kind kind_;
};

}  // namespace gloam::interpreter
