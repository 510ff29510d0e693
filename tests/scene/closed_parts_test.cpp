// SPDX-License-Identifier: MIT
#include "scene/rasterize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "scene/mesh.hpp"

namespace gloam::scene::closed_parts_test {

std::size_t hidden(const Mesh& mesh, bool orthographic = false) {
    const std::vector<bool> triangles = hidden_far_sides(mesh, orthographic);
    return static_cast<std::size_t>(std::ranges::count(triangles, true));
}

// A box of 12 triangles, straight before the eye.
Mesh box(double near = -5.0) {
    return make_box({-1, -1, near - 2.0}, {1, 1, near}, 10.0);
}

TEST(ClosedParts, OnlyTheFrontOfABoxIsSeen) {
    EXPECT_EQ(hidden(box()), 10U);
    EXPECT_EQ(hidden(box(), true), 10U);
}

TEST(ClosedParts, FromWithinEverySideIsSeen) {
    EXPECT_EQ(hidden(box(1.0)), 0U);
}

TEST(ClosedParts, WhatIsOpenHasTwoSides) {
    EXPECT_EQ(hidden(make_parallelogram({-1, -1, -5}, {0, 2, 0}, {2, 0, 0}, 1.0)), 0U);
    Mesh without_a_triangle = box();
    without_a_triangle.indices.resize(without_a_triangle.indices.size() - 3);
    EXPECT_EQ(hidden(without_a_triangle), 0U);
}

TEST(ClosedParts, TrianglesThatFaceInwardAreSeen) {
    Mesh inward = box();
    for (std::size_t i = 0; i < inward.indices.size(); i += 3)
        std::swap(inward.indices[i], inward.indices[i + 1]);
    EXPECT_EQ(hidden(inward), 0U);
}

// Parts of one mesh are told apart by their positions.
TEST(ClosedParts, EachPartIsJudgedAlone) {
    Mesh mesh = make_parallelogram({-9, -2, -9}, {0, 0, 9}, {18, 0, 0}, 20.0);
    append(mesh, box());
    append(mesh, make_box({4, -1, -7}, {6, 1, -5}, 10.0));
    // Of the box to the right, the front and the left side are seen.
    EXPECT_EQ(hidden(mesh), 10U + 8U);
}

}  // namespace gloam::scene::closed_parts_test
