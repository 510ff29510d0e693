// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "support/seen_files.hpp"

// main() of tests that open no devices of their own choice; device_main.cpp is that of the others.
int main(int argc, char** argv) {
    testing::InitGoogleMock(&argc, argv);
    gloam::test::keep_a_list_for_each_test();
    return RUN_ALL_TESTS();
}
