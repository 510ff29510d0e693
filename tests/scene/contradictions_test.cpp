// SPDX-License-Identifier: MIT
#include "scene/contradictions.hpp"

#include "scene/support.hpp"

// Buffers of an engine that contradict each other, or what was said of them, are refused by one sentence.
namespace gloam::scene::test::contradictions_test {

using Change = std::function<void(StoredInputs&)>;

// What an engine stores of the corner, and how that is read.
struct Row {
    const char* what;
    const char* expected;
    std::pair<const char*, const char*> stored{"linear", "view"};  // depth, normals
    std::pair<const char*, const char*> read{"linear", "view"};
    Change change = [](StoredInputs&) {};
};

Change each_normal(const std::function<glm::vec3(glm::vec3)>& change) {
    return [change](StoredInputs& stored) {
        for (glm::vec3& normal : stored.normal) normal = change(normal);
    };
}

const std::vector<Row> rows{
    {"as stored", ""},
    {"a depth buffer, as stored", "", {"buffer", "view"}, {"buffer", "view"}},
    {"world normals, as stored",
     "",
     {"linear", "world-octahedral-unorm"},
     {"linear", "world-octahedral-unorm"}},
    {"unorm, as stored", "", {"buffer", "view-unorm"}, {"buffer", "view-unorm"}},
    {"eye-linear depth read as a buffer", "from 0 to 1", {"linear", "view"}, {"buffer", "view"}},
    {"a depth buffer read as eye-linear", "--depth", {"buffer", "view"}},
    {"numbers of 0 to 1 read as they are", "another length", {"linear", "view-unorm"}},
    {"normals read as numbers of 0 to 1", "another length", {"linear", "view"}, {"linear", "view-unorm"}},
    {"octahedral normals read as vectors", "another length", {"linear", "view-octahedral"}},
    {"vectors read as octahedral normals", "30 degrees", {"linear", "view"}, {"linear", "view-octahedral"}},
    {"normals away from the eye", "face away", {}, {}, each_normal([](glm::vec3 n) { return -n; })},
    {"normals of 0", "another length", {}, {}, each_normal([](glm::vec3) { return glm::vec3(0); })},
    {"normals that are not numbers", "another length", {}, {}, each_normal([](glm::vec3) {
         return glm::vec3(nan);
     })},
    {"normals of another length", "another length", {}, {}, each_normal([](glm::vec3 n) {
         return 255.0F * n;
     })},
    {"the axes of another view space", "normals", {}, {}, each_normal([](glm::vec3 n) {
         return glm::vec3(n.z, n.x, n.y);
     })},
    {"depth in centimetres",
     "planes",
     {},
     {},
     [](StoredInputs& s) {
         for (float& d : s.depth) d *= 1e5F;
     }},
    {"one wrong pixel in ten",
     "",
     {},
     {},
     [](StoredInputs& s) {
         for (std::size_t i = 0; i < s.normal.size(); i += 10) s.normal[i] = glm::vec3(0);
     }},
};

TEST(Contradictions, OfEncodingsAndBuffersAreNamed) {
    const auto named = [](const std::pair<const char*, const char*>& names) {
        return names.first == nullptr ? Encoding{} : encoding_named(names.first, names.second);
    };
    for (const Row& row : rows) {
        GBuffer written = floor_and_wall();
        StoredInputs stored = stored_inputs(written, named(row.stored));
        row.change(stored);
        written.depth = stored.depth;
        written.normal = stored.normal;
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

TEST(Contradictions, ARadiusFitsTheScene) {
    for (const Projection projection : projections) {
        const GBuffer view = floor_and_wall(projection);
        EXPECT_EQ(radius_out_of_proportion(view, 1.0), "");
        EXPECT_THAT(radius_out_of_proportion(view, 1e6), HasSubstr("radius 1e+06"));
        EXPECT_THAT(radius_out_of_proportion(view, 1e-6), HasSubstr("below a pixel"));
    }
}

}  // namespace gloam::scene::test::contradictions_test
