// SPDX-License-Identifier: MIT
// Decisions on inexact numbers: comparisons, integers and indices that come out otherwise in double, or on
// another driver.
#include <algorithm>
#include <cmath>

#include "audit/internal/runs.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

namespace gloam::audit::internal {
namespace {

constexpr double least_part = 1e-4;  // of a result, that another way must change
constexpr int tried_drivers = 3;

// What an operation without a float result gave.
struct Decision {
    AuditLocation place;
    std::vector<subject::Word> bits;

    friend bool operator==(const Decision&, const Decision&) = default;
};

template <class N>
void append(const interpreter::Step<N>& step, std::vector<Decision>& all) {
    constexpr std::size_t most = 100'000;
    if (step.place.line == 0 || all.size() == most || step.results.empty()) return;
    if (!std::ranges::all_of(step.results, [](const auto& result) { return result.is_bits(); })) return;
    Decision& decision = all.emplace_back();
    decision.place = {step.place.file, step.place.line, step.place.function, step.operation()};
    for (const auto& result : step.results) decision.bits.push_back(result.bits());
}

template <class N>
std::vector<Decision> decisions_of(subject::InterpretedKernel<N>& kernel,
                                   std::span<const subject::Word> input) {
    std::vector<Decision> all;
    const auto run = [&] {
        try {
            kernel.run(input, [&all](const interpreter::Step<N>& step) { append(step, all); });
        } catch (const interpreter::Error&) {
            // what was decided before
        }
        throw numeric::Paths::Enough{};
    };
    (void)numeric::Paths::explore(numeric::float32, 1, run, numeric::Paths::Gaps::closed);
    return all;
}

// The first decision of one run that another run takes otherwise.
AuditLocation first_other(const std::vector<Decision>& a, const std::vector<Decision>& b) {
    const auto [first, other] = std::ranges::mismatch(a, b);
    return first == a.end() ? AuditLocation{} : first->place;
}

// How far a number is outside of bounds.
double distance_to(const numeric::Bounds& bounds, double x) {
    if (bounds.empty() || bounds.nan || !std::isfinite(x)) return 0.0;
    return std::max({bounds.low - x, x - bounds.high, 0.0});
}

}  // namespace

std::optional<Parting> AuditRuns::parting_of(std::span<const subject::Word> input, const Reading& reading) {
    if (!reading.fault.empty()) return std::nullopt;
    const std::vector<double> own = in_double(input);
    if (own.size() == reading.outputs.size()) {
        Reading other = reading;
        for (std::size_t w = 0; w < own.size(); ++w) {
            OutputReading& output = other.outputs[w];
            const bool same = own[w] == output.exact || !std::isfinite(own[w]);
            output = {.value = same ? own[w] : output.value, .exact = own[w], .permitted = output.permitted};
        }
        const Loss loss = largest(Concern::digits, other);
        if (loss.relative > least_part) return Parting{loss.output, own[loss.output], 0};
    }
    for (int driver = 1; driver <= tried_drivers; ++driver)
        if (const auto parting = parting_of_driver(input, reading, driver)) return parting;
    return std::nullopt;
}

std::optional<Parting> AuditRuns::parting_of_driver(std::span<const subject::Word> input,
                                                    const Reading& reading, int driver) {
    std::vector<double> results;
    bool faults = false;
    const auto take = [&](std::size_t w, const interpreter::Value<numeric::Interval>& value) {
        const numeric::Bounds bounds =
            module::is_float(scalars_[w])
                ? value.number().bounds()
                : numeric::Bounds::point(subject::whole_number(scalars_[w], value.bits()));
        const bool known = bounds.is_point() && !reading.outputs[w].permitted.is_anything();
        results.push_back(known ? bounds.low : std::nan(""));
    };
    drivers_.machine().set_sampling(static_cast<std::uint64_t>(driver));
    (void)run(drivers_, input, Gaps::closed, take, [&](const interpreter::Error& error) {
        faults = error.kind() == interpreter::Error::Kind::out_of_bounds;
    });
    if (faults) return Parting{0, std::nan(""), driver};
    if (results.size() != scalars_.size()) return std::nullopt;
    for (std::size_t w = 0; w < results.size(); ++w) {
        const double distance = distance_to(reading.outputs[w].permitted, results[w]);
        if (distance > least_part * std::max(std::abs(reading.outputs[w].value), least_[w]))
            return Parting{w, results[w], driver};
    }
    return std::nullopt;
}

AuditLocation AuditRuns::place_of(const Parting& parting, std::span<const subject::Word> input) {
    const std::vector<Decision> here = decisions_of(kernel_, input);
    if (parting.driver == 0) return first_other(here, decisions_of(doubles_, input));
    drivers_.machine().set_sampling(static_cast<std::uint64_t>(parting.driver));
    return first_other(here, decisions_of(drivers_, input));
}

}  // namespace gloam::audit::internal
