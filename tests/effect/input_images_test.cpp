// SPDX-License-Identifier: MIT
// Images that passes only read, as sampled images and as storage images: the same results, and pipelines
// whose bindings are those of their modules.
#include <gmock/gmock.h>

#include <cstddef>
#include <string>
#include <vector>

#include "bits.hpp"
#include "effect/internal/steps.hpp"
#include "effect/methods.hpp"
#include "gpu/program_of.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"
#include "shader/reflection.hpp"

namespace gloam::effect {
namespace input_images_test {

gpu::BindingKind kind_of(const shader::Binding& binding) {
    switch (binding.type) {
        case shader::BindingType::storage_buffer:
            return gpu::BindingKind::storage_buffer;
        case shader::BindingType::sampled_image:
            return gpu::BindingKind::sampled_image;
        default:
            return gpu::BindingKind::storage_image;
    }
}

struct Variant {
    const char* method;
    HistoryPrecision precision;
    Filter filter;
};

class InputImages : public OnDevice<testing::TestWithParam<Variant>> {
  protected:
    static constexpr int frames = 3;
    static constexpr gpu::Extent extent{75, 43};

    [[nodiscard]] static Settings settings() {
        Settings settings = with_radius(with_method({}, GetParam().method), 0.5F);
        settings.precision = GetParam().precision;
        settings.filter = GetParam().filter;
        settings.table_size = 2048;
        settings.remap_c = 1.5F;
        settings.layers = 2;
        return settings;
    }

    [[nodiscard]] std::vector<scene::GBuffer> views() const {
        std::vector<scene::GBuffer> all;
        for (int frame = 0; frame < frames; ++frame) {
            all.push_back(scene::rasterize(device_, passes_, scene::make_scene("moving"), extent,
                                           {.frame = frame, .motion = true, .layers = 2}));
            if (frame > 0) all.back().normal.clear();
        }
        return all;
    }

    // Of each frame, what is shown, and the samples in the mean.
    [[nodiscard]] std::vector<std::vector<float>> results(scene::Inputs inputs) const {
        AmbientOcclusion effect(device_, passes_.reading(inputs), extent);
        std::vector<std::vector<float>> all;
        effect.watch([&](const Step& pass, bool after) {
            if (!after) expect_bindings_of_module(pass, inputs);
        });
        for (const scene::GBuffer& view : views()) {
            all.empty() ? effect.begin(view, settings()) : effect.advance(view);
            Frame frame = effect.next();
            for (auto* values : {&frame.occlusion, &frame.filtered, &frame.convergence})
                all.push_back(std::move(*values));
        }
        return all;
    }

  private:
    static void expect_bindings_of_module(const Step& pass, scene::Inputs inputs) {
        const gpu::PipelineProgram& program = gpu::program_of(*pass.pipeline);
        for (const shader::Binding& binding : shader::reflect(program.spirv).bindings) {
            EXPECT_EQ(program.bindings.at(binding.number), kind_of(binding))
                << pass.name << " " << binding.name;
            const bool read_only = kind_of(binding) != gpu::BindingKind::storage_buffer && !binding.writes;
            const bool sampled = kind_of(binding) == gpu::BindingKind::sampled_image;
            EXPECT_EQ(sampled, read_only && inputs == scene::Inputs::sampled)
                << pass.name << " " << binding.name;
        }
    }
};

TEST_P(InputImages, SampledAndStorageImagesGiveTheSameBits) {
    const auto sampled = results(scene::Inputs::sampled);
    const auto stored = results(scene::Inputs::storage);
    ASSERT_EQ(sampled.size(), std::size_t{3 * frames});
    for (std::size_t i = 0; i < sampled.size(); ++i) EXPECT_EQ(bits_of(sampled[i]), bits_of(stored[i])) << i;
}

INSTANTIATE_TEST_SUITE_P(Of, InputImages,
                         testing::Values(Variant{"alchemy", HistoryPrecision::float16, Filter::convergence},
                                         Variant{"gtao", HistoryPrecision::packed, Filter::geometry},
                                         Variant{"mssao", HistoryPrecision::float32, Filter::bilateral}),
                         [](const auto& info) { return std::string(info.param.method); });

}  // namespace input_images_test
}  // namespace gloam::effect
