// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "base/half.hpp"
#include "interpreter/internal/integers.hpp"
#include "interpreter/internal/vectors.hpp"
#include "numeric/paths.hpp"

// Conversions between floats and integers, between floats and their parts, and to and from packed words.
namespace gloam::interpreter::internal {

// An integer as a number of the instruction's format, correctly rounded.
template <class N, class I>
[[nodiscard]] N from_integer(I x) {
    if constexpr (std::is_same_v<N, numeric::Rearranged>) {
        return N(numeric::Interval(x));
    } else if constexpr (std::is_same_v<N, Explained>) {
        const auto exact = static_cast<double>(x);
        const double value = static_cast<float>(x);
        return {.value = value, .exact = exact, .local = value - exact, .permitted = numeric::Interval(x)};
    } else {
        return static_cast<N>(x);
    }
}

template <class N, class I>
void convert_integer(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k)
        s.set(i, i.result + k, from_integer<N>(static_cast<I>(s.bits(i.a + k))));
}

// Whether an integer has the whole part of a number. Intervals tell by themselves (ToInteger).
template <class I, class N>
[[nodiscard]] bool fits(const N& x) {
    if constexpr (std::is_same_v<N, double>) {
        constexpr double end = 0x1p31 * (std::is_signed_v<I> ? 1.0 : 2.0);
        return x > (std::is_signed_v<I> ? -0x1p31 - 1.0 : -1.0) && x < end;
    } else if constexpr (std::is_same_v<N, Explained>) {
        return fits<I>(x.value);
    } else {
        return true;
    }
}

template <class N, class I>
void convert_to_integer(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        s.set_if(fits<I>(x), i, i.result + k, static_cast<Word>(apply(ToInteger<I>{}, x)));
    }
}

// Of one format to another.
template <class N>
void convert_float(State<N>& s, const Instruction& i) {
    const bool half = (i.flags & flags::half) != 0;
    const auto rounded = [half](double x) {
        return half ? scalars::quantize_to_half(x) : double{static_cast<float>(x)};
    };
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Value<N>& from = s.slots[i.a + k];
        if (from.is_undefined()) {
            s.slots[i.result + k] = from;
        } else if constexpr (std::is_same_v<N, float>) {
            s.slots[i.result + k] = Value<N>::of(static_cast<float>(rounded(from.number())));
        } else if constexpr (std::is_same_v<N, double>) {
            s.set(i, i.result + k, from.number());
        } else if constexpr (std::is_same_v<N, Explained>) {
            N x = from.number();
            const double before = std::exchange(x.value, rounded(x.value));
            x.local = std::isfinite(x.value) ? x.value - before : 0.0;
            x.permitted = numeric::enclose(x.permitted.bounds());
            s.set(i, i.result + k, x);
        } else {
            s.set(i, i.result + k, N(numeric::enclose(settled(from.number()).bounds())));
        }
    }
}

struct Scale {
    int exponent;
    template <class N>
    N operator()(const N& x) const {
        if constexpr (std::is_floating_point_v<N>)
            return std::ldexp(x, exponent);
        else
            return numeric::times_power_of_two(x, exponent);
    }
};
struct LoadExponent {
    int exponent;
    template <class N>
    N operator()(const N& x) const {
        using namespace scalars;
        return ldexp(x, exponent);
    }
};

// ldexp(): undefined for a larger exponent than the type's, and for a product beyond it.
template <class N>
void load_exponent(State<N>& s, const Instruction& i) {
    const auto& format = (i.flags & flags::half) != 0 ? numeric::float16 : numeric::float32;
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        const int exponent = as_int(s.bits(i.b + k));
        const N product = assumed(i, apply(LoadExponent{exponent}, x), x);
        const double value = std::abs(known_value(x));
        const bool too_large = std::isfinite(value) && std::ldexp(value, exponent) > format.largest();
        s.set_if(exponent <= format.max_exponent + 1 && !too_large, i, i.result + k, product);
    }
}

// The fraction of an infinite number is 0 or NaN: no text says which.
template <class N>
[[nodiscard]] N with_zero_of_infinity(const N& x, const N& fraction) {
    const auto either = [](const numeric::Interval& part, const numeric::Interval& of) {
        const numeric::Bounds& b = of.bounds();
        if (b.empty() || !(std::isinf(b.low) || std::isinf(b.high))) return part;
        return numeric::Interval::within(numeric::hull(part.bounds(), numeric::Bounds::point(0.0)));
    };
    return with_permitted(either, fraction, x);
}

// modf(): fractions, then integral parts; both have the sign of the argument.
template <class N>
void modf(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        const N whole = apply(Trunc{}, x);
        s.set(i, i.result + k, assumed(i, with_zero_of_infinity(x, apply(Subtract{}, x, whole)), x));
        s.set(i, i.result + i.count + k, assumed(i, whole, x));
    }
}

// The exponent of frexp(): |x| in [2^(e-1), 2^e). On intervals each possible exponent is explored.
struct ExponentOf {
    template <class N>
    int operator()(const N& x) const {
        int exponent = 0;
        if (std::isfinite(x)) (void)std::frexp(static_cast<double>(x), &exponent);
        return exponent;
    }
    int operator()(const numeric::Interval& x) const {
        if (x.may_be_nan() || x.bounds().empty() || !std::isfinite(x.low()) || !std::isfinite(x.high()))
            throw numeric::Paths::Undetermined{};
        const bool crosses = x.low() < 0.0 && x.high() > 0.0;
        const bool touches = x.bounds().contains(0.0) && !(x.low() == 0.0 && x.high() == 0.0);
        if (crosses || touches) throw numeric::Paths::Undetermined{};
        const auto [low, high] = std::minmax({(*this)(x.low()), (*this)(x.high())});
        return low + static_cast<int>(numeric::Paths::choose(static_cast<std::size_t>(high - low) + 1));
    }
};

// frexp(): significands, then exponents.
template <class N>
void frexp(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        const int exponent = apply(ExponentOf{}, x);
        s.set(i, i.result + k, apply(Scale{-exponent}, x));
        s.set(i, i.result + i.count + k, exponent);
    }
}

// Packs round(clamp(x, low, 1) * scale) into the fields of a word.
template <class N, int Fields, bool Signed>
void pack(State<N>& s, const Instruction& i) {
    constexpr Word width = word_bits / Fields;
    constexpr double scale = Signed ? (1U << (width - 1U)) - 1U : mask_of(width);
    Word packed = 0;
    for (std::uint32_t k = 0; k < Fields; ++k) {
        const N x = s.number(i, i.a + k);
        const N clamped =
            assumed(i, apply(Clamp{}, x, constant<N>(Signed ? -1.0 : 0.0), constant<N>(1.0)), x);
        const N scaled = apply(Round{}, apply(Multiply{}, clamped, constant<N>(scale)));
        packed |= (static_cast<Word>(apply(ToInteger<std::int32_t>{}, scaled)) & mask_of(width))
                  << (k * width);
    }
    s.set(i, i.result, packed);
}

template <class N, int Fields, bool Signed>
void unpack(State<N>& s, const Instruction& i) {
    constexpr Word width = word_bits / Fields;
    constexpr double scale = Signed ? (1U << (width - 1U)) - 1U : mask_of(width);
    const Word packed = s.bits(i.a);
    for (std::uint32_t k = 0; k < Fields; ++k) {
        const Word field = extracted(packed, k * width, width, Signed);
        const N number = from_integer<N>(as_int(field));
        const N unit = apply(Divide{}, number, constant<N>(scale));
        s.set(i, i.result + k, Signed ? apply(Clamp{}, unit, constant<N>(-1.0), constant<N>(1.0)) : unit);
    }
}

// The bits of a float with the value of the half that has these bits.
[[nodiscard]] inline Word float_of_half(Word bits) {
    return std::bit_cast<Word>(base::from_half(static_cast<std::uint16_t>(bits)));
}

struct HalfBits {
    template <class N>
    Word operator()(const N& x) const {
        return base::to_half(static_cast<float>(x));
    }
    Word operator()(const numeric::Interval& x) const;
};

// Words from the bits of pairs of halves, and back.
template <class N>
void do_pack_halves(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Word low = apply(HalfBits{}, s.slots[i.a + 2 * k].number());
        const Word word = low | apply(HalfBits{}, s.slots[i.a + 2 * k + 1].number()) << 16U;
        s.slots[i.result + k] = i.b != 0 ? Value<N>::of_float(word) : Value<N>::of_bits(word);
    }
}
template <class N>
void do_unpack_halves(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Word bits = s.bits(i.a + k / 2) >> (16U * (k % 2)) & 0xffffU;
        s.slots[i.result + k] = Value<N>::of_float(float_of_half(bits));
    }
}

template <class N>
void pack_half(State<N>& s, const Instruction& i) {
    const auto bits_of = [&](std::uint32_t slot) {
        const N x = s.number(i, slot);
        return apply(HalfBits{}, assumed(i, x, x));
    };
    const Word low = bits_of(i.a);
    s.set(i, i.result, low | bits_of(i.a + 1) << 16U);
}

template <class N>
void unpack_half(State<N>& s, const Instruction& i) {
    const Word packed = s.bits(i.a);
    for (std::uint32_t k = 0; k < 2; ++k)
        s.set(i, i.result + k, number_from_bits<N>(float_of_half(packed >> (16U * k) & 0xffffU)));
}

}  // namespace gloam::interpreter::internal
