// SPDX-License-Identifier: MIT
#include "judge/interpretation.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/program.hpp"
#include "module/spirv.hpp"
#include "numeric/numbers.hpp"

namespace gloam::judge {

using namespace subject;

Sample::Outcome hull_of(const Permitted& permitted) {
    Sample::Outcome all = permitted.front();
    for (const Sample::Outcome& one : permitted) std::ranges::transform(all, one, all.begin(), numeric::hull);
    return all;
}

double fraction_of_width(double got, double want, const numeric::Bounds& bounds) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (std::isnan(got)) return bounds.nan ? 0.0 : infinity;
    if (bounds.empty()) return infinity;
    const bool inside = bounds.contains(got);
    // If `want` or `got` is not finite, there is no distance to measure; only inside or outside is known.
    if (!std::isfinite(want) || !std::isfinite(got)) return inside ? 0.0 : infinity;
    const double center = std::clamp(want, bounds.low, bounds.high);
    const double distance = std::abs(got - center);
    if (distance == 0.0) return 0.0;
    const double width = got > center ? bounds.high - center : center - bounds.low;
    return inside ? std::min(distance / width, 1.0) : distance / width;
}
namespace {

// Limit for one input, all paths together. Beyond it every result counts as permitted.
constexpr std::uint64_t most_path_steps = 4'000'000;

numeric::Bounds bounds_of(const numeric::Interval& x) {
    return x.bounds();
}
numeric::Bounds bounds_of(const numeric::Rearranged& x) {
    return x.interval().bounds();
}

// What a module asks a driver, or a compiler before it, to keep.
numeric::Paths::Specials specials_of(const module::Spirv& words) {
    using enum numeric::Paths::Specials;
    return module::preserves_specials(words) ? listed : dropped;
}

}  // namespace

Decoded decode(const KernelModules& modules, const ImageSet& images) {
    Decoded all;
    for (const auto& module : modules) {
        const module::Spirv& words = module->before.empty() ? module->spirv : module->before;
        all.push_back({.module = module,
                       .program = interpreter::Program(words, module->constants),
                       .images = image_words(*module, images),
                       .specials = specials_of(words)});
    }
    return all;
}

Interpretation::Location Interpretation::place_of(std::size_t index) const {
    if (decoded_.size() == 1) return {0, decoded_.front().module->fixed_inputs == 0 ? 0 : index};
    std::size_t part = 0;
    while (index >= decoded_.at(part).module->fixed_inputs) index -= decoded_[part++].module->fixed_inputs;
    return {part, index};
}

template <class N>
InterpretedKernel<N>& Interpretation::kernel(std::size_t part) {
    const DecodedModule& from = decoded_[part];
    auto& made = std::get<Made<N>>(parts_[part]);
    if (!made) made = std::make_unique<InterpretedKernel<N>>(from.program, *from.module, from.images);
    return *made;
}

bool Interpretation::is_exact(const InputRow& input, std::span<const Word> got) {
    const Location at = place_of(input.index);
    InterpretedKernel<float>& floats = kernel<float>(at.part);
    try {
        floats.run(input.words, at.index);
    } catch (const interpreter::Error& error) {
        if (error.is_of_group()) throw;
        return false;  // undefined: a device may return any value
    }
    exact_.clear();
    for (std::size_t w = 0; w < got.size(); ++w) exact_.push_back(floats.output(w).bits());
    return same_bits(outputs_, got, exact_);
}

std::uint64_t Interpretation::calculate(const InputRow& input, std::vector<double>& outputs) {
    const Location at = place_of(input.index);
    InterpretedKernel<double>& doubles = kernel<double>(at.part);
    outputs.clear();
    const std::uint64_t before = doubles.machine().steps();
    doubles.machine().set_limit(most_instructions);
    // A race may show in one order only.
    if (decoded_[at.part].module->team.kind == backend::Team::Kind::group) {
        doubles.set_order(interpreter::Order::backward);
        doubles.run(input.words, at.index);
        doubles.set_order(interpreter::Order::forward);
    }
    doubles.run(input.words, at.index);
    for (std::size_t w = 0; w < outputs_.size(); ++w) {
        const auto value = doubles.output(w);
        const auto why = doubles.machine().why_undefined(value);
        if (why && (why->is_used || w < results_)) {
            constexpr auto kind = interpreter::Error::Kind::undefined;
            if (why->place.function.empty()) throw interpreter::Error(kind, why->cause);
            throw interpreter::Error(kind, why->cause, why->place);
        }
        outputs.push_back(module::is_float(outputs_[w]) ? value.number()
                                                        : whole_number(outputs_[w], value.bits()));
    }
    return doubles.machine().steps() - before;
}

bool Interpretation::holds(const Sample::Outcome& outcome, std::span<const Word> got) const {
    for (std::size_t w = 0; w < got.size(); ++w)
        if (!outcome[w].contains(number_at(outputs_[w], got[w]))) return false;
    return true;
}

// All paths, or the paths up to the first one that yields `until`.
template <class N>
Permitted Interpretation::explore(const InputRow& input, std::span<const Word> until) {
    const Location at = place_of(input.index);
    InterpretedKernel<N>& kernel = this->kernel<N>(at.part);
    Permitted permitted;
    const std::uint64_t start = kernel.machine().steps();
    std::uint64_t before = start;
    bool splits = true;
    const auto run = [&] {
        // Begun again without the ways of whole numbers, it may take as long.
        if (splits && !numeric::Paths::choose_whole(1.0)) {
            splits = false;
            before = kernel.machine().steps();
        }
        try {
            kernel.machine().set_limit(most_path_steps -
                                       std::min(most_path_steps, kernel.machine().steps() - before));
            kernel.run(input.words, at.index);
            Sample::Outcome outcome;
            for (std::size_t w = 0; w < outputs_.size(); ++w) {
                const auto value = kernel.output(w);
                outcome.push_back(module::is_float(outputs_[w])
                                      ? bounds_of(value.number())
                                      : numeric::Bounds::point(whole_number(outputs_[w], value.bits())));
            }
            permitted.push_back(std::move(outcome));
        } catch (const interpreter::Error&) {
            throw numeric::Paths::Undetermined{};
        }
        if (!until.empty() && holds(permitted.back(), until)) throw numeric::Paths::Enough{};
    };
    const bool to_even = decoded_.front().module->rounds_to_even;
    const auto rounding = to_even ? numeric::Paths::Rounding::to_even : numeric::Paths::Rounding::either;
    const auto specials = of_driver_ ? decoded_[at.part].specials : numeric::Paths::Specials::kept;
    const auto outcome = numeric::Paths::explore(numeric::float32, most_paths, run,
                                                 numeric::Paths::Gaps::open, rounding, specials);
    steps_ += kernel.machine().steps() - start;
    if (outcome == numeric::Paths::Outcome::undetermined || outcome == numeric::Paths::Outcome::too_many)
        permitted = {Sample::Outcome(outputs_.size(), numeric::Bounds::anything())};
    return permitted;
}

bool Interpretation::is_permitted(const InputRow& input, std::span<const Word> got) {
    if (got.empty() || holds(explore<numeric::Interval>(input, got).back(), got)) return true;
    return decoded_[place_of(input.index).part].program.may_be_rearranged() &&
           holds(explore<numeric::Rearranged>(input, got).back(), got);
}

Permitted Interpretation::all_permitted(const InputRow& input) {
    return decoded_[place_of(input.index).part].program.may_be_rearranged()
               ? explore<numeric::Rearranged>(input)
               : explore<numeric::Interval>(input);
}

}  // namespace gloam::judge
