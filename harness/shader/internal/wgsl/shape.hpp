// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "shader/internal/wgsl/facts.hpp"

namespace gloam::shader::internal::wgsl {

// A selection whose branches only calculate a value: `a && b`, `a || b`, or one of two values.
struct Fold {
    enum class Kind { conjunction, disjunction, either };
    Kind kind = Kind::either;
    Id result = 0;  // a phi, or a variable without a name
    Id condition = 0;
    Id yes = 0;  // the values; of a conjunction or disjunction `yes` is the right one
    Id no = 0;
    Id negation = 0;         // of the condition, which is not needed
    std::vector<Id> blocks;  // of the branches, in order, with those of inner folds
    Id merge = 0;
};

// An argument variable that stands for another value or variable.
struct Shape {
    // By the label of the block that ends with the selection.
    std::map<Id, Fold> folds;
    std::set<Id> idle_values;      // negations that a fold has turned round
    std::map<Id, Id> only_values;  // of phis that only one block gives a value
    std::set<Id> fold_results;     // their phis and variables
    std::map<Id, Id> straight;     // a block: the first of those that run one after another with it
    std::map<Id, int> uses;        // of each value
    std::map<Id, Id> home;         // of a value: straight of the only block that uses it; 0: of several
    std::map<Id, Id> defined_in;   // of a value: straight of its block
    std::set<Id> bound;            // variables that only hand a value to one call
    std::map<Id, Id> same;         // variables that only hand another variable to one call, and which
    std::set<std::size_t> idle;    // instructions (by position) that `same` makes idle
};

// The shape of a function of the module.
[[nodiscard]] Shape shape_of(const Module& module, const Facts& facts, const Function& function);

}  // namespace gloam::shader::internal::wgsl
