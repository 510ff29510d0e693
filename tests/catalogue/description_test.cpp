// SPDX-License-Identifier: MIT
#include "catalogue/description.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "catalogue/catalogue.hpp"

namespace gloam::catalogue {
namespace description_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

// A shader library of one file, in a folder of its own.
class Library {
  public:
    explicit Library(const std::string& text) {
        fs::create_directories(folder_ / "gloam/numeric");
        fs::create_directories(folder_ / "builtin");
        std::ofstream(folder_ / "gloam/numeric/a.glsl") << text;
    }
    ~Library() { fs::remove_all(folder_); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    [[nodiscard]] const fs::path& path() const { return folder_; }

  private:
    inline static int count_ = 0;
    fs::path folder_ = fs::temp_directory_path() /
                       ("gloam-descriptions-" + std::to_string(getpid()) + "-" + std::to_string(++count_));
};

auto throws(const std::string& a, const std::string& b) {
    return ThrowsMessage<std::runtime_error>(AllOf(HasSubstr(a), HasSubstr(b)));
}

TEST(Descriptions, AreTheFirstSentenceOfTheCommentAboveAFunction) {
    const Library library(
        "// SPDX\n\n// Of the file, not of a function: `x` [y].\n\n"
        "// title of x (recorded), in [0, 1]: part (A-1): `min(x, 1): 0;  1` [someone et\n// al., eq 1]. "
        "More [of] it.\n"
        "// x: any float.\nprecise float gloam_a(float x) {\n}\n"
        "// Nothing, or a sentence: `x` [y].\nfloat gloam_b() {\n}\n");
    const auto all = descriptions(library.path());
    ASSERT_EQ(all.size(), 1U);
    const Description& a = all.at("A-1");
    EXPECT_EQ(a.title, "title of x (recorded), in [0, 1]: part");
    EXPECT_EQ(a.formula, "min(x, 1): 0;  1");
    EXPECT_EQ(a.source, "someone et al., eq 1");
    EXPECT_EQ(a.function, "gloam_a");
    EXPECT_EQ(a.file, "gloam/numeric/a.glsl");
}

TEST(Descriptions, OfNoFunctionAndOfTwoAreErrors) {
    const Library no_function("// title (A): `x` [y].\n\nfloat gloam_a() {\n}\n");
    EXPECT_THAT([&] { (void)descriptions(no_function.path()); },
                throws("gloam/numeric/a.glsl", "no function below the comment of A"));
    const Library two("// b (A): `x` [y].\nfloat f() {\n}\n// c (A): `x` [y].\nfloat g() {\n}\n");
    EXPECT_THAT([&] { (void)descriptions(two.path()); }, throws("A already describes f", "a.glsl"));
    EXPECT_THAT([&] { (void)descriptions(two.path() / "gloam"); },
                throws("expected the folder", "gloam/gloam"));
}

TEST(Descriptions, TheCatalogueNamesAnEquationThatTheyLack) {
    const Library library("// title (A): `x` [y].\nfloat gloam_a() {\n}\n");
    EXPECT_THAT([&] { (void)all_entries(library.path()); },
                throws(library.path().string() + " describes SINCOS-octant",
                       "begins with \"TITLE (SINCOS-octant): `FORMULA` [SOURCE].\""));
}

}  // namespace description_test
}  // namespace gloam::catalogue
