// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

#include "backend/vulkan/device.hpp"
#include "support/seen_files.hpp"

// main() of tests that open devices. With --swiftshader they run on a browser's SwiftShader; without one they
// leave with the exit status that ctest takes for "skipped".
int main(int argc, char** argv) {
    constexpr int skipped = 77;
    testing::InitGoogleMock(&argc, argv);
    const std::span arguments(argv, static_cast<std::size_t>(argc));
    if (std::ranges::any_of(arguments,
                            [](const char* a) { return std::string_view(a) == "--swiftshader"; })) {
        const auto manifest = gloam::backend::vulkan::find_swiftshader();
        if (!manifest) {
            std::puts("skipped: no SwiftShader here (Debian's package chromium has it)");
            return skipped;
        }
        gloam::backend::vulkan::add_drivers(std::array{*manifest});
        ::setenv("GLOAM_TEST_DEVICE", "SwiftShader", 1);
    }
    gloam::test::keep_a_list_for_each_test();
    return RUN_ALL_TESTS();
}
