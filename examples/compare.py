#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare.py EXAMPLE [--gloam PROGRAM] [--model FILE]: the passes of an engine: a page's folder, built, or a program.

It draws a mesh on a plane with each pass, off screen, without a GPU. Prints as a table how far the visibility is from the
traced one of the same triangles (root mean square), and the least time of a frame. Fails for an error of the engine or
of OpenGL; where gloam's error is not that of `gloam render`, or not below the engine's own; and where a camera that
moves, another size or an orthographic camera change what they should not."""
import argparse
import array
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/site"))
from browser import Browser  # noqa: E402

SIZE = (640, 480)
HALF = (320, 240)

# In the page: a view of the mesh, and what each_shot() of shots.hpp does for a program.
SCRIPT = """
const linear = (x) => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
let view = null;

function open(pass) {
    view?.dispose();
    view = new View(document.createElement("canvas"), pass, model);
}

async function shot(width, height, {eye, step, ...look}) {
    const bytes = new Uint8Array(4 * width * height);
    const draw = (i) => {
        const start = performance.now();
        view.look({eye: eye.map((x, axis) => x + i * step[axis]), ...look});
        view.draw();
        view.gl.readPixels(0, 0, width, height, view.gl.RGBA, view.gl.UNSIGNED_BYTE, bytes);
        return performance.now() - start;
    };
    view.setSize(width, height);
    for (let i = 0; i < 3; ++i) {  // until all is compiled
        draw(0);
        await view.ready?.();
        await new Promise((resolve) => setTimeout(resolve, 100));
    }
    view.restart();
    const least = Math.min(...[0, 1, 2, 3, 4, 5, 6, 7].map(draw));
    const values = Array.from(bytes.filter((_, i) => i % 4 === 0), (x) => View.encoded ? linear(x / 255) : x / 255);
    return [least, values.map((x) => x.toFixed(4)).join(" "), view.gl.getError()];
}
"""


def read_mesh(file):
    """Positions and triangles as `gloam render` draws them: on a plane, above its origin."""
    lines = [line.split() for line in Path(file).read_text(encoding="utf-8").splitlines()]
    positions = [[float(x) for x in words[1:4]] for words in lines if words[:1] == ["v"]]
    low, high = ([end(axis) for axis in zip(*positions)] for end in (min, max))
    foot = [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2]
    far = 30 * math.dist(low, high)
    plane = [[x * far, 0, z * far] for x, z in ((-1, 1), (1, 1), (1, -1), (-1, -1))]
    faces = [[int(word.split("/")[0]) - 1 for word in words[1:]] for words in lines if words[:1] == ["f"]]
    faces.append([len(positions) + i for i in range(4)])
    triangles = [[face[0], face[i - 1], face[i]] for face in faces for i in range(2, len(face))]
    return [[x - y for x, y in zip(point, foot)] for point in positions] + plane, triangles


def halved(values):
    """The means of two by two pixels."""
    width = SIZE[0]
    return [sum(values[i + j] for j in (0, 1, width, width + 1)) / 4
            for y in range(0, SIZE[1], 2) for i in range(y * width, (y + 1) * width, 2)]


def error(values, others):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(values, others, strict=True)) / len(values))


def make_shots(camera):
    """Sizes and cameras: a view, at half the size, again, from 12 times as far, orthographic, and reached by moving."""
    m = camera["view"]
    eye = [-sum(m[4 * axis + i] * m[12 + i] for i in range(3)) for axis in range(3)]
    back = [m[2], m[6], m[10]]
    distance = math.hypot(*eye)
    height = 2 * distance * math.tan(camera["fovy_rad"] / 2)
    target = [x - distance * b for x, b in zip(eye, back)]
    near = {"eye": eye, "target": target, "step": [0, 0, 0], "fovy": camera["fovy_rad"], "height": 0}
    far = {**near, "eye": [x + 12 * distance * b for x, b in zip(target, back)],
           "fovy": 2 * math.atan(height / 2 / (12 * distance))}
    step = 0.01 * distance
    moving = {**near, "eye": [eye[0] - 7 * step, *eye[1:]], "step": [step, 0, 0]}
    return (SIZE, near), (HALF, near), (SIZE, near), (SIZE, far), (SIZE, {**far, "height": height}), (SIZE, moving)


def page(example, mesh, radius, shots):
    """Draws the shots with each pass of a page: its name, and their milliseconds and visibilities, lowest row first."""
    positions, indices = ([x for row in rows for x in row] for rows in mesh)
    with Browser(timeout=300) as browser:
        browser.open(example / "index.html", "#compare")
        model = json.dumps({"positions": positions, "indices": indices, "radius": radius})
        browser.evaluate(f"{SCRIPT} const model = {model}; 0")
        for name in browser.evaluate("View.passes"):
            browser.evaluate(f"open('{name}')")
            drawn = [browser.evaluate(f"shot({', '.join(map(json.dumps, (*size, look)))})") for size, look in shots]
            yield name, [(time, [float(x) for x in text.split()]) for time, text, _ in drawn]
            if any(code for _, _, code in drawn):
                sys.exit(f"{name}: an error of WebGL")
        texts = [json.dumps(event) for event in browser.events if event.get("method") == "Log.entryAdded"]
        wrong = browser.problems() + [text for text in texts if "INVALID" in text]
        if wrong:
            sys.exit("\n".join(wrong))


def program(example, mesh, radius, shots):
    """The same by a program."""
    with tempfile.TemporaryDirectory() as folder:
        model, asked, result = (Path(folder, name) for name in ("model.obj", "shots", "result"))
        Path(folder, "white").write_text("newmtl white\nKd 1 1 1\n", encoding="utf-8")
        lines = [("mtllib", "white"), *(("v", *point) for point in mesh[0]), ("usemtl", "white"),
                 *(("f", *(i + 1 for i in corners)) for corners in mesh[1])]
        model.write_text("".join(" ".join(map(str, line)) + "\n" for line in lines), encoding="utf-8")
        rows = [(*size, *look["eye"], *look["target"], *look["step"], math.degrees(look["fovy"]), look["height"])
                for size, look in shots]
        asked.write_text("".join(" ".join(map(str, row)) + "\n" for row in rows), encoding="utf-8")
        display = [] if os.environ.get("DISPLAY") else ["xvfb-run", "-a"]
        done = subprocess.run([*display, example.resolve(), model, str(radius), asked, result], check=False,
                              env={**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1"})
        if done.returncode:
            sys.exit(f"{example}: exit status {done.returncode}")
        with open(result, "rb") as file:
            while name := file.readline():
                yield name.decode().strip(), [(float(file.readline()), [x / 255 for x in file.read(width * height)])
                                              for (width, height), _ in shots]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("example", type=Path)
    parser.add_argument("--gloam", default="gloam")
    parser.add_argument("--model", default="/usr/share/glmark2/models/bunny.obj")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([options.gloam, "render", options.model, "--orbit", "30,25", "--size", "x".join(map(str, SIZE)),
                        "--frames", "8", "--truth", "--truth-rays", "256", "--write-gbuffer", folder, "--out", folder,
                        "--quiet"], check=True)
        frame = json.loads(Path(folder, "f0000.json").read_text(encoding="utf-8"))
        rendered = json.loads(Path(folder, "render.json").read_text(encoding="utf-8"))["frames"][-1]["errors"]
        truth = [1 - x for x in array.array("f", Path(folder, "truth.pfm").read_bytes().split(b"\n", 3)[3])]
    render = rendered["filtered"]["rmse"]
    wrong, others, pictures = [], [], {}
    print(f"| pass | RMSE (G) | ms |\n| --- | --: | --: |\n| gloam render | {render:.4f} | - |")
    drawn = (page if options.example.is_dir() else program)(
        options.example, read_mesh(options.model), frame["ao_radius"], make_shots(frame["camera"]))
    for name, [(milliseconds, got), *more] in drawn:
        off = error(got, truth)
        print(f"| {name} | {off:.4f} | {milliseconds:.0f} |", flush=True)
        if not name.startswith("gloam"):
            others.append(off)
            continue
        half, again, far, flat, moved = (values for _, values in more)
        first = pictures.setdefault(name.removesuffix(", right-handed"), got)
        for what, value, limit in [("RMSE", off, min(1.1 * render, *others)),
                                   ("of the half", error(half, halved(truth)), 0.02),
                                   ("of the size again", error(again, got), 1e-3),
                                   ("from the left-handed picture", error(got, first), 1e-3),
                                   ("orthographic", error(flat, far), 0.02),
                                   ("of a camera that moved", error(moved, got), 0.006)]:
            if not value <= limit:
                wrong.append(f"{name}: {what} {value:.4f}, expected at most {limit:.4f}")
    if not pictures:
        wrong.append("no pass of gloam")
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
