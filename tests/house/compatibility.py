#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compatibility.py ROOT GLOAM [--update]: what docs/compatibility.md promises, compared with what 0.2 promised.

The record is tests/house/compatibility.txt: a line for each file, kind, command or output, whose items follow a colon.
More items pass; one that is gone or changed fails. --update writes the record anew. Within one minor version it only
adds. The promise of C++ is tests/house/package/api_0_2.cpp.
"""
import json
import re
import subprocess
import sys
import tempfile
import textwrap
from pathlib import Path

PROBE = """float half_of(float x) {
    return 0.5 * x;
}
"""
RACE = """#version 450
layout(local_size_x = 64) in;
shared float sum;
float raced(float x) {
    sum = x;
    return sum;
}
"""
# The command of each exit status; FOLDER has probe.glsl and race.comp.
STATUSES = ("--version", "list", "check FOLDER/probe.glsl --inputs 64 --device interpreter", "pack FOLDER/probe.glsl",
            "check FOLDER/race.comp --inputs 64 --device interpreter", "--no-such-option", "no-such-command",
            "check no-such-equation", "render no-such-scene", "pack FOLDER/no-such.glsl",
            "check --exit-code no-such-equation")
# The command that writes each JSON; "-": to standard output.
OUTPUTS = {
    "list": ("list --json", "-"),
    "list presets NAME": ("list presets balanced --json", "-"),
    "devices": ("devices --json", "-"),
    "check": ("check HALTON-2D CS-REMAP --inputs 64 --device interpreter --json FOLDER/check.json", "check.json"),
    "audit": ("audit FOLDER/probe.glsl --json FOLDER/audit.json", "audit.json"),
    "mutate": ("mutate FOLDER/probe.glsl --count 2 --json FOLDER/mutate.json -- true", "mutate.json"),
    "render": ("render corner --size 16x9 --radius 1 --out FOLDER/out --write-gbuffer FOLDER/g", "out/render.json"),
    "frame": (None, "g/f0000.json"),
    "pack --effect": ("pack --effect --out FOLDER/effect", "effect/effect.json"),
    "pack --npm": ("pack --npm FOLDER/npm", "npm/package.json"),
}


def glsl(root):
    """Functions with the types of their parameters, structures with their members, constants."""
    for path in sorted((root / "glsl" / "gloam").rglob("*.glsl")):
        text = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
        items = []
        for kind, name, parameters in re.findall(r"^(\w+) (gloam_\w+)\(([^()]*)\)", text, re.M):
            types = [re.sub(r"\s*\b\w+(\[\w*\])?$", r"\1", " ".join(one.split())) for one in parameters.split(",")]
            items.append(f"{kind} {name}({', '.join(types)})")
        for name, members in re.findall(r"^struct (\w+) \{(.*?)^\};", text, re.M | re.S):
            items.append(f"struct {name} {{{' '.join(members.split())}}}".replace(";", ","))
        items += re.findall(r"^(?:const \w+|#define) (GLOAM_\w+)(?= )", text, re.M)
        if items:
            yield f"glsl {path.relative_to(root / 'glsl')}", items


def names(lists):
    for kind, entries in lists.items():
        if kind != "gloam":
            yield f"names of {kind}", [entry["name"] for entry in entries]


def commands(gloam, command="", known=()):
    """Positionals and options of a command, with the kind of their values, and what the commands below it add."""
    text = gloam(f"{command} --help").split("\nExamples:")[0]
    options, _, below = text.partition("\nSubcommands:\n")
    found = re.findall(r"^  (\S+)(?: (TEXT|UINT|INT|FLOAT)\S*)?( \.\.\.)?", options, re.M)
    items = [f"{name} {kind}".strip() + more for aliases, kind, more in found for name in aliases.split(",")]
    yield f"command {command}".strip(), [item for item in items if item not in known] or ["as above"]
    for name in re.findall(r"^  (\w\S*) ", below, re.M):
        yield from commands(gloam, f"{command} {name}".strip(), items)


def fields(value, path=""):
    """Each field of a JSON with its type. Settings and passes have names of their own."""
    kinds = {dict: "object", list: "array", str: "string", bool: "bool", int: "number", float: "number"}
    if isinstance(value, dict) and path.split(".")[-1] not in ("settings", "times_ms"):
        for name, inner in value.items():
            yield from fields(inner, f"{path}.{name}".lstrip("."))
    elif isinstance(value, list):
        for inner in value:
            yield from fields(inner, path + "[]")
    elif value is not None:
        yield f"{path} {kinds[type(value)]}"


def layouts(effect):
    """What an engine binds to the passes of the default preset, and where the members of its blocks are."""
    for one in effect["passes"]:
        items = [f"{b['set']}.{b['binding']} {b['type'].removeprefix('VK_DESCRIPTOR_TYPE_')} {b['resource']}"
                 for b in one["bindings"]]
        items += [f"{m['name']} {m['type']} {m['rows']}x{m['columns']} at {m['offset']}"
                  for m in one.get("push_constants", {}).get("members", [])]
        yield f"layout of {one['file']}", items
    yield "images of the effect", [f"{i['name']} {i['format'].removeprefix('VK_FORMAT_')} {i['origin']}"
                                   for i in effect["images"]]


def current(root, program, version):
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "probe.glsl").write_text(PROBE, encoding="utf-8")
        (Path(folder) / "race.comp").write_text(RACE, encoding="utf-8")

        def run(line):
            words = [word.replace("FOLDER", folder) for word in line.split()]
            return subprocess.run([program, *words], capture_output=True, text=True, check=False)

        found = dict(glsl(root))
        found.update(commands(lambda line: run(line).stdout))
        found["exit statuses"] = [f"{run(line).returncode} {line}" for line in STATUSES]
        documents = {}
        for what, (line, file) in OUTPUTS.items():
            done = run(line) if line else done
            if done.returncode == 2:
                raise SystemExit(f"gloam {line}: exit status {done.returncode}: {done.stderr.strip()}")
            text = done.stdout if file == "-" else (Path(folder) / file).read_text(encoding="utf-8")
            documents[what] = json.loads(text)
            found[f"json {what}"] = sorted(set(fields(documents[what])))
            if documents[what].get("gloam", documents[what].get("version")) != version:
                raise SystemExit(f"gloam {line or what}: the JSON does not name the version, {version}")
        found.update(names(documents["list"]))
        found.update(layouts(documents["pack --effect"]))
        for what, place in (("effect", "effect"), ("npm", "npm")):
            found[f"files of {what}"] = sorted(path.name for path in (Path(folder) / place).iterdir())
        found["types of npm"] = re.findall(r"^export (?:declare )?(\w+ \w+)", "\n".join(
            path.read_text(encoding="utf-8") for path in sorted((Path(folder) / "npm").glob("*.d.ts"))), re.M)
        return {key: list(dict.fromkeys(" ".join(item.split()) for item in items)) for key, items in found.items()}


def read(text):
    record = {}
    for line in text.replace("\n  ", " ").splitlines():
        if line and not line.startswith("#"):
            key, _, items = line.partition(": ")
            record[key] = items.split("; ")
    return record


def written(version, record):
    lines = [f"# What gloam {version} promises; tests/house/compatibility.py --update writes it."]
    for key, items in record.items():
        lines.append(textwrap.fill(f"{key}: {'; '.join(items)}", 118, subsequent_indent="  ", break_long_words=False,
                                   break_on_hyphens=False))
    return "\n".join(lines) + "\n"


def missing(old, now):
    return [f"{key}: {item}" for key, items in old.items() for item in items if item not in now.get(key, [])]


def main():
    root, program = Path(sys.argv[1]).resolve(), sys.argv[2]
    file = Path(__file__).with_suffix(".txt")
    version = re.search(r"project\(gloam VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    old = re.match(r"# What gloam (\d+\.\d+)", text)
    old, now = read(text) if old and version.startswith(old[1] + ".") else {}, current(root, program, version)
    gone = missing(old, now)
    print("".join(f"promised by {version.rsplit('.', 1)[0]}, gone or changed: {line}\n" for line in gone), end="")
    if not gone and "--update" in sys.argv:
        file.write_text(written(version, now), encoding="utf-8")
    elif not old:
        print(f"{file.name} is not of {version}: --update writes it")
        return 1
    return 1 if gone else 0


if __name__ == "__main__":
    sys.exit(main())
