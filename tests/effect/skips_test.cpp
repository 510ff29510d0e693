// SPDX-License-Identifier: MIT
// Skips change nothing: over several frames, images are bit-identical with each skip and without.
#include "skips.hpp"

#include "support/method_names.hpp"

namespace gloam::effect::skips_test {

TEST_F(Skips, BackgroundOfAMovingCamera) {
    std::vector<Stay> stays;
    for (int i = 0; i < 8; ++i) stays.push_back({view("sky", 4 * i)});
    const std::vector<Frame> frames = expect_same(stays, settings_for("sky"));
    EXPECT_EQ(frames.front().work.tiles_blank, 0U) << "what the images hold is not known yet";
    EXPECT_GT(frames.back().work.tiles_blank, frames.back().work.tiles / 3);
    EXPECT_LT(frames.back().work.tiles_filtered, frames.back().work.tiles);
}

// Without a history and a filter the occlusion is all that is written.
TEST_F(Skips, FramesThatStandAlone) {
    std::vector<Stay> stays;
    for (int i = 0; i < 4; ++i) stays.push_back({view("sky", 8 * i), 1 + i % 2});
    Settings settings = settings_for("sky");
    settings.history = false;
    settings.filter = Filter::none;
    for (const float power : {1.0F, 2.0F}) {
        settings.remap_c = power;
        const std::vector<Frame> frames = expect_same(stays, settings);
        EXPECT_GT(frames.back().work.tiles_blank, frames.back().work.tiles / 3);
        EXPECT_THAT(frames.back().kept, Each(0.0F));
        EXPECT_GT(*std::ranges::max_element(frames.back().occlusion), 0.1F);
        for (const PassTime& time : frames[1].times) EXPECT_NE(time.pass, "reproject");
    }
}

TEST_F(Skips, MovingObjects) {
    std::vector<Stay> stays;
    for (int i = 0; i < 6; ++i) stays.push_back({view("moving", 20 + i), 1 + i % 2});
    (void)expect_same(stays, quick(settings_for("moving")));
}

TEST_F(Skips, SettledTilesOfAViewThatStandsStillAndMovesOn) {
    const std::vector<Stay> stays{
        {view("sky", 0), 7}, {view("sky", 6), 6}, {view("sky", 7), 1}, {view("sky", 8), 5}};
    for (const bool freeze : {true, false}) {
        Settings settings = quick(settings_for("sky"));
        settings.freeze = freeze;
        const std::vector<Frame> frames = expect_same(stays, settings);
        const Work& settled = frames[6].work;
        if (freeze) {
            EXPECT_EQ(settled.tiles_shaded, 0U);
            EXPECT_EQ(settled.tiles_filtered, 0U);
            EXPECT_EQ(settled.tiles_settled + settled.tiles_blank, settled.tiles);
            EXPECT_EQ(settled.samples, 0U);
        }
        EXPECT_GT(frames[7].work.tiles_shaded, 0U) << "the view has moved";
    }
}

TEST_F(Skips, WhatHasConvergedIsFrozenUntilTheViewMoves) {
    const std::vector<Stay> stays{{view("corner", 0), 6}, {view("corner", 1), 2}};
    Settings settings = quick(settings_for("corner"));
    const std::vector<Frame> frozen = run(stays, settings);
    settings.freeze = false;
    const std::vector<Frame> free = run(stays, settings);
    EXPECT_EQ(frozen[2].occlusion, free[2].occlusion) << "nothing had converged before";
    EXPECT_EQ(frozen[5].occlusion, frozen[3].occlusion);
    EXPECT_NE(free[5].occlusion, free[3].occlusion);
    EXPECT_EQ(frozen[5].work.samples, 0U);
    EXPECT_GT(frozen[6].work.samples, 0U);
}

TEST_F(Skips, SomeTilesSettleBeforeTheirNeighbours) {
    // What comes into view has no history, and the filter reads across the tiles' borders.
    const std::vector<Stay> stays{{view("columns", 0), 4}, {view("columns", 9), 8}};
    Settings settings = quick(settings_for("columns"));
    settings.weight_max = 200.0F;
    settings.c_adaptive = 0.9F;
    settings.filter_half_width = 5;
    bool partly = false;
    for (const Frame& frame : expect_same(stays, settings))
        partly |= frame.work.tiles_settled > 0 && frame.work.tiles_shaded > 0;
    EXPECT_TRUE(partly);
}

// With a packed history what the filter sees is not what the samples gave.
TEST_F(Skips, TilesThatTheFilterLeavesAsTheyAre) {
    const std::vector<Stay> stays{{view("columns", 0), 3}, {view("columns", 9), 4}};
    for (const auto precision : {HistoryPrecision::float32, HistoryPrecision::packed}) {
        Settings settings = without_skips(settings_for("columns"));
        settings.skip_filtered = true;
        settings.precision = precision;
        settings.table_size = 2048;
        settings.filter_half_width = 3;
        const std::vector<Frame> frames = expect_same(stays, settings);
        EXPECT_LT(frames.front().work.tiles_unfiltered, frames.front().work.tiles / 8)
            << "nothing has converged";
        const Work& after_a_move = frames[3].work;
        EXPECT_GT(after_a_move.tiles_unfiltered, after_a_move.tiles / 4);
        EXPECT_GT(after_a_move.tiles_filtered, 0U) << "what came into view";
        EXPECT_EQ(after_a_move.tiles_filtered + after_a_move.tiles_unfiltered, after_a_move.tiles);
        settings.remap_c = 2.0F;
        (void)expect_same(stays, settings);
    }
}

TEST_F(Skips, EveryFilterAndTheMap) {
    const std::vector<Stay> stays{{view("sky", 0), 5}, {view("sky", 5), 1}, {view("sky", 6), 5}};
    for (const Filter filter : {Filter::none, Filter::geometry, Filter::bilateral, Filter::sao}) {
        Settings settings = quick(settings_for("sky"));
        settings.filter = filter;
        settings.filter_half_width = 4;
        settings.remap_c = 2.0F;
        EXPECT_EQ(expect_same(stays, settings)[4].work.tiles_shaded, 0U);
    }
}

TEST_F(Skips, APackedHistory) {
    Settings settings = quick(settings_for("sky"));
    settings.table_size = 2048;
    const std::vector<Stay> stays{{view("sky", 0), 6}, {view("sky", 5), 5}};
    settings.precision = HistoryPrecision::packed;
    EXPECT_EQ(expect_same(stays, settings)[5].work.tiles_shaded, 0U);
}

TEST_F(Skips, GuardBands) {
    for (const bool history : {true, false}) {
        Settings settings = quick(settings_for("sky"));
        settings.guard = 0.1F;
        settings.guard_history = history;
        const std::vector<Stay> stays{
            {view("sky", 0, odd, 0.1), 5}, {view("sky", 5, odd, 0.1), 1}, {view("sky", 6, odd, 0.1), 5}};
        EXPECT_EQ(expect_same(stays, settings)[4].work.tiles_shaded, 0U);
    }
}

bool listed(const Frame& frame) {
    return std::ranges::any_of(frame.times, [](const PassTime& time) { return time.pass == "select_tiles"; });
}

TEST_F(Skips, NoListsWhereNothingIsLeftOutUntilTheViewStandsStill) {
    Settings settings = quick(settings_for("room"));
    settings.filter = Filter::geometry;
    settings.filter_half_width = 1;
    std::vector<Stay> stays;
    for (int i = 0; i < 30; ++i) stays.push_back({view("room", i)});
    stays.back().frames = 8;
    const std::vector<Frame> frames = expect_same(stays, settings);
    for (std::size_t i = 0; i < 30; ++i)
        EXPECT_EQ(listed(frames[i]), (i >= 1 && i < 5) || (i >= 25 && i < 29)) << i;
    for (std::size_t i = 30; i < frames.size(); ++i) EXPECT_TRUE(listed(frames[i])) << i;
    EXPECT_EQ(frames.back().work.tiles_shaded, 0U);
    EXPECT_EQ(frames[5].work.tiles_shaded, frames[5].work.tiles);
}

TEST_F(Skips, ListsComeBackWithSomethingToLeaveOut) {
    Settings settings = quick(settings_for("sky"));
    settings.filter = Filter::none;
    std::vector<Stay> stays;
    scene::GBuffer full = view("sky", 0);
    for (float& depth : full.depth) depth = depth > 0.0F && std::isfinite(depth) ? depth : 30.0F;
    full.camera.previous_from_current = glm::mat4(1.0F);
    for (int i = 0; i < 5; ++i) stays.push_back({full});
    for (int i = 1; i < 25; ++i) stays.push_back({view("sky", i)});
    const std::vector<Frame> frames = expect_same(stays, settings);
    EXPECT_FALSE(listed(frames[10]));
    EXPECT_EQ(frames[10].work.tiles_blank, 0U);
    EXPECT_GT(frames.back().work.tiles_blank, frames.back().work.tiles / 3);
}

class SkipsOf : public Skips, public testing::WithParamInterface<std::string> {};

TEST_P(SkipsOf, ChangeNothing) {
    const gpu::Extent small{29, 19};
    // Methods of whole slices take fewer samples than asked for, and so more frames to fill the mean.
    const std::vector<Stay> stays{{view("corner", 0, small), 8}};
    const Settings settings = with_method(quick(Settings{}), GetParam());
    EXPECT_EQ(expect_same(stays, settings)[7].work.tiles_shaded, 0U);
}

INSTANTIATE_TEST_SUITE_P(All, SkipsOf, testing::ValuesIn(test::method_names()), test::parameter_name);

TEST_F(Skips, GeometryAppearsWhereAllWasBackground) {
    const scene::GBuffer full = view("corner", 0);
    scene::GBuffer empty = full;
    empty.depth.assign(empty.depth.size(), infinity);
    scene::GBuffer follows = full;
    follows.camera.previous_from_current = glm::mat4(1.0F);
    empty.camera.previous_from_current = glm::mat4(1.0F);
    const std::vector<Frame> frames =
        expect_same({{full, 3}, {empty, 4}, {follows, 1}, {empty, 1}, {follows, 2}}, quick(Settings{}));
    EXPECT_EQ(frames[6].work.tiles_blank, frames[6].work.tiles);
    EXPECT_EQ(frames[7].work.tiles_shaded, frames[7].work.tiles);
}

}  // namespace gloam::effect::skips_test
