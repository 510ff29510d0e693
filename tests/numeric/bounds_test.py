# SPDX-License-Identifier: MIT
"""Calculates anew, in exact fractions and decimals, what Vulkan's rules permit to an operation, and compares it to
the bit with the bounds of the interpreter's numbers, in float32 and in float16.

bounds_test.py PROGRAM: 250 inputs for each operation and format, or GLOAM_BOUNDS_INPUTS of them."""

import math
import os
import random
import struct
import subprocess
import sys
from decimal import Decimal, getcontext
from fractions import Fraction

getcontext().prec = 60
SMALL = Fraction(1, 2**40)  # below it, two terms of a series say more than 60 digits
INFINITY = math.inf
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494")
LN2 = Decimal(2).ln()


class Format:
    """A float format: digits of the significand, bias of the exponent, and the errors that Vulkan permits in it."""

    def __init__(self, bits, digits, bias, exp_ulps, log_error, sine_error, atan_ulps):
        self.bits, self.digits, self.bias = bits, digits, bias
        self.exp_ulps, self.log_error, self.sine_error, self.atan_ulps = exp_ulps, log_error, sine_error, atan_ulps
        self.normal = Fraction(2) ** (1 - bias)
        self.largest = Fraction(2) ** (bias + 1) - self.gap(Fraction(2) ** bias)

    def gap(self, x):
        """Of the floats around x, above zero."""
        return Fraction(2) ** (max(exponent(x), 1 - self.bias) - self.digits + 1)


def to_float(bits):
    return struct.unpack("<f", struct.pack("<I", bits))[0]


def exponent(x):
    """floor(log2(|x|))"""
    guess = abs(x).numerator.bit_length() - x.denominator.bit_length()
    return guess - 1 if abs(x) < Fraction(2) ** guess else guess


def down(x):
    """The largest float that is at most x."""
    if x in (0, INFINITY, -INFINITY):
        return x
    if x > F.largest:
        return F.largest
    if x < -F.largest:
        return -INFINITY
    return math.floor(x / F.gap(x)) * F.gap(x)


def up(x):
    return -down(-x)


def ulp(x):
    """Harrison's: the distance of the two nearest floats that enclose x."""
    if x == 0:
        return F.gap(F.normal)
    if abs(x) >= F.largest:
        return F.gap(F.largest)
    power = Fraction(2) ** exponent(x)
    return F.gap(x) / 2 if abs(x) == power and power > F.normal else F.gap(x)


def flushed(low, high):
    return 0 if 0 < low < F.normal else low, 0 if -F.normal < high < 0 else high


def rounded(low, high):
    """Correctly rounded: either neighbour."""
    return flushed(down(low), up(high))


def inside(low, high):
    """The floats between two ends; beyond the largest one, it or infinity."""
    first = -INFINITY if low < -F.largest else min(up(low), F.largest)
    last = INFINITY if high > F.largest else max(down(high), -F.largest)
    return flushed(first, last)


def within_ulps(x, count):
    return inside(x - count * ulp(x), x + count * ulp(x))


def root(x):
    return Decimal(x.numerator) / Decimal(x.denominator)


def logarithm(x, base):
    if x == 1:
        return Fraction(0)
    number = abs(root(x)).ln() / base
    whole = round(number)
    return Fraction(whole) if base == LN2 and Fraction(2) ** whole == x else Fraction(number)


def log_bounds(x, base):
    value = logarithm(x, base)
    if x < Fraction(1, 2) or x > 2:
        return within_ulps(value, 3)
    error = F.log_error  # "<": the ends themselves are outside
    low, high = inside(value - error, value + error)
    low = up(low + Fraction(1, 2**160)) if low == value - error else low
    return low, down(high - Fraction(1, 2**160)) if high == value + error else high


def power(x, factor):
    """exp(x * factor)"""
    if abs(x) < SMALL:
        step = x * Fraction(factor)
        return 1 + step + step * step / 2
    if x * Fraction(factor) > 200:
        return Fraction(2) ** 300
    if x * Fraction(factor) < -400:
        return Fraction(1, 2**500)
    whole = x.denominator == 1 and factor == LN2
    return Fraction(2) ** x.numerator if whole else Fraction((root(x) * factor).exp())


def power_bounds(x, factor):
    low, high = within_ulps(power(x, factor), F.exp_ulps + 2 * abs(x))
    return max(low, 0), high


def sine(x):
    """Of a decimal in [-4, 4]."""
    term, total, k = x, x, 1
    while abs(term) > Decimal(10) ** -58:
        k += 2
        term = -term * x * x / (k * (k - 1))
        total += term
    return total


def sine_bounds(value):
    low, high = inside(value - F.sine_error, value + F.sine_error)
    return max(low, -1), min(high, 1)


def sin_bounds(x):
    return sine_bounds(x - x**3 / 6 if abs(x) < SMALL else Fraction(sine(root(x))))


def cos_bounds(x):
    return sine_bounds(1 - x * x / 2 if abs(x) < SMALL else Fraction(sine(PI / 2 - root(x))))


def arc(x):
    if abs(x) < SMALL:
        return x - x**3 / 3
    t = root(x)
    for _ in range(4):
        t = t / (1 + (1 + t * t).sqrt())
    term, total, k = t, t, 1
    while abs(term) > abs(total) * Decimal(10) ** -58:
        term = -term * t * t
        k += 2
        total += term / k
    return Fraction(total * 16)


def exact(x):
    return x, x


def times_constant(x, constant):
    constants = down(Fraction(constant)), up(Fraction(constant))
    products = [x * c for c in constants]
    return rounded(min(products), max(products))


RULES = {
    "add": lambda x, y: rounded(x + y, x + y),
    "multiply": lambda x, y: rounded(x * y, x * y),
    "floor": lambda x, _: exact(math.floor(x)),
    "ceil": lambda x, _: exact(math.ceil(x)),
    "trunc": lambda x, _: exact(math.trunc(x)),
    "fract": lambda x, _: rounded(x - math.floor(x), x - math.floor(x)),
    "divide": lambda x, y: within_ulps(x / y, Fraction(5, 2)),
    "degrees": lambda x, _: times_constant(x, Decimal(180) / PI),
    "radians": lambda x, _: times_constant(x, PI / Decimal(180)),
    "inversesqrt": lambda x, _: within_ulps(Fraction(1 / root(x).sqrt()), 2),
    "exp": lambda x, _: power_bounds(x, Decimal(1)),
    "exp2": lambda x, _: power_bounds(x, LN2),
    "log": lambda x, _: log_bounds(x, Decimal(1)),
    "log2": lambda x, _: log_bounds(x, LN2),
    "sin": lambda x, _: sin_bounds(x),
    "cos": lambda x, _: cos_bounds(x),
    "atan": lambda x, _: within_ulps(arc(x), F.atan_ulps),
}
POSITIVE = {"inversesqrt", "log", "log2"}


def draw(numbers, name):
    """A normal float: of usual size, beside a power of two, or any."""
    kind = numbers.randrange(4)
    sign = 1 if name in POSITIVE else numbers.choice((-1, 1))
    if name in ("sin", "cos"):
        power_of_two = -numbers.randrange(min(F.bias, 40)) if kind < 3 else numbers.randrange(1 - F.bias, 1)
    elif kind == 3:
        power_of_two = numbers.randrange(1 - F.bias, F.bias + 1)
    else:
        power_of_two = numbers.randrange(-8, 8)
    whole = 2 ** (F.digits - 1)
    fraction = numbers.randrange(4) if kind == 1 else numbers.randrange(whole)
    if kind == 1 and numbers.randrange(2):
        fraction = whole - 1 - fraction
    return sign * Fraction(whole + fraction, whole) * Fraction(2) ** power_of_two


def cases(numbers, name, count):
    while count > 0:
        x, y = draw(numbers, name), draw(numbers, name)
        if name == "divide" and abs(y) >= Fraction(2) ** (F.bias - 1):  # nothing is promised
            continue
        count -= 1
        yield x, y


def text_of(x):
    return repr(float(x))


def compare(program, name, count):
    """The number of inputs with other bounds, and of those where the difference is within the error of double."""
    inputs = list(cases(random.Random(f"{name}{F.bits}"), name, count))
    lines = "".join(f"{name} {F.bits} {float(x).hex()} {float(y).hex()}\n" for x, y in inputs)
    answers = subprocess.run([program], input=lines, capture_output=True, text=True, check=True).stdout.split("\n")
    wrong = 0
    for (x, y), answer in zip(inputs, answers):
        got = tuple(to_float(int(bits, 16)) for bits in answer.split())
        want = RULES[name](x, y)
        if got == tuple(map(float, want)):
            continue
        wrong += 1
        if wrong < 4:
            print(f"{name}({text_of(x)}, {text_of(y)}): got {got}, want {tuple(map(text_of, want))}")
    return wrong


def main(program):
    global F
    count = int(os.environ.get("GLOAM_BOUNDS_INPUTS", "250"))
    failed = {}
    for F in (Format(32, 24, 127, 3, Fraction(1, 2**21), Fraction(1, 2**11), 4096),
              Format(16, 11, 15, 1, Fraction(1, 2**7), Fraction(1, 2**7), 5)):
        for name in RULES:
            wrong = compare(program, name, count)
            if wrong > count // 100_000:  # double tells the ends from a float beside them but for one in 2^26
                failed[f"{name} of float{F.bits}"] = wrong
    print(f"{count} inputs for each of {len(RULES)} operations in two formats; other bounds: {failed or 'none'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
