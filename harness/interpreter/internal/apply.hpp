// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "interpreter/internal/scalars.hpp"
#include "interpreter/number.hpp"
#include "numeric/paths.hpp"

namespace gloam::interpreter::internal {

// Converts a number of any type to one that the functions take; an expression that may be rearranged becomes
// its interval.
template <class N>
[[nodiscard]] const N& settled(const N& x) {
    return x;
}
[[nodiscard]] inline numeric::Interval settled(const numeric::Rearranged& x) {
    return x.interval();
}

// apply(f, x...): calls the function object f, which takes any of float, double and Interval, on a number
// type.
template <class F, class N, class... More>
[[nodiscard]] auto apply(const F& f, const N& x, const More&... more) {
    return f(x, more...);
}

// On Explained: calls f on every number type. If the result is a number, it also gets the local error.
template <class F, class... More>
[[nodiscard]] auto apply(const F& f, const Explained& x, const More&... more) {
    using Result = decltype(f(x.value, more.value...));
    if constexpr (std::is_same_v<Result, float>) {
        Explained result;
        result.value = f(x.value, more.value...);
        result.exact = f(x.exact, more.exact...);
        const double reached = f(static_cast<double>(x.value), static_cast<double>(more.value)...);
        result.local = static_cast<double>(result.value) - reached;
        result.permitted = f(x.permitted, more.permitted...);
        return result;
    } else {
        return f(x.value, more.value...);
    }
}

template <class F, class... More>
[[nodiscard]] auto apply(const F& f, const numeric::Rearranged& x, const More&... more) {
    const auto result = f(settled(x), settled(more)...);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(result)>, numeric::Interval>) {
        return numeric::Rearranged(result);
    } else {
        return result;
    }
}

// A constant as a number.
template <class N>
[[nodiscard]] N constant(double x) {
    return N(x);
}
template <>
[[nodiscard]] inline numeric::Rearranged constant(double x) {
    return numeric::Rearranged(numeric::Interval(x));
}
template <>
[[nodiscard]] inline Explained constant(double x) {
    return {.value = static_cast<float>(x), .exact = x, .local = 0.0, .permitted = numeric::Interval(x)};
}

// The result of a half-precision operation: on intervals it may have the precision of float16.
template <class N>
[[nodiscard]] N relaxed(const N& x) {
    return x;
}
[[nodiscard]] inline numeric::Interval relaxed(const numeric::Interval& x) {
    return numeric::enclose(x.bounds());
}
[[nodiscard]] inline numeric::Rearranged relaxed(const numeric::Rearranged& x) {
    return numeric::Rearranged(numeric::enclose(x.interval().bounds()));
}
[[nodiscard]] inline Explained relaxed(const Explained& x) {
    Explained result = x;
    result.permitted = numeric::enclose(x.permitted.bounds());
    return result;
}

}  // namespace gloam::interpreter::internal
