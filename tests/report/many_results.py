#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""many_results.py RESULTS FOLDER COUNT: writes COUNT files as `gloam check --json` would on as many machines.

RESULTS is one such file. Each copy gets the names of another device and driver, out of some two hundred of each vendor;
every tenth has a failure. For trials of `gloam report --summary`."""
import json
import random
import sys
from pathlib import Path

DEVICES = [("NVIDIA GeForce RTX {}", "NVIDIA 5{:02}.{}.06"), ("AMD Radeon RX {} (RADV)", "radv Mesa 2{}.{}.1"),
           ("Intel(R) Arc A{}", "Intel open-source Mesa 2{}.{}.3"), ("Adreno (TM) {}", "Qualcomm Adreno 512.{}.{}"),
           ("Mali-G{}", "Mali-G v1.r{}p{}")]


def main():
    text = Path(sys.argv[1]).read_text(encoding="utf-8")
    device = json.loads(text)["device"]
    failing = text.replace('"outside": 0', '"outside": 3', 1)
    folder = Path(sys.argv[2])
    folder.mkdir()
    chance = random.Random(1)
    for i in range(int(sys.argv[3])):
        name, driver = chance.choice(DEVICES)
        copy = failing if chance.random() < 0.1 else text
        for found, instead in ((device["name"], name.format(chance.randrange(600, 640))),
                               (device["driver"], driver.format(chance.randrange(3, 40), chance.randrange(5)))):
            copy = copy.replace(json.dumps(found), json.dumps(instead), 1)
        (folder / f"{i:06}.json").write_text(copy, encoding="utf-8")


if __name__ == "__main__":
    main()
