// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <glm/gtc/packing.hpp>

#include "scene/support.hpp"

// Buffers of an engine that contradict each other, or what was said of them, are refused by one sentence.
// More in tests/tools/stories.
namespace gloam::scene::test::contradictions_test {

using Names = std::pair<const char*, const char*>;  // of the encodings of depth and normals
using Normal = std::function<glm::vec3(glm::vec3)>;
constexpr Names plain{"linear", "view"};
constexpr Names world{"linear", "world"};
constexpr float radial = 0.0F;

// What an engine stores of the corner, and how that is read.
struct Row {
    const char* what;
    const char* expected;
    Names stored = plain;
    Names read = plain;
    Normal change = std::identity{};
    std::size_t every = 1;  // of the normals is changed
    float scale = 1.0F;     // of the depth; radial: it is the distance to the eye
};

// A bump map: every direction within about 20 degrees of a normal, in turn.
glm::vec3 rough(glm::vec3 n) {
    static int turns = 0;
    const float angle = 2.4F * static_cast<float>(++turns);
    return glm::normalize(n + 0.35F * glm::vec3(std::cos(angle), std::sin(angle), std::sin(2.0F * angle)));
}

const std::vector<Row> rows{
    {"as stored", ""},
    {"a depth buffer, as stored", "", {"buffer", "view"}, {"buffer", "view"}},
    {"world normals", "", {"linear", "world-octahedral-unorm"}, {"linear", "world-octahedral-unorm"}},
    {"unorm, as stored", "", {"buffer", "view-unorm"}, {"buffer", "view-unorm"}},
    {"a depth buffer read as eye-linear", "--depth", {"buffer", "view"}},
    {"numbers of 0 to 1 read as they are", "another length", {"linear", "view-unorm"}},
    {"octahedral normals read as vectors", "another length", {"linear", "view-octahedral"}},
    {"vectors read as octahedral normals", "30 degrees", plain, {"linear", "view-octahedral"}},
    {"normals away from the eye", "face away", plain, plain, [](glm::vec3 n) { return -n; }},
    {"normals of 0", "another length", plain, plain, [](glm::vec3) { return glm::vec3(0); }},
    {"normals that are not numbers", "another length", plain, plain,
     [](glm::vec3) { return glm::vec3(nan); }},
    {"normals of another length", "another length", plain, plain, [](glm::vec3 n) { return 255.0F * n; }},
    {"another view space", "normals", plain, plain, [](glm::vec3 n) { return glm::vec3(n.z, n.x, n.y); }},
    {"depth in centimetres", "planes", plain, plain, std::identity{}, 1, 1e5F},
    {"distance to the eye", "expected eye-linear depth", plain, plain, std::identity{}, 1, radial},
    {"distance to the eye, world normals", "distance to the eye", world, world, std::identity{}, 1, radial},
    {"bumps", "", plain, plain, rough},
    {"bumps, distance to the eye", "distance to the eye", plain, plain, rough, 3, radial},
    {"one wrong pixel in ten", "", plain, plain, [](glm::vec3) { return glm::vec3(0); }, 10},
};

TEST(Contradictions, OfEncodingsAndBuffersAreNamed) {
    const auto named = [](const Names& names) { return encoding_named(names.first, names.second); };
    for (const Row& row : rows) {
        GBuffer written = floor_and_wall();
        const StoredInputs stored = stored_inputs(written, named(row.stored));
        written.depth = stored.depth;
        const PixelPositions positions(written);
        for (std::size_t i = 0; i < written.depth.size(); ++i)
            written.depth[i] *=
                row.scale == radial ? float(glm::length(positions.ray(i).direction)) : row.scale;
        written.normal = stored.normal;
        for (std::size_t i = 0; i < written.normal.size(); i += row.every)
            written.normal[i] = row.change(stored.normal[i]);
        const TemporaryDirectory folder;
        write_frame(folder, 0, written);
        std::string text;
        try {
            (void)read_gbuffer(folder.path(), 0, named(row.read));
        } catch (const std::runtime_error& error) {
            text = error.what();
        }
        EXPECT_THAT(text, HasSubstr(row.expected)) << row.what;
        EXPECT_EQ(text.empty(), *row.expected == '\0') << row.what << ": " << text;
    }
}

TEST(Contradictions, ABufferWhoseZIsReversedUnlikeTheProjection) {
    for (const bool reversed : {false, true}) {
        GBuffer view = floor_and_wall();
        view.camera = make_frame({.reversed_z = reversed}, 1.0);
        view.depth = stored_inputs(view, {.depth_buffer = true}).depth;
        for (float& b : view.depth) b = 1.0F - b;
        std::fill_n(view.depth.begin(), 33, reversed ? 1.0F : 0.0F);  // sky
        const TemporaryDirectory folder;
        write_frame(folder, 0, view);
        expect_error<std::runtime_error>(
            [&] { (void)read_gbuffer(folder.path(), 0, {.depth_buffer = true}); }, {"f0000", "near plane"});
    }
}

// Depth of so many bits, or of halves, by a camera with this near plane.
TEST(Contradictions, StepsOfDepthAreSmallBesideTheRadius) {
    struct Steps {
        int bits;
        double near;
        bool reversed;
        double radius;
        bool coarse;
    };
    constexpr int floats = 0;
    constexpr int halves = -1;
    constexpr int linear_halves = -2;
    for (const Steps& row : {Steps{floats, 0.1, false, 0.5, false},
                             {floats, 1e-6, false, 0.5, true},
                             {floats, 1e-6, true, 0.5, false},
                             {24, 1e-6, true, 0.5, true},
                             {24, 0.1, false, 0.5, false},
                             {16, 0.1, false, 0.5, false},
                             {16, 0.001, false, 0.5, true},
                             {12, 0.1, false, 0.05, true},
                             {halves, 0.1, false, 0.01, true},
                             {halves, 0.1, true, 0.5, false},
                             {linear_halves, 0.1, false, 0.5, false},
                             {linear_halves, 0.1, false, 0.005, true}}) {
        GBuffer view = floor_and_wall();
        view.camera = make_frame({.near = row.near, .reversed_z = row.reversed}, 1.0);
        view.stored = stored_inputs(view, {.depth_buffer = row.bits != linear_halves});
        for (float& x : view.stored->depth) {
            const double largest = std::exp2(row.bits) - 1.0;
            if (row.bits > 0) x = static_cast<float>(std::round(x * largest) / largest);
            if (row.bits < 0) x = glm::unpackHalf1x16(glm::packHalf1x16(x));
        }
        const std::string text = too_coarse_steps(view, row.radius);
        EXPECT_EQ(!text.empty(), row.coarse) << row.bits << " bits, near " << row.near << ": " << text;
        EXPECT_EQ(text.find(fmt::format("near {:g} and far", row.near)) != text.npos, row.coarse);
    }
}

}  // namespace gloam::scene::test::contradictions_test
