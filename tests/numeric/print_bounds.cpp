// SPDX-License-Identifier: MIT
// For bounds_test.py. Reads lines of an operation, the bits of a format and two operands, "exp2 16 0x1p+0
// 0x0p+0". Prints the bits of the least and of the largest number that the rules permit, as floats.
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "numeric/interval.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric {
namespace {

using Operation = std::function<Interval(const Interval&, const Interval&)>;

const std::map<std::string, Operation> operations{
    {"add", [](const Interval& x, const Interval& y) { return x + y; }},
    {"multiply", [](const Interval& x, const Interval& y) { return x * y; }},
    {"floor", [](const Interval& x, const Interval&) { return floor(x); }},
    {"ceil", [](const Interval& x, const Interval&) { return ceil(x); }},
    {"trunc", [](const Interval& x, const Interval&) { return trunc(x); }},
    {"fract", [](const Interval& x, const Interval&) { return fract(x); }},
    {"divide", [](const Interval& x, const Interval& y) { return x / y; }},
    {"degrees", [](const Interval& x, const Interval&) { return degrees(x); }},
    {"radians", [](const Interval& x, const Interval&) { return radians(x); }},
    {"inversesqrt", [](const Interval& x, const Interval&) { return inversesqrt(x); }},
    {"exp", [](const Interval& x, const Interval&) { return exp(x); }},
    {"exp2", [](const Interval& x, const Interval&) { return exp2(x); }},
    {"log", [](const Interval& x, const Interval&) { return log(x); }},
    {"log2", [](const Interval& x, const Interval&) { return log2(x); }},
    {"sin", [](const Interval& x, const Interval&) { return sin(x); }},
    {"cos", [](const Interval& x, const Interval&) { return cos(x); }},
    {"atan", [](const Interval& x, const Interval&) { return atan(x); }}};

Interval number_of(const std::string& text) {
    return Interval::input(std::strtof(text.c_str(), nullptr));
}

}  // namespace
}  // namespace gloam::numeric

int main() {
    using namespace gloam::numeric;
    std::string name;
    int bits = 0;
    std::string x;
    std::string y;
    while (std::cin >> name >> bits >> x >> y)
        Paths::explore(bits == 16 ? float16 : float32, 1, [&] {
            const Bounds bounds = operations.at(name)(number_of(x), number_of(y)).bounds();
            for (const double end : {bounds.low, bounds.high})
                std::cout << std::hex << std::bit_cast<std::uint32_t>(static_cast<float>(end)) << ' ';
            std::cout << '\n';
        });
    return 0;
}
