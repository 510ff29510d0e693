// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "check/judge.hpp"

namespace gloam::check::internal {

// The largest error of the outputs of one input against one candidate for the exact result.
struct Error {
    double ulp = 0.0;
    double absolute = 0.0;
    double fraction = 0.0;  // of the budget
};

// The scalar types of a signature's inputs and outputs, which every judge needs.
struct Scalars {
    explicit Scalars(const Signature& signature)
        : inputs(signature.input_scalars()),
          outputs(signature.output_scalars()),
          output_values(signature.output_values()) {}

    std::vector<shader::Scalar> inputs;
    std::vector<shader::Scalar> outputs;
    std::vector<std::size_t> output_values;
};

[[nodiscard]] double as_number(shader::Scalar scalar, Word word);

// Returns true to end the visit.
using InputVisitor = std::function<bool(const std::vector<Word>& inputs)>;

// Visits the further inputs whose exact results the budget of an input also allows: the input with subnormals
// flushed to zero, then those within the backward budget. Returns whether a visit ended it.
bool visit_covered_inputs(const Budget& budget, const std::vector<shader::Scalar>& scalars,
                          std::span<const Word> inputs, const InputVisitor& visit);

// Measures outputs against the documented budget.
class BudgetJudge {
  public:
    BudgetJudge(const Question& question, const ImageSet& images, const Scalars& scalars)
        : question_(question), images_(images), scalars_(scalars) {}

    // The error of the outputs of an input; infinite if one is outside the codomain, and otherwise 0 if the
    // budget is not promised for the input.
    [[nodiscard]] Error measure(const Sample& sample, bool promised);

    // Whether some result other than NaN is outside the codomain.
    [[nodiscard]] bool has_codomain() const;

    // The error of a value against another.
    [[nodiscard]] Error float_error(double got, double want, double unit) const;

    // ULP of the largest component of each value if the budget measures by it, otherwise 0.
    [[nodiscard]] double unit_of(std::span<const double> want) const;

  private:
    [[nodiscard]] bool inside_codomain(std::span<const Word> got) const;
    [[nodiscard]] Error error_against(std::span<const Word> got, const std::vector<double>& want) const;
    void add_value(Error& error, std::span<const Word> got, std::span<const double> want,
                   shader::Scalar scalar) const;
    [[nodiscard]] Error best_error(const Sample& sample);

    const Question& question_;
    const ImageSet& images_;
    const Scalars& scalars_;
    std::vector<double> candidate_;
};

}  // namespace gloam::check::internal
