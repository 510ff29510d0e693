# SPDX-License-Identifier: MIT
"""frame_test.py GLOAM COMPILER WORK DEPTH NORMALS KIND...: examples/vulkan and examples/opengl, built in WORK from
nothing but the folder that `gloam pack --effect` writes. In 24 frames of a moving view, with a cut and another size
among them, they show what `gloam render` shows, but for APART/255 in each pixel, by right- and left-handed cameras."""
import array
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

GLOAM, COMPILER, WORK, DEPTH, NORMALS, *KINDS = sys.argv[1:]
WORK = Path(WORK)
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
GBUFFERS = WORK / "gbuffers"
FRAMES = 24  # two sequences of half of them
INPUTS = ("--radius", "0.3", "--depth", DEPTH, "--normals", NORMALS)
# Vulkan's validation layers; newer ones check what shaders access by the last word alone.
ENVIRONMENT = {"LIBGL_ALWAYS_SOFTWARE": "1", "VK_INSTANCE_LAYERS": "VK_LAYER_KHRONOS_validation",
               "VK_LAYER_ENABLES": "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT",
               "VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC": "true"}


def run(*command, environment=()):
    """Ends the test where the command fails, or Vulkan's validation layers report something."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env={**os.environ, **dict(environment)}, check=False)
    if done.returncode or re.search("Validation (Error|Warning)", done.stdout):
        sys.exit(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout}")


def write_gbuffers():
    """Those of `gloam render`. The camera cuts in the middle of the first sequence; the second's view is smaller."""
    GBUFFERS.mkdir()
    for first, size in ((0, "161x99"), (FRAMES // 2, "96x54")):
        run(GLOAM, "render", "moving", "--size", size, "--frame", first, "--frames", FRAMES // 2, *INPUTS,
            "--write-gbuffer", WORK / size, "--out", WORK / "first")
        for frame in range(FRAMES // 2):
            for kind in (".json", "_depth.pfm", "_normal.pfm"):
                (WORK / size / f"f{frame:04}{kind}").rename(GBUFFERS / f"f{first + frame:04}{kind}")
    before = ("prev_view", "previous_from_current")
    change_frame(FRAMES // 4, lambda camera: [camera.pop(name, None) for name in before])


def change_frame(number, change):
    file = GBUFFERS / f"f{number:04}.json"
    frame = json.loads(file.read_text(encoding="utf-8"))
    change(frame["camera"])
    file.write_text(json.dumps(frame), encoding="utf-8")


def mirror(camera):
    """Makes the camera left-handed: its view space has z turned."""
    for name in ("view", "prev_view", "proj_vk", "proj_gl", "previous_from_current"):
        rows, columns = "proj" not in name, name.startswith(("proj", "previous"))
        if camera.get(name):
            camera[name] = [-x if (rows and k % 4 == 2) != (columns and k // 4 == 2) else x
                            for k, x in enumerate(camera[name])]


def mirror_normals(number):
    image = GBUFFERS / f"f{number:04}_normal.pfm"
    *head, texels = image.read_bytes().split(b"\n", 3)
    numbers = array.array("f", texels)
    numbers[2::3] = array.array("f", (-z for z in numbers[2::3]))
    image.write_bytes(b"\n".join([*head, numbers.tobytes()]))


def compare(one, other, most):
    """The pictures of two folders differ by at most so many 255ths in every pixel, and from each other."""
    seen = set()
    for name in (f"f{i:04}_ao.pfm" for i in range(FRAMES)):
        a, b = (array.array("f", (WORK / folder / name).read_bytes().split(b"\n", 3)[3]) for folder in (one, other))
        apart = max(255 * abs(x - y) for x, y in zip(a, b, strict=True))
        if not apart <= most * 1.001:
            sys.exit(f"{other}/{name}: {apart}/255 from {one}")
        seen.add(a.tobytes())
    if len(seen) != FRAMES:
        sys.exit(f"of {FRAMES} frames only {len(seen)} differ")


class Kind:
    """KIND, "PRESET SET EXAMPLE VERSION APART...": what gloam makes of the G-buffers, and what each example does."""
    def __init__(self, words):
        self.name = words.replace(" ", "_")
        preset, setting, *examples = words.split()
        self.options = ("--preset", preset, "--set", setting)
        self.examples = list(zip(*[iter(examples)] * 3, strict=True))
        for example, version, _ in self.examples:
            build = WORK / self.name / example
            run(GLOAM, "pack", "--effect", *self.options, "--normals", NORMALS, "--version", version, "--out",
                build / "effect")
            run("cmake", "-G", "Ninja", "-S", EXAMPLES / example, "-B", build, f"-DCMAKE_CXX_COMPILER={COMPILER}",
                "-DCMAKE_BUILD_TYPE=Debug", f"-DPRESET={preset}", f"-DEFFECT={build}/effect",
                "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror")
            run("cmake", "--build", build)

    def show(self, hand):
        rendered = f"{self.name}/{hand}"
        run(GLOAM, "render", "--gbuffer", GBUFFERS, *self.options, *INPUTS, "--out", WORK / rendered)
        for example, _, apart in self.examples:
            shown = f"{self.name}/{example}/{hand}"
            run(WORK / self.name / example / f"{example}_frame", GBUFFERS, WORK / shown, "0.3", DEPTH,
                environment=ENVIRONMENT)
            compare(rendered, shown, float(apart))
            compare(f"{self.name}/{example}/right", shown, 0)
        compare(f"{self.name}/right", rendered, 0)


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    kinds = [Kind(words) for words in KINDS]
    write_gbuffers()
    for kind in kinds:
        kind.show("right")
    for number in range(FRAMES):
        change_frame(number, mirror)
        if NORMALS == "view":
            mirror_normals(number)
    for kind in kinds:
        kind.show("left")


if __name__ == "__main__":
    main()
