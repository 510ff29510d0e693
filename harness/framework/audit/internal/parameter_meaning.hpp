// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace gloam::audit::internal {

// The largest number where only the smallest is known, and the smallest positive number of usual size.
inline constexpr double usual_high = 1000.0;
inline constexpr double usual_low = 1e-3;

enum class Kind { range, positive, unit };

// What a name or a comment says of the components of a parameter.
struct Meaning {
    Kind kind = Kind::range;
    double low = 0.0;
    double high = 1.0;
};

// What most shaders mean by this name for a float parameter with so many components.
[[nodiscard]] std::optional<Meaning> meaning_of_name(const std::string& name, int components);

// What a comment says of the name, alone or in a list: docs/verdicts.md has the forms. `others`: names of
// parameters, at which the words about this one end.
[[nodiscard]] std::optional<Meaning> meaning_of_comment(std::string_view comment, const std::string& name,
                                                        const std::set<std::string>& others, bool is_vector);

}  // namespace gloam::audit::internal
