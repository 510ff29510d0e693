// SPDX-License-Identifier: MIT
#include "subject/domain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "base/number.hpp"
#include "numeric/numbers.hpp"

namespace gloam::subject {
namespace {

using Words = std::vector<Word>;

using module::Scalar;

Values float_values(Scalar scalar, double low, double high,
                    const std::function<double(numeric::Random&)>& make) {
    Values values = made_by<Word>([=](numeric::Random& random) { return float_word(scalar, make(random)); });
    values.floats = {true};
    values.contains = [=](std::span<const Word> words) {
        const auto value = from_word<double>(words.front());
        return value >= low && value <= high &&
               (scalar != Scalar::float16_ || float_word(scalar, value) == words.front());
    };
    return values;
}

double squared_length(std::span<const Word> vector) {
    double squared = 0.0;
    for (const Word word : vector) squared += from_word<double>(word) * from_word<double>(word);
    return squared;
}

void add_numbers(Values& values, Scalar scalar, std::initializer_list<double> numbers) {
    for (const double number : numbers) values.fixed.push_back({.words = {float_word(scalar, number)}});
}

void require_order(double low, double high) {
    if (!(low <= high))
        throw std::invalid_argument(fmt::format("a range needs low <= high, these are {} and {}", low, high));
}

}  // namespace

std::size_t Values::words() const {
    if (!floats.empty()) return floats.size();
    numeric::Random random(0);
    DrawContext context{.random = random};
    Words drawn;
    draw(context, drawn);
    return drawn.size();
}

bool Values::admits(std::span<const Word> words) const {
    const auto same = [words](const Fixed& value) { return std::ranges::equal(value.words, words); };
    return (contains && contains(words)) || std::ranges::any_of(fixed, same);
}

Values Values::and_special(Scalar scalar) const {
    Values more = *this;
    const std::size_t count = words();
    numeric::Random random(1);
    for (const double special : numeric::special_values(format_of(scalar))) {
        const Word word = float_word(scalar, special);
        more.fixed.push_back({.words = Words(count, word)});
        for (std::size_t i = 0; count > 1 && i < count; ++i) {
            DrawContext context{.random = random};
            Fixed one{.words = {}, .branch = false};
            draw(context, one.words);
            one.words[i] = word;
            more.fixed.push_back(std::move(one));
        }
    }
    return more;
}

Values Values::and_near(std::initializer_list<double> points, Scalar scalar) const {
    Values more = *this;
    for (const double point : points)
        for (const int steps : {-1, 0, 1}) {
            const Word word = stepped_float(scalar, float_word(scalar, point), steps);
            more.fixed.push_back({.words = {word}, .branch = true});
        }
    return more;
}

Values Values::and_near_integers(std::initializer_list<long> points) const {
    Values more = *this;
    for (const long point : points)
        for (const long offset : {-1L, 0L, 1L})
            more.fixed.push_back({.words = {static_cast<Word>(point + offset)}, .branch = true});
    return more;
}

Values Values::only_as_drawn() const {
    Values same = *this;
    same.image_sizes.clear();
    same.only_drawn = true;
    return same;
}

Values uniform(double low, double high, Scalar scalar) {
    require_order(low, high);
    Values values = float_values(scalar, low, high,
                                 [low, high](numeric::Random& random) { return random.uniform(low, high); });
    add_numbers(values, scalar, {low, high});
    const numeric::FloatFormat& format = format_of(scalar);
    for (const double size : {0.0, format.smallest_subnormal(), format.smallest_normal()})
        for (const double side : {size, -size})
            if (side >= low && side <= high) add_numbers(values, scalar, {side});
    return values;
}

Values log_uniform(double low, double high, Scalar scalar) {
    require_order(low, high);
    if (!(low > 0.0)) throw std::invalid_argument("log_uniform needs 0 < low");
    Values values = float_values(scalar, low, high, [low, high](numeric::Random& random) {
        return std::clamp(std::exp(random.uniform(std::log(low), std::log(high))), low, high);
    });
    add_numbers(values, scalar, {low, high});
    return values;
}

Values signed_log_uniform(double low, double high, Scalar scalar) {
    const Values magnitude = log_uniform(low, high, scalar);
    Values values{.floats = magnitude.floats};
    values.draw = [magnitude](DrawContext& context, Words& words) {
        magnitude.draw(context, words);
        words.back() ^= context.random.below(2) == 0 ? 0U : 0x80000000U;
    };
    values.contains = [magnitude](std::span<const Word> words) {
        const Word positive = words.front() & 0x7fffffffU;
        return magnitude.contains(std::span(&positive, 1));
    };
    add_numbers(values, scalar, {low, -low, high, -high});
    return values;
}

Values any_float() {
    Values values = made_by<Word>([](numeric::Random& random) { return random(); });
    values.floats = {true};
    values.contains = [](std::span<const Word>) { return true; };
    return values;
}

Values integers(long low, long high) {
    require_order(static_cast<double>(low), static_cast<double>(high));
    const auto count = static_cast<std::uint64_t>(high - low) + 1U;
    Values values =
        made_by<Word>([=](numeric::Random& random) { return low + static_cast<long>(random.below(count)); });
    for (const long end : {low, high}) values.fixed.push_back({.words = {static_cast<Word>(end)}});
    // The distance from `low`, modulo 2^32, must not exceed that of `high`.
    values.contains = [first = static_cast<Word>(low), last = static_cast<Word>(high)](
                          std::span<const Word> words) { return words[0] - first <= last - first; };
    return values;
}

Values log_integers(long high) {
    const double most = std::log(static_cast<double>(high) + 1.0);
    Values values = made_by<Word>([=](numeric::Random& random) {
        return std::min(static_cast<long>(std::exp(random.uniform(0.0, most))), high);
    });
    values.fixed = {{.words = {0U}}, {.words = {1U}}, {.words = {static_cast<Word>(high)}}};
    values.contains = [high](std::span<const Word> words) { return words[0] <= static_cast<Word>(high); };
    return values;
}

Values booleans() {
    Values values = made_by<bool>([](numeric::Random& random) { return random.below(2) == 1; });
    values.contains = [](std::span<const Word> words) { return words[0] <= 1U; };
    return values;
}

Values vector(int components, const Values& component) {
    Values values = vector(std::vector<Values>(static_cast<std::size_t>(components), component));
    for (const Values::Fixed& fixed : component.fixed) {
        Values::Fixed all{.words = {}, .branch = fixed.branch};
        for (int i = 0; i < components; ++i)
            all.words.insert(all.words.end(), fixed.words.begin(), fixed.words.end());
        values.fixed.push_back(std::move(all));
    }
    return values;
}

namespace {

// Fixed values of a vector take words x words: of a large one, each of so many is taken.
std::size_t fixed_stride(const std::vector<Values>& components) {
    constexpr std::size_t most_words = std::size_t{1} << 20U;
    std::size_t fixed = 0;
    for (const Values& component : components) fixed += component.fixed.size();
    return fixed * components.size() / most_words + 1;
}

}  // namespace

Values vector(const std::vector<Values>& components) {
    Values values;
    const auto shared = std::make_shared<const std::vector<Values>>(components);
    values.draw = [shared](DrawContext& context, Words& words) {
        for (const Values& component : *shared) component.draw(context, words);
    };
    std::vector<std::size_t> sizes;
    for (const Values& component : components) {
        sizes.push_back(component.words());
        values.floats.insert(values.floats.end(), component.floats.begin(), component.floats.end());
    }
    if (values.floats.size() != std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}))
        values.floats.clear();  // one is unknown
    values.contains = [shared, sizes](std::span<const Word> words) {
        for (std::size_t i = 0; i < shared->size(); words = words.subspan(sizes[i++]))
            if (!shared->at(i).admits(words.first(sizes[i]))) return false;
        return true;
    };
    numeric::Random random(2);
    std::size_t first = 0;
    std::size_t met = 0;
    const std::size_t one_of = fixed_stride(components);
    for (std::size_t i = 0; i < components.size(); first += sizes[i++]) {
        const Values& component = components[i];
        for (const std::size_t size : component.image_sizes) values.image_sizes.push_back(first + size);
        for (const Values::Fixed& fixed : component.fixed) {
            if (met++ % one_of != 0) continue;
            DrawContext context{.random = random};
            Values::Fixed one{.words = {}, .branch = fixed.branch};
            values.draw(context, one.words);
            std::ranges::copy(fixed.words, one.words.begin() + static_cast<std::ptrdiff_t>(first));
            values.fixed.push_back(std::move(one));
        }
    }
    return values;
}

namespace {

void append_point(double radius, double angle, Words& words) {
    words.push_back(to_word(static_cast<float>(radius * std::cos(angle))));
    words.push_back(to_word(static_cast<float>(radius * std::sin(angle))));
}

}  // namespace

Values unit_vector(int components) {
    if (components < 2 || components > 4) throw std::invalid_argument("unit_vector has 2, 3 or 4 components");
    constexpr double turn = 2.0 * std::numbers::pi;
    Values values{.floats = std::vector(static_cast<std::size_t>(components), true)};
    values.draw = [components](DrawContext& context, Words& words) {
        numeric::Random& random = context.random;
        if (components == 4) {  // two points on circles, whose squared radii add up to 1
            const double share = random.unit();
            for (const double radius : {std::sqrt(1.0 - share), std::sqrt(share)})
                append_point(radius, random.uniform(0.0, turn), words);
            return;
        }
        const double angle = random.uniform(0.0, turn);
        const double z = components == 3 ? random.uniform(-1.0, 1.0) : 0.0;
        append_point(std::sqrt(1.0 - z * z), angle, words);
        if (components == 3) words.push_back(to_word(static_cast<float>(z)));
    };
    values.contains = [](std::span<const Word> words) {
        return std::abs(squared_length(words) - 1.0) <= 0x1p-22;  // within the rounding error of drawn values
    };
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(components); ++axis) {
        for (const float sign : {1.0F, -1.0F}) {
            Values::Fixed& fixed = values.fixed.emplace_back();
            fixed.words.resize(static_cast<std::size_t>(components));
            fixed.words[axis] = to_word(sign);
        }
    }
    return values;
}

Values vector_of_length(int components, const Values& length) {
    Values values{.floats = std::vector(static_cast<std::size_t>(components), true)};
    values.draw = [direction = unit_vector(components), length](DrawContext& context, Words& words) {
        Words scale;
        length.draw(context, scale);
        const std::size_t first = words.size();
        direction.draw(context, words);
        for (std::size_t i = first; i < words.size(); ++i)
            words[i] = to_word(from_word<float>(words[i]) * from_word<float>(scale.front()));
    };
    values.contains = [length](std::span<const Word> words) {
        const Word measured = to_word(std::sqrt(squared_length(words)));
        return length.admits(std::span(&measured, 1));
    };
    return values;
}

Values either(const Values& a, const Values& b) {
    Values values{.fixed = a.fixed, .floats = a.floats == b.floats ? a.floats : std::vector<bool>{}};
    values.fixed.insert(values.fixed.end(), b.fixed.begin(), b.fixed.end());
    values.draw = [a, b](DrawContext& context, Words& words) {
        (context.random.below(2) == 0 ? a : b).draw(context, words);
    };
    values.contains = [a, b](std::span<const Word> words) { return a.admits(words) || b.admits(words); };
    return values;
}

Values image_pixel() {
    Values values;
    values.draw = [](DrawContext& context, Words& words) {
        for (int axis = 0; axis < 2; ++axis)
            words.push_back(static_cast<Word>(
                context.random.below(static_cast<std::uint64_t>(context.image_size[axis]))));
    };
    return values;
}

Values image_size() {
    Values values{.image_sizes = {0}};
    values.draw = [](DrawContext& context, Words& words) { append_words(context.image_size, words); };
    return values;
}

std::optional<Range> range_of(const Ranges& ranges, const std::string& name) {
    const auto found = ranges.find(name);
    if (found != ranges.end()) return found->second;
    const std::size_t dot = name.rfind('.');
    return dot == std::string::npos ? std::nullopt : range_of(ranges, name.substr(0, dot));
}

std::pair<std::string, Range> range_from(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::size_t colon = text.find(':', std::min(equals, text.size()));
    const bool has_ends = equals != 0 && equals != std::string::npos && colon != std::string::npos;
    const auto number = [&](std::size_t from, std::size_t to) {
        return has_ends ? base::number_from<double>(text.substr(from + 1, to - from - 1)) : std::nullopt;
    };
    const auto low = number(equals, colon);
    const auto high = number(colon, text.size());
    if (!low || !high) throw std::invalid_argument(fmt::format("--range {}: expected NAME=LOW:HIGH", text));
    const Range range{*low, *high};
    if (!range.is_valid())
        throw std::invalid_argument(fmt::format("--range {}: expected finite floats, LOW <= HIGH", text));
    return {text.substr(0, equals), range};
}

}  // namespace gloam::subject
