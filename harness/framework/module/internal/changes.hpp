// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "module/internal/editable.hpp"

// The changes of metamorphic.hpp.
namespace gloam::shader::internal {

// Numbers that are equal on every machine for the same seed.
class Chance {
  public:
    explicit Chance(std::uint64_t seed) : engine_(seed) {}
    [[nodiscard]] std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
    template <class T>
    [[nodiscard]] const T& of(const std::vector<T>& all) {
        return all[below(all.size())];
    }

  private:
    std::mt19937_64 engine_;
};

struct Change {
    std::string_view name;
    // Whether it can be made at this instruction; of one that changes a block, at its label.
    bool (*accepts)(const Editable& module, const Spot& spot);
    // Makes it at such a place; false: it could not be made there.
    bool (*make)(Editable& module, const Spot& spot, Chance& chance);
};

// Instructions that calculate a false that no compiler knows, for a place in a function: whether the kernel
// has no inputs. In a module that is no kernel of gloam, or by chance, it is the constant.
struct Opaque {
    std::vector<Op> ops;  // to insert before its use
    Id id = 0;
};
[[nodiscard]] Opaque opaque_false(Editable& module, Chance& chance);

[[nodiscard]] const std::vector<Change>& changes_of_values();
[[nodiscard]] const std::vector<Change>& changes_of_flow();

}  // namespace gloam::shader::internal
