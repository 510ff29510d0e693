// SPDX-License-Identifier: MIT
#include "support/seen_files.hpp"

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

}  // namespace

void keep_a_list_for_each_test() {
    const char* list = std::getenv(list_variable);
    if (list == nullptr) return;
    auto listener = std::make_unique<ListForEachTest>(list);
    testing::UnitTest::GetInstance()->listeners().Append(listener.release());  // which owns it from now on
}

}  // namespace gloam::test
