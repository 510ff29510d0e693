// SPDX-License-Identifier: MIT
// The plan is what the effect does: the same passes in the same order, over images of the same size.
#include "effect/plan.hpp"

#include <fmt/format.h>

#include "effect/methods.hpp"
#include "on_device.hpp"

namespace gloam::effect::plan_test {

using shader::LaidOut;

class PlanTest : public OnDevice<testing::Test> {};

std::vector<std::string> names_of(const std::vector<PassTime>& times) {
    std::vector<std::string> names;
    for (const PassTime& time : times) names.push_back(time.pass);
    return names;
}

TEST_F(PlanTest, IsWhatAFrameRuns) {
    const gpu::Extent extent{33, 17};
    const scene::GBuffer first = drawn("room", extent, {.frame = 0});
    const scene::GBuffer second = drawn("room", extent, {.frame = 1});
    for (const char* method : {"hemisphere", "mssao", "dual_resolution", "sao_chain", "separable"}) {
        for (const bool history : {true, false}) {
            Settings settings = with_method(preset_named("tssao-paper").settings, method);
            settings.history = history;
            settings.remap_b = 2.0F;
            AmbientOcclusion& effect = effect_for(extent);
            effect.begin(first, settings);
            (void)effect.next(1);
            effect.advance(second);
            std::vector<std::string> ran = names_of(effect.next(1).times);
            std::erase(
                ran, "remap");  // of the unfiltered occlusion, which nobody is shown where there is a filter
            std::vector<std::string> planned;
            for (const PlannedPass& pass : plan_of(settings, {.view = extent}, passes_).passes)
                planned.push_back(pass.name);
            std::erase(planned, "remap");
            EXPECT_EQ(planned, ran) << method << " " << history;
        }
    }
}

TEST_F(PlanTest, RefusesWhatSettingsRefuse) {
    Settings settings;
    settings.samples = 0;
    EXPECT_THROW((void)plan_of(settings, {}, passes_), std::invalid_argument);
}

// What C++ and shaders share is found by its name.
class Layouts : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] shader::ModuleInterface interface_of(const PassSource& source) const {
        return shader::reflect(passes_.compile(source.file, source.defines, source.replaced));
    }

    [[nodiscard]] std::vector<LaidOut> buffer_of(const PassSource& source, const std::string& block) const {
        for (const shader::Binding& binding : interface_of(source).bindings)
            if (binding.block && binding.block->name == block) return binding.block->members;
        ADD_FAILURE() << source.file << " has no buffer " << block;
        return {};
    }
};

TEST_F(Layouts, NumbersAreThoseOfTheirNames) {
    const shader::ModuleInterface pass = interface_of({.file = "study/reproject.comp"});
    Settings settings;
    settings.depth_tolerance = 0.125F;
    settings.taps = HistoryTaps::bilinear;
    Values values = values_of({scene::make_frame({}, 1.0), {7, 5}, {}}, settings);
    const std::vector<std::byte> bytes = values.push_constants(pass, "");
    const auto word = [&](const char* name, std::size_t place) {
        const auto at = std::ranges::find(pass.push_constants->members, name, &LaidOut::name)->offset;
        std::uint32_t bits = 0;
        std::memcpy(&bits, &bytes.at(at + 4 * place), sizeof bits);
        return bits;
    };
    EXPECT_EQ(word("size", 1), 5U);
    EXPECT_EQ(word("depth_tolerance", 0), std::bit_cast<std::uint32_t>(0.125F));
    for (const std::size_t i : {0, 5, 10, 15})
        EXPECT_EQ(word("previous_from_current", i), std::bit_cast<std::uint32_t>(1.0F)) << i;
    for (const gpu::SpecializationConstant& constant : values.constants(pass, ""))
        if (constant.id == 1) {
            EXPECT_EQ(constant.bits, 1U) << "taps";
        }
    values.set("depth_tolerance", glm::vec2(1.0F));
    EXPECT_THROW((void)values.push_constants(pass, ""), std::logic_error);
    EXPECT_THROW((void)Values().constants(pass, ""), std::logic_error);
}

TEST_F(Layouts, Buffers) {
    const std::vector<LaidOut> method = buffer_of(occlusion_source({}), "MethodSettings");
    ASSERT_EQ(method.size(), 1U);
    EXPECT_EQ(method[0].size, sizeof(MethodValues));
    std::vector<std::string> members;
    for (const LaidOut& member : method[0].members)
        members.push_back(fmt::format("{} {} at {}", member.type, member.name, member.offset));
    std::vector<std::string> ours;
#define CHOICE(...)
#define FLAG(...)
#define METHOD(...)
#define NUMBER(...)
#define OWN(type, name, ...)                                                   \
    ours.push_back(fmt::format("{} {} at {}",                                  \
                               std::is_same_v<type, float>           ? "float" \
                               : std::is_same_v<type, std::uint32_t> ? "uint"  \
                                                                     : "int",  \
                               #name, offsetof(MethodValues, name)));
#include "effect/setting_list.inc"
    EXPECT_EQ(members, ours);
}

// Engines have sampled images, and OpenGL ES 3.1 lets no pass read an image of four channels that it writes.
TEST_F(Layouts, NoImageIsReadAndWritten) {
    std::set<std::string> seen;
    for (const char* method :
         {"dual_resolution", "sao_chain", "separable", "mssao", "volumetric_area", "disc_proxy_two"}) {
        Settings settings = with_method({}, method);
        settings.remap_b = 2.0F;
        if (reads(method_named(method), "layers")) settings.own.layers = 2;
        const PlanOptions options{.moving_objects = true, .normals = false};
        for (const PlannedPass& pass : plan_of(settings, options, passes_).passes) {
            for (const shader::Binding& binding : interface_of(pass.source).bindings) {
                const bool stored = binding.type == shader::BindingType::storage_image;
                EXPECT_TRUE(!stored || (binding.writes && !binding.reads))
                    << pass.source.file << " " << binding.name;
            }
            seen.insert(pass.source.file);
        }
    }
    EXPECT_EQ(seen.size(), 12U);
}

}  // namespace gloam::effect::plan_test
