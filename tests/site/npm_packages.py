# SPDX-License-Identifier: MIT
"""Packages of npm for tests, where there is npm and its registry is within reach."""
import shutil
import subprocess

from site_case import skip

UNREACHABLE = ("EAI_AGAIN", "ECONNREFUSED", "ECONNRESET", "ENETUNREACH", "ENOTFOUND", "ETIMEDOUT", "EHOSTUNREACH",
               "E429", "E500", "E502", "E503", "E504")  # the last are answers of a registry that is not well


def install(folder, *packages):
    """Installs packages, and those that package.json in the folder names, or skips the tests that need them."""
    if shutil.which("npm") is None:
        skip("no npm")
    command = ["npm", "install", "--no-audit", "--no-fund", "--no-package-lock", "--fetch-retries=0",
               "--fetch-timeout=20000", "--prefix", folder, *packages]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0 and any(word in done.stderr for word in UNREACHABLE):
        skip("npm reaches no registry")
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
