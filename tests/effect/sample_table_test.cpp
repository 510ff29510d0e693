// SPDX-License-Identifier: MIT
// What samples share is computed once, on the device, and changes nothing: the same images to the bit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace sample_table_test {

constexpr gpu::Extent odd{61, 35};

template <class Base>
class WithView : public OnDevice<Base> {
  protected:
    [[nodiscard]] scene::GBuffer view(int frame) const {
        return scene::rasterize(this->device_, this->passes_, scene::make_scene("moving"), odd,
                                {.frame = frame, .motion = true});
    }

    [[nodiscard]] static Settings settings_for(const std::string& method) {
        const auto radius = static_cast<float>(scene::make_scene("moving").ao_radius);
        return with_radius(with_method(preset_named("paper").settings, method), radius);
    }

    // Some frames of a still view, then some of another: what is rotated and what is not.
    [[nodiscard]] std::vector<Frame> run(AmbientOcclusion& effect, const Settings& settings) const {
        std::vector<Frame> frames;
        effect.begin(view(0), settings);
        for (int i = 0; i < 3; ++i) frames.push_back(effect.next());
        effect.advance(view(1));
        for (int i = 0; i < 3; ++i) frames.push_back(effect.next(2));
        return frames;
    }

    [[nodiscard]] std::vector<Frame> run(const Settings& settings) const {
        return run(this->effect_for(odd), settings);
    }
};

bool fills_table(const Frame& frame) {
    return std::ranges::any_of(frame.times, [](const PassTime& t) { return t.pass == "sample_table"; });
}

void expect_same(const std::vector<Frame>& left, const std::vector<Frame>& right) {
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        EXPECT_EQ(left[i].occlusion, right[i].occlusion) << "frame " << i;
        EXPECT_EQ(left[i].convergence, right[i].convergence) << "frame " << i;
        EXPECT_EQ(left[i].work.samples, right[i].work.samples) << "frame " << i;
    }
}

class SampleTableOf : public WithView<testing::TestWithParam<std::string>> {};

TEST_P(SampleTableOf, ChangesNothing) {
    AmbientOcclusion effect(device_, passes_, odd);  // it has no table of another test
    Settings settings = settings_for(GetParam());
    const std::vector<Frame> with = run(effect, settings);
    EXPECT_TRUE(fills_table(with.front()));
    settings.sample_table = false;
    const std::vector<Frame> without = run(effect, settings);
    EXPECT_TRUE(std::ranges::none_of(without, fills_table));
    expect_same(with, without);
}

std::vector<std::string> methods_that_share() {
    std::vector<std::string> names;
    for (const MethodInfo& method : methods()) {
        if (!method.points.empty()) names.push_back(method.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, SampleTableOf, testing::ValuesIn(methods_that_share()),
                         [](const auto& test) { return test.param; });

class SampleTable : public WithView<testing::Test> {};

TEST_F(SampleTable, SequenceStartsOver) {
    Settings settings = settings_for("hemisphere");
    settings.table_size = 40;
    AmbientOcclusion effect(device_, passes_, odd);
    const std::vector<Frame> with = run(effect, settings);
    // 71 samples are all there are: 32 at first, and the rest in the frame after.
    EXPECT_TRUE(fills_table(with[1]));
    EXPECT_TRUE(fills_table(with[2]));
    EXPECT_FALSE(fills_table(with[3]));
    settings.sample_table = false;
    expect_same(with, run(settings));
}

TEST_F(SampleTable, OutlivesAViewAndGrows) {
    AmbientOcclusion effect(device_, passes_, odd);
    Settings few = settings_for("hemisphere");
    few.samples = few.samples_converged = 3;
    (void)run(effect, few);
    const std::vector<Frame> again = run(effect, few);
    EXPECT_TRUE(std::ranges::none_of(again, fills_table));
    const Settings many = settings_for("hemisphere");
    expect_same(run(effect, many), run(many));
    const Settings disc = settings_for("disc");
    expect_same(run(effect, disc), run(disc));
    expect_same(run(effect, many), run(many));
}

TEST_F(SampleTable, NoneForALongSequence) {
    Settings settings = settings_for("hemisphere");
    settings.table_size = 16'777'216;
    EXPECT_TRUE(std::ranges::none_of(run(settings), fills_table));
}

}  // namespace sample_table_test
}  // namespace gloam::effect
