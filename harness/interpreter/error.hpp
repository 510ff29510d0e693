// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace gloam::interpreter {

// Where an instruction comes from.
struct Place {
    std::string function;  // its name in the module; empty outside of functions
    std::string file;      // of the source; empty where the module does not tell (OpLine)
    unsigned line = 0;     // 0 where the module does not tell
    std::size_t word = 0;  // of the instruction in the module
};

// "blend (gloam/temporal/blend.glsl:12)", or the word of the module where it has no lines.
[[nodiscard]] std::string to_text(const Place& place);

// A module that cannot be run, or a run that cannot go on.
class Error : public std::runtime_error {
  public:
    enum class Kind {
        unknown_instruction,  // an instruction, type or decoration that the interpreter does not know
        malformed,            // no valid module
        missing,              // no such entry point, function, buffer or image
        out_of_bounds,        // an access outside an array, a buffer or an image
        too_many_steps        // more instructions than the limit: a loop that nothing ends
    };

    Error(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    Error(Kind kind, const std::string& message, const Place& place)
        : std::runtime_error(message + ", in " + to_text(place)), kind_(kind) {}

    [[nodiscard]] Kind kind() const { return kind_; }

  private:
    Kind kind_;
};

}  // namespace gloam::interpreter
