// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "module/internal/editable.hpp"

// The changes of metamorphic.hpp. Each finds a place by chance and returns whether it found one.
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

// A place of an instruction.
struct Spot {
    std::size_t function = 0;
    std::size_t block = 0;
    std::size_t op = 0;
};

struct Change {
    std::string_view name;
    bool (*make)(Editable& module, Chance& chance);
};

// All instructions of all functions that a test accepts.
template <class Accepts>
[[nodiscard]] std::vector<Spot> spots(const Editable& module, const Accepts& accepts) {
    std::vector<Spot> found;
    for (std::size_t f = 0; f < module.functions.size(); ++f)
        for (std::size_t b = 0; b < module.functions[f].blocks.size(); ++b)
            for (std::size_t i = 0; i < module.functions[f].blocks[b].ops.size(); ++i)
                if (accepts(module.functions[f].blocks[b].ops[i])) found.push_back({f, b, i});
    return found;
}

// Instructions that calculate a false that no compiler knows, for a place in a function: whether the kernel
// has no inputs. In a module that is no kernel of gloam, or by chance, it is the constant.
struct Opaque {
    std::vector<Op> ops;  // to insert before its use
    Id id = 0;
};
[[nodiscard]] Opaque opaque_false(Editable& module, Chance& chance);

// A type of numbers or truth values: scalars, vectors and matrices of them.
[[nodiscard]] bool is_of_numbers(const Editable& module, Id type);

[[nodiscard]] const std::vector<Change>& changes_of_values();
[[nodiscard]] const std::vector<Change>& changes_of_flow();

}  // namespace gloam::shader::internal
