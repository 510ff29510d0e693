// SPDX-License-Identifier: MIT
// Every include compiles alone, unchanged and packed, in every GLSL version that the library supports.
#include "audit/audit.hpp"
#include "backend/gl/program.hpp"
#include "module/texts.hpp"
#include "support/entries.hpp"
#include "support/lab.hpp"
#include "support/library_files.hpp"

namespace gloam::languages_test {

namespace fs = std::filesystem;

const std::vector<fs::path> roots{GLOAM_GLSL_DIR};

constexpr source::Language languages[] = {source::Language::vulkan450, source::Language::gl430,
                                          source::Language::gl330,     source::Language::es300,
                                          source::Language::es310,     source::Language::es320};

class EveryInclude : public testing::TestWithParam<std::string> {};

TEST_P(EveryInclude, CompilesAlone) {
    const source::Source source{.name = GetParam(), .text = "#include \"" + GetParam() + "\"\n"};
    for (const source::Language language : languages)
        EXPECT_NO_THROW(module::check_compiles(source, language, roots)) << source::to_string(language);
}

TEST_P(EveryInclude, CompilesPacked) {
    for (const source::Language language : languages) {
        const std::string packed =
            module::pack(std::vector{roots.front() / GetParam()}, {.language = language}, roots);
        EXPECT_EQ(packed.find("#include"), std::string::npos) << source::to_string(language);
    }
}

TEST_P(EveryInclude, IsTranslated) {
    const std::string packed = module::pack(std::vector{roots.front() / GetParam()}, {}, roots);
    for (const module::Target target : {module::Target::hlsl, module::Target::msl})
        EXPECT_NO_THROW((void)module::translated({.name = GetParam(), .text = packed}, target));
}

INSTANTIATE_TEST_SUITE_P(Library, EveryInclude, testing::ValuesIn(test::library_files()),
                         test::library_file_name);

// Each compute shader of passes/, as a whole shader; the fragment shaders are for OpenGL alone.
TEST(EveryPass, IsTranslated) {
    std::size_t count = 0;
    for (const auto& file : fs::recursive_directory_iterator(roots.front() / "passes")) {
        const std::vector files{file.path()};
        const bool is_fragment = file.path().extension() == ".frag";
        for (const source::Language language : {source::Language::gl330, source::Language::es300}) {
            const source::PackRequest request{.language = language, .stage = source::Stage::fragment};
            if (!is_fragment) break;
            EXPECT_FALSE(module::pack(files, request, roots).empty());
        }
        if (file.path().extension() != ".comp") continue;
        const std::string packed = module::pack(files, {.stage = source::Stage::compute}, roots);
        for (const module::Target target : {module::Target::hlsl, module::Target::msl}) {
            // SPIRV-Cross writes no gathers of integers in HLSL.
            const bool gathers_integers = packed.find(" usampler2D ") != std::string::npos;
            if (target == module::Target::hlsl && gathers_integers) continue;
            const std::string text =
                module::translated({file.path().string(), packed}, target, source::Stage::compute);
            EXPECT_NE(text.find(target == module::Target::hlsl ? " main(" : " main0("), std::string::npos)
                << file.path();
        }
        ++count;
    }
    EXPECT_GE(count, 26U);
}

class Languages : public testing::TestWithParam<source::Language> {};

TEST_P(Languages, TheWholeLibraryCompilesPackedIntoOne) {
    std::vector<fs::path> files;
    for (const std::string& name : test::library_files()) files.push_back(roots.front() / name);
    EXPECT_NO_THROW((void)module::pack(files, {.language = GetParam()}, roots));
}

INSTANTIATE_TEST_SUITE_P(All, Languages, testing::ValuesIn(languages),
                         [](const auto& info) { return "glsl_" + source::to_string(info.param); });

// Every line and every branch of the library is reached by the inputs of some entry, but for those listed
// here with the reason.

// The file below glsl/, the text of the line, and the way of the branch (empty: the line itself).
using Point = std::tuple<std::string, std::string, std::string>;

constexpr const char* flushed =
    "NaN: only a device that flushes a subnormal contrast beside an infinite occlusion comes here";

constexpr const char* prepared = "a preparation pass calls it for the level or the slice before";

// Lines that the inputs of no entry reach, with the reason; it applies to all ways of the line.
const std::map<std::pair<std::string, std::string>, std::string> unreached{
    {{"gloam/occlusion/hbao.glsl", "return visibility > 0.0 ? visibility : (visibility <= 0.0 ? 0.0 : 1.0);"},
     flushed},
    {{"gloam/methods/mssao.glsl",
      "float mean = count > 0.0 ? (reach.z * own + coarser.count * coarser.mean) / count : 0.0;"},
     prepared},
    {{"gloam/methods/mssao.glsl", "float own = reach.z == 0.0 ? 0.0"}, prepared},
    {{"gloam/methods/mssao.glsl", "float share = level == 0 ? 1.0 : clamp(largest - 1.0, 0.0, 1.0);"},
     prepared},
    {{"gloam/methods/separable.glsl", "one.angle = kernel.angle + (second ? GLOAM_PI : 0.0);"}, prepared}};

std::string below_glsl(const std::string& file) {
    const std::size_t at = file.rfind("glsl/gloam/");
    return at == std::string::npos ? file : file.substr(at + std::string("glsl/").size());
}

TEST(CatalogueCoverage, WhatCanBeReachedIs) {
    const subject::Lab lab({.device = std::string(subject::interpreter_name),
                            .include_roots = {GLOAM_GLSL_DIR},
                            .cache_directory = test::cache_directory()});
    std::map<Point, bool> reached;
    std::map<Point, std::set<std::size_t>> seen_by;  // the numbers of entries
    const auto measure = [&](std::size_t number, const judge::RunOptions& options) {
        const catalogue::Entry& entry = test::entries()[number];
        const judge::Coverage coverage = audit::measure_coverage(lab, entry.question, options);
        EXPECT_FALSE(coverage.points.empty()) << entry.description.id;
        for (const judge::Coverage::Point& point : coverage.points) {
            const Point key{below_glsl(point.file), point.text, point.way};
            reached[key] = reached[key] || point.reached;
            seen_by[key].insert(number);
        }
    };
    // A few inputs reach nearly all; where they leave something, more follow, at last all.
    std::set<std::size_t> left;
    for (std::size_t i = 0; i < test::entries().size(); ++i) left.insert(i);
    for (const std::size_t inputs : {std::size_t{512}, std::size_t{8'192}, judge::RunOptions{}.inputs}) {
        for (const std::size_t i : left) measure(i, {.inputs = inputs});
        left.clear();
        for (const auto& [point, is_reached] : reached)
            if (!is_reached) left.insert(seen_by[point].begin(), seen_by[point].end());
    }
    EXPECT_GT(reached.size(), 2000U);
    std::set<std::pair<std::string, std::string>> excused;
    for (const auto& [point, is_reached] : reached) {
        if (is_reached) continue;
        const auto& [file, text, way] = point;
        const bool listed = unreached.contains({file, text});
        if (listed) excused.insert({file, text});
        EXPECT_TRUE(listed) << file << ": " << text << " is never " << (way.empty() ? "reached" : way)
                            << ", not by " << test::entries()[*seen_by[point].begin()].description.id
                            << " either";
    }
    for (const auto& [line, reason] : unreached)
        EXPECT_TRUE(excused.contains(line)) << line.first << ": " << line.second << " is reached";
}

// Every include on a device of OpenGL ES, as an engine has it: the whole file, packed for the version. Mesa
// links also what main() does not call.
TEST(OpenGlIncludes, EachCompiles) {
    std::optional<backend::gl::Device> device;
    try {
        device.emplace("es:llvmpipe-3.0");
    } catch (const backend::gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    for (const std::string& file : test::library_files()) {
        const std::string text =
            module::pack(std::vector{roots.front() / file}, {.language = source::Language::es300}, roots);
        const backend::gl::ShaderText shader{file, text + "\nvoid main() {}\n"};
        try {
            const backend::gl::Program program(*device, backend::gl::Program::Stage::fragment, shader);
        } catch (const backend::Error& error) {  // of the prototypes, which an engine defines
            EXPECT_THAT(error.what(), HasSubstr("unresolved reference to function")) << file;
        }
    }
}

// Every equation of the catalogue on the device, over its whole domain.

constexpr std::size_t inputs_per_equation = 65'536;
constexpr std::size_t strict_inputs = 512;
constexpr double most_slack = 4.0;

// A quotient may have an error of 2.5 ULP. Software drivers have half an ULP, GPUs up to 2.4
// (docs/drivers.md), so less would be no promise.
bool is_tightest(const judge::Budget& budget) {
    return budget.ulp <= 2.5 && budget.absolute <= 0x1p-126;
}

class Sweep : public testing::TestWithParam<std::size_t> {
  protected:
    // Of a built-in function the rules may permit every result: determinant(), for example.
    void expect_ok(const judge::Answer& result) const {
        const bool is_ours = entry_.description.file.starts_with("gloam/");
        EXPECT_TRUE(is_ours ? result.passed() : !result.failed()) << entry_.description.id << ": " << result;
    }
    // The largest share of the budget that a driver at hand takes; not beyond what is enough.
    [[nodiscard]] double largest_fraction(double worst) const {
        if (worst * most_slack >= 1.0) return worst;
        for (const backend::DeviceInfo& info : backend::vulkan::list_devices()) {
            const subject::Lab lab({.device = std::to_string(info.index),
                                    .validation = true,
                                    .include_roots = roots,
                                    .cache_directory = test::cache_directory()});
            worst =
                std::max(worst, judge::run(lab, entry_.question, {.inputs = inputs_per_equation}).fraction);
        }
        return worst;
    }
    const catalogue::Entry& entry_ = test::entries()[GetParam()];
};

// A documented accuracy is also what the function really achieves: no driver at hand may leave more than
// three quarters of a budget unused.
TEST_P(Sweep, StaysWithinItsBudget) {
    const subject::Lab lab = test::make_lab();
    const judge::Answer result = judge::run(lab, entry_.question, {.inputs = inputs_per_equation});
    expect_ok(result);
    EXPECT_EQ(result.inputs(), inputs_per_equation);
    const judge::Budget& budget = entry_.question.budget;
    if (entry_.question.only_rules || is_tightest(budget)) return;
    const double worst = largest_fraction(result.fraction);
    EXPECT_GE(worst * most_slack, 1.0)
        << "documents " << judge::to_text(budget) << ", of which " << worst << " is used at most";
}

// Each operation rounded on its own: the narrowest bounds of Vulkan's rules, which budgets may hide errors
// inside.
TEST_P(Sweep, IsPermittedWhenStrict) {
    const subject::Lab lab = test::make_lab({}, module::variant("strict"));
    const judge::Answer result = judge::run(lab, entry_.question, {.inputs = strict_inputs});
    expect_ok(result);
    EXPECT_EQ(result.criterion, judge::Criterion::rules);
    EXPECT_EQ(result.by_rules, strict_inputs);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Sweep, test::entry_numbers(), test::entry_name);

}  // namespace gloam::languages_test
