# SPDX-License-Identifier: MIT
"""What the tests of the packages share. Their arguments are SOURCE and BUILD: the tree, and its build folder."""
import re
import subprocess
import sys
from pathlib import Path

SOURCE, BUILD = (Path(argument).resolve() for argument in sys.argv[1:3])
VERSION = re.search(r"project\(gloam VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
CONSUMER = SOURCE / "examples" / "own_function"


def run(*command, **options):
    """What a command prints. Raises an AssertionError with it where the command fails."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False, **options)
    if done.returncode:
        raise AssertionError(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{done.stdout}")
    return done.stdout


def configured(source, build, *options):
    """Configures a tree, for which every source must be there. Returns what it can build."""
    run("cmake", "-G", "Ninja", "-S", source, "-B", build, *options)
    return run("ninja", "-C", build, "-t", "targets", "all")
