// SPDX-License-Identifier: MIT
#include "interpreter/number.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/gtc/packing.hpp>

#include "interpreter/internal/conversions.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

namespace gloam::interpreter {

template <>
float number_from_bits<float>(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}
template <>
double number_from_bits<double>(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}
template <>
numeric::Interval number_from_bits<numeric::Interval>(std::uint32_t bits) {
    return numeric::Interval::input(std::bit_cast<float>(bits));
}
template <>
numeric::Rearranged number_from_bits<numeric::Rearranged>(std::uint32_t bits) {
    return numeric::Rearranged(number_from_bits<numeric::Interval>(bits));
}
template <>
Explained number_from_bits<Explained>(std::uint32_t bits) {
    const auto value = std::bit_cast<float>(bits);
    return {.value = value, .exact = value, .local = 0.0, .permitted = numeric::Interval::input(value)};
}

template <>
double undefined_number<double>() {
    return 0.0;
}
template <>
numeric::Interval undefined_number<numeric::Interval>() {
    return numeric::Interval::anything();
}
template <>
numeric::Rearranged undefined_number<numeric::Rearranged>() {
    return numeric::Rearranged(numeric::Interval::anything());
}
template <>
Explained undefined_number<Explained>() {
    return {.value = 0.0F, .exact = 0.0, .local = 0.0, .permitted = numeric::Interval::anything()};
}

template <>
std::uint32_t undefined_bits<double>() {
    return 0;
}
template <>
std::uint32_t undefined_bits<Explained>() {
    return 0;
}
template <>
std::uint32_t undefined_bits<numeric::Interval>() {
    throw numeric::Paths::Undetermined{};
}
template <>
std::uint32_t undefined_bits<numeric::Rearranged>() {
    throw numeric::Paths::Undetermined{};
}

std::uint32_t sign_bit(const numeric::Interval& x) {
    const bool may_be_positive = x.may_be_nan() || x.high() >= 0.0;
    const bool may_be_negative = x.may_be_nan() || x.low() <= 0.0;
    if (may_be_positive && may_be_negative) return static_cast<std::uint32_t>(numeric::Paths::choose(2));
    return may_be_negative ? 1U : 0U;
}
std::uint32_t sign_bit(const numeric::Rearranged& x) {
    return sign_bit(x.interval());
}

template <>
std::optional<float> exponent_field(const float&) {
    return std::nullopt;
}
template <>
std::optional<double> exponent_field(const double&) {
    return std::nullopt;
}
template <>
std::optional<Explained> exponent_field(const Explained&) {
    return std::nullopt;
}
namespace {

// The power of two whose float has the exponent of that magnitude: 0 for 0 and subnormal numbers.
double power_of(double magnitude) {
    constexpr double smallest_normal = 0x1p-126;
    constexpr double largest_power = 0x1p127;
    if (magnitude < smallest_normal) return 0.0;
    return std::min(std::exp2(std::ilogb(magnitude)), largest_power);
}

}  // namespace

template <>
std::optional<numeric::Interval> exponent_field(const numeric::Interval& x) {
    if (!numeric::is_finite(x)) return number_from_bits<numeric::Interval>(exponent_mask);
    const double low = std::abs(x.low());
    const double high = std::abs(x.high());
    const bool has_zero = x.low() <= 0.0 && x.high() >= 0.0;
    return numeric::Interval::within(has_zero ? 0.0 : power_of(std::min(low, high)),
                                     power_of(std::max(low, high)));
}
template <>
std::optional<numeric::Rearranged> exponent_field(const numeric::Rearranged& x) {
    const std::optional<numeric::Interval> field = exponent_field(x.interval());
    return field ? std::optional(numeric::Rearranged(*field)) : std::nullopt;
}

std::uint32_t bits_from_number(double x) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(x));
}
std::uint32_t bits_from_number(const numeric::Interval& x) {
    return numeric::to_bits(x);
}
std::uint32_t bits_from_number(const numeric::Rearranged& x) {
    return numeric::to_bits(x.interval());
}
std::uint32_t bits_from_number(const Explained& x) {
    return bits_from_number(x.value);
}

namespace internal {

Word half_bits(float x) {
    return glm::packHalf1x16(scalars::quantize_to_half(x));
}

float half_value(Word bits) {
    return glm::unpackHalf1x16(static_cast<glm::uint16>(bits));
}

// One of the possible halfs. Their bits increase with their magnitude; a subnormal may be flushed to zero.
Word HalfBits::operator()(const numeric::Interval& x) const {
    constexpr int most = 64;
    constexpr int sign = 0x8000;
    if (x.may_be_nan() || x.bounds().empty()) throw numeric::Paths::Undetermined{};
    const auto ordinal = [](double value) {
        const auto bits = static_cast<int>(half_bits(static_cast<float>(value)));
        return (bits & sign) != 0 ? -(bits & ~sign) : bits;
    };
    const int low = ordinal(numeric::float16.round_down(x.low()));
    const int high = ordinal(numeric::float16.round_up(x.high()));
    if (high - low >= most) throw numeric::Paths::Undetermined{};
    std::vector<int> halfs;
    for (int taken = low; taken <= high; ++taken) halfs.push_back(taken < 0 ? -taken | sign : taken);
    const double normal = numeric::float16.smallest_normal();
    if (x.low() < normal && x.high() > -normal) halfs.insert(halfs.end(), {0, sign});
    return static_cast<Word>(halfs[numeric::Paths::choose(halfs.size())]);
}

}  // namespace internal
}  // namespace gloam::interpreter
