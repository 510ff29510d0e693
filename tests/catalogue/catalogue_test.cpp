// SPDX-License-Identifier: MIT
#include "catalogue/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "shader/compile.hpp"
#include "shader/include.hpp"

namespace gloam::catalogue {
namespace catalogue_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<fs::path> library_files() {
    std::vector<fs::path> files;
    for (const auto& file : fs::recursive_directory_iterator(fs::path(GLOAM_GLSL_DIR) / "gloam")) {
        if (file.path().extension() == ".glsl") files.push_back(file.path());
    }
    std::ranges::sort(files);
    return files;
}

// Functions that a file defines itself, not through its includes: their names stand in its own text before a
// brace.
std::set<std::string> functions_of(const fs::path& file) {
    const std::string name = fs::relative(file, GLOAM_GLSL_DIR).string();
    const std::string own = shader::read_text(file);
    std::set<std::string> names;
    for (const shader::Function& f :
         shader::functions({.name = name, .text = "#version 450\n#include \"" + name + "\"\n"},
                           {.include_roots = {GLOAM_GLSL_DIR}})) {
        if (f.defined && own.find(" " + f.name + "(") != std::string::npos) names.insert(f.name);
    }
    return names;
}

// Methods, and what their loops share, are judged whole: each has a descriptor, by which
// tests/glsl/method_gathers_test.cpp and the tests of the effect try it.
bool is_method(const fs::path& file) {
    const std::string name = fs::relative(file, GLOAM_GLSL_DIR).string();
    return name.starts_with("gloam/methods/") || name.starts_with("gloam/gather/");
}

TEST(Catalogue, EveryPublicFunctionOfTheLibraryHasAnEntry) {
    std::set<std::string> known;
    for (const Entry& entry : all_entries(GLOAM_GLSL_DIR)) known.insert(entry.description.function);
    for (const fs::path& file : library_files()) {
        if (is_method(file)) continue;
        for (const std::string& function : functions_of(file)) {
            EXPECT_TRUE(known.contains(function)) << function << " of " << file << " is not in the catalogue";
        }
    }
}

TEST(Catalogue, EveryDescriptionHasAnEntryThatNamesItsFunction) {
    std::map<std::string, Description> described = descriptions(GLOAM_GLSL_DIR);
    for (const Entry& entry : all_entries(GLOAM_GLSL_DIR)) {
        const Description& d = entry.description;
        EXPECT_FALSE(d.title.empty() || d.formula.empty() || d.source.empty()) << d.id;
        EXPECT_TRUE(functions_of(fs::path(GLOAM_GLSL_DIR) / d.file).contains(d.function)) << d.id;
        EXPECT_EQ(described.erase(d.id), 1U) << d.id;
    }
    for (const auto& [id, description] : described)
        ADD_FAILURE() << description.file << ": " << id << " has no entry in the catalogue";
}

// Whether an entry returns a float: what holds for every input is then a statement of its own.
bool returns_floats(const Entry& entry) {
    return std::ranges::count(entry.question.signature.output_scalars(), shader::Scalar::float_) > 0;
}

// Results without a codomain: any number is possible for some input. With the reason.
const std::map<std::string, std::string> any_number{
    {"CS-I-ratio", "a height over a half chord: any float, -infinity for background"},
    {"CS-I-pair", "as far as its caller believes: any float from lowest to highest"},
    {"CS-P-add", "a sum of products of any size"},
};

TEST(Catalogue, EveryResultIsHeldInsideItsCodomain) {
    for (const Entry& entry : all_entries(GLOAM_GLSL_DIR)) {
        if (entry.question.only_rules || !returns_floats(entry)) continue;
        const check::Codomain& codomain = entry.question.codomain;
        const std::string& id = entry.description.id;
        EXPECT_LE(codomain.low, codomain.high) << id;
        const bool bounded = !(std::isinf(codomain.low) && codomain.low < 0.0 && std::isinf(codomain.high));
        EXPECT_EQ(bounded, !any_number.contains(id)) << id << ": needs a codomain, or a reason for none";
    }
}

TEST(Catalogue, GlobsSelectByIdAndFunctionInAnyCase) {
    const Entries entries = all_entries(GLOAM_GLSL_DIR);
    EXPECT_EQ(select(entries, {}).size(), entries.size());
    EXPECT_EQ(select(entries, {"tssao-5"}).size(), 1U);
    EXPECT_EQ(select(entries, {"gloam_blend"}).size(), 1U);
    EXPECT_GT(select(entries, {"TSSAO-*"}).size(), 10U);
    EXPECT_EQ(select(entries, {"tssao-5", "TSSAO-5"}).size(), 1U);
    EXPECT_THAT([&] { (void)select(entries, {"TSSAO-5", "NO-SUCH"}); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr("NO-SUCH")));
}

TEST(Catalogue, Globs) {
    EXPECT_TRUE(matches_glob("HALTON-2D", "halton*"));
    EXPECT_TRUE(matches_glob("HALTON-2D", "*-?d"));
    EXPECT_TRUE(matches_glob("", "*"));
    EXPECT_FALSE(matches_glob("HALTON", "halton-*"));
    EXPECT_FALSE(matches_glob("HALTON", "halto"));
}

}  // namespace catalogue_test
}  // namespace gloam::catalogue
