// SPDX-License-Identifier: MIT
#include "shader/variant.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "disassembly.hpp"
#include "shader/include.hpp"
#include "support.hpp"
#include "support/library_files.hpp"

namespace gloam::shader {
namespace variant_test {

using test::Disassembly;
using test::kernel;
using test::message_of;
using testing::AllOf;
using testing::HasSubstr;

TEST(Variants, HaveTheirNamesInOrder) {
    std::vector<std::string> names;
    for (const Variant& known : variants()) {
        names.push_back(known.name);
        EXPECT_FALSE(known.description.empty()) << known.name;
        EXPECT_EQ(variant(known.name).description, known.description);
    }
    EXPECT_THAT(names, testing::ElementsAre("shipped", "strict", "optimized", "small", "round_trip", "hlsl",
                                            "relaxed", "literals", "specialization"));
}

TEST(Variants, AnUnknownNameListsThoseThereAre) {
    EXPECT_THAT(message_of<std::invalid_argument>([] { (void)variant("fast"); }),
                AllOf(HasSubstr("\"fast\""), HasSubstr("shipped, strict, "), HasSubstr("specialization")));
}

Spirv module_of(const std::string& name) {
    const Source source = kernel("float f(float x) { return x * x + x; }",
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
    EXPECT_EQ(decorated("round_trip", "NoContraction"), 0u);
    EXPECT_LT(module_of("optimized").size(), module_of("shipped").size());
    EXPECT_LT(module_of("small").size(), module_of("shipped").size());
    EXPECT_NE(module_of("round_trip"), module_of("shipped"));
    EXPECT_NE(module_of("hlsl"), module_of("shipped"));
    EXPECT_NE(module_of("hlsl"), module_of("round_trip"));
    EXPECT_EQ(module_of("specialization"), module_of("shipped"));
    EXPECT_EQ(module_of("literals"), module_of("optimized"));
}

TEST(Variants, StepsCombine) {
    const Source source = kernel("float f(float x) { return x * x + x; }", "f(result[1])");
    Variant all = variant("relaxed");
    all.optimization = Optimization::performance;
    all.through = Variant::Through::glsl;
    const Disassembly module(compile(source, {.variant = all}));
    EXPECT_TRUE(module.results("OpFunctionCall").empty());
    EXPECT_EQ(module.decorated("NoContraction").size(), 2u);
    EXPECT_GE(module.decorated("RelaxedPrecision").size(), 3u);
}

std::string type_name(const Type& type) {
    return type.scalar == Scalar::structure ? type.name : to_glsl(type);
}

// "T f(A, B) { T r; return r; }", for a prototype.
std::string body_of(const Function& prototype) {
    const std::string head = to_glsl(prototype);
    if (prototype.result.scalar == Scalar::void_) return head + " {}\n";
    return head + " { " + type_name(prototype.result) + " r; return r; }\n";
}

// A shader that calls every function of a file once; its prototypes get a body.
Source caller_of(const std::string& file) {
    const std::string include = "#include \"" + file + "\"\n";
    const Source probe{"probe of " + file, "#version 450\n" + include};
    std::string bodies;
    std::string calls;
    std::size_t count = 0;
    for (const Function& function : functions(probe, {.include_roots = {GLOAM_GLSL_DIR}})) {
        if (!function.defined) {
            bodies += body_of(function);
            continue;
        }
        std::string arguments;
        for (const Parameter& parameter : function.parameters) {
            const std::string variable = "v" + std::to_string(count++);
            calls += "    " + type_name(parameter.type) + " " + variable + ";\n";
            arguments += (arguments.empty() ? "" : ", ") + variable;
        }
        calls += "    " + function.name + "(" + arguments + ");\n";
    }
    return {"caller of " + file, "#version 450\nlayout(local_size_x = 1) in;\n" + include + bodies +
                                     "void main() {\n" + calls + "}\n"};
}

class EveryFile : public testing::TestWithParam<std::string> {};

// compile() validates: a failure is an exception.
TEST_P(EveryFile, OfTheLibraryCanBeMade) {
    const Source source = caller_of(GetParam());
    for (const char* name : {"strict", "relaxed", "round_trip", "hlsl"}) {
        EXPECT_NO_THROW((void)compile(source, {.include_roots = {GLOAM_GLSL_DIR}, .variant = variant(name)}))
            << name << '\n'
            << source.text;
    }
}

INSTANTIATE_TEST_SUITE_P(Library, EveryFile, testing::ValuesIn(gloam::test::library_files()),
                         gloam::test::library_file_name);

}  // namespace variant_test
}  // namespace gloam::shader
