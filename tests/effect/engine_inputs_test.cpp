// SPDX-License-Identifier: MIT
// Depth and normals as engines store them. Output formats: the error that they add.
#include <glm/gtc/matrix_transform.hpp>

#include "backend/vulkan/commands.hpp"
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::engine_inputs_test {

constexpr backend::Extent extent{83, 47};

using EngineInputs = OnDevice<testing::TestWithParam<Engine>>;

// A sequence of an engine's frames, whose history follows, is that of what they stand for, as files are read.
TEST_P(EngineInputs, GiveTheFramesOfWhatTheyStandFor) {
    std::vector<scene::GBuffer> stored;
    for (const int frame : {20, 21, 22}) {
        scene::GBuffer& view = stored.emplace_back(drawn(seen_by(GetParam()), extent, {.frame = frame}));
        view.depth[5] = infinity;
        // A world in which normals point to all sides.
        view.camera.view = view.camera.view * glm::rotate(glm::mat4(1.0F), 3.0F, glm::vec3(2, 1, -2));
        store(GetParam(), view);
    }
    std::vector<scene::GBuffer> linear = stored;
    for (scene::GBuffer& view : linear) {
        for (std::size_t i = 0; i < view.depth.size(); ++i) {
            const scene::Encoding& encoding = view.stored->encoding;
            view.depth[i] = scene::linear_depth(view.stored->depth[i], encoding, view.camera);
            view.normal[i] = scene::view_normal(view.stored->normal[i], encoding, view.camera);
        }
        view.stored.reset();
    }
    const Settings settings = with_radius(with_method({}, "gtao"), 0.5F);
    const Frame shown = run(stored, settings).back();
    const Frame wanted = run(linear, settings).back();
    EXPECT_LT(errors_of(shown.filtered, wanted.filtered).rmse, 5e-4);
    EXPECT_LT(errors_of(shown.kept, wanted.kept).mean, 0.1);
    EXPECT_GT(mean_of(shown.kept), 0.8 * 2 * settings.samples);
    EXPECT_GT(std::ranges::max(shown.filtered), 0.1F);
}

// Those that store depth in floats, in front of the eye.
std::vector<Engine> engines_with_floats() {
    std::vector<Engine> chosen;
    std::ranges::copy_if(engines, std::back_inserter(chosen), [](const Engine& engine) {
        return engine.depth_bits == 32 && engine.before_near == 0.0;
    });
    return chosen;
}

INSTANTIATE_TEST_SUITE_P(Of, EngineInputs, testing::ValuesIn(engines_with_floats()));

class OutputFormats : public OnDevice<testing::Test> {};

// Filtered and not, with a history and without, over two frames; what is displayed alone differs. A store to
// a half may be rounded towards zero.
TEST_F(OutputFormats, AddNoMoreThanTheirRounding) {
    const scene::GBuffer view = drawn("room", extent, {});
    // No share of 7 samples is exact in binary; the frame's history of 10 bits would round what differs in
    // the last bit.
    for (const char* changes : {"radius=0.3", "radius=0.3 filter=none samples=7 samples_converged=7",
                                "radius=0.3 filter=none samples=7 samples_converged=7 history=off",
                                "preset=quality radius=0.3 history=off"}) {
        const Settings settings = with({}, changes);
        const Frame full = run(view, with(settings, "output=r32f"), 2);
        for (const char* output : {"r16f", "r8"}) {
            const Frame shown = run(view, with(settings, std::string("output=") + output), 2);
            EXPECT_EQ(shown.convergence, full.convergence);
            double worst = 0.0;
            for (std::size_t i = 0; i < full.filtered.size(); ++i) {
                const double value = double{full.filtered[i]};
                const double most =
                    output == std::string("r8") ? 0.5 / 255.0 + 1e-6 : value * 0x1p-10 + 0x1p-23;
                const double error = std::abs(double{shown.filtered[i]} - value);
                EXPECT_LE(error, most) << value;
                worst = std::max(worst, error / most);
            }
            EXPECT_GT(worst, 0.2) << changes << ": fewer bits are seen; largest "
                                  << *std::ranges::max_element(full.filtered);
        }
    }
}

// Images that passes only read, as sampled images and as storage images: the same results.

class InputImages : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] std::vector<Frame> results(const Settings& settings, scene::Inputs inputs) const {
        scene::PassLibrary passes = passes_;
        passes.inputs = inputs;
        constexpr backend::Extent size{75, 43};
        AmbientOcclusion effect(device_, passes);
        effect.watch([&](const Step& pass, bool) {
            const auto& kinds = pass.pipeline->bindings();
            EXPECT_EQ(std::ranges::count(kinds, backend::vulkan::BindingKind::sampled_image) > 0,
                      inputs == scene::Inputs::sampled)
                << pass.name;
        });
        std::vector<Frame> all;
        for (int frame = 0; frame < 3; ++frame) {
            scene::GBuffer view = drawn("moving", size, {.frame = frame, .motion = true, .layers = 2});
            if (frame > 0) view.normal.clear();
            all.empty() ? effect.begin(view, settings) : effect.advance(view);
            all.push_back(effect.next());
        }
        return all;
    }
};

TEST_F(InputImages, SampledAndStorageImagesGiveTheSameBits) {
    for (const char* changes :
         {"filter=convergence layers=2", "method=gtao filter=geometry", "method=mssao filter=bilateral"}) {
        const Settings settings = with(Settings{}, std::string(changes) + " radius=0.5 remap_c=1.5");
        expect_same_images(results(settings, scene::Inputs::sampled),
                           results(settings, scene::Inputs::storage));
    }
}

}  // namespace gloam::effect::engine_inputs_test
