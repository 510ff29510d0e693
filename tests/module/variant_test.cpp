// SPDX-License-Identifier: MIT
#include "module/include.hpp"
#include "module/internal/front_end.hpp"
#include "module/support.hpp"
#include "source/declarations.hpp"
#include "support/library_files.hpp"

namespace gloam::module::variant_test {

TEST(Variants, HaveTheirNamesInOrder) {
    std::vector<std::string> names;
    for (const Variant& known : variants()) {
        names.push_back(known.name);
        EXPECT_FALSE(known.description.empty()) << known.name;
        EXPECT_EQ(variant(known.name).description, known.description);
    }
    EXPECT_THAT(names, ElementsAre("shipped", "strict", "optimized", "small", "relaxed", "literals",
                                   "specialization"));
}

TEST(Variants, AnUnknownNameListsThoseThereAre) {
    EXPECT_THAT(message_of<std::invalid_argument>([] { (void)variant("fast"); }),
                AllOf(HasSubstr("\"fast\""), HasSubstr("shipped, strict, "), HasSubstr("specialization")));
}

Spirv module_of(const std::string& name) {
    const source::Source source = kernel("float f(float x) { return x * x + x; }",
                                         "f(result[1]) - uintBitsToFloat(1u + uint(result[2]))");
    return compile(source, {.variant = variant(name)});
}

std::size_t decorated(const std::string& name, const std::string& decoration) {
    return Disassembly(module_of(name)).decorated(decoration).size();
}

TEST(Variants, EachMakesAModuleOfItsOwn) {
    EXPECT_EQ(decorated("shipped", "NoContraction"), 0u);
    EXPECT_EQ(decorated("strict", "NoContraction"), 3u);
    EXPECT_EQ(decorated("strict", "RelaxedPrecision"), 0u);
    EXPECT_EQ(decorated("relaxed", "NoContraction"), 3u);
    EXPECT_GT(decorated("relaxed", "RelaxedPrecision"), 5u);
    EXPECT_LT(module_of("optimized").size(), module_of("shipped").size());
    EXPECT_LT(module_of("small").size(), module_of("shipped").size());
    EXPECT_EQ(module_of("specialization"), module_of("shipped"));
    EXPECT_EQ(module_of("literals"), module_of("optimized"));
}

constexpr source::Language all[] = {
    source::Language::vulkan450, source::Language::gl430, source::Language::gl330, source::Language::gl150,
    source::Language::es300,     source::Language::es310, source::Language::es320};

std::string error_of(const std::string& body, source::Language language) {
    return message_of<source::CompileError>([&] { check_compiles({"body", body}, language, {fixtures()}); });
}

// The languages that accept the body.
std::string accepted_by(const std::string& body) {
    std::string names;
    for (const source::Language language : all)
        if (error_of(body, language).empty()) names += to_string(language) + " ";
    return names;
}

TEST(Language, IncludesAndUndefinedPrototypesCompileEverywhere) {
    for (const char* name : {"math/hypot.glsl", "math/neighbour.glsl", "fetch.glsl"})
        EXPECT_EQ(accepted_by("#include \"" + std::string(name) + "\"\n"),
                  "450 430 330 150 300es 310es 320es ")
            << name;
}

TEST(Language, AcceptsABodyThatIsWrittenForIt) {
    const std::vector<std::array<const char*, 3>> bodies{
        {"an empty body compiles", "", "450 430 330 150 300es 310es 320es "},
        {"a body may end in a comment", "float f(float x) { return x; } // no newline",
         "450 430 330 150 300es 310es 320es "},
        {"implicit conversion is not for es", "float f(float x) { return x * 2; }", "450 430 330 150 "},
        {"bitfield functions are newer", "uint f(uint x) { return bitfieldReverse(x); }",
         "450 430 310es 320es "},
        {"doubles are for desktop", "double f(double x) { return x; }", "450 430 "},
        {"vulkan alone refuses free uniforms", "uniform float x;\nfloat f() { return x; }",
         "430 330 150 300es 310es 320es "},
        {"recursion compiles nowhere", "float f(float x) { return f(x); }", ""}};
    for (const auto& [about, text, languages] : bodies) EXPECT_EQ(accepted_by(text), languages) << about;
}

TEST(Language, ErrorsNameTheLineOfTheBodyOrTheInclude) {
    const std::string inner = fixture("broken/inner.glsl").string() + ":5: ";
    for (const source::Language language : all) {
        EXPECT_THAT(error_of("\nfloat f() {\n    return oops;\n}\n", language), StartsWith("body:3: 'oops'"))
            << to_string(language);
        EXPECT_THAT(error_of("#include \"broken/outer.glsl\"\n", language), StartsWith(inner))
            << to_string(language);
    }
    EXPECT_THAT(error_of("#include \"none.glsl\"\n", source::Language::es300),
                StartsWith("body:1: cannot find include"));
}

}  // namespace gloam::module::variant_test
