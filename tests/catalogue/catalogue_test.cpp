// SPDX-License-Identifier: MIT
#include "catalogue/catalogue.hpp"
#include "catalogue/description.hpp"
#include "catalogue/printed.hpp"
#include "module/compile.hpp"
#include "support/entries.hpp"
#include "support/files.hpp"
#include "support/lab.hpp"
#include "support/library_files.hpp"

#include <regex>

namespace gloam::catalogue::catalogue_test {

// Functions that a file of the library defines itself, not through its includes: their names stand in its own
// text before a brace.
std::set<std::string> functions_of(const std::string& file) {
    const std::string own = module::read_text(std::filesystem::path(GLOAM_GLSL_DIR) / file);
    std::set<std::string> names;
    for (const module::Function& f :
         module::functions({.name = file, .text = "#version 450\n#include \"" + file + "\"\n"},
                           {.include_roots = {GLOAM_GLSL_DIR}})) {
        if (f.defined && own.find(" " + f.name + "(") != std::string::npos) names.insert(f.name);
    }
    return names;
}

// But for the parts of methods, which the methods' own entries judge.
TEST(Catalogue, EveryPublicFunctionOfTheLibraryHasAnEntry) {
    std::set<std::string> known;
    for (const Entry& entry : all_entries(GLOAM_GLSL_DIR)) known.insert(entry.description.function);
    for (const std::string& file : test::library_files()) {
        if (file.starts_with("gloam/methods/") || file.starts_with("gloam/gather/")) continue;
        for (const std::string& function : functions_of(file))
            EXPECT_TRUE(known.contains(function)) << function << " of " << file << " is not in the catalogue";
    }
}

TEST(Catalogue, EveryDescriptionHasAnEntryThatNamesItsFunction) {
    std::map<std::string, Description> described = descriptions(GLOAM_GLSL_DIR);
    for (const Entry& entry : all_entries(GLOAM_GLSL_DIR)) {
        const Description& d = entry.description;
        EXPECT_FALSE(d.title.empty() || d.formula.empty() || d.source.empty()) << d.id;
        EXPECT_TRUE(functions_of(d.file).contains(d.function)) << d.id;
        EXPECT_EQ(described.erase(d.id), 1U) << d.id;
    }
    for (const auto& [id, description] : described)
        ADD_FAILURE() << description.file << ": " << id << " has no entry in the catalogue";
}

// But for errors of something (1e-6 of the distances), which the check's inputs make numbers.
TEST(Catalogue, AnErrorInACommentIsTheOneThatIsChecked) {
    const std::regex error(
        R"(Error: (?:at most )?(\d[\d.]*(?:e-\d+)?)( ulp| ULP)?(?: in each component)?[.,;](?: |$))");
    int compared = 0;
    for (const Entry& entry : all_entries(GLOAM_GLSL_DIR)) {
        const Description& d = entry.description;
        const std::string text = std::regex_replace(
            module::read_text(std::filesystem::path(GLOAM_GLSL_DIR) / d.file), std::regex("\n// "), " ");
        const std::size_t begin = text.find("(" + d.id + "): ");
        const std::string comment = text.substr(begin, text.find('\n', begin) - begin);
        std::smatch found;
        if (!std::regex_search(comment, found, error)) continue;
        const auto& [ulp, absolute, backward, largest] = entry.question.budget;
        EXPECT_EQ(std::stod(found[1]), found[2].matched ? ulp : absolute) << d.id;
        ++compared;
    }
    EXPECT_GT(compared, 100);
}

// Whether an entry returns a float: what holds for every input is then a statement of its own.
bool returns_floats(const Entry& entry) {
    return std::ranges::count(entry.question.signature.output_scalars(), module::Scalar::float_) > 0;
}

// Results without a codomain: any number is possible for some input. With the reason.
const std::map<std::string, std::string> any_number{
    {"CS-I-ratio", "a height over a half chord: any float, -infinity for background"},
    {"CS-I-pair", "as far as its caller believes: any float from lowest to highest"},
    {"FRAME-axes", "axes over a projection of the normal that may be short"},
    {"FRAME-before", "places outside the image, for cameras that its caller gives"},
    {"FRAME-behind", "its polynomial has no limit beyond the angles that its caller gives"},
    {"FRAME-end", "amounts and rises of the features that its caller gives"},
    {"FRAME-pair", "places and heights of any size"},
    {"FRAME-tap", "rises and places of any size"},
};

TEST(Catalogue, EveryResultIsHeldInsideItsCodomain) {
    for (const Entry& entry : all_entries(GLOAM_GLSL_DIR)) {
        if (entry.question.only_rules || !returns_floats(entry)) continue;
        const judge::Codomain& codomain = entry.question.codomain;
        const std::string& id = entry.description.id;
        EXPECT_LE(codomain.low, codomain.high) << id;
        const bool bounded = !(std::isinf(codomain.low) && codomain.low < 0.0 && std::isinf(codomain.high));
        EXPECT_EQ(bounded, !any_number.contains(id)) << id << ": needs a codomain, or a reason for none";
    }
}

// The functions that a name finds, in their order.
std::vector<std::string> found_by(const std::string& name) {
    std::vector<std::string> functions;
    for (const Entry& entry : select(test::entries(), {name}))
        functions.push_back(entry.description.function);
    return functions;
}

TEST(Catalogue, NumbersOfPapersLeadToFunctions) {
    const std::pair<const char*, const char*> rows[] = {{"TSSAO-1", "gloam_sample_cosine"},
                                                        {"TSSAO-4", "gloam_estimator_mean"},
                                                        {"TSSAO-5", "gloam_blend"},
                                                        {"TSSAO-14", "gloam_hemisphere_cosine"},
                                                        {"CGF-4", "gloam_previous_clip_static"},
                                                        {"Mattausch (6)", "gloam_blend"},
                                                        {"TSSAO eq. 12", "gloam_contribution_fox_compton"},
                                                        {"issao-7", "gloam_bilateral_filter"},
                                                        {"Qiu 6", "gloam_contribution_issao"},
                                                        {"CS-2.1", "gloam_ambient_light"},
                                                        {"CS-2.4", "gloam_sample_cosine"},
                                                        {"cs 3.1", "gloam_contribution_crytek"},
                                                        {"eq 3.4", "gloam_hbao_step"},
                                                        {"study 3.5", "gloam_line_occlusion"},
                                                        {"CS-3.7", "gloam_falloff_alchemy"},
                                                        {"Aalund 3.10", "gloam_contribution_alchemy"},
                                                        {"section 3.2.12", "gloam_bent_add"},
                                                        {"figure 2 of ISSAO", "gloam_issao_attenuation"},
                                                        {"guard band", "gloam_guard_band_border"},
                                                        {"headed", "gloam_volumetric"},  // a part of a phrase
                                                        {"hemisphere", "gloam_hemisphere"},
                                                        {"*Gears*", "gloam_radius_cap"}};
    for (const auto& [name, function] : rows) EXPECT_EQ(found_by(name).front(), function) << name;
    EXPECT_GT(found_by("CS-3.*").size(), 8U);
    for (const char* none : {"TSSAO-15", "CS-3.11", "CS-3", "ISSAO-0"})
        EXPECT_THROW((void)found_by(none), std::invalid_argument) << none;
}

TEST(Catalogue, ANameOfSeveralRowsOrOfNoFunctionIsSaidToBeThat) {
    for (const auto& [name, rows] : {std::pair("eq 6", 2U), std::pair("table 1", 2U), std::pair("4.2", 2U)}) {
        const Found found = find(test::entries(), {name});
        EXPECT_EQ(found.several, name);
        EXPECT_GE(found.rows.size(), rows) << name;
        EXPECT_THAT(found.entries, testing::IsEmpty()) << name;
    }
    for (const char* name : {"k_1", "results", "table 4", "Mattausch 8", "prefixes tc, ec, wc, cc, ndc, sc"})
        EXPECT_EQ(find(test::entries(), {"TSSAO-5", name}).lacking, name);
}

TEST(Catalogue, EveryPlaceAndPhraseOfARowLeadsToIt) {
    for (const PrintedRow& row : printed_rows()) {
        std::vector<std::string> names = row.places;
        names.insert(names.end(), row.phrases.begin(), row.phrases.end());
        for (const std::string& name : names)
            EXPECT_THAT(rows_named(name), testing::Contains(testing::Field(&PrintedRow::says, row.says)))
                << name;
    }
}

// A shader library of one file, in a folder of its own.
class Library {
  public:
    explicit Library(const std::string& text) {
        std::filesystem::create_directories(folder_.path() / "builtin");
        folder_.write("gloam/numeric/a.glsl", text);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

  private:
    test::TemporaryDirectory folder_;
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

}  // namespace gloam::catalogue::catalogue_test
