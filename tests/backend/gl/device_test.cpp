// SPDX-License-Identifier: MIT
#include "backend/gl/device.hpp"
#include "backend/gl/program.hpp"
#include "support/test.hpp"

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

using OpenDevice = Opened;

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

using OpenGlProgram = Opened;

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

}  // namespace gloam::backend::gl::device_test
