// SPDX-License-Identifier: MIT
#include "audit/internal/runs.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "audit/internal/search.hpp"
#include "interpreter/program.hpp"
#include "judge/session.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

namespace gloam::audit::internal {

using namespace judge;
using namespace subject;

using module::Scalar;

AuditRuns::AuditRuns(const Lab& lab, const Question& question, const KernelSource& source, std::uint64_t seed)
    : AuditRuns(lined_module(lab, source), question, images_of(question.first_scenario(), seed)) {}

AuditRuns::AuditRuns(const Lab& lab, const Question& question, const KernelSource& changed,
                     const AuditRuns& original)
    : AuditRuns(lined_module(lab, changed), question, original.images_) {
    least_ = original.least_;
}

AuditRuns::AuditRuns(KernelModule module, const Question& question, ImageSet images)
    : question_(question),
      scalars_(question.signature.output_scalars()),
      sizes_(question.signature.output_values()),
      least_(scalars_.size(), std::numeric_limits<float>::min()),
      images_(std::move(images)),
      decoded_(decode({std::make_shared<const KernelModule>(std::move(module))}, images_)),
      interpretation_(decoded_, question.signature, false),
      kernel_(decoded_[0].program, *decoded_[0].module, decoded_[0].images),
      floats_(decoded_[0].program, *decoded_[0].module, decoded_[0].images),
      doubles_(decoded_[0].program, *decoded_[0].module, decoded_[0].images),
      drivers_(decoded_[0].program, *decoded_[0].module, decoded_[0].images) {
    drivers_.machine().set_sampling(1);
    const auto limit = [](auto&... kernel) { (kernel.machine().set_limit(most_audited_instructions), ...); };
    limit(kernel_, floats_, doubles_, drivers_);
}

Reading AuditRuns::read(std::span<const Word> input, Gaps gaps) {
    constexpr std::size_t most_ways = 16;
    Reading reading;
    const auto take = [&](std::size_t w, const interpreter::Value<interpreter::Explained>& value) {
        if (w < reading.outputs.size()) {  // another way, on the same path
            const numeric::Bounds more =
                value.is_number() ? value.number().permitted.bounds() : reading.outputs[w].permitted;
            reading.outputs[w].permitted = numeric::hull(reading.outputs[w].permitted, more);
            return;
        }
        if (kernel_.machine().why_undefined(value)) {
            reading.outputs.push_back({.permitted = numeric::Bounds::anything()});
        } else if (module::is_float(scalars_[w])) {
            const interpreter::Explained x = value.number();
            reading.outputs.push_back({x.value, x.exact, x.permitted.bounds()});
        } else {
            const double exact = whole_number(scalars_[w], value.bits());
            reading.outputs.push_back({exact, exact, numeric::Bounds::point(exact)});
        }
    };
    (void)run(
        kernel_, input, gaps, take,
        [&](const interpreter::Error& error) {
            reading = {.outputs = {},
                       .fault = error.what(),
                       .too_long = error.kind() == interpreter::Error::Kind::too_many_steps};
        },
        most_ways);
    return reading;
}

bool AuditRuns::is_undefined(std::span<const Word> input, const Reading& reading, Gaps gaps) {
    constexpr int drivers = 16;
    if (!shows(Concern::undefined, reading)) return false;
    bool undefined = false;
    const auto take = [&](std::size_t w, const interpreter::Value<numeric::Interval>& value) {
        undefined = undefined || value.is_undefined();
        if (undefined || !module::is_float(scalars_[w])) return;
        const numeric::Bounds bounds = value.number().bounds();
        undefined = bounds.is_anything() || bounds.nan;
    };
    for (int i = 0; i < drivers && !undefined; ++i)
        undefined = run(drivers_, input, gaps, take, [&](const auto&) { undefined = true; }) ==
                        numeric::Paths::Outcome::undetermined ||
                    undefined;
    return undefined;
}

std::vector<numeric::Bounds> AuditRuns::permitted(std::span<const Word> input) {
    return hull_of(interpretation_.all_permitted({0, input}));
}

std::vector<double> AuditRuns::in_double(std::span<const Word> input) {
    std::vector<double> outputs;
    try {
        instructions_ += interpretation_.calculate({0, input}, outputs);
    } catch (const interpreter::Error& error) {
        if (error.kind() == interpreter::Error::Kind::too_many_steps)
            instructions_ += Interpretation::most_instructions;
        outputs.clear();
    }
    return outputs;
}

std::vector<double> AuditRuns::in_float(std::span<const Word> input) {
    const std::uint64_t before = floats_.machine().steps();
    try {
        floats_.run(input);
    } catch (const interpreter::Error&) {
        return {};
    }
    instructions_ += floats_.machine().steps() - before;
    std::vector<double> outputs;
    for (std::size_t w = 0; w < scalars_.size(); ++w)
        outputs.push_back(number_at(scalars_[w], floats_.output(w).bits()));
    return outputs;
}

Explanation AuditRuns::steps(std::span<const Word> input, Gaps gaps) {
    try {
        return explain(kernel_, input, gaps);
    } catch (const interpreter::Error&) {
        return {};
    }
}

void AuditRuns::set_usual(const Domain::Inputs& inputs) {
    constexpr double usual_part = 0x1p-10;
    constexpr std::uint64_t most_instructions = 2'000'000;
    const std::uint64_t before = instructions_;
    std::vector<std::vector<double>> lengths(sizes_.size());
    for (std::size_t i = 0; i < inputs.count() && instructions_ - before < most_instructions; ++i) {
        const std::vector<double> outputs = in_double(inputs.row(i));
        for (std::size_t v = 0, first = 0; !outputs.empty() && v < sizes_.size(); first += sizes_[v++]) {
            double length = 0.0;
            for (std::size_t w = first; w < first + sizes_[v]; ++w)
                length = std::max(length, std::abs(outputs[w]));
            if (std::isfinite(length)) lengths[v].push_back(length);
        }
    }
    for (std::size_t v = 0, first = 0; v < sizes_.size(); first += sizes_[v++]) {
        std::ranges::sort(lengths[v]);
        const double median = lengths[v].empty() ? 0.0 : lengths[v][lengths[v].size() / 2];
        std::fill_n(least_.begin() + static_cast<std::ptrdiff_t>(first), sizes_[v],
                    std::max(least_[first], usual_part * median));
    }
}

namespace {

std::string short_text(Scalar scalar, Word word) {
    if (module::is_float(scalar)) return fmt::format("{}", from_word<float>(word));
    return scalar == Scalar::uint_ ? fmt::format("{}", word) : subject::text_of(scalar, word);
}

}  // namespace

std::string AuditRuns::named(std::span<const Word> input) const {
    std::vector<std::string> all;
    const std::function<void(const module::Type&, const std::string&)> add = [&](const module::Type& type,
                                                                                 const std::string& name) {
        if (type.scalar == Scalar::structure && !type.sizes.empty()) {
            for (std::uint32_t i = 0; i < type.sizes.front(); ++i)
                add(module::element_of(type), fmt::format("{}[{}]", name, i));
            return;
        }
        if (type.scalar == Scalar::structure) {
            for (const module::Member& member : type.members) add(member.type, name + "." + member.name);
            return;
        }
        if (type.scalar == Scalar::sampler) return;
        std::vector<std::string> numbers;
        for (const Scalar scalar : scalars_of(type)) {
            numbers.push_back(short_text(scalar, input.front()));
            input = input.subspan(1);
        }
        all.push_back(fmt::format(fmt::runtime(numbers.size() == 1 ? "{} = {}" : "{} = ({})"), name,
                                  fmt::join(numbers, ", ")));
    };
    for (const module::Parameter& parameter : question_.signature.parameters)
        if (parameter.direction != source::Direction::out) add(parameter.type, parameter.name);
    return fmt::format("{}", fmt::join(all, ", "));
}

// A component is compared with the largest of its vector: the direction of a vector is what counts. What is
// not finite is a concern of its own.
Loss AuditRuns::largest(Concern concern, const Reading& reading) const {
    Loss worst;
    std::size_t first = 0;
    for (std::size_t v = 0; v < sizes_.size(); first += sizes_[v++]) {
        double length = least_[first];
        for (std::size_t w = first; w < first + sizes_[v]; ++w)
            if (std::isfinite(reading.outputs[w].exact))
                length = std::max(length, std::abs(reading.outputs[w].exact));
        for (std::size_t w = first; w < first + sizes_[v]; ++w) {
            const OutputReading& output = reading.outputs[w];
            const double absolute = concern == Concern::digits ? std::abs(output.value - output.exact)
                                                               : output.permitted.high - output.permitted.low;
            if (std::isfinite(absolute) && absolute / length > worst.relative) worst = {w, absolute / length};
        }
    }
    return worst;
}

}  // namespace gloam::audit::internal
