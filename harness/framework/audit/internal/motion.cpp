// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

#include "audit/internal/search.hpp"
#include "check/explain.hpp"
#include "numeric/numbers.hpp"

namespace gloam::check::internal {
namespace {

constexpr std::size_t most_parameters = 6;
constexpr std::size_t most_outputs = 4;
constexpr std::size_t lines_of_each = 4;  // through so many drawn inputs
constexpr std::size_t most_meeting = 8;   // where parameters meet
constexpr std::size_t most_lines = 24;    // with those, and with those at constants
constexpr std::size_t points = 129;       // of a line
constexpr double jump_ratio = 4.0;        // a step from one float to the next, beside those around it
constexpr double visible_step = 1e-7;     // of the result: about the ULP of float32
constexpr std::size_t tried_pairs = 12;   // of neighbouring points, where the line is steepest for its place
constexpr double turn_part = 1e-9;        // of it: less is rounding of double
constexpr std::size_t float_steps = 64;   // steps of float32 that are looked at

struct Point {
    float x = 0.0F;
    double y = 0.0;
};

// The scalar float parameters.
std::vector<Slot> axes_of(const Question& question) {
    std::vector<Slot> axes = slots_of(question);
    std::erase_if(axes, [](const Slot& slot) { return !(slot.parameter->type == type_of<float>()); });
    if (axes.size() > most_parameters) axes.resize(most_parameters);
    return axes;
}

// The result of one parameter's values; the others are those of a base input.
class Line {
  public:
    Line(AuditRuns& runs, const Slot& axis, std::vector<Word> base, std::size_t output)
        : runs_(runs), axis_(axis), base_(std::move(base)), output_(output) {}

    [[nodiscard]] std::vector<Word> input(float x) const {
        std::vector<Word> words = base_;
        words[axis_.first] = to_word(x);
        return words;
    }
    [[nodiscard]] double in_double(float x) const { return value(runs_.in_double(input(x))); }
    [[nodiscard]] double in_float(float x) const { return value(runs_.in_float(input(x))); }
    [[nodiscard]] AuditRuns& runs() const { return runs_; }

    [[nodiscard]] std::vector<Point> sampled(const std::vector<float>& positions) const {
        std::vector<Point> all;
        for (const float x : positions) {
            const double y = in_double(x);
            if (std::isfinite(y)) all.push_back({x, y});
        }
        return all;
    }

  private:
    [[nodiscard]] double value(const std::vector<double>& outputs) const {
        return outputs.empty() ? std::nan("") : outputs.at(output_);
    }

    AuditRuns& runs_;
    const Slot& axis_;
    std::vector<Word> base_;
    std::size_t output_;
};

// Orders floats like the numbers that they are, neighbours one apart.
std::int64_t order_of(float x) {
    const auto bits = static_cast<std::int64_t>(to_word(x) & 0x7fffffffU);
    return std::signbit(x) ? -bits : bits;
}
float float_at(std::int64_t order) {
    const auto bits = static_cast<Word>(order < 0 ? -order : order);
    return from_word<float>(order < 0 ? bits | 0x80000000U : bits);
}

// Halves the way between two points until they are neighbours, towards the larger difference.
std::pair<Point, Point> narrowed(const Line& line, Point low, Point high) {
    while (order_of(high.x) - order_of(low.x) > 1) {
        const float x = float_at((order_of(low.x) + order_of(high.x)) / 2);
        const Point middle{x, line.in_double(x)};
        if (!std::isfinite(middle.y)) break;
        (std::abs(middle.y - low.y) > std::abs(high.y - middle.y) ? high : low) = middle;
    }
    return {low, high};
}

// The place where the operations of two neighbouring inputs part: another way of a branch, or a value that
// changes by far more than its operands.
void locate(AuditMotion& motion, AuditRuns& runs, const std::vector<Word>& a, const std::vector<Word>& b) {
    constexpr double large = 1e-4;
    const Explanation first = runs.steps(a);
    const Explanation second = runs.steps(b);
    for (std::size_t i = 0; i < std::min(first.steps.size(), second.steps.size()); ++i) {
        const ExplainedStep& x = first.steps[i];
        const ExplainedStep& y = second.steps[i];
        const bool parted = x.line != y.line || x.operation != y.operation;
        const double change =
            std::abs(x.exact - y.exact) / std::max({std::abs(x.exact), std::abs(y.exact), 1e-30});
        if (!parted && !(change > large)) continue;
        // Ways part behind the last common operation, which is the condition's.
        const ExplainedStep& shown = parted && i > 0 ? first.steps[i - 1] : x;
        motion.line = shown.line;
        motion.file = shown.file;
        return;
    }
}

bool admits(const Slot& slot, float x) {
    const Word word = to_word(x);
    return slot.values->admits(std::span(&word, 1));
}

// A constant of the source, which a comparison may name, with its neighbours.
std::vector<float> around(float constant) {
    std::vector<float> all;
    for (int steps = -2; steps <= 2; ++steps) all.push_back(numeric::step(constant, steps));
    return all;
}

std::vector<float> positions_of(const AuditRuns& runs, const AuditSearch& search, const Domain::Inputs& drawn,
                                const Slot& axis) {
    std::vector<float> all;
    for (const std::vector<Word>& words : search.traced) all.push_back(from_word<float>(words[axis.first]));
    for (std::size_t i = 0; i < drawn.count(); ++i) all.push_back(from_word<float>(drawn.row(i)[axis.first]));
    for (const float constant : runs.constants())
        for (const float x : around(constant))
            if (x != 0.0F && admits(axis, x)) all.push_back(x);
    std::erase_if(all, [](float x) { return !std::isfinite(x); });
    std::ranges::sort(all, [](float a, float b) { return order_of(a) < order_of(b); });
    const auto same = std::ranges::unique(all);
    all.erase(same.begin(), same.end());
    return all;
}

// The inputs through which lines go: a few drawn ones, and the first of them with another parameter at a
// constant or beside it, or as far beyond a third one as this one usually is.
class Bases {
  public:
    Bases(const AuditRuns& runs, const AuditSearch& search, const Slot& axis, float middle)
        : all_(search.traced.begin(), search.traced.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                  lines_of_each, search.traced.size()))) {
        if (all_.empty()) return;
        std::vector<Slot> others = axes_of(runs.question());
        std::erase_if(others, [&](const Slot& slot) { return slot.first == axis.first; });
        for (const Slot& slot : others)
            for (const Slot& other : others)
                if (slot.first != other.first && all_.size() < lines_of_each + most_meeting)
                    add(slot, from_word<float>(all_[0][other.first]) + middle);
        for (const float constant : runs.constants())
            for (const Slot& slot : others)
                for (const int steps : {-1, 0, 1}) add(slot, numeric::step(constant, steps));
    }

    [[nodiscard]] const std::vector<std::vector<Word>>& all() const { return all_; }

  private:
    void add(const Slot& slot, float x) {
        if (all_.size() == most_lines || !admits(slot, x)) return;
        std::vector<Word> words = all_[0];
        words[slot.first] = to_word(x);
        all_.push_back(std::move(words));
    }

    std::vector<std::vector<Word>> all_;
};

struct Shape {
    bool rises = false;
    bool falls = false;
    double range = 0.0;
    double usual = 0.0;              // the range of the middle half
    std::vector<std::size_t> steep;  // pairs of points, by the first: the steepest for their surroundings
    std::size_t turn = 0;            // the first point at which the direction changes
};

// The pairs whose difference is largest beside those of their neighbours.
std::vector<std::size_t> steep_pairs(const std::vector<Point>& all) {
    const auto difference = [&all](std::size_t i) { return std::abs(all[i + 1].y - all[i].y); };
    std::vector<std::pair<double, std::size_t>> pairs;
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const double before = i > 0 ? difference(i - 1) : 0.0;
        const double behind = i + 2 < all.size() ? difference(i + 1) : 0.0;
        if (difference(i) > 0.0) pairs.emplace_back(difference(i) / (before + behind + 1e-30), i);
    }
    std::ranges::sort(pairs, std::greater<>());
    std::vector<std::size_t> steep;
    for (std::size_t k = 0; k < std::min(pairs.size(), tried_pairs); ++k) steep.push_back(pairs[k].second);
    return steep;
}

Shape shape_of(const std::vector<Point>& all) {
    Shape shape{.steep = steep_pairs(all)};
    std::vector<double> sorted;
    for (const Point& point : all) sorted.push_back(point.y);
    std::ranges::sort(sorted);
    shape.range = sorted.back() - sorted.front();
    shape.usual = sorted[3 * sorted.size() / 4] - sorted[sorted.size() / 4];
    int direction = 0;
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const double step = all[i + 1].y - all[i].y;
        if (std::abs(step) <= turn_part * std::max(std::abs(all[i].y), shape.usual)) continue;
        const int now = step > 0.0 ? 1 : -1;
        (now > 0 ? shape.rises : shape.falls) = true;
        if (direction != 0 && now != direction && shape.turn == 0) shape.turn = i;
        direction = now;
    }
    return shape;
}

// Whether the step between two neighbouring floats is none of a slope: those around it are far smaller.
bool is_jump(const Line& line, const Point& a, const Point& b) {
    if (order_of(b.x) - order_of(a.x) != 1) return false;
    const double step = std::abs(b.y - a.y);
    if (!(step > visible_step * std::max(std::abs(a.y), std::abs(b.y)))) return false;
    const double before = std::abs(a.y - line.in_double(numeric::step(a.x, -1)));
    const double behind = std::abs(line.in_double(numeric::step(b.x, 1)) - b.y);
    const double around =
        std::max(std::isfinite(before) ? before : 0.0, std::isfinite(behind) ? behind : 0.0);
    return step > jump_ratio * around;
}

// The first jump of a line between two neighbouring floats.
std::optional<std::pair<Point, Point>> jump_of(const Line& line, const std::vector<Point>& all,
                                               const Shape& shape) {
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
        if (order_of(all[i + 1].x) - order_of(all[i].x) == 1 && is_jump(line, all[i], all[i + 1]))
            return std::pair{all[i], all[i + 1]};
    for (const std::size_t i : shape.steep) {
        const auto pair = narrowed(line, all[i], all[i + 1]);
        if (is_jump(line, pair.first, pair.second)) return pair;
    }
    return std::nullopt;
}

// The largest step of float32 against the direction of the function, in ULP of the result.
double backward_step(const Line& line, const std::vector<Point>& all, bool rising) {
    double most = 0.0;
    const std::size_t stride = std::max<std::size_t>(all.size() / float_steps, 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        // Each of those at a constant, and some of the others.
        const bool has_neighbour = i + 1 < all.size() && order_of(all[i + 1].x) - order_of(all[i].x) == 1;
        if (!has_neighbour && i % stride != 0) continue;
        const double here = line.in_float(all[i].x);
        const double next = line.in_float(numeric::step(all[i].x, 1));
        const double back = rising ? here - next : next - here;
        if (std::isfinite(back) && back > 0.0) most = std::max(most, back / numeric::float32.ulp(here));
    }
    return most;
}

// Looks along the lines of one parameter at one output.
AuditMotion motion_of(AuditRuns& runs, const AuditSearch& search, const Domain::Inputs& drawn,
                      const Slot& axis, std::size_t output, std::uint64_t most_instructions) {
    AuditMotion motion{.parameter = axis.parameter->name, .output = output};
    bool rises = false;
    bool falls = false;
    const std::vector<float> positions = positions_of(runs, search, drawn, axis);
    const float middle = positions.empty() ? 0.0F : positions[positions.size() / 2];
    const Bases bases(runs, search, axis, middle);
    for (const std::vector<Word>& base : bases.all()) {
        if (runs.instructions() > most_instructions) break;
        const Line line(runs, axis, base, output);
        const std::vector<Point> all = line.sampled(positions);
        if (all.size() < 3) continue;
        const Shape shape = shape_of(all);
        if (!(shape.range > 0.0)) continue;
        if (const auto jump = jump_of(line, all, shape)) {
            if (motion.kind == AuditMotion::Kind::jumping) continue;  // one is enough
            const auto& [a, b] = *jump;
            motion.kind = AuditMotion::Kind::jumping;
            motion.words = line.input(a.x);
            motion.at = static_cast<double>(b.x);
            motion.before = a.y;
            motion.behind = b.y;
            locate(motion, runs, motion.words, line.input(b.x));
        }
        if (shape.rises && shape.falls && motion.words.empty()) {
            motion.words = line.input(all[shape.turn].x);
            motion.at = static_cast<double>(all[shape.turn].x);
            motion.before = all[shape.turn].y;
        }
        if (shape.rises != shape.falls)
            motion.backward = std::max(motion.backward, backward_step(line, all, shape.rises));
        rises = rises || shape.rises;
        falls = falls || shape.falls;
    }
    if (motion.kind != AuditMotion::Kind::jumping) {
        using enum AuditMotion::Kind;
        motion.kind = rises && falls ? turning : rises ? rising : falls ? falling : constant;
    }
    return motion;
}

}  // namespace

std::vector<AuditMotion> motions(AuditRuns& runs, const AuditSearch& search,
                                 std::uint64_t most_instructions) {
    std::vector<AuditMotion> all;
    const Question& question = runs.question();
    const std::size_t outputs = std::min(question.signature.output_words(), most_outputs);
    const std::vector<Slot> axes = axes_of(question);
    if (axes.empty()) return all;
    const Domain::Inputs drawn = question.domain.draw(points, 1, runs.image_size());
    for (const Slot& axis : axes)
        for (std::size_t output = 0; output < outputs; ++output) {
            if (runs.instructions() > most_instructions) return all;
            AuditMotion motion = motion_of(runs, search, drawn, axis, output, most_instructions);
            if (!motion.words.empty()) motion.values = runs.named(motion.words);
            all.push_back(std::move(motion));
        }
    return all;
}

}  // namespace gloam::check::internal
