// SPDX-License-Identifier: MIT
// The plan is what the effect does: the same passes in the same order, over images of the same size.
#include "effect/plan.hpp"

#include "effect/methods.hpp"
#include "on_device.hpp"

namespace gloam::effect::plan_test {

class PlanTest : public OnDevice<testing::Test> {};

TEST_F(PlanTest, IsWhatAFrameRuns) {
    const backend::Extent extent{33, 17};
    const std::vector<scene::GBuffer> views{drawn("room", extent), drawn("room", extent, {.frame = 1})};
    for (const char* method : {"hemisphere", "mssao", "dual_resolution", "sao_chain", "separable"}) {
        for (const char* history : {" history=on", " history=off"}) {
            const Settings settings = with({}, "remap_b=2 method=" + (method + std::string(history)));
            std::vector<std::string> ran;
            const Frame frame = run(views, settings).back();
            for (const PassTime& time : frame.times) ran.push_back(time.pass);
            std::vector<std::string> planned;
            for (const PlannedPass& pass : plan_of(settings, {.view = extent}, passes_).passes)
                planned.push_back(pass.name);
            // Of the unfiltered occlusion, too, which nobody is shown where there is a filter.
            std::erase(ran, "remap");
            std::erase(planned, "remap");
            EXPECT_EQ(planned, ran) << method << history;
        }
    }
}

// Engines have sampled images, and OpenGL ES 3.1 lets no pass read an image of four channels that it writes.
TEST_F(PlanTest, NoImageIsReadAndWritten) {
    std::set<std::string> seen;
    for (const char* method :
         {"dual_resolution", "sao_chain", "separable", "mssao", "volumetric_area", "disc_proxy_two"}) {
        Settings settings = with({}, std::string("remap_b=2 method=") + method);
        if (reads(method_named(method), "layers")) settings.own.layers = 2;
        const PlanOptions options{.moving_objects = true, .normals = false};
        for (const PlannedPass& pass : plan_of(settings, options, passes_).passes) {
            const PassSource& source = pass.source;
            for (const module::Binding& binding :
                 module::reflect(passes_.compile(source.file, source.defines, source.replaced)).bindings) {
                const bool stored = binding.type == module::BindingType::storage_image;
                EXPECT_TRUE(!stored || (binding.writes && !binding.reads))
                    << source.file << " " << binding.name;
            }
            seen.insert(source.file);
        }
    }
    EXPECT_EQ(seen.size(), 12U);
}

}  // namespace gloam::effect::plan_test
