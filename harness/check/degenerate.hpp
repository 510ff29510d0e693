// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "check/signature.hpp"
#include "check/values.hpp"
#include "numeric/random.hpp"

namespace gloam::check {

// Inputs that independent draws hardly ever produce: vectors that are equal, opposite or parallel to each
// other or lie along an axis; numbers of a struct that are zero, negative, infinite or NaN; images whose
// sides are 0 or 1. Parameters with Values::only_as_drawn are not changed.
class Degenerate {
  public:
    Degenerate() = default;
    // One Values for each in and inout parameter of the signature.
    Degenerate(const Signature& signature, const std::vector<Values>& parameters);

    // Changes of one number: how many there are, and applying one of them to an input.
    [[nodiscard]] std::size_t count() const { return changes_.size(); }
    void change(std::size_t i, std::span<Word> row) const;

    // Replaces one vector, chosen at random, by an axis or by another vector of the input, if its Values
    // admit the result. Values without a test admit every vector of the same length. Returns whether a vector
    // was changed.
    bool relate(numeric::Random& random, std::span<Word> row) const;

  private:
    enum class Kind { zero, negative, infinite, nan, one };
    struct Change {
        std::size_t word;
        Kind kind;
    };
    struct Vector {
        std::size_t first;
        std::size_t size;
        const Values* values;  // null: it may not be changed
    };
    void add_struct(const shader::Type& type, std::size_t first);
    void add_vectors(const shader::Type& type, std::size_t first, const Values* values);
    void add_sides(const Values& values, std::size_t first);

    std::shared_ptr<const std::vector<Values>> parameters_;
    std::vector<Change> changes_;
    std::vector<Vector> vectors_;
};

}  // namespace gloam::check
