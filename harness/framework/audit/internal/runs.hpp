// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "judge/explain.hpp"
#include "judge/interpretation.hpp"
#include "module/spirv.hpp"
#include "subject/interpreted_kernel.hpp"
#include "subject/lab.hpp"

namespace gloam::audit::internal {

// One scalar of the result, on every number type at once. An integer or bool is exact.
struct OutputReading {
    double value = 0.0;
    double exact = 0.0;
    numeric::Bounds permitted = numeric::Bounds::point(0.0);
};

// The results of one input.
struct Reading {
    std::vector<OutputReading> outputs;  // empty if there is a fault
    std::string fault;
    bool too_long = false;  // the fault is that it does not end
};

// How a result of one input is off.
struct Loss {
    std::size_t output = 0;  // word where it is largest
    double relative = 0.0;   // beside the largest component of the same vector, or 2^-10 of its usual size
};

// An input at which a decision on an inexact number goes two ways: a comparison, an integer, an index.
struct Parting {
    std::size_t output = 0;
    double other = 0.0;  // what double gives on its own path, or a driver; NaN where the driver faults
    int driver = 0;      // that parts; 0: double
};

// A function that is ready to be run by the interpreter in every way that an audit needs. The objects that it
// is made from must outlive it.
class AuditRuns {
  public:
    using Gaps = numeric::Paths::Gaps;

    AuditRuns(const subject::Lab& lab, const judge::Question& question, const subject::KernelSource& source,
              std::uint64_t seed);
    // The same function with another text, measured like `original`, on the same images.
    AuditRuns(const subject::Lab& lab, const judge::Question& question, const subject::KernelSource& changed,
              const AuditRuns& original);

    // `gaps`: of Vulkan's rules.
    [[nodiscard]] Reading read(std::span<const subject::Word> input, Gaps gaps = Gaps::closed);

    // Whether some driver that keeps the rules has an undefined result: a guard that holds in float32 may
    // keep it from every driver, which intervals along one path do not see. `reading`: of the input.
    [[nodiscard]] bool is_undefined(std::span<const subject::Word> input, const Reading& reading,
                                    Gaps gaps = Gaps::closed);
    [[nodiscard]] bool is_undefined(std::span<const subject::Word> input, Gaps gaps) {
        return is_undefined(input, read(input, gaps), gaps);
    }

    // Whether double, or one of a few drivers that keep the rules, takes another path than float32 and gives
    // another result; the first that does. `reading`: of the input.
    [[nodiscard]] std::optional<Parting> parting_of(std::span<const subject::Word> input,
                                                    const Reading& reading);
    // The decision that parts them; unknown if it has no line.
    [[nodiscard]] AuditLocation place_of(const Parting& parting, std::span<const subject::Word> input);

    // Bounds of each output on all paths, in any order of sums.
    [[nodiscard]] std::vector<numeric::Bounds> permitted(std::span<const subject::Word> input);
    // The outputs in double, on double's own path. Empty if there is a fault.
    [[nodiscard]] std::vector<double> in_double(std::span<const subject::Word> input);
    // The outputs of correctly rounded float32, likewise.
    [[nodiscard]] std::vector<double> in_float(std::span<const subject::Word> input);
    // The operations of one input. Empty if there is a fault.
    [[nodiscard]] judge::Explanation steps(std::span<const subject::Word> input, Gaps gaps = Gaps::closed);

    // Learns the usual size of the results: the median magnitude over these inputs.
    void set_usual(const subject::Domain::Inputs& inputs);

    // The largest of the outputs' losses of digits, or of the widths of what drivers are permitted.
    [[nodiscard]] Loss largest(Concern concern, const Reading& reading) const;

    // "x = 0.5, n = (0, 1, 0)": an input by the names of the parameters, each float with enough digits.
    [[nodiscard]] std::string named(std::span<const subject::Word> input) const;

    [[nodiscard]] const judge::Question& question() const { return question_; }
    [[nodiscard]] const subject::KernelSource& source() const { return *decoded_[0].module->source; }
    [[nodiscard]] glm::ivec2 image_size() const { return question_.first_scenario().size; }
    [[nodiscard]] std::uint64_t instructions() const { return instructions_; }
    // The float constants of the function's module.
    [[nodiscard]] std::vector<float> numbers() const {
        return module::float_constants(decoded_[0].module->spirv);
    }

  private:
    AuditRuns(subject::KernelModule module, const judge::Question& question, subject::ImageSet images);
    [[nodiscard]] std::optional<Parting> parting_of_driver(std::span<const subject::Word> input,
                                                           const Reading& reading, int driver);
    // Runs a kernel along paths of the rules, at most `most`, and takes its outputs by their numbers, or why
    // it has none.
    template <class N, class Take, class Fail>
    numeric::Paths::Outcome run(subject::InterpretedKernel<N>& kernel, std::span<const subject::Word> input,
                                Gaps gaps, const Take& take, const Fail& fail, std::size_t most = 1) {
        const std::uint64_t before = kernel.machine().steps();
        const auto once = [&] {
            if (most > 1) numeric::Paths::choose_only_wholes();
            try {
                kernel.run(input);
                for (std::size_t w = 0; w < scalars_.size(); ++w) take(w, kernel.output(w));
            } catch (const interpreter::Error& error) {
                fail(error);
                throw numeric::Paths::Enough{};
            }
            if (most == 1) throw numeric::Paths::Enough{};
        };
        const auto outcome = numeric::Paths::explore(numeric::float32, most, once, gaps);
        instructions_ += kernel.machine().steps() - before;
        return outcome;
    }

    const judge::Question& question_;
    std::vector<module::Scalar> scalars_;
    std::vector<std::size_t> sizes_;  // of the result's vectors
    std::vector<double> least_;       // results in a word below count as large as this
    subject::ImageSet images_;
    judge::Decoded decoded_;
    judge::Interpretation interpretation_;
    subject::InterpretedKernel<interpreter::Explained> kernel_;
    subject::InterpretedKernel<float> floats_;
    subject::InterpretedKernel<double> doubles_;
    subject::InterpretedKernel<numeric::Interval> drivers_;  // one driver after another
    std::uint64_t instructions_ = 0;
};

}  // namespace gloam::audit::internal
