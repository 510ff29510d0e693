# SPDX-License-Identifier: MIT
"""compare.py RENDERED SHOWN APART: fails unless the 40 pictures of two folders differ by at most APART/255 in every
pixel, and from each other."""
import array
import sys
from pathlib import Path


def values(file):
    numbers = array.array("f")
    numbers.frombytes(file.read_bytes().split(b"\n", 3)[3])
    return numbers


seen = set()
for name in (f"f{i:04d}_ao.pfm" for i in range(40)):
    rendered, shown = (values(Path(folder, name)) for folder in sys.argv[1:3])
    apart = max(255 * abs(x - y) for x, y in zip(rendered, shown, strict=True))
    if not apart <= float(sys.argv[3]) * 1.001:
        sys.exit(f"{name}: {apart}/255 from what gloam render has written")
    seen.add(rendered.tobytes())
if len(seen) != 40:
    sys.exit(f"of 40 frames only {len(seen)} differ")
