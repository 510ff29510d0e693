#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""model_test.py GLOAM: models of the visitor on the first page, in headless Chromium: what is read, what is refused.

Left with status 77 where there is no Chromium."""
import base64
import copy
import json
import struct

from site_case import SiteCase, main

CORNERS = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
DATA = b"".join(struct.pack("<3f", *p) for p in CORNERS) + b"".join(struct.pack("<3H", *f) for f in FACES)
OBJ = "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in FACES)
GLTF = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"children": [1]}, {"mesh": 0, "translation": [5, 0, 0], "scale": [3, 3, 3]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4},
                      {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 12}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
        "buffers": [{"byteLength": len(DATA)}]}


def glb(document, data=DATA):
    """The bytes of a GLB file."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    parts = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
    return struct.pack("<III", 0x46546C67, 2, 12 + len(parts)) + parts


def embedded(document):
    """The bytes of a glTF file whose buffer stands in it."""
    document = copy.deepcopy(document)
    document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(DATA).decode()
    return json.dumps(document).encode()


def changed(path, value):
    """The document with another value at a path."""
    document = copy.deepcopy(GLTF)
    place = document
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = value
    return document


class ModelTest(SiteCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser.look(1000, 900)
        cls.browser.open(cls.site / "index.html", "#size=320x180")
        cls.browser.wait("gloam.live.state.effect?.frames > 0")
        cls.browser.evaluate("Promise.all(['model.js', 'obj.js', 'gltf.js'].map(gloam.loadScript)).then(() => 0)")

    def read(self, name, content):
        """The scene of a file, its arrays as lists; or the message of the error."""
        text = base64.b64encode(content if isinstance(content, bytes) else content.encode()).decode()
        return self.browser.evaluate(f"""gloam.model.read(new File([gloam.bytes("{text}")], {json.dumps(name)})).then(
            (scene) => ({{...scene, positions: [...scene.positions], normals: [...scene.normals],
                colors: [...scene.colors], indices: [...scene.indices], cameras: scene.cameras.length}}),
            (error) => error.message)""")

    def refused(self, name, content, words):
        message = self.read(name, content)
        self.assertIsInstance(message, str, f"{name} was read")
        self.assertTrue(message.startswith(name + ": "), message)
        self.assertIn(words, message)
        self.assertLessEqual(len(message), 300)

    def test_the_same_body_from_each_kind_of_file(self):
        scenes = [self.read("a.obj", OBJ), self.read("a.glb", glb(GLTF)), self.read("a.gltf", embedded(GLTF))]
        for scene in scenes:
            self.assertEqual(12, len(scene["indices"]))
            self.assertEqual(6 * scene["frames"], scene["cameras"])
            box = [max(scene["positions"][k::3]) - min(scene["positions"][k::3]) for k in range(3)]
            self.assertAlmostEqual(10, sum(side * side for side in box) ** 0.5, 4)
            for i, (a, b) in enumerate(zip(scene["positions"], scenes[0]["positions"])):
                self.assertAlmostEqual(a, b, 5, i)
            self.assertEqual([0, 0, -1], [round(x) for x in scene["normals"][:3]])
        self.assertEqual([255, 128, 0, 255], scenes[1]["colors"][:4])
        self.assertEqual([179, 179, 179, 255], scenes[0]["colors"][:4])

    def test_faces_of_obj(self):
        scene = self.read("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\nvn 0 0 1\n"
                          "vt 0 0\nusemtl x\ns off\nf -4/1/1 -3/1/1 -2/1/-1 -1//1 # a quad\n")
        self.assertEqual((18, 18), (len(scene["positions"]), len(scene["normals"])))
        self.assertEqual([0, 0, 1] * 6, scene["normals"])
        self.assertEqual([255, 0, 0, 255] * 6, scene["colors"])

    def test_what_is_wrong_in_obj_is_told_with_its_line(self):
        for text, words in (("v 1 2\n", "line 1: expected 3 numbers"), ("v 0 0 nan\n", "line 1: expected 3 numbers"),
                            ("v 0 0 1e999\n", "line 1: expected 3 numbers"),
                            ("v 0 0 0\nf 1 2 3\n", 'line 2: position "2" of 1'),
                            ("v 0 0 0\nf 0 1 1\n", 'position "0"'), ("v 0 0 0\nf -2 1 1\n", 'position "-2"'),
                            ("v 0 0 0\nf 1.5 1 1\n", 'position "1.5"'), ("v 0 0 0\nf 1 1\n", "fewer than three"),
                            ("v 0 0 0\nf 1//1 1//1 1//1\n", 'normal "1" of 0'), ("v 0 0 0\nf 1 1 1\n", "in one point"),
                            ("v 1e308 0 0\nv -1e308 0 0\nv 0 1e308 0\nf 1 2 3\n", "too far apart"),
                            ("", "no triangles"), ("\0\1\2", "no triangles")):
            with self.subTest(text=text):
                self.refused("bad.obj", text, words)

    def test_what_is_wrong_in_gltf_is_told(self):
        loop = changed(["nodes", 1, "children"], [0])
        deep = changed(["nodes"], [{"children": [i + 1]} for i in range(99)] + [{"mesh": 0}])
        wide = changed(["nodes"], [{"children": [i + 1] * 40} for i in range(9)] + [{"mesh": 0}])
        many = changed(["nodes"], [{"children": [1] * 200_000}, {"mesh": 0}])
        for document, words in (
                (loop, "node 0 is below itself"), (deep, "more than 64 deep"), (wide, "more than"), (many, "more than"),
                (changed(["accessors", 0, "count"], 1e6), "ends behind its buffer"),
                (changed(["accessors", 0, "count"], 1e15), "count is 1000000000000000"),
                (changed(["accessors", 0, "count"], -1), "count is -1"),
                (changed(["accessors", 0, "count"], "4"), 'count is "4"'),
                (changed(["accessors", 0, "componentType"], 5120), "expected floats as VEC3"),
                (changed(["accessors", 1, "componentType"], 5126), "expected whole numbers as SCALAR"),
                (changed(["accessors", 0, "sparse"], {}), "is sparse"),
                (changed(["bufferViews", 1, "byteOffset"], 60), "byteLength is 24"),
                (changed(["bufferViews", 1, "byteOffset"], -4), "byteOffset is -4"),
                (changed(["bufferViews", 0, "buffer"], 7), "an index of buffers is 7"),
                (changed(["bufferViews", 0, "byteStride"], 1e9), "byteStride is"),
                (changed(["accessors", 0, "count"], 3), "an index of a vertex is 3"),
                (changed(["nodes", 1, "mesh"], 9), "an index of meshes is 9"),
                (changed(["nodes", 1, "scale"], [None, 1, 1]), "scale: expected 3 numbers"),
                (changed(["nodes", 1, "matrix"], [1, 2]), "matrix: expected 16 numbers"),
                (changed(["nodes", 1, "scale"], [0, 0, 0]), "in one point"),
                (changed(["meshes", 0, "primitives"], {"length": 1e9}), "primitives: expected a list"),
                (changed(["meshes", 0, "primitives", 0], None), "primitives 0 is no object"),
                (changed(["meshes", 0, "primitives", 0, "mode"], 1), "no triangles"),
                (changed(["buffers", 0, "uri"], "https://example.org/x.bin"), "is a file of its own"),
                (changed(["extensionsRequired"], ["KHR_draco_mesh_compression"]), "KHR_draco_mesh_compression"),
                (changed(["asset"], {"version": "1.0"}), "glTF of version 2"), (None, "glTF of version 2"),
                (changed(["scene"], 3), "an index of scenes is 3")):
            with self.subTest(words=words):
                self.refused("bad.glb", glb(document), words)
        nan = struct.pack("<f", float("nan")) + DATA[4:]
        self.refused("bad.glb", glb(GLTF, nan), "a position is not finite")

    def test_every_beginning_of_a_file_is_refused(self):
        whole = glb(GLTF)
        for length in [*range(0, 64), *range(64, len(whole), 37), len(whole) - 1]:
            self.refused("short.glb", whole[:length], "short.glb")
        for length in range(0, len(embedded(GLTF)), 97):
            self.refused("short.gltf", embedded(GLTF)[:length], "short.gltf")

    def test_other_files_are_refused(self):
        self.refused("a.stl", OBJ, "expected a file that ends in")
        message = self.browser.evaluate("gloam.model.read({name: 'big.obj', size: 1e9})"
                                        ".catch((error) => error.message)")
        self.assertEqual("big.obj: 1000000000 bytes, expected at most 64000000", message)
        self.refused("many.obj", "v 0 0 0\nf" + " 1" * 500_010, "more than 500000 triangles")

    def choose(self, name, content):
        (self.folder / name).write_bytes(content)
        root = self.browser.call("DOM.getDocument")["root"]["nodeId"]
        node = self.browser.call("DOM.querySelector", nodeId=root, selector="#file")["nodeId"]
        self.browser.call("DOM.setFileInputFiles", files=[str(self.folder / name)], nodeId=node)

    def test_a_file_is_shown_and_a_bad_one_leaves_the_scene(self):
        self.choose("mine.glb", glb(GLTF))
        self.browser.wait("gloam.live.state.effect.scene.name === 'mine.glb' && gloam.live.state.effect.frames > 2")
        drawn = self.browser.evaluate("(async ({passes, images}) => (await passes.read(images, 1))"
                                      ".filter((depth) => depth > 0).length)(gloam.live.state.effect)")
        self.assertGreater(drawn, 1000)
        self.browser.wait("!location.hash.includes('scene=')")
        self.choose("<img src=x onerror=alert(1)>.obj", b"f 1 2 3\n")
        self.browser.wait("document.getElementById('told').textContent.includes('line 1: position')")
        self.assertEqual(0, self.browser.evaluate("document.querySelectorAll('main img').length"))
        self.assertEqual("mine.glb", self.browser.evaluate("gloam.live.state.effect.scene.name"))
        self.assertFalse(self.browser.evaluate("gloam.live.state.failed"))
        self.assertEqual([], self.browser.problems())


if __name__ == "__main__":
    main()
