# SPDX-License-Identifier: MIT
"""frame_test.py GLOAM COMPILER WORK EXAMPLE VERSION APART PRESET DEPTH NORMALS SET: examples/vulkan or examples/opengl,
built in WORK from nothing but the folder that `gloam pack --effect` writes. In 40 frames of a moving view, with a cut
and another size among them, it shows what `gloam render` shows, but for APART/255 in each pixel, by right- and
left-handed cameras."""
import array
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

GLOAM, COMPILER, WORK, EXAMPLE, VERSION, APART, PRESET, DEPTH, NORMALS, SET = sys.argv[1:]
WORK = Path(WORK)
SOURCE = Path(__file__).resolve().parents[2] / "examples" / EXAMPLE
GBUFFERS = WORK / "gbuffers"
OPTIONS = ("--preset", PRESET, "--radius", "0.3", "--depth", DEPTH, "--normals", NORMALS, "--set", SET)
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
    """Those of `gloam render`. The camera cuts at frame 10, and from frame 20 on the view is smaller."""
    GBUFFERS.mkdir()
    for first, size in ((0, "161x99"), (20, "96x54")):
        run(GLOAM, "render", "moving", "--size", size, "--frame", first, "--frames", 20, *OPTIONS, "--write-gbuffer",
            WORK / size, "--out", WORK / "first")
        for frame in range(20):
            for kind in (".json", "_depth.pfm", "_normal.pfm"):
                (WORK / size / f"f{frame:04}{kind}").rename(GBUFFERS / f"f{first + frame:04}{kind}")
    change_frame(10, lambda camera: [camera.pop(name, None) for name in ("prev_view", "previous_from_current")])


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
    for name in (f"f{i:04}_ao.pfm" for i in range(40)):
        a, b = (array.array("f", (WORK / folder / name).read_bytes().split(b"\n", 3)[3]) for folder in (one, other))
        apart = max(255 * abs(x - y) for x, y in zip(a, b, strict=True))
        if not apart <= most * 1.001:
            sys.exit(f"{other}/{name}: {apart}/255 from {one}")
        seen.add(a.tobytes())
    if len(seen) != 40:
        sys.exit(f"of 40 frames only {len(seen)} differ")


def show(rendered, shown):
    """What gloam makes of the G-buffers, and the example."""
    run(GLOAM, "render", "--gbuffer", GBUFFERS, *OPTIONS, "--out", WORK / rendered)
    run(WORK / "build" / f"{EXAMPLE}_frame", GBUFFERS, WORK / shown, "0.3", DEPTH, environment=ENVIRONMENT)


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    run(GLOAM, "pack", "--effect", "--preset", PRESET, "--normals", NORMALS, "--version", VERSION, "--set", SET,
        "--out", WORK / "effect")
    run("cmake", "-G", "Ninja", "-S", SOURCE, "-B", WORK / "build", f"-DCMAKE_CXX_COMPILER={COMPILER}",
        "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror", f"-DEFFECT={WORK}/effect",
        f"-DPRESET={PRESET}")
    run("cmake", "--build", WORK / "build")
    write_gbuffers()
    show("rendered", "shown")
    compare("rendered", "shown", float(APART))
    for number in range(40):
        change_frame(number, mirror)
        if NORMALS == "view":
            mirror_normals(number)
    show("left_rendered", "left")
    compare("shown", "left", 0)
    compare("rendered", "left_rendered", 0)


if __name__ == "__main__":
    main()
