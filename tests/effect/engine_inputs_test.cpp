// SPDX-License-Identifier: MIT
// Depth and normals as engines store them: what the pass makes of them, and that the rest of the frame is
// that of what it made. Output formats: the error that they add.
#include <glm/gtc/matrix_transform.hpp>

#include "backend/vulkan/commands.hpp"
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::engine_inputs_test {

constexpr gpu::Extent extent{83, 47};

using NormalsFromDepth = OnDevice<testing::Test>;

// Engines that store no normals: the pass gives a plane's pixels its normal.
TEST_F(NormalsFromDepth, OfAPlaneAreItsNormal) {
    for (const bool orthographic : {false, true}) {
        scene::GBuffer view = plane({29, 47}, orthographic, {0.6, -0.3, 1}, 3.0);
        const glm::vec3 expected = view.normal.front();
        view.normal.clear();
        AmbientOcclusion effect(device_, passes_, view.extent);
        std::vector<glm::vec3> written;
        effect.watch([&](const Step& pass, bool after) {
            if (after && pass.name == "normals_from_depth")
                written = vectors_of(image_of(pass, 1).download());
        });
        effect.begin(view, {});
        (void)effect.next();
        ASSERT_EQ(written.size(), view.depth.size());
        for (std::size_t i = 0; i < written.size(); ++i)
            ASSERT_LT(glm::length(written[i] - expected), 1e-4F) << i;
    }
}

class EngineInputs : public OnDevice<testing::TestWithParam<Engine>> {
  protected:
    [[nodiscard]] scene::GBuffer view(int frame = 0) const {
        scene::GBuffer view = drawn(seen_by(GetParam()), extent, {.frame = frame});
        view.depth[5] = infinity;
        // A world in which normals point to all sides.
        view.camera.view = view.camera.view * glm::rotate(glm::mat4(1.0F), 3.0F, glm::vec3(2, 1, -2));
        store(GetParam(), view);
        return view;
    }

    // The frames of a sequence of views; each view becomes what the first pass has made of its depth and
    // normals.
    [[nodiscard]] std::vector<Frame> frames_of(std::vector<scene::GBuffer>& views) const {
        AmbientOcclusion effect(device_, passes_, extent);
        std::vector<Frame> frames;
        effect.watch([&](const Step& pass, bool after) {
            if (!after || pass.name != "take_inputs") return;
            const auto image = [&](std::size_t binding) { return image_of(pass, binding).download(); };
            scene::GBuffer& converted = views[frames.size()];
            converted.depth = image(2);
            converted.normal = vectors_of(image(3));
            converted.stored.reset();
        });
        const std::vector<scene::GBuffer> given = views;
        for (const scene::GBuffer& one : given) {
            if (frames.empty())
                effect.begin(one, with_radius(with_method({}, "gtao"), 0.5F));
            else
                effect.advance(one);
            frames.push_back(effect.next());
        }
        return frames;
    }
};

// As files are read, and as what was stored but for the rounding of its bits.
TEST_P(EngineInputs, AreThePassesInputsWithinWhatTheFormatLoses) {
    const scene::GBuffer stored = view();
    std::vector<scene::GBuffer> views{stored};
    const Frame frame = frames_of(views).front();
    const scene::GBuffer& converted = views.front();
    ASSERT_FALSE(converted.stored.has_value());
    for (std::size_t i = 0; i < stored.depth.size(); ++i) {
        const float depth = stored.depth[i];
        if (!std::isfinite(depth)) {
            EXPECT_EQ(converted.depth[i], depth) << i;
            EXPECT_EQ(converted.normal[i], glm::vec3(0)) << i;
            continue;
        }
        const scene::Encoding& encoding = stored.stored->encoding;
        const float read = scene::linear_depth(stored.stored->depth[i], encoding, stored.camera);
        EXPECT_NEAR(converted.depth[i] / depth, 1.0F, 5e-6F) << i;
        EXPECT_NEAR(converted.depth[i] / read, 1.0F, 5e-6F) << i;
        EXPECT_LT(glm::distance(converted.normal[i], stored.normal[i]),
                  GetParam().normal_bits == 32 ? 5e-7F : 5e-3F)
            << i;
        EXPECT_LT(glm::distance(converted.normal[i],
                                scene::view_normal(stored.stored->normal[i], encoding, stored.camera)),
                  1e-6F)
            << i;
    }
    EXPECT_GT(*std::ranges::max_element(frame.occlusion), 0.2F);
}

// The frames are those of an engine that has depth linear and normals in view space: the history follows
// them.
TEST_P(EngineInputs, OfASequenceGiveTheFramesOfWhatTheyStandFor) {
    std::vector<scene::GBuffer> views{view(20), view(21), view(22)};
    const std::vector<Frame> of_stored = frames_of(views);
    for (const scene::GBuffer& one : views) ASSERT_FALSE(one.stored.has_value());
    const std::vector<Frame> of_linear = frames_of(views);
    for (std::size_t i = 0; i < of_stored.size(); ++i) expect_same_images(of_stored[i], of_linear[i]);
    const auto kept = std::ranges::count_if(of_stored[2].kept, [](float samples) { return samples > 0.0F; });
    EXPECT_GT(kept, static_cast<long>(of_stored[2].kept.size()) * 8 / 10);
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
    const auto frame_in = [&](OutputFormat output, Settings settings) {
        settings.output = output;
        return run(view, settings, 2);
    };
    Settings unfiltered = with_radius({}, 0.3F);
    unfiltered.filter = Filter::none;
    unfiltered.samples = unfiltered.samples_converged = 7;  // no share of them is exact in binary
    Settings alone = unfiltered;
    alone.history = false;
    Settings frame = with_radius(preset_named("quality").settings, 0.3F);
    frame.history = false;  // its 10 bits round what differs in the last bit
    for (const Settings& settings : {with_radius({}, 0.3F), unfiltered, alone, frame}) {
        const Frame full = frame_in(OutputFormat::r32f, settings);
        for (const OutputFormat output : {OutputFormat::r16f, OutputFormat::r8}) {
            const Frame shown = frame_in(output, settings);
            EXPECT_EQ(shown.convergence, full.convergence);
            double worst = 0.0;
            for (std::size_t i = 0; i < full.filtered.size(); ++i) {
                const double value = double{full.filtered[i]};
                const double most =
                    output == OutputFormat::r8 ? 0.5 / 255.0 + 1e-6 : value * 0x1p-10 + 0x1p-23;
                const double error = std::abs(double{shown.filtered[i]} - value);
                EXPECT_LE(error, most) << value;
                worst = std::max(worst, error / most);
            }
            EXPECT_GT(worst, 0.2) << settings.method << (settings.history ? "" : " alone")
                                  << ": fewer bits are seen; largest "
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
        constexpr gpu::Extent size{75, 43};
        AmbientOcclusion effect(device_, passes, size);
        effect.watch([&](const Step& pass, bool) {
            const auto& kinds = pass.pipeline->bindings();
            EXPECT_EQ(std::ranges::count(kinds, gpu::BindingKind::sampled_image) > 0,
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
