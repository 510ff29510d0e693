// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "source/declarations.hpp"
#include "source/excerpts.hpp"

namespace gloam::source::internal {

// Variables of a text's interface as variables at file scope that any function may set.
struct PlainGlobals {
    std::string text;                      // "float gain; vec4 tint;"
    std::map<std::string, Access> access;  // of each, by its name in the text
};

// The plain variables in place of a declaration of kind `interface`: a loose uniform, stage input or output;
// a block without an instance (each member is one), or with one (a structure of the block's name). Layouts,
// storage qualifiers and initial values are dropped. A specialization constant becomes a constant. nullopt
// for samplers, images, references to buffers and other types without values; `opaque`: these, by macros that
// stand for them. nullopt also where nothing is declared.
[[nodiscard]] std::optional<PlainGlobals> plain_globals(const Declaration& one,
                                                        const std::map<std::string, std::string>& opaque);

// The samplers, or images of two dimensions and 32 bits, that a declaration declares; nullopt for any other
// declaration, for arrays of images, and for arrays of arrays.
[[nodiscard]] std::optional<std::vector<BoundVariable>> bound_variables(
    const Declaration& one, const std::map<std::string, std::string>& opaque);

// Macros that turn accesses to images of two dimensions into those to the invocation's layer, `image_layer`.
[[nodiscard]] std::string image_macros();

// Whether the word is a type without values: "sampler2D", "uimageBuffer", "atomic_uint".
[[nodiscard]] bool is_opaque(std::string_view word);

}  // namespace gloam::source::internal
