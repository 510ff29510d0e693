#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What compatibility.py finds: planted removals and changes, and nothing where something is added."""
import unittest
from pathlib import Path

import compatibility

TEXT = Path(compatibility.__file__).with_suffix(".txt").read_text(encoding="utf-8")
RECORD = compatibility.read(TEXT)


class Compatibility(unittest.TestCase):
    def now(self, key, replace):
        """The record with the items of a key as `replace` makes them."""
        return {**RECORD, key: replace(RECORD[key])}

    def test_the_record_is_read_as_it_was_written(self):
        version = TEXT.split()[3]
        self.assertEqual(TEXT, compatibility.written(version, RECORD))
        self.assertGreater(sum(map(len, RECORD.values())), 1000)

    def test_what_is_added_passes(self):
        more = self.now("exit statuses", lambda items: [*items, "0 new"])
        self.assertEqual([], compatibility.missing(RECORD, {**more, "command new": ["--option"]}))

    def test_what_is_gone_fails(self):
        for key, items in RECORD.items():
            with self.subTest(key):
                gone = compatibility.missing(RECORD, self.now(key, lambda old: old[1:]))
                self.assertEqual([f"{key}: {items[0]}"], gone)
                self.assertEqual(len(items), len(compatibility.missing({key: items}, {})))

    def test_what_has_changed_fails(self):
        key = "glsl gloam/shading/remap.glsl"
        old = "float gloam_remap(float, float, float, float)"
        now = self.now(key, lambda items: [item.replace("(float,", "(vec2,") for item in items])
        self.assertEqual([f"{key}: {old}"], compatibility.missing(RECORD, now))


if __name__ == "__main__":
    unittest.main()
