// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "judge/question.hpp"

namespace gloam::judge::internal {

// The class of an input. `branch`: it was placed at a branch point.
[[nodiscard]] InputClass class_of(std::span<const Word> inputs, const std::vector<module::Scalar>& scalars,
                                  bool branch);

// Whether an input or its exact result contains NaN, infinity or -0, which some devices do not preserve.
[[nodiscard]] bool holds_special(const Sample& sample, const std::vector<module::Scalar>& scalars);

// Makes +0 of every -0, for a device that need not keep its sign: so the kernel and the reference get the
// same input, and it can be judged. `words`: one input after another.
void set_positive_zeros(std::span<Word> words, const std::vector<module::Scalar>& scalars);

// The scalar types of a signature's inputs and outputs, which every judge needs.
struct Scalars {
    explicit Scalars(const subject::Signature& signature)
        : inputs(signature.input_scalars()),
          outputs(signature.output_scalars()),
          output_values(signature.output_values()) {}

    std::vector<module::Scalar> inputs;
    std::vector<module::Scalar> outputs;
    std::vector<std::size_t> output_values;
};

// What the budget allows of each output around these exact results.
[[nodiscard]] std::vector<numeric::Bounds> allowed_around(const Question& question,
                                                          const std::vector<double>& want);

// Returns true to end the visit.
using InputVisitor = std::function<bool(const std::vector<Word>& inputs)>;

// Visits the further inputs whose exact results the budget of an input also allows: the input with subnormals
// flushed to zero, then those within the backward budget. Returns whether a visit ended it.
bool visit_covered_inputs(const Budget& budget, const std::vector<module::Scalar>& scalars,
                          std::span<const Word> inputs, const InputVisitor& visit);

// The error of the outputs of an input against the documented budget; infinite if one is outside the
// codomain, and otherwise 0 if the budget is not promised for the input.
[[nodiscard]] ErrorSize error_of(const Question& question, const subject::ImageSet& images,
                                 const Scalars& scalars, const Sample& sample, bool promised);

// Whether some result other than NaN is outside the codomain.
[[nodiscard]] bool has_codomain(const Question& question, const Scalars& scalars);

// The error of a value against another.
[[nodiscard]] ErrorSize float_error(const Budget& budget, double got, double want, double unit,
                                    const numeric::FloatFormat& format);

// ULP of the largest component of each value if the budget measures by it, otherwise 0.
[[nodiscard]] double unit_of(const Budget& budget, std::span<const double> want,
                             const numeric::FloatFormat& format);

// Whether an input is an edge, for which functions document the result: it contains a zero, an infinity or a
// NaN, and otherwise only values of usual size, so that neither overflow nor underflow occurs.
[[nodiscard]] bool is_edge(const Sample& sample, const Scalars& scalars);

// Whether the outputs at an edge equal those of the reference, independently of the promised accuracy. A
// float must be within 1/256 of the largest component of its value (0.01 at least), or within the budget. An
// infinity, a NaN, an integer and a bool must be exact. A branch that rounding decides may go either way, so
// the reference is also evaluated at inputs a few ULP away.
[[nodiscard]] bool holds_at_edge(const Question& question, const subject::ImageSet& images,
                                 const Scalars& scalars, const Sample& sample);

}  // namespace gloam::judge::internal
