// SPDX-License-Identifier: MIT
#include "cost/cost.hpp"

#include "backend/vulkan/radv.hpp"
#include "base/process.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::cost_test {

using cost::Cost;

std::string fixture(const std::string& name) {
    return std::string(FIXTURES "/") + name;
}

module::Spirv compiled(const std::string& name) {
    return module::compile({fixture(name), read_file(fixture(name))}, {});
}

// As RADV writes it: a loop in a loop, then a branch forward.
constexpr const char* assembly =
    "BB0:\n"
    "\tv_mov_b32_e32 v1, 0                    ; 7e020280\n"
    "\ts_load_dwordx4 s[4:7], s[4:5], null    ; f4080102 fa000000\n"
    "BB1:\n"
    "\tbuffer_load_dword v2, off, s[4:7], 0   ; e0300000\n"
    "BB2:\n"
    "\timage_sample v[3:4], v[5:6], s[8:15]   ; f0800000\n"
    "\ts_cbranch_scc1 BB2                     ; bf85000a\n"
    "\tv_pk_add_f16 v1, v1, v2                ; 06020501\n"
    "\ts_branch BB1                           ; bf82ffeb\n"
    "BB3:\n"
    "\ts_cbranch_execz BB4                    ; bf880000\n"
    "\timage_store v0, v[1:2], s[0:7]         ; f0200000\n"
    "\tglobal_atomic_add_u32 v0, v1, s[0:1]   ; dcc80000\n"
    "BB4:\n"
    "\ts_endpgm                               ; bf810000\n"
    "\ts_code_end                             ; bf9f0000\n";

TEST(Counted, InstructionsByTheUnitThatExecutesThem) {
    EXPECT_EQ(cost::counted(assembly),
              (Cost{.instructions = 11, .valu = 2, .loads = 2, .stores = 2, .loops = 2, .in_loops = 5}));
    for (const char* text : {"", "\n", "BB0:", "BB", "s_branch", "; v_mov_b32", "V_MOV_B32 v1, 0"})
        EXPECT_EQ(cost::counted(text).valu, 0U) << text;
}

// What a driver for a chip says: without RADV there is nothing to test.
class OfChip : public InFolder {
  protected:
    void SetUp() override {
        InFolder::SetUp();
        try {
            (void)cost::cost_of(compiled("filter3.comp"));
        } catch (const base::WorkError& error) {
            if (std::string(error.what()) == backend::vulkan::no_radv_message) GTEST_SKIP() << error.what();
        }
    }
    static json json_of(const std::vector<std::string>& arguments) {
        return json::parse(output_of(run_command(arguments)));
    }
};

// The count is that of 22.3.6 and of 25.0.7, the two Debians' Mesa.
TEST_F(OfChip, AFilterOfThreeByThree) {
    const Cost cost = cost::cost_of(compiled("filter3.comp"));
    EXPECT_EQ((std::array{cost.valu, cost.loads, cost.stores, cost.loops, cost.spilled}),
              (std::array<std::uint64_t, 5>{129, 4, 2, 0, 0}));
    EXPECT_GT(std::min(cost.registers, cost.waves), 0U);
    for (const char* family : cost::families) {
        const Cost cost = cost::cost_of(compiled("filter3.comp"), {.family = family});
        EXPECT_THAT(static_cast<double>(cost.valu), testing::DoubleNear(129, 30)) << family;
    }
}

TEST_F(OfChip, EveryKindOfBindingIsValid) {
    const Cost cost = cost::cost_of(compiled("descriptors.comp"), {.validation = true});
    EXPECT_EQ(cost.loops, 1U);
    EXPECT_GT(cost.in_loops, 0U);
    EXPECT_LT(cost.in_loops, cost.instructions);
}

TEST_F(OfChip, ConstantsAreThoseGiven) {
    const module::Spirv module = module::compile(
        {"constant.comp",
         "#version 450\nlayout(constant_id = 3) const int n = 1;\nlayout(binding = 0) buffer B { float v; "
         "};\n"
         "void main() { float s = v; for (int i = 0; i < n; ++i) s = sin(s) + 0.5; v = s; }\n"},
        {});
    const Cost four = cost::cost_of(module, {.constants = {{.id = 3, .bits = 4}}});
    EXPECT_GT(four.valu, cost::cost_of(module).valu + 5);
}

TEST_F(OfChip, TheEnvironmentOfAUserChangesNothing) {
    const std::vector<std::string> arguments{"cost", fixture("filter3.comp")};
    const std::string usual = output_of(run_command(arguments));
    const std::string other = output_of(run_command(
        arguments, {.environment = {"RADV_DEBUG=nooutoforder,shaders", "RADV_FORCE_FAMILY=POLARIS10",
                                    "ACO_DEBUG=noopt,nosched", "RADV_PERFTEST=cswave32",
                                    "VK_INSTANCE_LAYERS=VK_LAYER_no_such"}}));
    EXPECT_EQ(other, usual);
}

TEST_F(OfChip, AboveItsLimitTheStatusIsOne) {
    const CommandResult above = gloam("cost {} --below 128", fixture("filter3.comp"));
    EXPECT_EQ(above.status, 1);
    EXPECT_EQ(above.err, "filter3.comp: 129 vector instructions, allowed are 128\n");
    const CommandResult frame = gloam("cost --preset fast --below 1");
    EXPECT_EQ(frame.status, 1);
    EXPECT_THAT(frame.err, StartsWith("fast: "));
}

TEST_F(OfChip, FunctionsOfAFile) {
    std::ofstream(path("two.glsl")) << "float twice(float x) { return 2.0 * x; }\n"
                                       "float curve(float x) { return exp(sin(x)) / (1.0 + sqrt(x)); }\n"
                                       "float slope(float x) { return dFdx(x); }\n";
    const CommandResult all = gloam("cost {} --json", path("two.glsl"));
    EXPECT_EQ(all.status, 0);
    EXPECT_EQ(std::ranges::count(all.err, '\n'), 1) << all.err;
    EXPECT_THAT(all.err, HasSubstr("slope"));
    const json shaders = json::parse(all.out).at("shaders");
    ASSERT_EQ(shaders.size(), 2U);
    EXPECT_EQ(shaders[0].at("name"), "twice");
    EXPECT_GT(shaders[1].at("valu"), shaders[0].at("valu"));
    const json one = json_of(words("cost {} curve --json", path("two.glsl"))).at("shaders");
    EXPECT_EQ(one, json::array({shaders[1]}));
    expect_success(gloam("cost gloam/sampling/halton.glsl gloam_halton_2d"));
}

TEST_F(OfChip, DefinitionsKeepTheNumbersOfLines) {
    const fs::path file = write("defined.comp",
                                "#version 450\nlayout(binding = 0) buffer B { float v; };\n"
                                "void main() { v = VALUE; }\n");
    expect_success(gloam("cost {} --define VALUE=2.0", file));
    expect_could_not_run(gloam("cost {} --define OTHER", file), "defined.comp:3: ");
}

// Of the passes of a frame: the sums of vector instructions and bytes a pixel.
struct Frame {
    double valu = 0.0;
    double bytes = 0.0;
    double memory = 0.0;
};

Frame frame_of(const json& all) {
    Frame frame{.memory = all.at("memory_bytes")};
    for (const json& pass : all.at("passes")) {
        frame.valu += pass.at("valu_per_pixel").get<double>();
        frame.bytes += pass.at("bytes_per_pixel").get<double>();
        EXPECT_EQ(pass.at("loops"), 0) << pass;
        EXPECT_EQ(pass.at("spilled"), 0) << pass;
        EXPECT_NEAR(
            pass.at("valu").get<double>() / pass.at("pixels").get<double>() * pass.at("share").get<double>(),
            pass.at("valu_per_pixel"), 1e-6);
        EXPECT_GE(pass.at("microseconds"), 4.92);
    }
    return frame;
}

// The frames of the presets: within 2 % of what this compiler counted; then what a history adds, of the
// cheapest and the dearest.
TEST_F(OfChip, TheFramesOfThePresets) {
    const bool newer = gloam("devices").out.find("Mesa 25") != std::string::npos;
    for (const auto& [name, mesa_22, mesa_25, bytes, passes] :
         {std::tuple{"fast", 308, 310, 17.7, 3U}, std::tuple{"balanced", 577, 589, 17.7, 3U},
          std::tuple{"quality", 768, 775, 25.6, 6U}, std::tuple{"reference", 1081, 1095, 26.3, 6U}}) {
        const json all = json_of(words("cost --preset {} --set history=off --json", name));
        EXPECT_EQ(all.at("passes").size(), passes);
        const Frame single = frame_of(all);
        const int expected = newer ? mesa_25 : mesa_22;
        EXPECT_NEAR(single.valu, expected, 0.02 * expected) << name;
        EXPECT_NEAR(single.bytes, bytes, 0.02 * bytes) << name;
        EXPECT_LE(single.memory, 20e6) << name;
        EXPECT_GE(single.memory, 5e6) << name;
        if (name == std::string("balanced") || name == std::string("quality")) continue;
        const Frame sequence = frame_of(json_of(words("cost --preset {} --json", name)));
        EXPECT_NEAR(sequence.valu - single.valu, 45.0, 25.0) << name;
        EXPECT_LE(sequence.memory, 42e6) << name;
    }
}

// With all tiles in full there is nothing to join; with none, nothing to filter.
TEST_F(OfChip, TilesCountByTheirShare) {
    const auto valu = [&](const char* share) {
        return frame_of(json_of(words("cost --preset quality --tiles {} --json", share))).valu;
    };
    const double half = valu("0");
    const double full = valu("1");
    EXPECT_GT(full, 4.0 * half);
    EXPECT_NEAR(valu("0.25"), 0.75 * half + 0.25 * full, 1e-6);
}

TEST_F(OfChip, WhatCannotBeCountedIsOneLine) {
    const std::string filter = fixture("filter3.comp");
    for (const auto& [line, named] : {std::pair{"cost", "--preset NAME"},
                                      {"cost {} --preset fast", "--preset NAME"},
                                      {"cost --preset none", "none"},
                                      {"cost --preset fast --set magic=1", "magic"},
                                      {"cost {} --set history=off", "--set"},
                                      {"cost {} --sequence", "--sequence"},
                                      {"cost {} --family GTX", "expected NAVI21, NAVI31, POLARIS10"},
                                      {"cost --preset quality --tiles 2", "--tiles"},
                                      {"cost {} --tiles 0.5", "--preset NAME"}})
        expect_could_not_run(gloam(line, filter), named);
    expect_could_not_run(
        gloam("cost {}", write("far.comp",
                               "#version 450\nlayout(set = 40, binding = 0) buffer B { float v; };\n"
                               "void main() { v = 1.0; }\n")),
        "descriptor set 40:");
    expect_could_not_run(gloam("cost {}", write("quad.frag", "float f(float x) { return dFdx(x); }\n")),
                         "derivatives");
    const CommandResult without =
        run_command({"cost", filter}, {.environment = {"VK_DRIVER_FILES=/none", "VK_ICD_FILENAMES=/none"}});
    expect_could_not_run(without, backend::vulkan::no_radv_message);
}

}  // namespace gloam::test::cost_test
