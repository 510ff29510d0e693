#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The format check passes what clang-format wrote and fails anything else."""
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
STYLE = HERE.parents[1] / ".clang-format"


def check(name, text):
    """Exit status of the check on a folder that holds one file."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(STYLE, folder)
        Path(folder, name).write_text(text, encoding="utf-8")
        return subprocess.run([HERE / "format", folder], capture_output=True, check=False).returncode


class Format(unittest.TestCase):
    def test_formatted(self):
        self.assertEqual(check("a.cpp", "int main() {\n    return 0;\n}\n"), 0)

    def test_not_formatted(self):
        self.assertNotEqual(check("a.cpp", "int main() {\n  return 0;\n}\n"), 0)
        self.assertNotEqual(check("a.hpp", "int  f();\n"), 0)


if __name__ == "__main__":
    unittest.main()
