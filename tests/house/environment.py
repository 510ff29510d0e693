#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""environment.py CTEST BUILD: every GoogleTest of a build is run with the variables that gloam_test() gives it.

Without GLOAM_CACHE_DIR each of them would compile its shaders itself. Nothing would fail, and the run would take twice
as long.
"""
import json
import subprocess
import sys

SHARDING = {"GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX"}  # of a suite that is several tests for ctest
EXPECTED = {"GLOAM_CACHE_DIR", "GLOAM_DEPENDENCIES_OUTPUT", "LSAN_OPTIONS", "RC_PARAMS"}


def environment(test):
    """Names of the variables that are set for a test."""
    for setting in test["properties"]:
        if setting["name"] == "ENVIRONMENT":
            return {variable.partition("=")[0] for variable in setting["value"]}
    return set()


def main():
    ctest, build = sys.argv[1:]
    listing = subprocess.run([ctest, "--show-only=json-v1"], cwd=build, capture_output=True, check=True)
    tests = [test for test in json.loads(listing.stdout)["tests"]
             if "--gtest_filter" in " ".join(test.get("command", []))]
    if not tests:
        sys.exit(f"{build}: no GoogleTest found")
    wrong = [test["name"] for test in tests if environment(test) - SHARDING != EXPECTED]
    for name in wrong:
        print(f"{name}: expected the variables {', '.join(sorted(EXPECTED))}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
