#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every rule of borders.py finds what is planted for it in a clean house, on its line, and nothing else."""
import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import borders

SPDX = "// SPDX-License-Identifier: MIT\n"
PRINTED = "// No method or pass here calls it: it is TSSAO, eq 3."
HPP = SPDX + "#pragma once\n\n"
FOLDER = "/" + "home/somebody"  # in two pieces: the rule reads this file too


def shader(body, guard="GLOAM_OCCLUSION_SHADE_GLSL"):
    """A file of the shader library; the body starts at line 5."""
    return f"{SPDX}#ifndef {guard}\n#define {guard}\n\n{body}\n\n#endif\n"


CLEAN = {
    "README.md": "See `tools/run`, gloam/occlusion/shade.glsl and harness/WING/ROOM/CMakeLists.txt.\n"
                 "```cpp\n#include \"backend/vulkan/internal/vulkan.hpp\"\n\n    #include <vulkan/vulkan.hpp>\n```\n",
    "tests/shader/fixtures/odd.glsl": "no licence\n",
    "CMakeLists.txt": "# SPDX-License-Identifier: MIT\nproject(house)\n",
    "tools/run": "#!/usr/bin/env bash\n# SPDX-License-Identifier: MIT\n",
    "tools/main.cpp": SPDX + '#include "report/table.hpp"\n#include "catalogue/catalogue.hpp"\n',
    "harness/framework/backend/vulkan/device.hpp": HPP + "#include <memory>\n",
    "harness/framework/backend/vulkan/device.cpp":
        SPDX + '#include "backend/vulkan/internal/vulkan.hpp"\n#include <vulkan/vulkan.hpp>\n',
    "harness/framework/backend/vulkan/internal/vulkan.hpp": HPP + "#include <vulkan/vulkan_raii.hpp>\n",
    "harness/framework/shader/compile.cpp": SPDX + "#include <glslang/Public/ShaderLang.h>\n",
    "harness/framework/check/lab.hpp": HPP + '#include "backend/vulkan/device.hpp"\n#include "shader/compile.hpp"\n',
    "harness/occlusion/scene/mesh.cpp": SPDX + "#include <assimp/Importer.hpp>\n",
    "harness/framework/base/png.cpp": SPDX + "#include <stb/stb_image_write.h>\n",
    "harness/occlusion/reference/occlusion.hpp": HPP + "".join(
        f"double gloam_{name}();\n" for name in ("shade", "a", "b", "spare", "copied")),
    "tests/backend/vulkan/device_test.cpp":
        SPDX + '#include "backend/vulkan/internal/vulkan.hpp"\n#include "shader/compile.hpp"\n',
    "glsl/passes/shade.comp": SPDX + "layout(binding = 0) uniform Block { float x; };  // not gloam_spare(1.0)\n"
                                     "void main() { gloam_shade(1.0, gloam_a() + gloam_b() + gloam_alone()); }\n",
    "glsl/gloam/methods/any.glsl": shader(
        "// A method.\nGloamEstimate gloam_one(float x) { return gloam_of_one(x); }\n"
        "// Its own.\nfloat gloam_of_one(float x) { return x; }", guard="GLOAM_METHODS_ANY_GLSL"),
    "glsl/gloam/occlusion/copied.glsl": shader(
        f"// Copied.\n{PRINTED}\nfloat gloam_copied() {{ return 1.0; }}",
        guard="GLOAM_OCCLUSION_COPIED_GLSL"),
    "glsl/gloam/occlusion/shade.glsl": shader(
        '#include "gloam/geometry/depth.glsl"\n'
        "/* layout(binding = 0) uniform Commented { float main(); }; */\n"
        "const float GLOAM_LIMITS[2] = float[2](0.0, 1.0);\n"
        "// Two numbers.\nstruct GloamPair {\n    float a;\n    vec2 b;\n};\n"
        "// Asked of the user.\nfloat gloam_fetch_depth(ivec2 pixel);\n"
        "// Shades.\nfloat gloam_shade(float buffer_size,\n"
        "                  int i) { if (i > 0) { return 1.0; } return 0.0; }"),
}

# rule: (file, its whole text, line) for each way to break it
PLANTED = {
    "room_include": [
        ("harness/framework/backend/vulkan/wrong.cpp", SPDX + '#include "check/lab.hpp"\n', 2),
        ("harness/framework/numeric/wrong.hpp", HPP + '#include "backend/vulkan/device.hpp"\n', 4),
        ("harness/occlusion/report/wrong.cpp", SPDX + '#  include "scene/mesh.hpp"\n', 2),
        ("harness/occlusion/reference/wrong.hpp", HPP + '#include "check/lab.hpp"\n', 4),
        ("tools/wrong.cpp", SPDX + '#include "reference/math.hpp"\n', 2),
    ],
    "wing": [
        ("harness/backend/wrong.cpp", SPDX, 1),
        ("harness/occlusion/backend/wrong.cpp", SPDX, 1),
        ("harness/framework/report/wrong.cpp", SPDX, 1),
        ("harness/framework/wrong.cpp", SPDX, 1),
    ],
    "internal_include": [
        ("harness/framework/check/wrong.cpp", SPDX + '#include "backend/vulkan/internal/vulkan.hpp"\n', 2),
        ("tests/check/wrong_test.cpp", SPDX + '#include "backend/vulkan/internal/vulkan.hpp"\n', 2),
    ],
    "include_style": [
        ("harness/framework/backend/vulkan/wrong.cpp", SPDX + '#include "device.hpp"\n', 2),
        ("harness/framework/backend/vulkan/wrong.cpp", SPDX + '#include "../check/lab.hpp"\n', 2),
        ("harness/framework/check/wrong.cpp", SPDX + "#include <backend/vulkan/device.hpp>\n", 2),
    ],
    "library_home": [
        ("harness/framework/check/wrong.cpp", SPDX + "#include <vulkan/vulkan.h>\n", 2),
        ("harness/framework/backend/vulkan/wrong.hpp", HPP + "#include <vulkan/vulkan.h>\n", 4),
        ("tests/effect/wrong_test.cpp", SPDX + "#include <vulkan/vulkan.hpp>\n", 2),
        ("harness/framework/backend/vulkan/wrong.cpp", SPDX + "#include <glslang/Public/ShaderLang.h>\n", 2),
        ("harness/framework/backend/vulkan/wrong.cpp", SPDX + "#include <spirv-tools/libspirv.hpp>\n", 2),
        ("harness/occlusion/report/wrong.cpp", SPDX + "#include <assimp/scene.h>\n", 2),
        ("harness/occlusion/effect/wrong.cpp", SPDX + "#include <embree4/rtcore.h>\n", 2),
        ("harness/occlusion/scene/wrong.cpp", SPDX + "#include <stb/stb_image.h>\n", 2),
        ("harness/framework/base/wrong.cpp", SPDX + "#include <stb_truetype.h>\n", 2),
    ],
    "shader_bindings": [
        ("glsl/gloam/occlusion/shade.glsl", shader("layout(binding = 0) uniform sampler2D depth;"), 5),
        ("glsl/gloam/occlusion/shade.glsl", shader("layout(set = 0,\n       location = 1) in vec2 uv;"), 5),
        ("glsl/gloam/occlusion/shade.glsl", shader("uniform Block {\n    float x;\n};"), 5),
        ("glsl/gloam/occlusion/shade.glsl", shader("buffer Block { float x[]; } block;"), 5),
        ("glsl/gloam/occlusion/shade.glsl", shader("// Runs.\nvoid main() {}"), 6),
        ("glsl/gloam/occlusion/shade.glsl", shader("float state = 0.0;"), 5),
        ("glsl/gloam/occlusion/shade.glsl", shader("const float unnamed = 0.0;"), 5),
    ],
    "shader_comment": [
        ("glsl/gloam/occlusion/shade.glsl", shader("float gloam_shade() { return 1.0; }"), 5),
        ("glsl/gloam/occlusion/shade.glsl", shader("// Far away.\n\nfloat gloam_shade() {\n    return 1.0;\n}"), 7),
        ("glsl/gloam/occlusion/shade.glsl", shader("// One.\nfloat gloam_a() { return 1.0; }\n"
                                                   "float gloam_b() { return 1.0; }"), 7),
        ("glsl/gloam/occlusion/shade.glsl", shader("float gloam_fetch_depth(ivec2 pixel);"), 5),
    ],
    "shader_name": [("glsl/gloam/occlusion/shade.glsl", shader("// Shades.\nfloat shade() { return 1.0; }"), 6)],
    "shader_include": [
        ("glsl/gloam/occlusion/shade.glsl", shader('#include "depth.glsl"'), 5),
        ("glsl/gloam/occlusion/shade.glsl", shader('#include "passes/shade.comp"'), 5),
    ],
    "shader_reference": [
        ("glsl/gloam/occlusion/alone.glsl",
         shader("// Stands alone.\nfloat gloam_alone() { return 1.0; }", guard="GLOAM_OCCLUSION_ALONE_GLSL"), 6),
    ],
    "shader_caller": [
        ("glsl/gloam/occlusion/spare.glsl",
         shader("// Nothing calls it.\nfloat gloam_spare() { return 1.0; }", guard="GLOAM_OCCLUSION_SPARE_GLSL"), 6),
        ("glsl/gloam/occlusion/shade.glsl",
         shader(f"// A pass calls it.\n{PRINTED}\nfloat gloam_shade() {{ return 1.0; }}"), 7),
        ("glsl/gloam/methods/any.glsl",
         shader("// No method.\nfloat gloam_any(float x) { return x; }", guard="GLOAM_METHODS_ANY_GLSL"), 6),
    ],
    "guard": [
        ("harness/framework/backend/vulkan/wrong.hpp", SPDX + "#include <memory>\n", 1),
        ("glsl/gloam/occlusion/shade.glsl", SPDX + "// Shades.\nfloat gloam_shade() { return 1.0; }\n", 1),
        ("glsl/gloam/occlusion/shade.glsl", shader("", guard="GLOAM_OCCLUSION_OTHER_GLSL"), 1),
        ("glsl/gloam/occlusion/shade.glsl", shader("") + "#define GLOAM_AFTER\n", 1),
    ],
    "spdx": [
        ("harness/framework/backend/vulkan/wrong.cpp", "int x = 0;\n", 1),
        ("harness/framework/backend/vulkan/wrong.cpp", "// SPDX-License-Identifier: GPL-3.0-only\n", 1),
        ("harness/framework/backend/vulkan/wrong.cpp", "\n" + SPDX, 1),
        ("glsl/passes/wrong.comp", "void main() {}\n", 1),
        ("harness/framework/backend/vulkan/CMakeLists.txt", "gloam_room(gpu)\n", 1),
        ("cmake/wrong.cmake", "", 1),
        ("tests/house/wrong.py", "import sys\n", 1),
        ("tools/wrong", "#!/usr/bin/env bash\nset -e\n", 1),
    ],
    "paper_path": [
        ("README.md", "A house.\nSee `tools/no_such`.\n", 2),
        ("docs/page.md", "`#include \"gloam/occlusion/no_such.glsl\"`\n", 1),
    ],
    "paper_code": [
        ("README.md", "A house.\n\n```cpp\n#include <memory>\n#include <no_such>\n```\n", 3),
        ("docs/page.md", "```glsl\nfloat no_such();\n```\n", 1),
    ],
    "length": [("harness/framework/backend/vulkan/wrong.cpp", SPDX + "\n" * 400, 401)],
    "machine_path": [
        ("harness/framework/backend/vulkan/wrong.cpp", f'{SPDX}const char* file = "{FOLDER}/x.obj";\n', 2),
        ("README.md", f"See `{FOLDER}`.\n", 1),
        ("CMakePresets.json", f'{{"binaryDir": "{FOLDER}"}}\n', 1),
    ],
}


@contextlib.contextmanager
def house(changes):
    """A temporary tree: the clean house with some files replaced or added."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**CLEAN, **changes}.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        yield folder


def run_main(*arguments):
    output = io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
        status = borders.main(["borders.py", *arguments])
    return status, output.getvalue()


class Borders(unittest.TestCase):
    def test_a_clean_house_breaks_no_rule(self):
        with house({}) as folder:
            self.assertEqual(borders.violations(folder), [])
            self.assertEqual(run_main(folder), (0, ""))

    def test_the_framework_includes_nothing_of_ambient_occlusion(self):
        framework = borders.WINGS["framework"]
        for room, included in framework.items():
            self.assertLessEqual(included, framework.keys(), room)

    def test_every_rule_finds_what_is_planted(self):
        for rule, plants in PLANTED.items():
            for path, text, line in plants:
                with self.subTest(rule=rule, text=text), house({path: text}) as folder:
                    self.assertEqual([found[:3] for found in borders.violations(folder)], [(path, line, rule)])

    def test_no_rule_is_without_a_planted_violation(self):
        self.assertEqual({rule.__name__ for rule in (*borders.RULES, borders.shader_caller)}, set(PLANTED))

    def test_a_violation_is_printed_and_fails(self):
        path, text, line = PLANTED["room_include"][0]
        with house({path: text}) as folder:
            status, output = run_main(folder)
        expected = f"{path}:{line}: [room_include] backend may not include check/lab.hpp\n"
        self.assertEqual((status, output), (1, expected))

    def test_a_folder_that_is_no_house_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(run_main(folder)[0], 2)

    def test_a_file_of_exactly_the_limit_is_short_enough(self):
        with house({"harness/framework/backend/vulkan/long.cpp": SPDX + "\n" * (borders.MAX_LINES - 1)}) as folder:
            self.assertEqual(borders.violations(folder), [])


if __name__ == "__main__":
    unittest.main()
