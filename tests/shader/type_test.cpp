// SPDX-License-Identifier: MIT
#include "shader/type.hpp"

#include <gtest/gtest.h>

namespace gloam::shader {
namespace type_test {

Type vector(Scalar scalar, int rows) {
    return {.scalar = scalar, .rows = rows};
}
Type matrix(int columns, int rows) {
    return {.scalar = Scalar::float_, .columns = columns, .rows = rows};
}

Type structure(std::string name, std::vector<Member> members) {
    return {.scalar = Scalar::structure, .members = std::move(members), .name = std::move(name)};
}

TEST(Type, ReadsAsGlsl) {
    EXPECT_EQ(to_glsl(Type{}), "void");
    EXPECT_EQ(to_glsl(vector(Scalar::bool_, 1)), "bool");
    EXPECT_EQ(to_glsl(vector(Scalar::float_, 3)), "vec3");
    EXPECT_EQ(to_glsl(vector(Scalar::bool_, 2)), "bvec2");
    EXPECT_EQ(to_glsl(vector(Scalar::int_, 4)), "ivec4");
    EXPECT_EQ(to_glsl(vector(Scalar::uint_, 2)), "uvec2");
    EXPECT_EQ(to_glsl(matrix(3, 3)), "mat3");
    EXPECT_EQ(to_glsl(matrix(4, 3)), "mat4x3");
    EXPECT_EQ(to_glsl(matrix(2, 4)), "mat2x4");
}

TEST(Type, StructureListsItsMembers) {
    const Type inner = structure("Inner", {{"x", vector(Scalar::float_, 1)}});
    const Type outer = structure("Outer", {{"a", inner}, {"m", matrix(2, 3)}});
    EXPECT_EQ(to_glsl(outer), "Outer { Inner a; mat2x3 m; }");
}

TEST(Type, FunctionReadsAsPrototype) {
    const Type light = structure("Light", {{"power", vector(Scalar::float_, 1)}});
    const Function function{"shade",
                            light,
                            {{"uv", vector(Scalar::float_, 2), Direction::in},
                             {"depth", vector(Scalar::float_, 1), Direction::out},
                             {"", vector(Scalar::uint_, 1), Direction::inout}},
                            true};
    EXPECT_EQ(to_glsl(function), "Light shade(vec2 uv, out float depth, inout uint)");
    EXPECT_EQ(to_glsl(Function{"f", {}, {}, false}), "void f()");
}

TEST(Type, EqualityIsOfLayout) {
    const Type a = structure("A", {{"x", vector(Scalar::float_, 2)}});
    const Type other_names = structure("B", {{"y", vector(Scalar::float_, 2)}});
    const Type other_type = structure("A", {{"x", vector(Scalar::int_, 2)}});
    const Type longer = structure("A", {{"x", vector(Scalar::float_, 2)}, {"z", vector(Scalar::float_, 2)}});
    EXPECT_EQ(a, other_names);
    EXPECT_NE(a, other_type);
    EXPECT_NE(a, longer);
    EXPECT_NE(longer, a);
    EXPECT_NE(matrix(3, 4), matrix(4, 3));
    EXPECT_NE(vector(Scalar::float_, 3), vector(Scalar::float_, 4));
}

TEST(Type, UnsupportedComparesByItsText) {
    const Type array{.scalar = Scalar::unsupported, .name = "float[4]"};
    EXPECT_EQ(to_glsl(array), "float[4]");
    EXPECT_EQ(array, (Type{.scalar = Scalar::unsupported, .name = "float[4]"}));
    EXPECT_NE(array, (Type{.scalar = Scalar::unsupported, .name = "float[5]"}));
    EXPECT_FALSE(is_supported(array));
    EXPECT_FALSE(is_supported(structure("S", {{"inner", structure("T", {{"a", array}})}})));
    EXPECT_TRUE(is_supported(structure("S", {{"v", vector(Scalar::float_, 3)}})));
    EXPECT_TRUE(is_supported(Type{}));
}

}  // namespace type_test
}  // namespace gloam::shader
