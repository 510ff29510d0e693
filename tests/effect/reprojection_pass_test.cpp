// SPDX-License-Identifier: MIT
// The pass that moves the history, alone: what it brings to a pixel whose point was between four texels.
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec3.hpp>

#include "effect/internal/passes.hpp"
#include "on_device.hpp"

namespace gloam::effect::reprojection_pass_test {

constexpr glm::ivec2 size(16, 8);
constexpr float depth_of_all = 2.0F;
constexpr glm::vec2 shift(0.25F, 0.125F);  // texels: fractions that are exact in floats

struct Texel {
    float occlusion = 0.0F;
    float weight = 0.0F;
    float index = 0.0F;
    float depth = depth_of_all;

    friend bool operator==(const Texel&, const Texel&) = default;
};

using Texels = std::vector<Texel>;

std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y * size.x + x);
}

// Different everywhere, so that a texel that was mistaken for another shows.
Texels different() {
    Texels texels;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const auto i = static_cast<float>(at(x, y));
            texels.push_back(
                {.occlusion = i / 128.0F, .weight = 1.0F + i, .index = static_cast<float>(3 * x + 64 * y)});
        }
    }
    return texels;
}

Settings with_taps(HistoryTaps taps) {
    Settings settings;
    settings.taps = taps;
    return settings;
}

// The pass on images of that size.
class ReprojectionPass : public OnDevice<testing::Test> {
  protected:
    // The history of a wall that a parallel camera has moved along by `shift`.
    [[nodiscard]] Texels moved(const Texels& before, const Settings& settings, float tolerance = 0.1F) const {
        const glm::vec2 p00_p11(1.0F, -1.0F);
        const glm::vec2 step = 2.0F * shift / (glm::vec2(size) * p00_p11);  // view space
        Values values = values_of(Moment{.settings = settings});            // its cameras are orthographic
        values.set("previous_from_current", glm::translate(glm::mat4(1.0F), {step.x, step.y, 0.0F}));
        values.set("p00_p11", p00_p11);
        values.set("previous_p00_p11", p00_p11);
        values.set("size", size);
        values.set("depth_tolerance", tolerance);
        const gpu::Extent extent{static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)};
        using enum gpu::Format;
        Resources resources(device_);
        resources.image("depth", extent, r32f).upload(std::vector<float>(before.size(), depth_of_all));
        std::vector<float> words;
        for (const Texel& t : before) words.insert(words.end(), {t.occlusion, t.weight, t.index, t.depth});
        resources.image("before", extent, rgba32f).upload(words);
        const gpu::Image& after = resources.image("after", extent, rgba32f);
        Executor(device_, passes_)
            .run("reproject", {.file = "study/reproject.comp"}, {"depth", nothing_image, "before", "after"},
                 values, groups_for(extent), resources, {});
        Texels moved;
        const std::vector<float> got = after.download();
        for (std::size_t i = 0; i < got.size(); i += 4)
            moved.push_back({got[i], got[i + 1], got[i + 2], got[i + 3]});
        return moved;
    }
};

struct Taken {
    double occlusion = 0.0;
    double weight = 0.0;
    double share = 0.0;  // of the taps that count
};

// What comes to (x, y) from the four texels around its place, those beyond the edge being the last ones.
// validated: those of the same surface alone count.
Taken taken_at(const Texels& before, int x, int y, bool validated) {
    Taken sum;
    for (const int i : {0, 1}) {
        for (const int j : {0, 1}) {
            const Texel& tap = before[at(std::min(x + i, size.x - 1), std::min(y + j, size.y - 1))];
            if (validated && tap.depth != depth_of_all) continue;
            const double share = std::abs(1 - i - double{shift.x}) * std::abs(1 - j - double{shift.y});
            sum.occlusion += share * double{tap.occlusion};
            sum.weight += share * double{tap.weight};
            sum.share += share;
        }
    }
    return {sum.occlusion / sum.share, sum.weight / sum.share, sum.share};
}

// Bilinear taps count where the nearest one is of the surface, validated ones where they are themselves. The
// index is that of the nearest. Without and with a column of another surface.
TEST_F(ReprojectionPass, BringsTheMeanOfTheTexelsAroundThatAreOfTheSurface) {
    for (const HistoryTaps taps : {HistoryTaps::bilinear, HistoryTaps::validated}) {
        for (const bool hole : {false, true}) {
            Texels before = different();
            for (int y = 0; hole && y < size.y; ++y) before[at(5, y)].depth = 10.0F * depth_of_all;
            const Texels after = moved(before, with_taps(taps));
            for (std::size_t i = 0; i < before.size(); ++i) {
                SCOPED_TRACE(i);
                if (before[i].depth != depth_of_all && taps == HistoryTaps::bilinear) {
                    EXPECT_EQ(after[i].weight, 0.0F);
                    continue;
                }
                const Taken want = taken_at(before, static_cast<int>(i) % size.x,
                                            static_cast<int>(i) / size.x, taps == HistoryTaps::validated);
                EXPECT_NEAR(after[i].weight, want.weight, 1e-3);
                if (hole) continue;
                EXPECT_NEAR(after[i].occlusion, want.occlusion, 1e-5);
                EXPECT_EQ(after[i].index, before[i].index);
            }
        }
    }
}

TEST_F(ReprojectionPass, TheNearestTexelAloneIsCopied) {
    const Texels before = different();
    EXPECT_EQ(moved(before, with_taps(HistoryTaps::nearest)), before);
}

}  // namespace gloam::effect::reprojection_pass_test
