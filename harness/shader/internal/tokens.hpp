// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::shader::internal {

using Tokens = std::span<const std::string>;

// Words (names with what follows behind a '.', keywords, numbers) and single characters of a text without
// comments; lines that begin with # are passed over.
[[nodiscard]] std::vector<std::string> tokens_of(std::string_view text);

// The index behind the bracket that closes the one at `open`; the end if there is none.
[[nodiscard]] std::size_t behind_bracket(Tokens tokens, std::size_t open);

[[nodiscard]] bool contains(Tokens tokens, std::string_view word);

// The first parenthesis of a statement that starts a list of parameters: it follows a type and a name.
[[nodiscard]] std::optional<std::size_t> parameter_list(Tokens statement);

}  // namespace gloam::shader::internal
