#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare.py EXAMPLE [--gloam PROGRAM] [--model FILE]: the passes of examples/babylon or examples/playcanvas.

The example's page, built, draws a mesh on a plane with each pass, off screen in Chromium. Prints as a table how far the
visibility is from the traced one of the same triangles (root mean square), and what the pass adds to the time of a
frame. Fails for a message of the page and an error of WebGL; where gloam's error is not that of `gloam render`, or not
below the engine's own; and where another size or an orthographic camera change what they should not."""
import argparse
import array
import base64
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/site"))
from browser import Browser  # noqa: E402

SIZE = (640, 480)
HALF = (320, 240)

# In the page: a view of the mesh, and what it shows.
SCRIPT = """
const numbers = (text, Type) => Array.from(new Type(Uint8Array.from(atob(text), (one) => one.charCodeAt(0)).buffer));
const linear = (x) => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
let view = null, model = null;

// The last frame's visibility, upper row first.
function shown([width, height]) {
    const bytes = new Uint8Array(4 * width * height);
    view.gl.readPixels(0, 0, width, height, view.gl.RGBA, view.gl.UNSIGNED_BYTE, bytes);
    const values = Float32Array.from({length: width * height}, (_, i) => {
        const value = bytes[4 * ((height - 1 - Math.floor(i / width)) * width + i % width)] / 255;
        return View.encoded ? linear(value) : value;
    });
    let text = "";
    for (const byte of new Uint8Array(values.buffer)) text += String.fromCharCode(byte);
    return btoa(text);
}

// The first frame of a view, once all is compiled.
async function first(look, size) {
    view.setSize(...size);
    view.look(look);
    await view.ready();
    for (let i = 0; i < 3; ++i) {
        view.draw();
        await new Promise((resolve) => setTimeout(resolve, 100));
    }
    view.restart();
    view.draw();
    return shown(size);
}

function open(pass) {
    view?.dispose();
    view = new View(document.createElement("canvas"), pass, model);
}

// Milliseconds of frames, each waited for.
function times(count) {
    return Array.from({length: count}, () => {
        const start = performance.now();
        view.draw();
        view.gl.readPixels(0, 0, 1, 1, view.gl.RGBA, view.gl.UNSIGNED_BYTE, new Uint8Array(4));
        return performance.now() - start;
    });
}
"""


def read_mesh(file):
    """Positions and indices as `gloam render` draws them: on a plane, above its origin."""
    lines = [line.split() for line in Path(file).read_text(encoding="utf-8").splitlines()]
    positions = [[float(x) for x in words[1:4]] for words in lines if words[:1] == ["v"]]
    low, high = ([end(axis) for axis in zip(*positions)] for end in (min, max))
    foot = [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2]
    far = 30 * math.dist(low, high)
    plane = [[x * far, 0, z * far] for x, z in ((-1, 1), (1, 1), (1, -1), (-1, -1))]
    faces = [[int(word.split("/")[0]) - 1 for word in words[1:]] for words in lines if words[:1] == ["f"]]
    faces.append([len(positions) + i for i in range(4)])
    triangles = [face[j] for face in faces for i in range(2, len(face)) for j in (0, i - 1, i)]
    return [x - y for point in positions for x, y in zip(point, foot)] + sum(plane, []), triangles


def read_pfm(file):
    """The floats of a picture of one channel, upper row first."""
    size, _, data = Path(file).read_bytes().split(b"\n", 3)[1:]
    width, height = map(int, size.split())
    values = array.array("f", data)
    return [x for y in reversed(range(height)) for x in values[y * width:(y + 1) * width]]


def halved(values):
    """The means of two by two pixels."""
    width = SIZE[0]
    return [sum(values[i + j] for j in (0, 1, width, width + 1)) / 4
            for y in range(0, SIZE[1], 2) for i in range(y * width, (y + 1) * width, 2)]


def error(values, others):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(values, others, strict=True)) / len(values))


def looks(camera):
    """The same view: as it is, from 24 times as far, and orthographic."""
    m = camera["view"]
    eye = [-sum(m[4 * axis + i] * m[12 + i] for i in range(3)) for axis in range(3)]
    back = [m[2], m[6], m[10]]
    distance = math.hypot(*eye)
    height = 2 * distance * math.tan(camera["fovy_rad"] / 2)
    target = [x - distance * b for x, b in zip(eye, back)]
    near = {"eye": eye, "target": target, "fovy": camera["fovy_rad"]}
    far = {"eye": [x + 24 * distance * b for x, b in zip(target, back)], "target": target,
           "fovy": 2 * math.atan(height / 2 / (24 * distance))}
    return near, far, {**far, "height": height}


def encoded(kind, values):
    return base64.b64encode(array.array(kind, values).tobytes()).decode()


class Page(Browser):
    """The example's page with a mesh."""

    def load(self, example, model, radius):
        positions, indices = read_mesh(model)
        self.call("Page.navigate", url=(Path(example) / "index.html").resolve().as_uri() + "#compare")
        self.wait("window.View && document.readyState === 'complete'")
        self.evaluate(SCRIPT + f"model = {{positions: numbers('{encoded('f', positions)}', Float32Array), "
                      f"indices: numbers('{encoded('I', indices)}', Uint32Array), radius: {radius}}}; 0")

    def first(self, look, size=SIZE):
        """The visibility of a first frame."""
        return array.array("f", base64.b64decode(self.evaluate(f"first({json.dumps(look)}, {list(size)})")))

    def milliseconds(self):
        return sorted(self.evaluate("times(9)"))[4]


def compare(page, render, truth, camera):
    near, far, flat = looks(camera)
    wrong, errors, base, first = [], {}, 0, None
    print(f"| pass | RMSE (G) | ms |\n| --- | --: | --: |\n| gloam render | {render:.4f} | - |")
    for name in page.evaluate("View.passes"):
        page.evaluate(f"open('{name}')")
        got = page.first(near)
        errors[name] = error(got, truth)
        milliseconds = page.milliseconds()
        base = base or milliseconds
        print(f"| {name} | {errors[name]:.4f} | {milliseconds - base:.0f} |", flush=True)
        if name.startswith("gloam"):
            own = list(errors.values())[1]
            first = first or got
            for what, value, limit in [("RMSE", errors[name], min(1.1 * render, own)),
                                       ("of the half", error(page.first(near, HALF), halved(truth)), 0.02),
                                       ("of the size again", error(page.first(near), got), 1e-3),
                                       ("from gloam's first picture", error(got, first), 1e-3),
                                       ("orthographic", error(page.first(flat), page.first(far)), 0.02)]:
                if not value <= limit:
                    wrong.append(f"{name}: {what} {value:.4f}, expected at most {limit:.4f}")
        status = page.evaluate("view.gl.getError()")
        if status:
            wrong.append(f"{name}: error {status} of WebGL")
    texts = [json.dumps(event) for event in page.events if event.get("method") == "Log.entryAdded"]
    return wrong + page.problems() + [text for text in texts if "INVALID" in text]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("example")
    parser.add_argument("--gloam", default="gloam")
    parser.add_argument("--model", default="/usr/share/glmark2/models/bunny.obj")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, Page(timeout=300) as page:
        subprocess.run([options.gloam, "render", options.model, "--size", "x".join(map(str, SIZE)), "--truth",
                        "--truth-rays", "256", "--write-gbuffer", folder, "--out", folder, "--quiet"], check=True)
        frame = json.loads(Path(folder, "f0000.json").read_text(encoding="utf-8"))
        rendered = json.loads(Path(folder, "render.json").read_text(encoding="utf-8"))["frames"][0]["errors"]
        page.load(options.example, options.model, frame["ao_radius"])
        truth = [1 - x for x in read_pfm(Path(folder, "truth.pfm"))]
        wrong = compare(page, rendered["filtered"]["rmse"], truth, frame["camera"])
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
