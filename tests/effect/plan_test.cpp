// SPDX-License-Identifier: MIT
// The plan is what the effect does: the same passes in the same order, over images of the same size.
#include "effect/plan.hpp"

#include "effect/methods.hpp"
#include "on_device.hpp"

namespace gloam::effect::plan_test {

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

// Engines have sampled images, and OpenGL ES 3.1 lets no pass read an image of four channels that it writes.
TEST_F(PlanTest, NoImageIsReadAndWritten) {
    std::set<std::string> seen;
    for (const char* method :
         {"dual_resolution", "sao_chain", "separable", "mssao", "volumetric_area", "disc_proxy_two"}) {
        Settings settings = with_method({}, method);
        settings.remap_b = 2.0F;
        if (reads(method_named(method), "layers")) settings.own.layers = 2;
        const PlanOptions options{.moving_objects = true, .normals = false};
        for (const PlannedPass& pass : plan_of(settings, options, passes_).passes) {
            const PassSource& source = pass.source;
            for (const shader::Binding& binding :
                 shader::reflect(passes_.compile(source.file, source.defines, source.replaced)).bindings) {
                const bool stored = binding.type == shader::BindingType::storage_image;
                EXPECT_TRUE(!stored || (binding.writes && !binding.reads))
                    << source.file << " " << binding.name;
            }
            seen.insert(source.file);
        }
    }
    EXPECT_EQ(seen.size(), 12U);
}

}  // namespace gloam::effect::plan_test
