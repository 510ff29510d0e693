// SPDX-License-Identifier: MIT
// Hostile files: each soon ends with one line on standard error and status 2, and leaves nothing behind.
#include "tools/gloam.hpp"

namespace gloam::test::hostile_test {

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    all.reserve(text.size() * count);
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

std::string ply(const std::string& vertices, const std::string& faces, long vertex_count, long face_count) {
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertex_count) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(face_count) + "\nproperty list int int vertex_indices\nend_header\n" + vertices +
           faces;
}

using HostileFiles = InFolder;

TEST_F(HostileFiles, Meshes) {
    constexpr long corners = 300'000;
    std::string vertices;
    std::string face = std::to_string(corners);
    for (long i = 0; i < corners; ++i) {
        vertices += std::to_string(i) + " " + std::to_string(i * 7919 % 300'007) + " 0\n";
        face += " " + std::to_string(i);
    }
    face += "\n";
    const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n";
    const char glb[] = "glTF\x02\0\0\0\x14\0\0\0\xf0\xff\xff\xffJSON";  // whose chunk is to have 4 GiB
    struct Row {
        const char* name;
        std::string content;
        const char* why = "";
    };
    for (const Row& row : {Row{"a.ply", ply(triangle, "3 0 1 1000000\n", 3, 1), "1000000"},
                           {"b.ply", ply(triangle, "3 0 1 -1\n", 3, 1)},
                           {"c.ply", ply(triangle, "0\n3 0 1 2\n", 3, 2)},
                           {"d.ply", ply(vertices, face, corners, 1), "300000 corners"},
                           // What the assimp of Debian 12 does not survive, and that of Debian 13 leaves out.
                           {"a.off", "OFF\n" + std::to_string(corners) + " 1 0\n" + vertices + face},
                           {"a.gltf", repeated("[", 200'000)},
                           {"b.gltf", repeated("{\"a\":", 200'000)},
                           {"a.dae", "<?xml version=\"1.0\"?>" + repeated("<a>", 200'000)},
                           {"a.glb", std::string(glb, 20)},
                           {"e.ply", ply("", "", 2'000'000'000, 2'000'000'000)},
                           {"b.off", "OFF\n4000000000 4000000000 0\n"}}) {
        SCOPED_TRACE(row.name);
        const fs::path mesh = write(row.name, row.content);
        const CommandResult result = gloam("render {} --size 16x9 --out {}", mesh, path("out"));
        expect_could_not_run(result, mesh.string());
        EXPECT_THAT(result.err, HasSubstr(row.why));
        EXPECT_FALSE(fs::exists(path("out")));
    }
}

// Deeply nested, and with a value that is not quoted whole.
TEST_F(HostileFiles, Json) {
    for (const std::string& text :
         {repeated("{\"a\":", 1'000'000), repeated("[", 1'000'000) + repeated("]", 1'000'000),
          R"({"experiment": ")" + std::string(5'000'000, 'x') + "\"}"}) {
        const std::string file = write("a.json", text).string();
        const fs::path frame = write("gbuffer/f0000.json", text);
        for (const CommandResult& result :
             {gloam("report {}", file), gloam("bench --from {}", file),
              gloam("bench --compare {} {}", file, file),
              gloam("render --gbuffer {} --out {}", path("gbuffer"), path("o"))}) {
            expect_could_not_run(result, ".json");
            EXPECT_LT(result.err.size(), 1000U);
        }
    }
}

// Text in a results file is never a command, nor a way out of --out.
TEST_F(HostileFiles, ResultsAreNeitherCommandsNorPaths) {
    const auto good =
        nlohmann::ordered_json::parse(R"({"experiment": "e", "device": "d", "driver": "d", "frames": 2,
      "scored": 1, "repeat": 1, "rays": 32, "visits": [{"width": 32, "height": 32, "case": "a",
        "target": 0, "candidate": "m", "group": "g", "round": 0, "samples_asked": 4,
        "quality": {"rmse": 0.1, "rmse_raw": 0.2, "rmse_depth": 0.1, "rmse_depth_raw": 0.2, "bias": 0,
          "similarity": 1, "samples": 4, "memory_bytes": 1},
        "readings": [{"passes": [{"pass": "p", "ms": 1}]}]}]})");
    const fs::path out = path("deep/er/out");
    const fs::path proof = path("proof");
    const std::string hostile = "x'\nsystem('touch " + proof.string() + "')\n`touch " + proof.string() + "`";
    const auto run = [&](const nlohmann::ordered_json& results) {
        const CommandResult result =
            gloam("bench --from {} --out {}", write("results.json", results.dump()), out);
        EXPECT_TRUE(result.status == 0 || result.status == 2) << result.err;
        EXPECT_FALSE(fs::exists(proof)) << results.dump();
        return result.status;
    };
    EXPECT_EQ(run(good), 0);
    for (const char* place : {"/device", "/driver", "/visits/0/case", "/visits/0/candidate",
                              "/visits/0/group", "/visits/0/readings/0/passes/0/pass"}) {
        auto bad = good;
        bad[nlohmann::ordered_json::json_pointer(place)] = hostile;
        EXPECT_EQ(run(bad), 2) << place;
        bad[nlohmann::ordered_json::json_pointer(place)] = "../../../escaped";
        run(bad);
        for (const auto& entry : fs::recursive_directory_iterator(path(""))) {
            if (entry.path().filename().string().find("escaped") == std::string::npos) continue;
            EXPECT_EQ(entry.path().parent_path(), out) << entry.path();
        }
    }
}

// More in stories/own_files.txt, and of every kind in tests/module.
using HostileShaders = InFolder;

// What ends the compiler, or takes all memory, ends a copy of the process.
TEST_F(HostileShaders, TextsThatTheCompilerDoesNotSurvive) {
    const std::string deep = "float f(float x) { return " + repeated("x-", 100'000) + "x; }\n";
    std::string macros = "#define M0 x\n";
    for (int i = 1; i <= 40; ++i) macros += fmt::format("#define M{0} M{1} + M{1}\n", i, i - 1);
    const fs::path bad = write("deep.glsl", deep);
    for (const char* command :
         {"check {}", "explain {} f 1", "audit {}", "mutate {} -- true", "pack {} --target hlsl"})
        expect_could_not_run(gloam(command, bad), "deep.glsl: the compiler ended by signal 11");
    const fs::path whole = write("deep.comp", "#version 450\n" + deep + "void main() { f(1.0); }\n");
    expect_could_not_run(gloam("cost {}", whole), "deep.comp: the compiler ended by signal 11");
    const fs::path much = write("double.glsl", macros + "float f(float x) { return M40; }\n");
    expect_could_not_run(gloam("pack {}", much), "double.glsl: the compiler takes more than ");
}

// Each file includes the next one twice: 2^17 times.
TEST_F(HostileShaders, IncludesThatDouble) {
    for (int i = 0; i < 17; ++i) {
        const std::string next = "#include \"i" + std::to_string(i + 1) + ".glsl\"\n";
        write("i" + std::to_string(i) + ".glsl", next + next);
    }
    write("i17.glsl", "// nothing\n");
    expect_could_not_run(gloam("pack {}", path("i0.glsl")), "more than 65536 includes at ");
}

TEST_F(HostileShaders, WhatIsNoTextAndNamesThatAreNoLine) {
    const fs::path nul = write("nul.glsl", std::string("f\0", 2));
    const fs::path named = write("line\n\x1b[31mred.glsl", "float f(float x) { return x@; }\n");
    for (const char* command : {"check", "pack"}) {
        expect_could_not_run(gloam("{} {}", command, nul), "nul.glsl: ");
        const CommandResult result = gloam("{} {}", command, named);
        expect_could_not_run(result, "[31mred.glsl");
        EXPECT_THAT(result.err, Not(HasSubstr("\x1b")));
    }
}

}  // namespace gloam::test::hostile_test
