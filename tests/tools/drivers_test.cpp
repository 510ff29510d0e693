// SPDX-License-Identifier: MIT
// A browser's SwiftShader, and devices of OpenGL. Drivers that do not load: stories/drivers.txt.
#include "backend/vulkan/device.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::drivers_test {

json devices(const std::string& more = "", const CommandOptions& options = {}) {
    const json all =
        json::parse(output_of(run_command(words("devices --json" + more), options))).at("devices");
    EXPECT_EQ(all.back().at("name"), "interpreter");
    return all;
}

// The numbers of those whose name holds "SwiftShader".
std::vector<json> swiftshaders(const json& devices) {
    std::vector<json> found;
    for (const json& device : devices)
        if (device.at("name").get<std::string>().find("SwiftShader") != std::string::npos)
            found.push_back(device.at("index"));
    return found;
}

class SwiftShader : public InFolder {
  protected:
    void SetUp() override {
        if (!manifest_) GTEST_SKIP() << "no SwiftShader here (Debian's package chromium has it)";
    }
    const std::optional<fs::path> manifest_ = gpu::find_swiftshader();
};

TEST_F(SwiftShader, OfABrowserIsFoundAndComesLastUnlessTheEnvironmentChooses) {
    const CommandOptions alone{
        .environment = {"VK_DRIVER_FILES=" + manifest_->string(), "VK_ICD_FILENAMES=" + manifest_->string()}};
    EXPECT_EQ(swiftshaders(devices("", alone)), std::vector<json>{0});
    const CommandOptions elsewhere{.environment = {"VK_ADD_DRIVER_FILES=/no/such/driver.json"}};
    EXPECT_THAT(run_command(words("devices --json"), elsewhere).out, Not(HasSubstr("SwiftShader")));

    if (gpu::drivers_are_chosen()) GTEST_SKIP() << "the environment chooses the drivers";
    const json all = devices();
    const auto vulkan =
        std::ranges::count_if(all, [](const json& one) { return one.at("index").is_number(); });
    EXPECT_EQ(swiftshaders(all), std::vector<json>{vulkan - 1});
    EXPECT_EQ(swiftshaders(devices(" --driver " + manifest_->string())).size(), 1U) << "listed twice";
    EXPECT_THAT(output_of(gloam("check HALTON-base2 --inputs 64 --device swiftshader")),
                HasSubstr("device: SwiftShader"));
    if (vulkan > 1) {
        EXPECT_THAT(output_of(gloam("check HALTON-base2 --inputs 64")), Not(HasSubstr("SwiftShader")));
    }
}

using BrokenDriver = InFolder;

// However they come to be known, one line names it, and every command runs on the others.
TEST_F(BrokenDriver, BesideAWorkingOneCostsItselfOnly) {
    const fs::path lavapipe = installed_lavapipe();
    if (lavapipe.empty()) GTEST_SKIP() << "no lavapipe here (Debian: mesa-vulkan-drivers)";
    const fs::path broken = write("a broken one.json",
                                  R"({"file_format_version": "1.0.0", "ICD": {"api_version": "1.3.0",
                                  "library_path": ")" GLOAM_CRASHING_DRIVER "\"}}");
    const std::string both = broken.string() + ":" + lavapipe.string();
    const CommandOptions named{.environment = {"VK_DRIVER_FILES=" + both, "VK_ICD_FILENAMES=" + both}};
    const CommandOptions added{.environment = {"VK_ADD_DRIVER_FILES=" + broken.string()}};
    for (const auto& line :
         {words("devices"), words("check HALTON-base2 --inputs 64"),
          words("render corner --size 16x9 --samples 1 --out {}", path("render")),
          words("bench --scene corner --method hemisphere --samples 4 --size 32x18 --frames 1 "
                "--rays 32 --repeat 1 --out {}",
                path("bench"))}) {
        for (const CommandOptions& known : {named, added}) {
            const CommandResult result = run_command(line, known);
            EXPECT_EQ(result.status, 0) << line[0] << result.out << result.err;
            EXPECT_EQ(line_count(result.err), 1) << line[0] << result.err;
            EXPECT_THAT(result.err, AllOf(StartsWith("gloam: Vulkan driver " + broken.string() + ": "),
                                          HasSubstr("ABRT"), EndsWith("; it is skipped\n")));
            fs::remove_all(path("bench"));
        }
    }
}

// Those of Vulkan have a number and float controls; then those of OpenGL, and the interpreter as the last.
TEST(Devices, AreListedWithTheirFloatControls) {
    const json all = devices();
    ASSERT_GE(all.size(), 2U);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string type = all[i].at("type");
        const bool is_opengl = type.starts_with("opengl");
        EXPECT_EQ(all[i].at("index"), is_opengl || i + 1 == all.size() ? json() : json(i));
        EXPECT_NE(all[i].at("name"), "");
        EXPECT_EQ(all[i].contains("float32"), !is_opengl);
        if (!is_opengl) {
            EXPECT_TRUE(all[i].at("float32").at("denorm_preserve").is_boolean());
        }
    }
}

class OpenGlCommands : public InFolder {
  protected:
    void SetUp() override {
        for (const json& device : devices())
            if (device.at("type").get<std::string>().starts_with("opengl"))
                names_.push_back(device.at("name"));
        if (names_.empty()) GTEST_SKIP() << "no OpenGL device here";
    }
    std::vector<std::string> names_;
};

// There are no precision rules for OpenGL ES 3.0, and a built-in function documents no accuracy.
TEST_F(OpenGlCommands, EveryListedDeviceRunsChecksAndNothingJudgedIsNoSuccess) {
    const std::string listed = output_of(gloam("devices"));
    const fs::path file = path("results.json");
    const CommandResult result =
        gloam("check HALTON-2D BUILTIN-sin --inputs 256 --device gl --json {}", file);
    EXPECT_EQ(result.status, 0) << result.err;
    for (const std::string& name : names_) {
        EXPECT_THAT(listed, HasSubstr("\n" + name + ": OpenGL "));
        EXPECT_THAT(result.out, HasSubstr("device: " + name + " ("));
    }
    EXPECT_THAT(result.out, AllOf(HasSubstr(std::to_string(2 * names_.size()) + " checks, 0 failed"),
                                  HasSubstr("not judged")));
    EXPECT_THAT(output_of(gloam("report {}", file)), HasSubstr(names_.front()));

    const CommandResult none = gloam("check BUILTIN-sin --inputs 64 --device es:llvmpipe-3.0");
    EXPECT_EQ(none.status, 2) << none.out << none.err;
    EXPECT_THAT(none.out, AllOf(HasSubstr("not judged; it documents no accuracy"),
                                HasSubstr("1 checks, 0 failed, 1 not judged")));
}

TEST_F(OpenGlCommands, AFailureIsHandedOverAsTheShaderThatTheDriverWasGiven) {
    const Installation installation;
    installation.spoil_radical_inverse_base2();
    for (const std::string& name : names_) {
        if (name != "es:llvmpipe-3.0" && name != "es:llvmpipe-3.1") continue;
        const fs::path failures = installation.file("failures-" + name.substr(name.size() - 3));
        const CommandResult result =
            installation.gloam("check HALTON-base2 --inputs 64 --device {} --failures {}", name, failures);
        EXPECT_EQ(result.status, 1) << result.err;
        ASSERT_TRUE(fs::exists(failures));
        const fs::path device = fs::directory_iterator(failures)->path();
        const fs::path folder = fs::directory_iterator(device)->path();
        EXPECT_FALSE(fs::exists(folder / "repro.amber"));
        EXPECT_THAT(read_file(folder / "shader.glsl"),
                    HasSubstr("float gloam_radical_inverse_base2(uint index)"));
        EXPECT_THAT(read_file(folder / "report.txt"), HasSubstr(", OpenGL ES 3."));
    }
}

TEST_F(OpenGlCommands, OtherVariantsAndUnknownNamesAreRefusedInOneLine) {
    const std::string name = names_.front();
    expect_could_not_run(gloam("check HALTON-2D --device {} --variant strict", name),
                         name + ": expected the variant shipped");
    expect_could_not_run(
        gloam("check HALTON-2D --device gl:softpipe-3.3 --compiler {}", "spirv-opt -O"),
        "gl:softpipe-3.3: expected the variant shipped without steps, not shipped | spirv-opt -O");
    expect_could_not_run(gloam("check HALTON-2D --device gl:nonsense-1.0"),
                         "no OpenGL device \"gl:nonsense-1.0\"");
    expect_could_not_run(gloam("check HALTON-2D --device {} --validation", name),
                         "validation layers are of Vulkan");
}

TEST_F(OpenGlCommands, RunNoInvocationsTogether) {
    const fs::path shader =
        write("given.frag",
              "#version 300 es\nprecision mediump float;\nuniform sampler2D image;\nin vec2 uv;\n"
              "vec3 seen() { return texture(image, uv).rgb; }\n");
    const fs::path report = path("opengl.json");
    (void)gloam("check {} seen --inputs 64 --device {} --json {}", shader, names_.back(), report);
    EXPECT_THAT(read_file(report),
                HasSubstr("runs in several invocations together, and OpenGL runs each alone"));
}

}  // namespace gloam::test::drivers_test
