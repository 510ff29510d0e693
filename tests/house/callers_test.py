#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""callers.py finds functions that nothing calls and that do not say so, and those that say so and are called."""
import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import callers

LIBRARY = """// SPDX-License-Identifier: MIT
// Called by the pass.
float gloam_used(float x) {{
    return gloam_helper(x);
}}

// Called by the function above.
{helper}float gloam_helper(float x) {{
    return x;
}}

// Asked of the user.
float gloam_fetch_depth(ivec2 pixel);

// Called by nothing; in a comment stands gloam_spare(1.0).
{spare}float gloam_spare(float x) {{
    return x;
}}
"""
COPIED = callers.TO_BE_COPIED + "\n"


def found_in(helper="", spare=""):
    """(line, message) of what is found in a house of one library file, one method and one pass."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in {
            "glsl/gloam/occlusion/some.glsl": LIBRARY.format(helper=helper, spare=spare),
            "glsl/gloam/methods/one.glsl": "// A method.\nfloat gloam_one(float x) {\n    return gloam_of_one(x);\n}\n"
                                           "// Its own.\nfloat gloam_of_one(float x) {\n    return x;\n}\n",
            "glsl/passes/pass.comp": "// gloam_spare(2.0) is not called here\nvoid main() { gloam_used(1.0); }\n",
        }.items():
            file = Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return [(line, message) for _, line, message in callers.violations(folder)]


class Callers(unittest.TestCase):
    def test_nothing_is_found_where_each_is_called_or_to_be_copied(self):
        self.assertEqual(found_in(spare=COPIED), [])

    def test_a_function_that_nothing_calls_is_found(self):
        (line, message), = found_in()
        self.assertEqual(line, 16)
        self.assertIn("nothing calls gloam_spare", message)

    def test_a_function_that_is_called_is_not_said_to_be_there_to_be_copied(self):
        (line, message), = found_in(helper=COPIED, spare=COPIED)
        self.assertEqual(line, 9)
        self.assertIn("gloam_helper is called", message)

    def test_main_prints_and_fails(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(callers.main(["callers.py", folder]), 2)
        root = Path(__file__).resolve().parents[2]
        with contextlib.redirect_stdout(io.StringIO()) as out:
            self.assertEqual(callers.main(["callers.py", str(root)]), 0, out.getvalue())


if __name__ == "__main__":
    unittest.main()
