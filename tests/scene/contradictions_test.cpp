// SPDX-License-Identifier: MIT
#include "scene/contradictions.hpp"

#include "scene/analytic_scene.hpp"
#include "scene/support.hpp"

// Buffers of an engine that contradict each other, or what was said of them, are refused by one sentence.
namespace gloam::scene::test::contradictions_test {

// A floor before a wall, all of it visible, 33 x 33 pixels.
GBuffer corner(Projection projection = Projection::perspective) {
    const std::vector<ClosedFormView> views = closed_form_views(projection);
    const auto view = std::ranges::find_if(views, [](const auto& v) { return v.name.starts_with("wall"); });
    GBuffer buffer = draw(*view, 33);
    buffer.border = {};
    return buffer;
}

// What an engine stores of the corner, read back as it is said to be stored.
std::string said(const StoredInputs& stored, const Encoding& read_as) {
    const TemporaryDirectory folder;
    GBuffer written = corner();
    written.depth = stored.depth;
    written.normal = stored.normal;
    write_frame(folder, 0, written);
    try {
        (void)read_gbuffer(folder.path(), 0, read_as);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

struct Row {
    const char* what;
    std::string stored_depth;
    std::string stored_normals;
    std::string read_depth;
    std::string read_normals;
    const char* expected;
};

TEST(Contradictions, OfAnEncodingAreNamed) {
    const std::vector<Row> rows{
        {"as stored", "linear", "view", "linear", "view", ""},
        {"a depth buffer, as stored", "buffer", "view", "buffer", "view", ""},
        {"world normals, as stored", "linear", "world-octahedral-unorm", "linear", "world-octahedral-unorm",
         ""},
        {"unorm, as stored", "buffer", "view-unorm", "buffer", "view-unorm", ""},
        {"eye-linear depth read as a buffer", "linear", "view", "buffer", "view", "from 0 to 1"},
        {"a depth buffer read as eye-linear", "buffer", "view", "linear", "view", "--depth"},
        {"numbers of 0 to 1 read as they are", "linear", "view-unorm", "linear", "view", "another length"},
        {"normals read as numbers of 0 to 1", "linear", "view", "linear", "view-unorm", "another length"},
        {"octahedral normals read as vectors", "linear", "view-octahedral", "linear", "view",
         "another length"},
        {"vectors read as octahedral normals", "linear", "view", "linear", "view-octahedral", "30 degrees"},
    };
    for (const Row& row : rows) {
        const StoredInputs stored =
            stored_inputs(corner(), encoding_named(row.stored_depth, row.stored_normals));
        const std::string text = said(stored, encoding_named(row.read_depth, row.read_normals));
        EXPECT_THAT(text, HasSubstr(row.expected)) << row.what;
        EXPECT_EQ(text.empty(), *row.expected == '\0') << row.what << ": " << text;
    }
}

struct Change {
    const char* what;
    std::function<void(StoredInputs&)> change;
    const char* expected;
};

TEST(Contradictions, OfBuffersAreNamed) {
    const auto each = [](auto change) {
        return [change](StoredInputs& stored) {
            for (glm::vec3& normal : stored.normal) normal = change(normal);
        };
    };
    const std::vector<Change> rows{
        {"normals away from the eye", each([](glm::vec3 n) { return -n; }), "face away"},
        {"normals of 0", each([](glm::vec3) { return glm::vec3(0); }), "another length"},
        {"normals that are not numbers", each([](glm::vec3) { return glm::vec3(nan); }), "another length"},
        {"normals of another length", each([](glm::vec3 n) { return 255.0F * n; }), "another length"},
        {"the axes of another view space", each([](glm::vec3 n) { return glm::vec3(n.z, n.x, n.y); }),
         "normals"},
        {"depth in centimetres",
         [](StoredInputs& s) {
             for (float& d : s.depth) d *= 1e5F;
         },
         "planes"},
        {"one wrong pixel in ten",
         [](StoredInputs& s) {
             for (std::size_t i = 0; i < s.normal.size(); i += 10) s.normal[i] = glm::vec3(0);
         },
         ""},
    };
    for (const Change& row : rows) {
        StoredInputs stored = stored_inputs(corner(), {});
        row.change(stored);
        const std::string text = said(stored, {});
        EXPECT_THAT(text, HasSubstr(row.expected)) << row.what;
        EXPECT_EQ(text.empty(), *row.expected == '\0') << row.what << ": " << text;
    }
}

TEST(Contradictions, ABufferWhoseZIsReversedUnlikeTheProjection) {
    for (const bool reversed : {false, true}) {
        GBuffer view = corner();
        view.camera = make_frame({.reversed_z = reversed}, 1.0);
        view.depth[0] = std::numeric_limits<float>::infinity();
        StoredInputs stored = stored_inputs(view, {.depth_buffer = true});
        const TemporaryDirectory folder;
        for (float& b : stored.depth) b = 1.0F - b;
        for (std::size_t i = 0; i < 33; ++i) stored.depth[i] = reversed ? 1.0F : 0.0F;  // sky
        view.depth = stored.depth;
        write_frame(folder, 0, view);
        expect_error<std::runtime_error>(
            [&] { (void)read_gbuffer(folder.path(), 0, {.depth_buffer = true}); }, {"f0000", "near plane"});
    }
}

TEST(Contradictions, ARadiusFitsTheScene) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const GBuffer view = corner(projection);
        EXPECT_EQ(radius_out_of_proportion(view, 1.0), "");
        EXPECT_THAT(radius_out_of_proportion(view, 1e6), HasSubstr("radius 1e+06"));
        EXPECT_THAT(radius_out_of_proportion(view, 1e-6), HasSubstr("below a pixel"));
    }
}

// A camera whose axis is not in the middle of the image: the image is part of one with such a camera.
using OffCentreViews = InFolder;

TEST_F(OffCentreViews, HaveTheRaysOfTheWholeView) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const Border& around : {Border(0, 0, 20, 0), Border(15, 0, 0, 0), Border(0, 0, 0, 9),
                                     Border(0, 13, 0, 0), Border(12, 0, 0, 5), Border(0, 0, 24, 24)}) {
            GBuffer whole = corner(projection);
            whole.border = around;
            write_frame(folder, 0, cropped(whole));
            const GBuffer read = read_gbuffer(folder.path(), 0);
            EXPECT_EQ(read.off_centre, cropped(whole).off_centre);
            EXPECT_EQ(centred(read).extent, whole.extent);
            EXPECT_EQ(cropped(centred(read)).depth, read.depth);
            const PixelPositions positions(read);
            for (std::size_t i = 0; i < read.depth.size(); ++i) {
                const glm::dvec3 at = positions.at(i, 3.0);
                const glm::dvec2 place = glm::dvec2(i % read.extent.width, i / read.extent.width) + 0.5;
                ASSERT_LT(glm::distance(positions.pixel_of(at), place), 1e-9) << i;
                const glm::dvec2 outer = place + glm::dvec2(around.left, around.top);
                ASSERT_LT(glm::distance(PixelPositions(whole).pixel_of(at), outer), 1e-4) << i;
            }
        }
    }
}

// three.js gives orthographic cameras a near plane behind the eye: what lies there is part of the picture.
TEST(OrthographicViews, BehindTheEyesPlaneAreReadAsTheSameView) {
    for (const bool reversed : {false, true}) {
        for (const bool buffer : {false, true}) {
            GBuffer view = corner(Projection::orthographic);
            const Encoding encoding{.depth_buffer = buffer};
            const auto behind = [&](double by) {
                GBuffer moved = view;
                glm::dmat4 projection =
                    make_frame({.projection = Projection::orthographic, .reversed_z = reversed}, 1.0).proj_vk;
                projection[0][0] = view.camera.proj_vk[0][0];
                projection[1][1] = view.camera.proj_vk[1][1];
                const glm::dmat4 shift{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, -by, 1}};
                moved.camera.proj_vk = glm::mat4(projection * shift);
                moved.camera.view = glm::mat4(glm::inverse(shift) * glm::dmat4(view.camera.view));
                for (float& d : moved.depth)
                    d = static_cast<float>(
                        buffer ? stored_depth(double{d}, encoding, {.proj_vk = glm::mat4(projection)})
                               : double{d} - by);
                return moved;
            };
            const TemporaryDirectory folder;
            write_frame(folder, 0, behind(0.0));
            write_frame(folder, 1, behind(50.0));
            const GBuffer want = read_gbuffer(folder.path(), 0, encoding);
            const GBuffer got = read_gbuffer(folder.path(), 1, encoding);
            EXPECT_GT(planes_of(got.camera.proj_vk).near, 0.0);
            const PixelPositions then(want);
            const PixelPositions now(got);
            for (std::size_t i = 0; i < want.depth.size(); ++i) {
                const glm::dvec3 a = then.at(i, double{want.depth[i]});
                const glm::dvec3 b = now.at(i, double{got.depth[i]});
                const glm::dvec4 world_a = glm::inverse(glm::dmat4(want.camera.view)) * glm::dvec4(a, 1.0);
                const glm::dvec4 world_b = glm::inverse(glm::dmat4(got.camera.view)) * glm::dvec4(b, 1.0);
                ASSERT_LT(glm::distance(world_a, world_b), 1e-4) << i;
            }
        }
    }
}

}  // namespace gloam::scene::test::contradictions_test
