// SPDX-License-Identifier: MIT
#pragma once

#include "effect/methods.hpp"
#include "on_device.hpp"

// Frames with skips and the same frames without.
namespace gloam::effect {

inline constexpr gpu::Extent odd{83, 45};

// A view, and how many frames of it are made.
struct Stay {
    scene::GBuffer view;
    int frames = 1;
};

class Skips : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] scene::GBuffer view(const std::string& name, int frame, gpu::Extent extent = odd,
                                      double guard = 0.0) const {
        return drawn(name, extent, {.frame = frame, .motion = true, .guard = guard});
    }

    [[nodiscard]] Settings settings_for(const std::string& name) const {
        return with_skips(with_radius(preset_named("tssao-paper").settings,
                                      static_cast<float>(scene::make_scene(name).ao_radius)));
    }

    // All frames of all stays. Before, the images contained other values.
    [[nodiscard]] std::vector<Frame> run(const std::vector<Stay>& stays, const Settings& settings) const {
        AmbientOcclusion& effect = effect_for(stays.front().view.extent);
        scene::GBuffer dirt = stays.front().view;
        dirt.depth.assign(dirt.depth.size(), 2.0F);
        effect.begin(dirt, settings);
        (void)effect.next();
        (void)effect.next();
        std::vector<Frame> frames;
        for (const Stay& stay : stays) {
            frames.empty() ? effect.begin(stay.view, settings) : effect.advance(stay.view);
            for (int i = 0; i < stay.frames; ++i) frames.push_back(effect.next(i % 2 + 1));
        }
        return frames;
    }

    // Returns the frames with the skips.
    std::vector<Frame> expect_same(const std::vector<Stay>& stays, const Settings& settings) const {
        std::vector<Frame> with = run(stays, settings);
        const std::vector<Frame> without = run(stays, without_skips(settings));
        expect_same_images(with, without);
        for (std::size_t i = 0; i < with.size(); ++i) {
            SCOPED_TRACE("frame " + std::to_string(i));
            EXPECT_EQ(with[i].work.samples, without[i].work.samples);
            EXPECT_EQ(with[i].work.background, without[i].work.background);
            EXPECT_EQ(without[i].work.tiles_shaded, without[i].work.tiles);
        }
        return with;
    }
};

// Converges in three frames.
inline Settings quick(Settings settings) {
    settings.weight_max = 64.0F;
    settings.freeze = true;
    return with_skips(settings);
}

}  // namespace gloam::effect
