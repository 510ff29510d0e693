// SPDX-License-Identifier: MIT
#include "check/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <thread>

#include "numeric/float_class.hpp"
#include "numeric/ulp.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t corner_words = 6;  // most float inputs whose corners are all tried

// How far the outputs of one input are from one candidate for the truth.
struct Error {
    double ulp = 0.0;
    double absolute = 0.0;
    double fraction = 0.0;
};

double as_number(Scalar scalar, Word word) {
    switch (scalar) {
        case Scalar::float_:
            return from_word<float>(word);
        case Scalar::int_:
            return from_word<int>(word);
        default:
            return word;
    }
}

double fraction_of(double error, double allowed) {
    if (error == 0.0) return 0.0;
    return allowed > 0.0 ? error / allowed : infinity;
}

// The class of one input, and the float words it was read from.
InputClass class_of(std::span<const Word> inputs, const std::vector<Scalar>& scalars, bool branch) {
    auto worst = branch ? InputClass::branch : InputClass::ordinary;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (scalars[i] != Scalar::float_) continue;
        auto here = InputClass::ordinary;
        switch (numeric::classify(from_word<float>(inputs[i]))) {
            case numeric::FloatClass::ordinary:
                break;
            case numeric::FloatClass::zero:
                here = InputClass::zero;
                break;
            case numeric::FloatClass::subnormal:
                here = InputClass::subnormal;
                break;
            case numeric::FloatClass::huge:
                here = InputClass::huge;
                break;
            case numeric::FloatClass::infinite:
                here = InputClass::infinite;
                break;
            case numeric::FloatClass::nan:
                here = InputClass::nan;
                break;
        }
        worst = std::max(worst, here);
    }
    return worst;
}

class Judge {
  public:
    Judge(const Rules& rules, const ImageSet& images)
        : rules_(rules),
          images_(images),
          input_scalars_(rules.signature.input_scalars()),
          output_scalars_(rules.signature.output_scalars()),
          output_values_(rules.signature.output_values()) {}

    void add(Census& census, Sample& sample, bool branch) {
        sample.input_class = class_of(sample.inputs, input_scalars_, branch);
        rules_.reference(images_, sample.inputs, sample.want);
        if (sample.want.size() != output_scalars_.size()) {
            throw std::logic_error(fmt::format("the reference gave {} output words, the signature has {}",
                                               sample.want.size(), output_scalars_.size()));
        }
        if (!rules_.judge_nan && holds_special(sample)) {
            census.add_recorded(sample.input_class);
            return;
        }
        const bool poisoned = !inside_codomain(sample.got);
        const bool promised = !rules_.promised || rules_.promised(sample.inputs);
        Error error = promised ? best_error(sample) : Error{};
        if (poisoned) error = {.ulp = infinity, .absolute = infinity, .fraction = infinity};
        sample.ulp = error.ulp;
        sample.absolute = error.absolute;
        sample.fraction = error.fraction;
        census.add(sample, error.fraction > 1.0);
    }

  private:
    bool holds_special(const Sample& sample) const {
        for (std::size_t i = 0; i < sample.inputs.size(); ++i) {
            if (input_scalars_[i] != Scalar::float_) continue;
            const auto value = from_word<float>(sample.inputs[i]);
            if (!std::isfinite(value) || (value == 0.0F && std::signbit(value))) return true;
        }
        return std::ranges::any_of(sample.want, [](double want) { return !std::isfinite(want); });
    }

    bool inside_codomain(std::span<const Word> got) const {
        for (std::size_t i = 0; i < got.size(); ++i) {
            if (output_scalars_[i] != Scalar::float_) continue;
            const auto value = static_cast<double>(from_word<float>(got[i]));
            if (!(value >= rules_.codomain.low && value <= rules_.codomain.high)) return false;
        }
        return true;
    }

    Error error_against(std::span<const Word> got, const std::vector<double>& want) const {
        Error error;
        std::size_t first = 0;
        for (const std::size_t words : output_values_) {
            add_value(error, got.subspan(first, words), std::span(want).subspan(first, words),
                      output_scalars_[first]);
            first += words;
        }
        return error;
    }

    void add_value(Error& error, std::span<const Word> got, std::span<const double> want,
                   Scalar scalar) const {
        double unit = 0.0;  // ULP of the largest component, when components are measured by it
        for (const double w : want) {
            if (rules_.budget.of_largest_component && std::isfinite(w))
                unit = std::max(unit, numeric::ulp_size(w));
        }
        for (std::size_t i = 0; i < got.size(); ++i) {
            if (scalar == Scalar::float_) {
                add_float(error, from_word<float>(got[i]), want[i], unit);
            } else if (as_number(scalar, got[i]) != want[i]) {
                error = {.ulp = infinity, .absolute = infinity, .fraction = infinity};
            }
        }
    }

    void add_float(Error& error, float got, double want, double unit) const {
        const double absolute = numeric::absolute_error(got, want);
        const double ulp =
            unit > 0.0 && std::isfinite(absolute) ? absolute / unit : numeric::ulp_error(got, want);
        const double fraction =
            std::min(fraction_of(ulp, rules_.budget.ulp), fraction_of(absolute, rules_.budget.absolute));
        error.absolute = std::max(error.absolute, absolute);
        error.fraction = std::max(error.fraction, fraction);
        if (absolute > rules_.budget.absolute) error.ulp = std::max(error.ulp, ulp);
    }

    // The error against the reference at the input itself; if that fails, against the nearest of the inputs
    // that the rules also allow: subnormals flushed to zero, and inputs within the backward budget.
    Error best_error(const Sample& sample) {
        Error best = error_against(sample.got, sample.want);
        const auto try_at = [&](const std::vector<Word>& inputs) {
            rules_.reference(images_, inputs, candidate_);
            const Error error = error_against(sample.got, candidate_);
            if (error.fraction < best.fraction) best = error;
            return best.fraction <= 1.0;
        };
        if (best.fraction <= 1.0 || try_at(flushed(sample.inputs))) return best;
        for (int steps = 1; steps <= rules_.budget.backward_ulp; ++steps) {
            if (try_moved(sample.inputs, steps, try_at)) break;
        }
        return best;
    }

    std::vector<Word> flushed(std::span<const Word> inputs) const {
        std::vector<Word> moved(inputs.begin(), inputs.end());
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const bool subnormal =
                input_scalars_[i] == Scalar::float_ &&
                numeric::classify(from_word<float>(moved[i])) == numeric::FloatClass::subnormal;
            if (subnormal) moved[i] &= 0x80000000U;
        }
        return moved;
    }

    // Moves each float input alone, then all of them together in every combination of directions.
    template <class Try>
    bool try_moved(std::span<const Word> inputs, int steps, Try&& try_at) const {
        std::vector<std::size_t> floats;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            if (input_scalars_[i] == Scalar::float_) floats.push_back(i);
        }
        const auto move = [steps](std::vector<Word>& words, std::size_t i, bool up) {
            words[i] = to_word(numeric::step(from_word<float>(words[i]), up ? steps : -steps));
        };
        for (const std::size_t i : floats) {
            for (const bool up : {false, true}) {
                std::vector<Word> moved(inputs.begin(), inputs.end());
                move(moved, i, up);
                if (try_at(moved)) return true;
            }
        }
        if (floats.size() < 2 || floats.size() > corner_words) return false;
        for (std::size_t corner = 0; corner < std::size_t{1} << floats.size(); ++corner) {
            std::vector<Word> moved(inputs.begin(), inputs.end());
            for (std::size_t f = 0; f < floats.size(); ++f) move(moved, floats[f], ((corner >> f) & 1U) != 0);
            if (try_at(moved)) return true;
        }
        return false;
    }

    const Rules& rules_;
    const ImageSet& images_;
    std::vector<Scalar> input_scalars_;
    std::vector<Scalar> output_scalars_;
    std::vector<std::size_t> output_values_;
    std::vector<double> candidate_;
};

}  // namespace

std::string to_text(const Budget& budget) {
    std::string text;
    if (budget.ulp > 0.0)
        text = fmt::format("{:g} ulp{}", budget.ulp,
                           budget.of_largest_component ? " of the largest component" : "");
    if (budget.absolute > 0.0)
        text += fmt::format("{}{:g} absolute", text.empty() ? "" : " or ", budget.absolute);
    if (text.empty()) text = "exact";
    if (budget.backward_ulp > 0) text += fmt::format(" at inputs within {} ulp", budget.backward_ulp);
    return text;
}

Census judge(const Rules& rules, const Domain::Inputs& inputs, std::span<const Word> outputs,
             const ImageSet& images, const std::string& scenario) {
    const std::size_t width = rules.signature.output_words();
    const auto part = [&](std::size_t begin, std::size_t end) {
        Judge judge(rules, images);
        Census census;
        Sample sample{.scenario = scenario};
        for (std::size_t i = begin; i < end; ++i) {
            const auto row = inputs.row(i);
            const auto got = outputs.subspan(i * width, width);
            sample.index = i;
            sample.inputs.assign(row.begin(), row.end());
            sample.got.assign(got.begin(), got.end());
            sample.want.clear();
            judge.add(census, sample, inputs.branch[i]);
        }
        return census;
    };
    const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t share = inputs.count() / threads + 1;
    std::vector<std::future<Census>> parts;
    for (std::size_t begin = 0; begin < inputs.count(); begin += share) {
        parts.push_back(std::async(std::launch::async, part, begin, std::min(begin + share, inputs.count())));
    }
    Census all;
    for (auto& census : parts) all.merge(census.get());
    return all;
}

}  // namespace gloam::check
