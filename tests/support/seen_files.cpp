// SPDX-License-Identifier: MIT
// Which tests read which shaders: what tools/test-readers asks.
//
// ctest gives each group of tests a list in GLOAM_DEPENDENCIES_OUTPUT, to which the shader compiler adds the
// files that it reads. Here each test of the group gets a list of its own beside that: LIST:TEST, with commas
// in the place of slashes. Its last line is "seconds " and how long the test took. What is read outside of a
// test stays in the list of the group.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

namespace gloam::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_variable = "GLOAM_DEPENDENCIES_OUTPUT";

class ListForEachTest : public testing::EmptyTestEventListener {
  public:
    explicit ListForEachTest(std::string list) : list_(std::move(list)) {}

    void OnTestStart(const testing::TestInfo& test) override {
        std::string name = std::string(test.test_suite_name()) + "." + test.name();
        std::ranges::replace(name, '/', ',');
        ::setenv(list_variable, (list_ + ":" + name).c_str(), 1);
    }
    // The last line of a list: how long the test took.
    void OnTestEnd(const testing::TestInfo& test) override {
        if (fs::exists(std::getenv(list_variable)))
            std::ofstream(std::getenv(list_variable), std::ios::app)
                << "seconds " << static_cast<double>(test.result()->elapsed_time()) / 1000.0 << "\n";
        ::setenv(list_variable, list_.c_str(), 1);
    }

  private:
    std::string list_;
};

[[maybe_unused]] const bool listening = [] {
    const char* const list = std::getenv(list_variable);
    if (list != nullptr)  // GoogleTest owns the listener
        testing::UnitTest::GetInstance()->listeners().Append(
            std::make_unique<ListForEachTest>(list).release());
    return true;
}();

}  // namespace
}  // namespace gloam::test
