// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

// Visits the members of a small aggregate in order, so that a plain struct needs no description of its own.
namespace gloam::check {
namespace detail {

struct AnyField {
    template <class T>
    operator T() const;  // never defined: used in unevaluated contexts only
};

template <class T, std::size_t... I>
constexpr bool initializable(std::index_sequence<I...>) {
    return requires { T{((void)I, AnyField{})...}; };
}

template <class T, std::size_t N = 9>
constexpr std::size_t field_count() {
    if constexpr (N == 0) {
        return 0;
    } else if constexpr (initializable<T>(std::make_index_sequence<N>{})) {
        return N;
    } else {
        return field_count<T, N - 1>();
    }
}

}  // namespace detail

// Calls visit(member&) for each member of an aggregate of 1 to 9 members.
template <class T, class Visit>
void for_each_field(T& value, Visit&& visit) {
    using Value = std::remove_const_t<T>;
    static_assert(std::is_aggregate_v<Value>,
                  "a parameter must be a scalar, a GLM vector or matrix, or a plain struct of those");
    constexpr std::size_t count = detail::field_count<Value>();
    static_assert(count > 0 && !detail::initializable<Value>(std::make_index_sequence<10>{}),
                  "a struct has 1 to 9 members");
    const auto all = [&visit](auto&... fields) { (visit(fields), ...); };
    if constexpr (count == 1) {
        auto& [a] = value;
        all(a);
    } else if constexpr (count == 2) {
        auto& [a, b] = value;
        all(a, b);
    } else if constexpr (count == 3) {
        auto& [a, b, c] = value;
        all(a, b, c);
    } else if constexpr (count == 4) {
        auto& [a, b, c, d] = value;
        all(a, b, c, d);
    } else if constexpr (count == 5) {
        auto& [a, b, c, d, e] = value;
        all(a, b, c, d, e);
    } else if constexpr (count == 6) {
        auto& [a, b, c, d, e, f] = value;
        all(a, b, c, d, e, f);
    } else if constexpr (count == 7) {
        auto& [a, b, c, d, e, f, g] = value;
        all(a, b, c, d, e, f, g);
    } else if constexpr (count == 8) {
        auto& [a, b, c, d, e, f, g, h] = value;
        all(a, b, c, d, e, f, g, h);
    } else {
        auto& [a, b, c, d, e, f, g, h, i] = value;
        all(a, b, c, d, e, f, g, h, i);
    }
}

}  // namespace gloam::check
