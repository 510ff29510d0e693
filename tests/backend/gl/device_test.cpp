// SPDX-License-Identifier: MIT
#include "backend/gl/device.hpp"
#include "backend/gl/program.hpp"
#include "support/test_name.hpp"

namespace gloam::backend::gl::device_test {

// The device of a test, which is skipped in one line where this machine has no such device.
class Opened : public testing::Test {
  protected:
    // False where there is none.
    bool open(const std::string& name) {
        try {
            device_.emplace(name);
        } catch (const Unavailable& error) {
            skipped_ = error.what();
        }
        return device_.has_value();
    }
    [[nodiscard]] const Device& device() const { return *device_; }
    void close() { device_.reset(); }

    std::string skipped_;

  private:
    std::optional<Device> device_;
};

#define GLOAM_OPEN_OR_SKIP(name) \
    if (!open(name)) GTEST_SKIP() << skipped_

class OpenDevice : public Opened {};

// Both executors, one after the other, in one process.
TEST_F(OpenDevice, EachExecutorIsTheOneThatWasAskedFor) {
    for (const char* name : {"es:llvmpipe-3.0", "es:softpipe-3.0", "es:llvmpipe-3.0"}) {
        GLOAM_OPEN_OR_SKIP(name);
        EXPECT_THAT(device().info().renderer, HasSubstr(device().info().id.executor));
        EXPECT_EQ(device().info().max_storage_blocks, 0U);
        close();
    }
}

TEST_F(OpenDevice, TheEnvironmentStaysAsItWas) {
    GLOAM_OPEN_OR_SKIP("es:llvmpipe-3.0");
    close();
    ::setenv("GALLIUM_DRIVER", "softpipe", 1);
    ::unsetenv("LIBGL_ALWAYS_SOFTWARE");
    const bool opened = open("es:llvmpipe-3.0");
    const std::string driver = std::getenv("GALLIUM_DRIVER");
    ::unsetenv("GALLIUM_DRIVER");
    EXPECT_TRUE(opened) << skipped_;
    EXPECT_EQ(driver, "softpipe");
    EXPECT_EQ(std::getenv("LIBGL_ALWAYS_SOFTWARE"), nullptr);
}

TEST_F(OpenDevice, AnotherExecutorMustWait) {
    GLOAM_OPEN_OR_SKIP("es:softpipe-3.0");
    expect_error<Unavailable>([] { const Device other("es:llvmpipe-3.0"); },
                              {"runs softpipe: close its devices before one of llvmpipe"});
    EXPECT_NO_THROW(const Device same("es:softpipe-3.1"));
}

TEST_F(OpenDevice, AVersionThatTheDriverLacksIsRefused) {
    GLOAM_OPEN_OR_SKIP("es:softpipe-3.0");
    close();
    // If a later softpipe has it, another refusal has to be found for this test.
    expect_error<VersionRefused>(
        [] { const Device device("gl:softpipe-4.5"); },
        {"gl:softpipe-4.5: the driver makes no context of OpenGL 4.5 (EGL error 0x"});
}

TEST(DeviceNames, OthersAreNone) {
    for (const char* text : {"", "gl", "gl:", "gl:llvmpipe", "gl:llvmpipe-4.6", "es:llvmpipe-3.3",
                             "GL:llvmpipe-4.5", "gl:llvmpipe-4.5 ", "llvmpipe"})
        EXPECT_FALSE(device_name_from(text)) << text;
    for (const char* text : {"", "gl", "llvmpipe", "interpreter", "0"})
        EXPECT_FALSE(is_device_name(text)) << text;
}

class OpenGlProgram : public Opened {};

constexpr const char* head = "#version 300 es\nprecision highp float;\nout highp uvec4 target;\n";

TEST_F(OpenGlProgram, WhatIsRejectedOrDoesNotLinkIsNamedWithItsLine) {
    GLOAM_OPEN_OR_SKIP("es:llvmpipe-3.0");
    const auto refuse = [&](const char* text, std::initializer_list<std::string> parts) {
        const ShaderText shader{"wrong.frag", std::string(head) + text};
        expect_error<backend::Error>(
            [&] { const Program program(device(), Program::Stage::fragment, shader); }, parts);
    };
    refuse("void main() {\n    target = vec3(1.0);\n}\n",
           {"wrong.frag: line 5: ", "error", "[    target = vec3(1.0);]"});
    refuse("float missing(float x);\nvoid main() { target = uvec4(missing(1.0)); }\n",
           {"wrong.frag: does not link: ", "missing"});
}

TEST_F(OpenGlProgram, AVersionThatTheContextLacksIsRejected) {
    GLOAM_OPEN_OR_SKIP("gl:softpipe-3.3");
    const ShaderText text{"new.comp", "#version 450\nlayout(local_size_x = 1) in;\nvoid main() {}\n"};
    EXPECT_THROW(const Program program(device(), Program::Stage::compute, text), backend::Error);
}

// Whether a device passes words on bit by bit: NaN with a payload, subnormals, -0, infinity among them.
const std::vector<Word> awkward{0x7fc01234U, 0xffffffffU, 0x00000001U, 0x80000000U,
                                0x7f800000U, 0x3f800000U, 0x807fffffU, 0U};

class OpenGlRuns : public Opened, public testing::WithParamInterface<const char*> {};

class OpenGlDispatches : public OpenGlRuns {};
class OpenGlDraws : public OpenGlRuns {};

TEST_P(OpenGlDispatches, ReadsAndWritesStorageBuffers) {
    GLOAM_OPEN_OR_SKIP(GetParam());
    const std::string version = device().info().id.version.api == Api::gl ? "450" : "310 es";
    const Program program(device(), Program::Stage::compute, {"add.comp", "#version " + version + R"(
layout(local_size_x = 4) in;
layout(std140, binding = 5) uniform Settings { uint more; };
layout(std430, binding = 0) readonly buffer From { uint from[]; };
layout(std430, binding = 1) buffer To { uint to[]; };
void main() { to[gl_GlobalInvocationID.x] = from[gl_GlobalInvocationID.x] + more; }
)"});
    Buffer from(device(), awkward.size());
    from.write(0, awkward);
    const Buffer to(device(), awkward.size() + 1);
    Buffer settings(device(), 4);
    settings.write(0, std::vector<Word>{3});
    dispatch(device(), {.program = program,
                        .storage = {{0, from}, {1, to}},
                        .uniforms = {{5, settings}},
                        .groups = {static_cast<std::uint32_t>(awkward.size() / 4), 1, 1}});
    std::vector<Word> want;
    for (const Word word : awkward) want.push_back(word + 3);
    want.push_back(0);
    EXPECT_EQ(to.read(), want);
    EXPECT_EQ(from.read(), awkward);
}

TEST_P(OpenGlDraws, ReadsTexturesAndWritesEveryTargetBitByBit) {
    GLOAM_OPEN_OR_SKIP(GetParam());
    const bool es = device().info().id.version.api == Api::es;
    const Program program(
        device(), Program::Stage::fragment,
        {"copy.frag",
         std::string(es ? "#version 300 es\nprecision highp float;\n" : "#version 330 core\n") + R"(
uniform highp usampler2D words;
uniform uint first;
layout(location = 0) out highp uvec4 one;
layout(location = 1) out highp uvec4 two;
uint word(uint at) {
    return floatBitsToUint(uintBitsToFloat(texelFetch(words, ivec2(int(at & 2047u), int(at >> 11u)), 0).x));
}
void main() {
    uint at = first + 8u * (uint(gl_FragCoord.y) * 2u + uint(gl_FragCoord.x));
    one = uvec4(word(at), word(at + 1u), word(at + 2u), word(at + 3u));
    two = uvec4(word(at + 4u), word(at + 5u), word(at + 6u), word(at + 7u));
}
)"});
    std::vector<Word> words(2047, 9U);  // the first fragment reads over the end of a row
    for (Word i = 0; i < 6; ++i)
        for (const Word word : awkward) words.push_back(word + (i << 8U));
    const WordTexture texture(device(), words);
    const auto targets = draw(device(), {.program = program,
                                         .textures = {{"words", &texture}, {"not_used", &texture}},
                                         .uniforms = {{"first", 2047}},
                                         .width = 2,
                                         .height = 3,
                                         .targets = 2});
    ASSERT_EQ(targets.size(), 2U);
    for (std::size_t pixel = 0; pixel < 6; ++pixel) {
        for (std::size_t k = 0; k < 8; ++k) {
            EXPECT_EQ(targets[k / 4].at(pixel * 4 + k % 4), words[2047 + pixel * 8 + k]) << pixel << " " << k;
        }
    }
}

std::string name_of(const testing::TestParamInfo<const char*>& info) {
    return test::test_name(info.param);
}

INSTANTIATE_TEST_SUITE_P(All, OpenGlDispatches,
                         testing::Values("gl:llvmpipe-4.5", "es:llvmpipe-3.1", "es:softpipe-3.1"), name_of);
INSTANTIATE_TEST_SUITE_P(All, OpenGlDraws,
                         testing::Values("gl:llvmpipe-3.3", "es:llvmpipe-3.0", "es:softpipe-3.0"), name_of);

}  // namespace gloam::backend::gl::device_test
