// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/lines.hpp"
#include "source/text.hpp"

namespace gloam::source {

struct PackRequest {
    Language language = Language::vulkan450;
    // The requested functions; what they use is included. Empty: main of the texts if there is one, otherwise
    // all functions that the texts define themselves; for texts without functions, all declarations.
    std::vector<std::string> functions;
    std::optional<Stage> stage;  // of a text with a main; empty: usual_stage()
    // Values of specialization constants by their number, as bits. Others keep the value of the text.
    std::map<std::uint32_t, std::uint32_t> constants{};
};

// One text of this version without includes and conditions. Its order: the #version line, licences,
// #extension lines, a comment that says what to call and what to define where there are prototypes without a
// body, and the comment at the head of the texts; then what the user has to supply (those prototypes,
// bindings, specialization constants, structures of the functions' parameters); then the rest. Each
// declaration follows those that it uses.
// Declarations that the functions do not use are dropped, except constants and macros that a kept comment
// names: "FX_STEP", or "FX_FALLOFF_*" for all that begin so. Comments stay with the declaration below them. A
// name counts as a use of every declaration with this name, so the result can contain unused declarations,
// but lacks none.
// Throws std::invalid_argument for a function that the texts do not have. `main`: whether it has one.
struct Packed {
    std::string text;
    bool main = false;
};
[[nodiscard]] Packed packed(const ActiveText& texts, const PackRequest& request);

// A text without comments, indents and blank lines; and the number of its lines.
[[nodiscard]] std::string code_of(std::string_view text);
[[nodiscard]] std::size_t code_lines(std::string_view text);
// Such lines of all texts that pack() wrote: a function, structure, constant or macro counts once.
[[nodiscard]] std::size_t code_lines(const std::vector<std::string>& packed);

}  // namespace gloam::source
