// SPDX-License-Identifier: MIT
#include "shader/reflection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gloam::shader {
namespace reflection_test {

using testing::ElementsAre;

ModuleInterface interface_of(const std::string& text) {
    return reflect(compile({.name = "text", .text = "#version 450\n" + text}, {}));
}

TEST(Reflection, ImagesSayHowTheyAreUsed) {
    const ModuleInterface all = interface_of(R"(
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 2, rgba16ui) uniform readonly uimage2D read;
layout(binding = 0, r32f) uniform writeonly image2D written;
layout(set = 1, binding = 1, rgba32f) uniform image2D both;
layout(binding = 3) uniform sampler2D sampled;
layout(binding = 4) uniform usampler2D sampled_integers;
void main() {
    imageStore(written, ivec2(0), vec4(imageLoad(read, ivec2(0))) + texelFetch(sampled, ivec2(0), 0) +
                                      vec4(texelFetch(sampled_integers, ivec2(0), 0)));
    imageStore(both, ivec2(0), imageLoad(both, ivec2(1)));
})");
    ASSERT_EQ(all.bindings.size(), 5U);
    EXPECT_EQ(all.local_size, (std::array<std::uint32_t, 3>{8, 4, 1}));
    const std::vector<std::string> names{"written", "read", "sampled", "sampled_integers", "both"};
    const std::vector<std::string> formats{"r32f", "rgba16ui", "", "", "rgba32f"};
    const std::vector<std::string> texels{"float", "uint", "float", "uint", "float"};
    const std::vector<std::pair<bool, bool>> access{
        {false, true}, {true, false}, {true, false}, {true, false}, {true, true}};
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(all.bindings[i].name, names[i]);
        EXPECT_EQ(all.bindings[i].format, formats[i]);
        EXPECT_EQ(all.bindings[i].texel, texels[i]) << names[i];
        EXPECT_EQ(std::pair(all.bindings[i].reads, all.bindings[i].writes), access[i]) << names[i];
    }
    EXPECT_EQ(all.bindings[2].type, BindingType::sampled_image);
    EXPECT_EQ(all.bindings[4].set, 1U);
    EXPECT_FALSE(all.push_constants);
}

TEST(Reflection, BlocksSayWhereTheirMembersLie) {
    const ModuleInterface all = interface_of(R"(
struct Inner { vec2 a; uint b; };
layout(binding = 4, std430) readonly buffer Values { float first; Inner inner[3]; vec4 rest[]; } values;
layout(push_constant) uniform Parameters { mat4 m; vec2 v; ivec2 size; float f; } parameters;
layout(binding = 5, std430) buffer Out { vec4 result; };
void main() {
    result = parameters.m * vec4(parameters.v, parameters.size) * parameters.f +
             values.rest[0] * values.inner[1].a.x + values.first;
})");
    ASSERT_TRUE(all.push_constants);
    const std::vector<LaidOut>& members = all.push_constants->members;
    ASSERT_EQ(members.size(), 4U);
    EXPECT_EQ(members[0].columns, 4U);
    EXPECT_EQ(members[0].size, 64U);
    EXPECT_EQ(members[1].offset, 64U);
    EXPECT_EQ(members[2].type, "int");
    EXPECT_EQ(members[2].size, 8U);
    EXPECT_EQ(members[3].offset, 80U);
    EXPECT_EQ(all.push_constants->size, 84U);
    ASSERT_EQ(all.bindings.size(), 2U);
    ASSERT_TRUE(all.bindings[0].block);
    EXPECT_EQ(all.bindings[0].block->name, "Values");
    EXPECT_TRUE(all.bindings[0].reads && !all.bindings[0].writes);
    EXPECT_TRUE(all.bindings[1].writes);
    const std::vector<LaidOut>& values = all.bindings[0].block->members;
    EXPECT_EQ(values[1].type, "Inner");
    EXPECT_EQ(values[1].stride, 16U);
    EXPECT_EQ(values[1].size, 48U);
    EXPECT_EQ(values[1].members[1].offset, 8U);
    EXPECT_THAT(values[1].sizes, ElementsAre(3U));
    EXPECT_EQ(values[2].offset, 64U);
    EXPECT_THAT(values[2].sizes, ElementsAre(0U));
}

TEST(Reflection, ConstantsHaveTheValueOfTheText) {
    const ModuleInterface all = interface_of(R"(
layout(constant_id = 9) const float length = -0.0;
layout(constant_id = 2) const bool on = true;
layout(binding = 0) buffer Out { float result; };
void main() { if (on) result = length; })");
    ASSERT_EQ(all.constants.size(), 2U);
    EXPECT_EQ(all.constants[0].name, "on");
    EXPECT_EQ(all.constants[0].type, "bool");
    EXPECT_EQ(all.constants[0].bits, 1U);
    EXPECT_EQ(all.constants[1].id, 9U);
    EXPECT_EQ(all.constants[1].bits, 0x80000000U);
}

TEST(Reflection, NoModuleIsRefused) {
    EXPECT_THROW((void)reflect({1, 2, 3}), std::runtime_error);
}

}  // namespace reflection_test
}  // namespace gloam::shader
