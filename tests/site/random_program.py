# SPDX-License-Identifier: MIT
"""Random functions of integers in GLSL: loops, switches, early returns, outputs, short circuits."""
import random

HEAD = """int g(ivec2 v) { return v.x > v.y ? v.x - v.y : v.x & v.y; }
int h(int k, inout int s) { s += k; if (s > 20) s -= 7; k *= 2; return s ^ k; }
int f(int a, int b) {
    int s = b;
    ivec2 p = ivec2(a, b);
    int array[4] = int[4](a, b, 3, 4);
"""
TAIL = """
    return s * 3 + p.x * 5 + p.y * 7 + array[0] + array[1] * 11 + array[2] * 13 + array[3] * 17 + a * 19;
}
"""


class Program:
    """The function f(int a, int b) of a seed. No expression has a side effect: GLSL does not say in which order
    operands are evaluated."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.variables = 0
        self.changing = ["a", "s"]
        self.text = HEAD + self.block(["a", "b", "s", "p.x", "p.y"], 3, None) + TAIL

    def number(self, names, depth):
        choose = self.random.choice
        if depth <= 0 or self.random.random() < 0.2:
            return choose([*names, str(self.random.randint(0, 9))])
        x, y = self.number(names, depth - 1), self.number(names, depth - 1)
        return choose([
            lambda: f"({x} {choose('+-*&|^')} {y})",
            lambda: f"({x} {choose('+-*&|^')} {y})",
            lambda: f"({self.truth(names, depth - 1)} ? {x} : {y})",
            lambda: f"({self.truth(names, depth - 1)} ? g(ivec2({x}, {y})) : {x})",
            lambda: f"min({x}, {y})",
            lambda: f"({x} << 1)",
            lambda: f"array[{x} & 3]",
            lambda: f"g(ivec2({x}, {y}).yx)"])()

    def truth(self, names, depth):
        choose = self.random.choice
        if depth <= 0 or self.random.random() < 0.4:
            compare = choose(["<", ">", "<=", "==", "!="])
            return f"({self.number(names, depth - 1)} {compare} {self.number(names, depth - 1)})"
        x, y = self.truth(names, depth - 1), self.truth(names, depth - 1)
        return choose([f"({x} && {y})", f"({x} || {y})", f"!{x}"])

    def block(self, names, depth, inside):
        names, changing = list(names), list(self.changing)
        lines = [self.statement(names, depth, inside) for _ in range(self.random.randint(1, 4))]
        self.changing = changing
        return "\n".join(lines)

    def new_name(self):
        self.variables += 1
        return f"v{self.variables}"

    def statement(self, names, depth, inside):
        nested = [self.selection, self.loop, self.switch] if depth > 0 else []
        leave = [self.leave] if inside else []
        return self.random.choice([self.declaration, self.assignment, self.assignment, self.element, self.call,
                                   self.early_return, *nested, *nested, *leave])(names, depth, inside)

    def declaration(self, names, *_):
        value, name = self.number(names, 3), self.new_name()
        names.append(name)
        self.changing = [*self.changing, name]
        return f"int {name} = {value};"

    def assignment(self, names, *_):
        change = self.random.choice(["=", "+=", "-=", "^="])
        return f"{self.random.choice([*self.changing, 'p.x', 'p.y'])} {change} {self.number(names, 3)};"

    def element(self, names, *_):
        return f"array[{self.number(names, 1)} & 3] = {self.number(names, 2)};"

    def call(self, names, *_):
        result, changed = self.random.sample(self.changing, 2)
        return f"{result} = h({self.number(names, 2)}, {changed});"

    def early_return(self, names, *_):
        return f"if (a == {self.random.randint(-8, 7)}) return {self.number(names, 2)};"

    def selection(self, names, depth, inside):
        text = f"if ({self.truth(names, 2)}) {{\n{self.block(names, depth - 1, inside)}\n}}"
        return text + (f" else {{\n{self.block(names, depth - 1, inside)}\n}}" if self.random.random() < 0.5 else "")

    def loop(self, names, depth, _):
        name = self.new_name()
        further = f" && {self.truth(names, 1)}" if self.random.random() < 0.3 else ""
        return (f"for (int {name} = 0; {name} < {self.random.randint(1, 4)}{further}; ++{name}) {{\n"
                f"{self.block([*names, name], depth - 1, 'loop')}\n}}")

    def switch(self, names, depth, _):
        cases = ""
        for label in range(self.random.randint(1, 3)):
            ends = "break;\n" if self.random.random() < 0.6 else ""
            cases += f"case {label}: {{\n{self.block(names, depth - 1, 'switch')}\n}}\n{ends}"
        last = self.block(names, depth - 1, "switch")
        return f"switch ({self.number(names, 2)} & 3) {{\n{cases}default: {{\n{last}\n}}\n}}"

    def leave(self, names, _, inside):
        jump = self.random.choice(["break", "continue"] if inside == "loop" else ["break"])
        return f"if ({self.truth(names, 2)}) {jump};"
