// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "audit/own_domain.hpp"
#include "judge/function.hpp"
#include "judge/question.hpp"
#include "judge/run.hpp"
#include "numeric/interval.hpp"
#include "subject/lab.hpp"
#include "subject/own_function.hpp"

// Where a shader function itself goes wrong, whatever the driver. The interpreter runs it correctly rounded,
// in double and on intervals, and searches for the worst inputs of its domain. It needs no reference.
namespace gloam::audit {

// Decimal digits of a float32 (24 bits).
inline constexpr double float_digits = 7.2;

// Of one input; more count as a loop without end.
inline constexpr std::uint64_t most_audited_instructions = 500'000;

enum class Concern {
    fault,        // an access outside an array, or a loop that does not end
    is_false,     // of a property, which must hold
    not_finite,   // a result is NaN or infinite
    undefined,    // the result of an operation is undefined: every result is permitted, or NaN
    unspecified,  // the same, where only the precision is not stated: sin beyond pi, sqrt(0), pow(0, y)
    parting,      // a decision on an inexact number, which double or another driver takes the other way
    digits,       // float32 loses digits that double keeps
    drivers       // two conforming drivers may differ
};
[[nodiscard]] std::string name_of(Concern concern);  // "not finite"

// An operation of the source.
struct AuditLocation {
    std::string file;
    unsigned line = 0;  // 0: unknown
    std::string function;
    std::string operation;  // "OpFSub"

    friend auto operator<=>(const AuditLocation&, const AuditLocation&) = default;
};

// The result of a finding's input on a device.
struct AuditWitness {
    std::string device;
    double value = 0.0;
};

// The worst input for one concern, or for one operation where it arises.
struct AuditFinding {
    Concern concern = Concern::fault;
    double share = 0.0;  // of random inputs that show it, but for digits and drivers; 0: found by search
    std::vector<subject::Word> words;  // the worst input, with the simplest numbers that show the same
    std::string values;                // "x = 0.5, n = (0, 1, 0)"
    std::size_t output = 0;            // word of the result that shows it most
    double value = 0.0;                // float32, correctly rounded
    double exact = 0.0;                // in double; of a parting the other result, NaN where a driver faults
    numeric::Bounds permitted = numeric::Bounds::point(0.0);  // by Vulkan's rules
    double lost = 0.0;                                        // decimal digits, of the 7.2 that a float32 has
    bool cancels = false;  // digits: the result keeps the errors of its operands, and is small beside them
    std::string message;   // of a fault; of a parting, whose result is the other one
    std::vector<AuditWitness> witnesses;
    AuditLocation place;      // where it arises
    std::string reservation;  // on what it rests that drivers hardly do; may be empty
};

// A line of the source, over all traced inputs.
struct AuditLine {
    std::string file;
    unsigned line = 0;
    double lost = 0.0;  // most digits that its operations lose
};

// A change of the source that was tried and helps.
struct AuditRewrite {
    std::string file;
    unsigned line = 0;
    std::string before;  // "1.0 - cos(x)"
    std::string after;
    std::string helper;  // a function that `after` calls; may be empty
    std::string reason;  // "the difference cancels near x = 0"
    std::string gain;    // "lost digits 6.9 -> 0.4", measured on the same inputs
};

struct Audit {
    std::string function;
    std::string declaration;  // "float f(float x)"
    std::string file;
    std::vector<OrdinaryValues> domain;  // for whom the inputs were drawn
    std::size_t random = 0;              // inputs drawn at random, without special values
    std::size_t inputs = 0;              // all that were run
    std::size_t too_long = 0;            // of these, ended after most_audited_instructions
    std::vector<AuditFinding> findings;  // the gravest first
    std::vector<AuditLine> lines;
    judge::Coverage coverage;
    std::vector<AuditRewrite> rewrites;

    // Whether an input came to its end. Otherwise nothing is known of the function.
    [[nodiscard]] bool was_run() const { return inputs > too_long; }
    // Whether an input of the domain faults, makes a property false, or gives NaN, infinity or no defined
    // result.
    [[nodiscard]] bool is_broken() const;
};

struct AuditOptions {
    std::size_t inputs = 8'192;  // half of them drawn, the others by a search for worse ones
    std::uint64_t seed = 1;
    std::uint64_t steps = 60'000'000;  // instructions of the search; fewer inputs are run if they need more
};

// Audits the function of a question; its domain decides the inputs. `domain`: its description. Images have
// the content of the question's first scenario. Throws like Lab::kernel(), and interpreter::Error for an
// instruction that the interpreter does not know.
[[nodiscard]] Audit audit(const subject::Lab& lab, const judge::Question& question,
                          const std::vector<OrdinaryValues>& domain, const AuditOptions& options = {});

// The same for a function that C++ has.
template <class Type>
[[nodiscard]] Audit audit(const judge::Function<Type>& function, const subject::Domain& domain,
                          const AuditOptions& options = {}) {
    return audit(function.lab(), function.question(domain), {}, options);
}

// The same for a function of a file from elsewhere, in its ordinary domain.
[[nodiscard]] Audit audit(const subject::Lab& lab, const subject::OwnFunction& own,
                          const subject::Ranges& ranges, const AuditOptions& options = {});

// Runs the worst inputs of an audit on the lab's device and adds what it gives. Inputs that fault are not
// run. `question`: of the same function. Throws like Lab::kernel() and KernelCore::run().
void add_witness(Audit& audit, const subject::Lab& lab, const judge::Question& question,
                 const AuditOptions& options = {});

// Measures what the inputs of a run reach, in the function and in all that it calls, with the interpreter in
// float32. Throws like run(), and interpreter::Error.
[[nodiscard]] judge::Coverage measure_coverage(const subject::Lab& lab, const judge::Question& question,
                                               const judge::RunOptions& options);

// What a finding shows: "NaN", "0.25, exactly 0.5", "up to 3.9 of 7.2 digits".
[[nodiscard]] std::string result_text(const AuditFinding& finding);
[[nodiscard]] std::string extent_text(const AuditFinding& finding);
// "tone.glsl:12 (acos)", empty if the place is unknown.
[[nodiscard]] std::string to_text(const AuditLocation& place);
// On what the result rests, and what devices give: "0.25 on llvmpipe".
[[nodiscard]] std::vector<std::string> remarks_on(const AuditFinding& finding);
// The ways and lines that nothing reached, one each: "tone.glsl:12: never true: if (x > 2.0)".
[[nodiscard]] std::vector<std::string> missed(const judge::Coverage& coverage);

// The audit in a few lines, for people.
[[nodiscard]] std::string to_text(const Audit& audit);
std::ostream& operator<<(std::ostream& stream, const Audit& audit);

}  // namespace gloam::audit
