# SPDX-License-Identifier: MIT
"""mirror.py GBUFFERS NORMALS: gives the 40 frames of a folder left-handed cameras, whose view space has z turned."""
import array
import json
import sys
from pathlib import Path

for i in range(40):
    file = Path(sys.argv[1], f"f{i:04d}.json")
    frame = json.loads(file.read_text(encoding="utf-8"))
    camera = frame["camera"]
    for name in ("view", "prev_view", "proj_vk", "proj_gl", "previous_from_current"):
        rows, columns = "proj" not in name, name.startswith(("proj", "previous"))
        if camera.get(name):
            camera[name] = [-x if (rows and k % 4 == 2) != (columns and k // 4 == 2) else x
                            for k, x in enumerate(camera[name])]
    file.write_text(json.dumps(frame), encoding="utf-8")
    if sys.argv[2] == "view":
        image = Path(sys.argv[1], f"f{i:04d}_normal.pfm")
        *head, texels = image.read_bytes().split(b"\n", 3)
        numbers = array.array("f", texels)
        numbers[2::3] = array.array("f", (-z for z in numbers[2::3]))
        image.write_bytes(b"\n".join([*head, numbers.tobytes()]))
