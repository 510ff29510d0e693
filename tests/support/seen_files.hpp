// SPDX-License-Identifier: MIT
#pragma once

// Which tests read which shaders: what tools/test-readers asks.
//
// ctest gives each group of tests a list in GLOAM_DEPENDENCIES_OUTPUT, to which the shader compiler adds the
// files that it reads. keep_a_list_for_each_test() gives each test of the group a list of its own beside
// that: LIST:TEST, with commas in the place of slashes. Its last line is "seconds " and how long the test
// took. What is read outside of a test stays in the list of the group.
namespace gloam::test {

// Call once, between InitGoogleTest() and RUN_ALL_TESTS(). Does nothing without that variable.
void keep_a_list_for_each_test();

}  // namespace gloam::test
