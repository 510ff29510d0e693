// SPDX-License-Identifier: MIT
// Reads lines of an operation and the bits of its operands, "exp2 3f800000 0", and prints the bits of the
// least and the largest float that the rules permit, for bounds_test.py.
#include <bit>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>

#include "numeric/interval.hpp"

namespace gloam::numeric {
namespace {

using Operation = std::function<Interval(const Interval&, const Interval&)>;

const std::map<std::string, Operation> operations{
    {"add", [](const Interval& x, const Interval& y) { return x + y; }},
    {"multiply", [](const Interval& x, const Interval& y) { return x * y; }},
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

std::uint32_t bits_of(double end) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(end));
}

void print_all() {
    std::string name;
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    while (std::cin >> name >> std::hex >> x >> y) {
        const Bounds bounds =
            operations
                .at(name)(Interval::input(std::bit_cast<float>(x)), Interval::input(std::bit_cast<float>(y)))
                .bounds();
        std::cout << std::hex << bits_of(bounds.low) << ' ' << bits_of(bounds.high) << '\n';
    }
}

}  // namespace
}  // namespace gloam::numeric

int main() {
    gloam::numeric::print_all();
    return 0;
}
