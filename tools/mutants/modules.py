# SPDX-License-Identifier: MIT
"""Whether a fault changes the SPIR-V of the shaders that include its file."""
import hashlib
import re
import shutil
import subprocess
from pathlib import Path

from faults import bare

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "release"


class Unable(Exception):
    """The script cannot run."""


def closure(file, root, done=None):
    """The text of a file and of all that it includes, each once, in order."""
    done = set() if done is None else done
    if file in done or not file.exists():
        return ""
    done.add(file)
    text = file.read_text(encoding="utf-8")
    parts = [closure(file.parent / name if (file.parent / name).exists() else root / name, root, done)
             for name in re.findall(r'^#include "([^"]+)"', text, re.M)]
    return "".join(parts) + text


def with_includes(text):
    """The text of a shader for the compiler's program, which takes #include only where it is asked for."""
    return re.sub(r"^(#version .*)$", r"\1\n#extension GL_GOOGLE_include_directive : require", text, count=1,
                  flags=re.M)


class Kernel:
    """A compute shader that calls each function of a library file with values of a buffer."""

    SCALARS = {"float": "{}", "int": "floatBitsToInt({})", "uint": "floatBitsToUint({})", "bool": "({} > 0.0)"}
    BACK = {"float": "{}", "int": "intBitsToFloat({})", "uint": "uintBitsToFloat({})", "bool": "float({})"}

    def __init__(self, text):
        self.text = bare(text)
        self.read = 0
        self.structs = {name: [(kind, one.strip()) for kind, names in re.findall(r"(\w+)\s+([\w\s,]+);", body)
                               for one in names.split(",")]
                        for name, body in re.findall(r"\bstruct\s+(\w+)\s*\{([^}]*)\}", self.text)}

    def parts(self, kind, value):
        """The scalars of a value: pairs of type and expression. None: of no known type."""
        if kind in self.SCALARS:
            return [(kind, value)]
        if vector := re.fullmatch(r"([iub]?)vec([234])", kind):
            scalar = {"": "float", "i": "int", "u": "uint", "b": "bool"}[vector[1]]
            return [(scalar, f"{value}.{one}") for one in "xyzw"[:int(vector[2])]]
        if matrix := re.fullmatch(r"mat([234])", kind):
            return [part for k in range(int(matrix[1])) for part in self.parts(f"vec{matrix[1]}", f"{value}[{k}]")]
        if kind not in self.structs:
            raise Unable(f"mutants.py: no value of the type {kind} can be made")
        return [part for member, one in self.structs[kind] for part in self.parts(member, f"{value}.{one}")]

    def made(self, kind, offset="0"):
        """A value from words of the buffer that nothing else has read."""
        if kind in self.structs:
            return f"{kind}({', '.join(self.made(member, offset) for member, _ in self.structs[kind])})"
        values = []
        for scalar, _ in self.parts(kind, "v"):
            values.append(self.SCALARS[scalar].format(f"given[{self.read} + {offset}]"))
            self.read += 1
        return values[0] if kind in self.SCALARS else f"{kind}({', '.join(values)})"

    def source(self, include, functions):
        lines = []
        for kind, name in dict.fromkeys(re.findall(r"^(\w+) (\w+)\(ivec2 \w+\);", self.text, re.M)):
            if not re.search(rf"^{kind} {name}\(ivec2 \w+\) {{", self.text, re.M):
                lines.append(f"{kind} {name}(ivec2 pixel) {{ return {self.made(kind, '97 * pixel.x + pixel.y')}; }}")
        lines.append("void main() {\nint at = 0;")
        for kind, name, parameters in functions:
            lines += self.call(kind, name, parameters)
        return with_includes(
            "#version 450\nlayout(std430, binding = 0) readonly buffer Given { float given[]; };\n"
            "layout(std430, binding = 1) writeonly buffer Got { float got[]; };\n"
            f'#include "{include}"\n' + "\n".join(lines) + "\n}\n")

    def call(self, kind, name, parameters):
        words = [one.split() for one in parameters.replace("const ", "").split(",") if one.strip()]
        kinds = [[word for word in one if word not in ("in", "out", "inout", "highp")][0] for one in words]
        lines = ["{"] + [f"{one} a{i} = {self.made(one)};" for i, one in enumerate(kinds)]
        call = f"{name}({', '.join(f'a{i}' for i in range(len(kinds)))})"
        lines.append(f"{call};" if kind == "void" else f"{kind} result = {call};")
        shown = [] if kind == "void" else self.parts(kind, "result")
        for i, one in enumerate(words):
            shown += self.parts(kinds[i], f"a{i}") if one[0] in ("out", "inout") else []
        return lines + [f"got[at++] = {self.BACK[scalar].format(value)};" for scalar, value in shown] + ["}"]


FUNCTION = re.compile(r"^(\w+) (\w+)\(([^)]*)\) \{", re.M)


class Modules:
    """What the shaders that include a file compile to."""

    def __init__(self, scratch):
        self.glsl = scratch / "glsl"
        self.scratch = scratch
        self.hashes = {}  # of the files as they are, by shader
        shutil.copytree(ROOT / "glsl", self.glsl)
        for file in self.glsl.rglob("*"):
            if file.is_file():
                file.write_text(with_includes(file.read_text(encoding="utf-8")), encoding="utf-8")

    def change(self, name, before, after, start):
        """What the text `after` of glsl/NAME in the place of `before`, from a place on, changes in the shaders that
        include it: "invalid" where one does not compile, "same" where each has the same optimised module, "other"."""
        shaders = self.of_a_pass(name) if name.startswith("passes/") else self.of_the_library(name, before, start)
        verdict = "other" if not shaders or is_conditional(before, start) else "same"
        file = self.glsl / name
        for shader, folder in shaders:
            file.write_text(with_includes(before), encoding="utf-8")
            key = (shader.read_text(encoding="utf-8"), closure(shader, self.glsl))
            if key not in self.hashes:
                self.hashes[key] = self.compiled(shader, folder)
            file.write_text(with_includes(after), encoding="utf-8")
            changed = self.compiled(shader, folder)
            file.write_text(with_includes(before), encoding="utf-8")
            if self.hashes[key] is None:
                raise Unable(f"{shader.name}: a shader of glsl/{name} does not compile")
            if changed is None:
                return "invalid"
            if changed != self.hashes[key]:
                return "other"
        return verdict

    def of_a_pass(self, name):
        """The passes that include a file, with the folders of their includes."""
        passes = [one for one in (self.glsl / "passes").rglob("*") if one.suffix in (".comp", ".vert", ".frag")]
        return [(one, one.parent) for one in sorted(passes) if self.includes(one, self.glsl / name)]

    def of_the_library(self, name, text, start):
        """A kernel of the file's functions; outside of a function, also of those of the files that include it."""
        users = [self.glsl / name]
        if not any(one.start() < start < end_of_function(text, one.start()) for one in FUNCTION.finditer(bare(text))):
            users += [one for one in sorted((self.glsl / "gloam").rglob("*.glsl"))
                      if f'"{name}"' in one.read_text(encoding="utf-8")]
        shaders = []
        for user in users:
            functions = FUNCTION.findall(bare(user.read_text(encoding="utf-8")))
            kernel = self.scratch / f"kernel{len(shaders)}.comp"
            source = Kernel(closure(user, self.glsl)).source(user.relative_to(self.glsl), functions)
            kernel.write_text(source, encoding="utf-8")
            shaders.append((kernel, self.scratch))
        return shaders

    def includes(self, shader, file):
        done = set()
        closure(shader, self.glsl, done)
        return file.resolve() in {one.resolve() for one in done}

    def compiled(self, shader, folder):
        """A hash of the optimised module; None where the compiler refuses the shader."""
        module = self.scratch / "module.spv"
        compiler = ["glslangValidator", "-V", "--target-env", "vulkan1.2", f"-I{self.glsl}", f"-I{folder}",
                    "-o", str(module), str(shader)]
        if subprocess.run(compiler, capture_output=True).returncode != 0:
            return None
        optimizer = ["spirv-opt", "--strip-debug", "-O", str(module), "-o", str(module)]
        if subprocess.run(optimizer, capture_output=True).returncode != 0:
            return None
        return hashlib.sha256(module.read_bytes()).hexdigest()


def end_of_function(text, start):
    return text.index("\n}", start)


def is_conditional(text, start):
    """Whether a place is compiled under some definitions only; the guard of an include does not count."""
    open_ones = []
    for line in text[:start].splitlines():
        if re.match(r"\s*#\s*if", line):
            open_ones.append(not re.match(r"#ifndef GLOAM_\w+_GLSL$", line))
        elif re.match(r"\s*#\s*endif", line):
            open_ones.pop()
    return any(open_ones)
