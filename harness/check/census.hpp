// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/scalars.hpp"

namespace gloam::check {

// The class of an input: the most unusual of its float values, in this order (NaN is the most unusual).
enum class InputClass { ordinary, branch, zero, subnormal, huge, infinite, nan };
inline constexpr std::size_t input_class_count = 7;

[[nodiscard]] constexpr std::string_view name_of(InputClass input_class) {
    constexpr std::array<std::string_view, input_class_count> names{
        "ordinary", "branch", "zero", "subnormal", "huge", "infinite", "nan"};
    return names.at(static_cast<std::size_t>(input_class));
}

// One evaluated input and how far it was off.
struct Sample {
    std::size_t index = 0;  // position in its run
    InputClass input_class = InputClass::ordinary;
    std::string scenario;  // images it ran with; empty without images
    std::vector<Word> inputs;
    std::vector<Word> got;
    std::vector<double> want;
    double ulp = 0.0;  // worst of its outputs
    double absolute = 0.0;
    double fraction = 0.0;  // of the budget; above 1 is outside
};

struct ClassCount {
    std::size_t inputs = 0;
    std::size_t outside = 0;   // failed
    std::size_t recorded = 0;  // the device promises nothing here, so it was not judged
};

// What a check found, by class of input.
struct Census {
    std::array<ClassCount, input_class_count> classes{};
    double max_ulp = 0.0;         // over judged outputs that the absolute part of the budget does not cover
    double max_absolute = 0.0;    // over judged outputs
    double fraction = 0.0;        // worst error as a fraction of the budget
    std::optional<Sample> worst;  // largest fraction
    std::array<std::optional<Sample>, input_class_count> first_outside;  // first failure of each class

    [[nodiscard]] std::size_t inputs() const;
    [[nodiscard]] std::size_t outside() const;
    [[nodiscard]] std::size_t recorded() const;

    // Adds a judged sample; `outside` when it failed.
    void add(const Sample& sample, bool is_outside);
    void add_recorded(InputClass input_class) { ++count(input_class).inputs, ++count(input_class).recorded; }
    // Adds what another part of the same run found; parts are merged in the order of their inputs.
    void merge(const Census& later);

  private:
    ClassCount& count(InputClass input_class) { return classes.at(static_cast<std::size_t>(input_class)); }
};

}  // namespace gloam::check
