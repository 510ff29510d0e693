// SPDX-License-Identifier: MIT
// Hostile files: each soon ends with one line on standard error and status 2, and leaves nothing behind.
#include "tools/gloam.hpp"

namespace gloam::test::hostile_test {

class HostileFiles : public InFolder {
  protected:
    // gloam refuses the mesh, within seconds, and writes nothing.
    void expect_refused(const std::string& name, const std::string& content, const std::string& why) const {
        const fs::path mesh = write(name, content);
        const fs::path out = path("out");
        const CommandResult result = run_command(words("render {} --size 16x9 --out {}", mesh, out),
                                                 {.timeout = std::chrono::seconds(100)});
        expect_could_not_run(result, mesh.string());
        EXPECT_THAT(result.err, HasSubstr(why));
        EXPECT_FALSE(fs::exists(out));
    }
};

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    all.reserve(text.size() * count);
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

std::string ply(const std::string& vertices, const std::string& faces, long vertex_count, long face_count) {
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertex_count) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(face_count) + "\nproperty list uchar int vertex_indices\nend_header\n" + vertices +
           faces;
}

TEST_F(HostileFiles, AnIndexOutOfRange) {
    expect_refused("a.ply", ply("0 0 0\n1 0 0\n0 1 0\n", "3 0 1 1000000\n", 3, 1), "1000000");
    expect_refused("b.ply", ply("0 0 0\n1 0 0\n0 1 0\n", "3 0 1 -1\n", 3, 1), "");
}

TEST_F(HostileFiles, AFaceWithoutCorners) {
    expect_refused("a.ply", ply("0 0 0\n1 0 0\n0 1 0\n", "0\n3 0 1 2\n", 3, 2), "");
}

TEST_F(HostileFiles, AFaceOfManyCorners) {
    constexpr long corners = 300'000;
    std::string vertices;
    std::string face = std::to_string(corners);
    for (long i = 0; i < corners; ++i) {
        vertices += std::to_string(i) + " " + std::to_string(i * 7919 % 300'007) + " 0\n";
        face += " " + std::to_string(i);
    }
    std::string text = ply(vertices, face + "\n", corners, 1);
    text.replace(text.find("list uchar"), 10, "list int");
    expect_refused("a.ply", text, "300000 corners");
    // What the assimp of Debian 12 does not survive, and that of Debian 13 leaves out.
    expect_refused("a.off", "OFF\n" + std::to_string(corners) + " 1 0\n" + vertices + face + "\n", "");
}

// Every prefix and many single changes of small files: read or refused, never more than that.
TEST_F(HostileFiles, DamagedMeshes) {
    const std::vector<std::pair<std::string, std::string>> whole{
        {"a.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n"},
        {"a.ply", ply("0 0 0\n1 0 0\n0 1 0\n1 1 0\n", "3 0 1 2\n4 0 1 3 2\n", 4, 2)},
        {"a.stl",
         "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
         "endfacet\nendsolid a\n"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"}};
    std::minstd_rand random(1);
    for (const auto& [name, text] : whole) {
        for (std::size_t i = 0; i < 12; ++i) {
            std::string damaged = text.substr(0, i < 4 ? text.size() * (i + 1) / 5 : text.size());
            for (std::size_t k = 3; k < i; ++k)
                damaged[random() % damaged.size()] = "-0123456789e. \n"[random() % 15];
            const fs::path file = write(name, damaged);
            const fs::path out = path("out");
            const CommandResult result = gloam("render {} --size 16x9 --samples 1 --out {}", file, out);
            EXPECT_TRUE(result.status == 0 || result.status == 2) << result.status << "\n" << damaged;
            EXPECT_EQ(line_count(result.err), result.status == 0 ? 0 : 1) << result.err;
        }
    }
}

TEST_F(HostileFiles, MeshesThatAreDeeplyNested) {
    expect_refused("a.gltf", repeated("[", 200'000), "");
    expect_refused("b.gltf", repeated("{\"a\":", 200'000), "");
    expect_refused("c.dae", "<?xml version=\"1.0\"?>" + repeated("<a>", 200'000), "");
}

TEST_F(HostileFiles, MeshesThatPromiseTooMuch) {
    // A binary glTF whose chunk is to have 4 GiB.
    const char glb[] = "glTF\x02\0\0\0\x14\0\0\0\xf0\xff\xff\xffJSON";
    expect_refused("a.glb", std::string(glb, 20), "");
    expect_refused("b.ply", ply("", "", 2'000'000'000, 2'000'000'000), "");
    expect_refused("c.off", "OFF\n4000000000 4000000000 0\n", "");
}

TEST_F(HostileFiles, JsonThatIsDeeplyNested) {
    const std::string arrays = repeated("[", 1'000'000);
    const std::string objects = repeated("{\"a\":", 1'000'000);
    const std::string whole = repeated("[", 1'000'000) + repeated("]", 1'000'000);
    for (const std::string& text : {arrays, objects, whole}) {
        const std::string file = write("a.json", text).string();
        expect_could_not_run(gloam("report {}", file), file);
        expect_could_not_run(gloam("bench --from {}", file), file);
        expect_could_not_run(gloam("bench --compare {} {}", file, file), file);
        const fs::path frame = write("gbuffer/f0000.json", text);
        expect_could_not_run(gloam("render --gbuffer {} --out {}", path("gbuffer"), path("o")),
                             frame.string());
    }
}

TEST_F(HostileFiles, AWrongValueIsNotQuotedWhole) {
    const std::string long_text(5'000'000, 'x');
    write("gbuffer/f0000.json", R"({"camera": {}, "width": ")" + std::string(900'000, 'x') + "\"}");
    const CommandResult frame = gloam("render --gbuffer {} --out {}", path("gbuffer"), path("o"));
    expect_could_not_run(frame, "width");
    EXPECT_LT(frame.err.size(), 1000U);
    const std::string file = write("a.json", R"({"experiment": ")" + long_text + "\"}").string();
    const CommandResult report = gloam("bench --from {}", file);
    expect_could_not_run(report, "experiment");
    EXPECT_LT(report.err.size(), 1000U);
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
        const fs::path file = write("results.json", results.dump());
        const CommandResult result = gloam("bench --from {} --out {}", file, out);
        EXPECT_TRUE(result.status == 0 || result.status == 2) << result.err;
        EXPECT_FALSE(fs::exists(proof)) << results.dump();
        return result;
    };
    EXPECT_EQ(run(good).status, 0);
    for (const char* place : {"/device", "/driver", "/visits/0/case", "/visits/0/candidate",
                              "/visits/0/group", "/visits/0/readings/0/passes/0/pass"}) {
        auto bad = good;
        bad[nlohmann::ordered_json::json_pointer(place)] = hostile;
        EXPECT_EQ(run(bad).status, 2) << place;
        bad[nlohmann::ordered_json::json_pointer(place)] = "../../../escaped";
        run(bad);
        for (const auto& entry : fs::recursive_directory_iterator(path(""))) {
            if (entry.path().filename().string().find("escaped") == std::string::npos) continue;
            EXPECT_EQ(entry.path().parent_path(), out) << entry.path();
        }
    }
}

// Hostile shaders: `check`, `explain` and `pack` refuse each with one line on standard error and status 2.

class HostileShaders : public InFolder {
  protected:
    static void expect_refused(const fs::path& file, const std::string& why) {
        for (const char* command : {"check {}", "explain {} f 1", "pack {}", "pack {} --target hlsl"}) {
            const CommandResult result = gloam(command, file);
            expect_could_not_run(result, file.filename().string());
            EXPECT_THAT(result.err, AllOf(HasSubstr(why), Not(HasSubstr("\x1b")))) << command;
        }
    }
};

// A #line directive can name any file as the place of a line; gloam does not follow it.
TEST_F(HostileShaders, CoverageDoesNotQuoteOtherFiles) {
    const fs::path secret = write("secret.txt", "password\n");
    const fs::path file = write("own/a.glsl", "float f(float x) {\n#line 1 \"" + secret.string() +
                                                  "\"\nif (x > 1e30 && x < 0.0) return 1.0;\nreturn x;\n}\n");
    const std::string json = path("a.json").string();
    const CommandResult result = gloam("check {} --inputs 64 --coverage --json {}", file, json);
    EXPECT_THAT(result.out + read_file(json), AllOf(HasSubstr("a.glsl"), Not(HasSubstr("password"))));
}

// Of every kind: the suite Hostile of the tests of compiling.
TEST_F(HostileShaders, FilesThatAreNoText) {
    expect_refused(write("nul.glsl", std::string("f\0", 2)), "NUL");
    fs::create_directory(path("folder.glsl"));
    expect_refused(path("folder.glsl"), "is a folder");
}

// What ends the compiler, or takes all memory, ends a copy of the process.
TEST_F(HostileShaders, TextsThatTheCompilerDoesNotSurvive) {
    const std::string deep = "float f(float x) { return " + repeated("x-", 200'000) + "x; }\n";
    std::string macros = "#define M0 x\n";
    for (int i = 1; i <= 40; ++i) macros += fmt::format("#define M{0} M{1} + M{1}\n", i, i - 1);
    const fs::path bad = write("deep.glsl", deep);
    const fs::path whole = write("deep.comp", "#version 450\n" + deep + "void main() { f(1.0); }\n");
    for (const char* command :
         {"check {}", "explain {} f 1", "audit {}", "mutate {} -- true", "pack {} --target hlsl"})
        expect_could_not_run(gloam(command, bad), "deep.glsl: the compiler ended by signal 11");
    expect_could_not_run(gloam("cost {}", whole), "deep.comp: the compiler ended by signal 11");
    const fs::path much = write("double.glsl", macros + "float f(float x) { return M40; }\n");
    expect_could_not_run(gloam("pack {}", much), "double.glsl: the compiler takes more than ");
}

TEST_F(HostileShaders, ControlCharactersDoNotReachTheTerminal) {
    const std::string red = "\x1b[31mred";
    expect_refused(write("token.glsl", "float f(float x) { return " + red + "; }\n"), "");
    expect_refused(write("error.glsl", "#error " + red + "\n"), "");
    expect_refused(write("include.glsl", "#include \"" + red + "\"\n"), "[31mred");
    const fs::path named = write("line\n" + red + ".glsl", "float f(float x) { return x@; }\n");
    for (const char* command : {"check", "pack"}) {
        const CommandResult result = gloam("{} {}", command, named);
        expect_could_not_run(result, "[31mred.glsl");
        EXPECT_THAT(result.out + result.err, Not(HasSubstr("\x1b")));
    }
}

}  // namespace gloam::test::hostile_test
