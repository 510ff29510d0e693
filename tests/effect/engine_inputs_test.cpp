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

// What rounding to its bits turns a normal by, at most, radians. Each of three numbers is off by half a step
// of 2 / (2^bits - 1). Two octahedral ones move the point of their plane by sqrt(6) half steps, at a distance
// of at least sqrt(1/3).
double most_apart(const Engine& engine, const scene::Encoding& encoding) {
    if (engine.normal_bits == 32) return 5e-7;
    const double half_step = 1.0 / (std::exp2(engine.normal_bits) - 1.0);
    return (encoding.octahedral ? std::sqrt(18.0) : std::sqrt(3.0)) * half_step;
}

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

    // What a stored depth of 24 bits of mantissa loses of a depth, relatively, and four roundings.
    [[nodiscard]] static double depth_loss(double depth, double stored, const scene::CameraFrame& camera) {
        const double half_step = std::abs(stored) * 0x1p-24;
        const double slope = camera.orthographic() ? 1.0 / std::abs(double{camera.proj_vk[2][2]})
                                                   : depth * depth / std::abs(double{camera.proj_vk[3][2]});
        // The sum with p22 rounds as well, at most as much as the larger of its two terms.
        const double sum = std::max(std::abs(stored), std::abs(double{camera.proj_vk[2][2]})) * 0x1p-24;
        return (half_step + sum) * slope / depth + 4 * 0x1p-23;
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

TEST_P(EngineInputs, AreThePassesInputsWithinWhatTheFormatLoses) {
    const scene::GBuffer given = view();
    std::vector<scene::GBuffer> views{given};
    const Frame of_stored = frames_of(views).front();
    const scene::GBuffer& converted = views.front();
    ASSERT_FALSE(converted.stored.has_value());
    double worst = 0.0;
    for (std::size_t i = 0; i < given.depth.size(); ++i) {
        const double depth = double{given.depth[i]};
        if (!std::isfinite(depth)) {
            EXPECT_EQ(converted.depth[i], given.depth[i]) << i;
            EXPECT_EQ(converted.normal[i], glm::vec3(0)) << i;
            continue;
        }
        const double loss = depth_loss(depth, double{given.stored->depth[i]}, given.camera);
        EXPECT_LE(std::abs(double{converted.depth[i]} / depth - 1.0), loss) << i << ": " << depth;
        const double sine =
            glm::length(glm::cross(glm::dvec3(converted.normal[i]), glm::dvec3(given.normal[i])));
        EXPECT_GT(glm::dot(converted.normal[i], given.normal[i]), 0.9F) << i;
        worst = std::max(worst, sine);
        // As files are read.
        const glm::vec3 read =
            scene::view_normal(given.stored->normal[i], given.stored->encoding, given.camera);
        EXPECT_LT(glm::length(converted.normal[i] - read), 1e-6F) << i;
        const float read_depth =
            scene::linear_depth(given.stored->depth[i], given.stored->encoding, given.camera);
        EXPECT_NEAR(converted.depth[i] / read_depth, 1.0F, 1e-6F + static_cast<float>(loss)) << i;
    }
    const double most = most_apart(GetParam(), given.stored->encoding);
    EXPECT_LE(worst, most);
    EXPECT_GE(worst, GetParam().normal_bits == 32 ? 0.0 : most / 4) << "the normals are rounded";
    EXPECT_GT(*std::ranges::max_element(of_stored.occlusion), 0.2F);
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
            expect_same_images(shown, full, {&Frame::convergence});
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

struct Variant {
    const char* method;
    Filter filter;
};

class InputImages : public OnDevice<testing::TestWithParam<Variant>> {
  protected:
    static constexpr int frames = 3;
    static constexpr gpu::Extent extent{75, 43};

    [[nodiscard]] static Settings settings() {
        Settings settings = with_radius(with_method({}, GetParam().method), 0.5F);
        settings.filter = GetParam().filter;
        settings.table_size = 2048;
        settings.remap_c = 1.5F;
        if (reads(method_named(settings.method), "layers")) settings.own.layers = 2;
        return settings;
    }

    [[nodiscard]] std::vector<scene::GBuffer> views() const {
        std::vector<scene::GBuffer> all;
        for (int frame = 0; frame < frames; ++frame) {
            all.push_back(drawn("moving", extent, {.frame = frame, .motion = true, .layers = 2}));
            if (frame > 0) all.back().normal.clear();
        }
        return all;
    }

    [[nodiscard]] std::vector<Frame> results(scene::Inputs inputs) const {
        scene::PassLibrary passes = passes_;
        passes.inputs = inputs;
        AmbientOcclusion effect(device_, passes, extent);
        std::vector<Frame> all;
        effect.watch([&](const Step& pass, bool) {
            const auto& kinds = gpu::program_of(*pass.pipeline).bindings;
            EXPECT_EQ(std::ranges::count(kinds, gpu::BindingKind::sampled_image) > 0,
                      inputs == scene::Inputs::sampled)
                << pass.name;
        });
        for (const scene::GBuffer& view : views()) {
            all.empty() ? effect.begin(view, settings()) : effect.advance(view);
            all.push_back(effect.next());
        }
        return all;
    }
};

TEST_P(InputImages, SampledAndStorageImagesGiveTheSameBits) {
    expect_same_images(results(scene::Inputs::sampled), results(scene::Inputs::storage));
}

INSTANTIATE_TEST_SUITE_P(Of, InputImages,
                         testing::Values(Variant{"alchemy", Filter::convergence},
                                         Variant{"gtao", Filter::geometry},
                                         Variant{"mssao", Filter::bilateral}),
                         [](const auto& info) { return std::string(info.param.method); });

TEST(Errors, OfKnownNumbers) {
    const Errors errors =
        errors_of(std::vector<float>{0.5F, 0.25F, 1.0F, 0.9F}, std::vector<float>{0.25F, 0.75F, nan, 0.9F});
    EXPECT_EQ(errors.compared, 3U);
    EXPECT_DOUBLE_EQ(errors.rmse, std::sqrt((0.0625 + 0.25) / 3.0));
    EXPECT_DOUBLE_EQ(errors.mean, 0.25);
    EXPECT_DOUBLE_EQ(errors.bias, -0.25 / 3.0);
    EXPECT_DOUBLE_EQ(errors.max, 0.5);
    std::vector<float> rising(100);
    std::iota(rising.begin(), rising.end(), 1.0F);
    EXPECT_EQ(errors_of(rising, std::vector<float>(100, 0.0F)).percentile_99, 99.0);
    EXPECT_EQ(errors_of(std::vector<float>{1.0F}, std::vector<float>{nan}).compared, 0U);
    EXPECT_THROW((void)errors_of(rising, std::vector<float>(3)), std::invalid_argument);
}

// A ball of radius 1 at depth 4, under a right angle of view: its silhouette reaches atan(1 / sqrt(15)) from
// its centre.
TEST(Truth, IsNotKnownNearTheBorder) {
    scene::GBuffer view{.extent = {400, 400}};
    view.depth.assign(160'000, 4.0F);
    view.camera = scene::make_frame({.fovy_rad = std::acos(-1.0) / 2}, 1.0);
    const Truth truth = truth_of(view, 1.0, [](const glm::dvec3&, double) { return 0.5; });
    const double pixel = 4.0 * 2.0 / 400.0;
    int first = 0;
    while (!std::isfinite(truth[static_cast<std::size_t>(200 * 400 + first)])) ++first;
    const double x = -4.0 + (first + 0.5) * pixel;  // world units from the axis
    const double edge = std::tan(std::atan(-x / 4.0) + std::asin(1.0 / std::hypot(x, 4.0)));
    EXPECT_NEAR(edge, 1.0 - 2.0 / 400.0, 0.02);
    EXPECT_LT(edge, 1.0);
    EXPECT_EQ(truth[200 * 400 + 200], 0.5F);
}

}  // namespace gloam::effect::engine_inputs_test
