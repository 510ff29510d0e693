// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shader/language.hpp"

namespace gloam::shader {

struct PackRequest {
    Language language = Language::vulkan450;
    // The functions that are wanted, with what they reach. Empty: main of the texts where they have one, else
    // every function that they define themselves; of texts without a function, all that they declare.
    std::vector<std::string> functions;
    std::optional<Stage> stage;  // of a text with a main; empty: usual_stage()
    // Bits of specialization constants by their number: the value that the text gives them. Others stay.
    std::map<std::uint32_t, std::uint32_t> constants{};
};

// One text without includes and conditions, of that version: its #version line, licences, #extension lines,
// the comment at the head of the texts; then what whoever uses it has to give (bindings, specialization
// constants, the structures that the functions take, the prototypes without a body) and the rest, each after
// what it uses. What the functions do not reach is left out; comments stay with what they stand above. A name
// is taken for a use of everything that has it: more may stay than is used, never less. The text has been
// compiled. Throws CompileError (of the texts as they are, where the fault lies there), std::invalid_argument
// for a function that the texts do not have, std::runtime_error for a file that cannot be read.
[[nodiscard]] std::string pack(const std::vector<std::filesystem::path>& files, const PackRequest& request,
                               const std::vector<std::filesystem::path>& roots);
[[nodiscard]] std::string pack(const std::vector<Source>& sources, const PackRequest& request,
                               const std::vector<std::filesystem::path>& roots);

// Lines that hold more than blanks and comments.
[[nodiscard]] std::size_t code_lines(std::string_view text);

}  // namespace gloam::shader
