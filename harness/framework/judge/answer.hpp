// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/failure.hpp"
#include "numeric/interval.hpp"
#include "subject/signature.hpp"

namespace gloam::judge {

using backend::Word;

// The largest permitted difference from the reference: an output passes if its error is at most `ulp` units
// in the last place, or at most `absolute`. Integers and bools must be equal.
struct Budget {
    double ulp = 0.0;
    double absolute = 0.0;
    // No forward bound exists where the function is discontinuous. Then a result also passes if it is within
    // the budget for inputs that are moved by at most this many ULP each. Inputs that are small whole numbers
    // stay: a count, or the end of a range, is meant exactly.
    int backward_ulp = 0;
    // Measures each vector or matrix in the ULP of its largest component, not in each component's own.
    bool of_largest_component = false;
};

// The budget as text: "4 ulp or 1e-07", "exact", "2 ulp at inputs within 1 ulp".
[[nodiscard]] std::string to_text(const Budget& budget);

// The part of a function, and of all that it calls, that the inputs of a check reach.
struct Coverage {
    std::size_t inputs = 0;  // inputs that were run: until everything was reached, for about a second at most

    // A line, or one way of a branch in it: each side of a condition, each case of a switch.
    struct Point {
        std::string file;
        unsigned line = 0;
        std::string text;  // of the line
        std::string way;   // "true", "false, branch 2 of the line", "case 3"; empty: the line itself
        bool reached = false;
    };
    std::vector<Point> points;

    [[nodiscard]] bool is_complete() const;
};

// "lines 12 of 12, branches 7 of 8", and a line of text for each missed point.
[[nodiscard]] std::string to_text(const Coverage& coverage);

// What an output is judged by: the function's documented budget, or Vulkan's precision rules.
enum class Criterion { budget, rules };
[[nodiscard]] constexpr std::string_view name_of(Criterion criterion) {
    return criterion == Criterion::budget ? "budget" : "rules";
}

// The class of an input: the most unusual of its float values, in this order (NaN is the most unusual).
enum class InputClass { ordinary, branch, zero, subnormal, huge, infinite, nan };
inline constexpr std::size_t input_class_count = 7;

[[nodiscard]] constexpr std::string_view name_of(InputClass input_class) {
    constexpr std::array<std::string_view, input_class_count> names{
        "ordinary", "branch", "zero", "subnormal", "huge", "infinite", "nan"};
    return names.at(static_cast<std::size_t>(input_class));
}

// An error, or the largest of some by each measure.
struct ErrorSize {
    double ulp = 0.0;
    double absolute = 0.0;
    double fraction = 0.0;  // of the budget: ULP or absolute error, whichever is less

    void raise(const ErrorSize& other) {
        ulp = std::max(ulp, other.ulp);
        absolute = std::max(absolute, other.absolute);
        fraction = std::max(fraction, other.fraction);
    }
};

// One evaluated input, with its errors.
struct Sample {
    // The bounds of each output word that one way through the function permits together.
    using Outcome = std::vector<numeric::Bounds>;

    std::size_t index = 0;  // position in its run
    InputClass input_class = InputClass::ordinary;
    std::string scenario;  // the images that it ran with; empty without images
    std::string values;    // of the inputs, in decimal and hexadecimal; set when it becomes part of an answer
    std::vector<Word> inputs;
    std::vector<Word> got;
    std::vector<double> want;
    ErrorSize error;         // the largest of its outputs; ulp: of those beyond Budget::absolute
    double fraction = 0.0;   // of what the criterion allows (budget, permitted width); above 1 is outside
    Outcome permitted;       // the hull of all outcomes, if the rules were asked
    bool forbidden = false;  // the rules do not permit the outputs
    // If these are forbidden and there are several: each outcome. Beyond most_outcomes, neighbours are merged
    // as long as their hull does not contain the outputs.
    std::vector<Outcome> outcomes = {};
    static constexpr std::size_t most_outcomes = 16;

    // `outcomes`, or `permitted` alone; none if the rules were not asked.
    [[nodiscard]] std::vector<Outcome> permitted_outcomes() const {
        if (!outcomes.empty() || permitted.empty()) return outcomes;
        return {permitted};
    }
};

// Of one that fails, "3 ulp, 0.1 absolute". Without an error, it was measured against no documented accuracy.
[[nodiscard]] std::string error_text(const Sample& sample);

// The inputs of a class. A recorded or open input was not judged.
struct ClassCount {
    std::size_t inputs = 0;
    std::size_t outside = 0;   // failed
    std::size_t recorded = 0;  // the device promises nothing here
    std::size_t open = 0;      // the device's result was free: nothing but a NaN could have failed
};

// The inputs of a function with boolean results whose exact results hold one of both values.
struct PredicateCount {
    std::size_t inputs = 0;
    std::size_t judged = 0;  // of these, inputs for which some result would have failed
};

using base::Reason;

// Why a function itself has no result for an input.
enum class NoResult { undefined, too_long };
[[nodiscard]] constexpr std::string_view name_of(NoResult kind) {
    return kind == NoResult::undefined ? "undefined" : "too long";
}

// What a check says. Every summary, table, page and exit status is made from it.
enum class Outcome {
    ok,         // enough inputs were judged, and none failed
    failed,     // an input failed, or the check did not run to its end
    not_judged  // too few inputs were judged: Answer::not_judged_because()
};

// "ok", "failed", "not judged".
[[nodiscard]] std::string_view name_of(Outcome outcome);

// The least share of a check's inputs that must be judged. The smallest share in the catalogue is 0.34, on
// OpenGL (DEPTH-quotient, most of whose results are infinite or NaN). With less than a quarter, the verdict
// is one of a few corners of the domain.
inline constexpr double least_judged_share = 0.25;

// What was asked, and how it was judged.
struct AnswerIdentity {
    std::string equation;  // the question's name: an ID of the catalogue, else that of the function
    std::string function;
    std::string file;
    std::string variant;
    Criterion criterion = Criterion::budget;
    Budget budget;
    bool must_hold = false;  // see Question::must_hold

    // Whether Vulkan's rules alone judge; the budget is measured then.
    [[nodiscard]] bool rules_alone() const { return criterion == Criterion::rules; }
    // The two parts of `variant`: "shipped" and "spirv-opt -O", which can be empty.
    [[nodiscard]] std::string variant_before_steps() const;
    [[nodiscard]] std::string steps() const;
};

// How many inputs there were, and what became of them.
struct AnswerCounts {
    std::array<ClassCount, input_class_count> classes{};
    std::array<PredicateCount, 2> predicate{};  // for false and true, if all results are boolean
    std::size_t by_rules = 0;                   // inputs that were judged by the rules
    std::size_t forbidden = 0;                  // of these, inputs whose outputs the rules do not permit
    std::size_t bounded = 0;    // inputs whose bounds were calculated; the next counts among these
    std::size_t unbounded = 0;  // inputs for which the rules permit anything for some output
    std::size_t undefined = 0;  // of the recorded inputs: the function's own result is undefined
    std::size_t distinct = 0;   // of a property: inputs that are not the same
    // For inputs as constants of the shader: the number whose results differ in any bit from those of the
    // same shader with the inputs in memory. All NaNs count as equal.
    std::size_t differs = 0;

    [[nodiscard]] std::size_t inputs() const { return total(&ClassCount::inputs); }
    [[nodiscard]] std::size_t outside() const { return total(&ClassCount::outside); }
    [[nodiscard]] std::size_t recorded() const { return total(&ClassCount::recorded); }
    [[nodiscard]] std::size_t open() const { return total(&ClassCount::open); }

    void add_recorded(InputClass input_class) { ++count(input_class).inputs, ++count(input_class).recorded; }
    // Counts an added input of a function whose results are all boolean.
    void add_predicate(const std::vector<double>& want, bool was_judged);
    void merge(const AnswerCounts& later);
    ClassCount& count(InputClass input_class) { return classes.at(static_cast<std::size_t>(input_class)); }

  private:
    [[nodiscard]] std::size_t total(std::size_t ClassCount::* member) const;
};

// The largest errors, and the inputs that show most.
struct WorstCases {
    ErrorSize largest;            // over judged outputs; ulp: of those beyond Budget::absolute
    double fraction = 0.0;        // worst error as a fraction of what the criterion allows
    std::optional<Sample> worst;  // largest fraction
    std::array<std::optional<Sample>, input_class_count> first_outside;  // first failure of each class
    std::optional<Sample> first_unbounded;
    NoResult no_result = NoResult::undefined;  // of the first undefined input
    std::string first_undefined;               // why

    // Adds those of a later part of the same run.
    void merge(const WorstCases& later);
};

// The result of one question in one variant on one device, or the reason why there is none. Tables, pages and
// JSON are made from it, and processes exchange it.
struct Answer : AnswerIdentity, AnswerCounts, WorstCases {
    // What Vulkan's rules permit, over the inputs for which the budget is promised and the rules bound the
    // result.
    ErrorSize guarantee;
    std::optional<Coverage> coverage;  // what the inputs reached, if measured
    std::string fault;                 // an access outside an image; empty: none
    std::string domain;                // of a property: "8 different inputs: x 0 to 7 (type)"; else empty
    std::string error;                 // why it could not run; empty: it ran
    Reason reason = Reason::none;
    double seconds = 0.0;
    std::string story;  // of a failure, in several lines for people

    // Inputs for which some result would have failed. Where the rules alone are the criterion, it is known of
    // the inputs whose bounds were calculated, and the same share is assumed of the others.
    [[nodiscard]] std::size_t judged() const;
    // The worst error as a fraction of the permitted width, or of the budget.
    [[nodiscard]] double fraction_of_allowed() const { return rules_alone() ? fraction : largest.fraction; }
    [[nodiscard]] bool ran() const { return error.empty(); }
    [[nodiscard]] Outcome outcome() const;
    // Why the outcome is `not_judged`; empty otherwise.
    [[nodiscard]] std::string not_judged_because() const;
    // The classes for which nothing is promised for any input: by the device, or, where the rules alone are
    // the criterion, by the rules.
    [[nodiscard]] std::vector<InputClass> not_promised() const;
    [[nodiscard]] bool passed() const { return outcome() == Outcome::ok; }
    [[nodiscard]] bool failed() const { return outcome() == Outcome::failed; }

    // Adds a judged sample; `outside` when it failed.
    void add(const Sample& sample, bool is_outside);
    void add_undefined(InputClass input_class, NoResult kind, const std::string& why);
    // Adds the answer of another part of the same run. Parts are merged in the order of their inputs.
    void merge(const Answer& later);
};

// The values of a signature's inputs as text, each in decimal and hexadecimal: "vec2 (0.5 (0x3f000000), 1
// (0x3f800000)), int 3".
[[nodiscard]] std::string describe_inputs(const subject::Signature& signature,
                                          const std::vector<Word>& inputs);
// The result and the out and inout values, in order: "0.5 (0x3f000000), true".
[[nodiscard]] std::string describe_outputs(const subject::Signature& signature,
                                           const std::vector<Word>& outputs);

// Criterion, counts by class of input, and the worst input with its outputs and the expected ones.
[[nodiscard]] std::string describe(const subject::Signature& signature, const Answer& answer);

// Sets Sample::values of every sample of an answer.
void describe_samples(const subject::Signature& signature, Answer& answer);

// Prints describe()'s text, so that EXPECT_TRUE(answer.passed()) << answer describes the failure.
std::ostream& operator<<(std::ostream& stream, const Answer& answer);

}  // namespace gloam::judge
