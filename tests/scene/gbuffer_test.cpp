// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::gbuffer_test {

using nlohmann::json;

namespace fs = std::filesystem;

// 3 x 2; the third pixel is background.
GBuffer example(const Camera& camera = {}) {
    GBuffer gbuffer{.extent = {3, 2},
                    .depth = {0.1F, 2.0F, infinity, 4.0F, 5.0F, 6e30F},
                    .normal = {6, glm::normalize(glm::vec3(0.3F, -0.2F, 0.9F))},
                    .motion = {6, {0.25F, -3.5F, 1.0F}},
                    .camera = make_frame(camera, 1.5),
                    .ao_radius = 0.3};
    gbuffer.normal[2] = glm::vec3(0);
    return gbuffer;
}

void expect_same(const GBuffer& got, const GBuffer& want) {
    EXPECT_EQ(frame_json(got, 0), frame_json(want, 0));
    EXPECT_EQ(got.depth, want.depth);
    EXPECT_EQ(got.normal, want.normal);
    EXPECT_EQ(got.motion, want.motion);
    EXPECT_EQ(got.layers, want.layers);
    EXPECT_EQ(got.ao_radius, want.ao_radius);
    EXPECT_EQ(got.border, want.border);
    EXPECT_EQ(got.camera.view, want.camera.view);
    EXPECT_EQ(got.camera.proj_vk, want.camera.proj_vk);
}

using GBufferTest = InFolder;

TEST_F(GBufferTest, WhatIsWrittenIsRead) {
    std::vector<GBuffer> frames;
    for (const Projection projection : projections) {
        frames.push_back(example({.eye = {1, 2, 3}, .projection = projection}));
        frames.push_back(example({.eye = {1, 2, 3}, .projection = projection, .reversed_z = true}));
        frames.back().border =
            projection == Projection::perspective ? Border(backend::Extent{1, 0}) : Border(0, 0, 2, 1);
        frames.back().camera.previous_view = make_frame({.eye = {1, 2, 3.5}}, 1.5).view;
    }
    for (const bool reversed : {false, true})
        frames.push_back(example({.far = double{infinity}, .reversed_z = reversed}));
    frames.push_back({.extent = {3, 2}, .depth = example().depth, .camera = make_frame({}, 1.5)});
    frames.push_back(example());
    frames.back().layers = {{-2, 3, infinity, 4, 5, 6}, {5, 6, 7, 8, 9, 10}};
    std::vector<int> numbers;
    for (int i = 0; i < static_cast<int>(frames.size()); ++i) {
        write_frame(folder, i, frames.at(static_cast<std::size_t>(i)));
        expect_same(read_gbuffer(folder.path(), i), frames.at(static_cast<std::size_t>(i)));
        numbers.push_back(i);
    }
    for (const char* name : {"f0010_depth.pfm", "f12.json", "f00001.json", "xf0001.json", "f0004.json.part"})
        folder.write(name, "{}");
    EXPECT_EQ(frames_of(folder.path()), numbers);
}

// A frame of one pixel by that camera, with a change of its description, in which null removes a key.
GBuffer one_pixel(const Camera& camera, const char* change) {
    const TemporaryDirectory folder;
    const GBuffer view{.extent = {1, 1}, .depth = {2.5F}, .camera = make_frame(camera, 1.0)};
    write_frame(folder, 0, view);
    json description = json::parse(frame_json(view, 0));
    description.merge_patch(json::parse(change));
    folder.write("f0000.json", description.dump());
    return read_gbuffer(folder.path(), 0);
}

void expect_close(const glm::mat4& got, const glm::mat4& want) {
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(got[i / 4][i % 4], want[i / 4][i % 4], 1e-6F) << i;
}

TEST_F(GBufferTest, EitherProjectionWillDoOrPlanesAndAngle) {
    for (const Camera& camera :
         {Camera{}, Camera{.reversed_z = true}, Camera{.projection = Projection::orthographic}})
        expect_close(one_pixel(camera, R"({"camera": {"proj_vk": null}})").camera.proj_vk,
                     make_frame(camera, 1.0).proj_vk);
    const GBuffer lens =
        one_pixel({}, R"({"camera": {"proj_vk": null, "proj_gl": null, "near": 0.25, "far": 40,
                                                      "fovy_rad": 1.1, "aspect": 1}})");
    expect_close(lens.camera.proj_vk, make_frame({.fovy_rad = 1.1, .near = 0.25, .far = 40.0}, 1.0).proj_vk);
    // Beside a projection they are not looked at, nor are keys that are not known.
    const GBuffer unused =
        one_pixel({}, R"({"camera": {"near": -5}, "unknown": {"key": "is ignored"}, "frame": null})");
    expect_close(unused.camera.proj_vk, make_frame({}, 1.0).proj_vk);
    EXPECT_FALSE(unused.camera.previous_view || unused.ao_radius);
}

// tests/examples/mirror.py has perspective cameras, with vectors and world normals.
TEST_F(GBufferTest, LeftHandedViewsAreRightHandedOnesMirrored) {
    for (const char* normals : {"view-unorm", "view-octahedral", "view-octahedral-unorm"}) {
        SCOPED_TRACE(normals);
        const Encoding encoding = encoding_named("linear", normals);
        const auto read = [&](GBuffer view) {
            view.normal = stored_inputs(view, encoding).normal;
            write_frame(folder, 0, view);
            return read_gbuffer(folder.path(), 0, encoding);
        };
        GBuffer view = example({.eye = {1, 2, 3}, .projection = Projection::orthographic});
        view.normal = {{0, 0, 1}, {0.6F, 0, 0.8F}, {0, -0.6F, 0.8F}, {0, 0, 1}, {0, 0.8F, 0.6F}, {1, 0, 0}};
        const GBuffer want = read(view);
        glm::mat4 mirror(1.0F);
        mirror[2][2] = -1.0F;
        view.camera.view = mirror * view.camera.view;
        view.camera.proj_vk = view.camera.proj_vk * mirror;
        for (glm::vec3& n : view.normal) n.z = -n.z;
        const GBuffer got = read(view);
        EXPECT_EQ(got.camera.view, want.camera.view);
        EXPECT_EQ(got.camera.proj_vk, want.camera.proj_vk);
        for (std::size_t i = 0; i < view.depth.size(); ++i)
            EXPECT_LT(glm::distance(got.normal[i], want.normal[i]), 1e-6F) << i;
    }
}

TEST_F(GBufferTest, ValuesThatAreNoneAreBackgroundOrNoDirectionOrNoHistory) {
    GBuffer gbuffer = example();
    gbuffer.depth = {0.0F, -0.0F, -1.0F, nan, 3.0F, -infinity};
    gbuffer.layers = {{-2, 0, nan, infinity, -infinity, 7}};
    write_frame(folder, 0, gbuffer);
    const GBuffer read = read_gbuffer(folder.path(), 0);
    EXPECT_EQ(read.depth, (std::vector{infinity, infinity, infinity, infinity, 3.0F, infinity}));
    EXPECT_EQ(read.layers[0], (std::vector{-2.0F, infinity, infinity, infinity, infinity, 7.0F}));
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(read.normal[i] == glm::vec3(0), i != 4) << i;

    gbuffer.depth.assign(6, 1.0F);
    gbuffer.normal = {{0, 0, 1.001F},   {nan, 0, 1},    {0, 0, 0},
                      {infinity, 0, 0}, {0, 0.999F, 0}, {0.6F, 0, 0.8F}};
    gbuffer.motion[1] = {nan, 0, 1};
    write_frame(folder, 1, gbuffer);
    const GBuffer others = read_gbuffer(folder.path(), 1);
    EXPECT_EQ(others.normal, (std::vector<glm::vec3>{
                                 {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0.6F, 0, 0.8F}}));
    EXPECT_EQ(others.motion[0], gbuffer.motion[0]);
    EXPECT_EQ(others.motion[1], glm::vec3(0));
}

// A folder with a frame 0 of 2 x 1 pixels that can be read.
class GBufferError : public InFolder {
  protected:
    GBufferError() {
        write_frame(folder, 0, view);
        (void)read_gbuffer(folder.path(), 0);
    }

    void expect(std::initializer_list<std::string> parts) const {
        expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); }, parts);
    }

    const GBuffer view{.extent = {2, 1}, .depth = {1, 2}, .camera = make_frame({}, 2.0)};
    const json description = json::parse(frame_json(view, 0));
};

TEST_F(GBufferError, Folders) {
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 1); }, {"f0001.json"});
    const TemporaryDirectory empty;
    expect_error<std::runtime_error>([&] { (void)frames_of(empty.path()); },
                                     {empty.path().c_str(), "f0000.json"});
    for (const int frame : {-1, 10000})
        expect_error<std::invalid_argument>([&] { (void)read_gbuffer(folder.path(), frame); },
                                            {"frame", "9999"});
    fs::remove(folder.path() / "f0000_depth.pfm");
    expect({"f0000_depth.pfm", "missing"});
}

TEST_F(GBufferError, Files) {
    struct Row {
        const char* file;
        std::string text;
        std::array<std::string, 2> parts{};
    };
    const std::string good = pfm_text({2, 1}, {1, 2});
    const std::vector<Row> rows{{"f0000_depth.pfm", pfm_text({1, 2}, {1, 2}), {"1x2", "expected 2x1"}},
                                {"f0000_depth.pfm", good.substr(0, good.size() - 1), {"cut short"}},
                                {"f0000_depth.exr", "anything", {"f0000_depth.pfm"}},
                                {"f0000_normal.pfm", pfm_text({1, 1}, {0, 0, 1}), {"1x1", "expected 2x1"}},
                                {"f0000_normal.pfm", good, {"1 channel", "3 channels"}},
                                {"f0000_previous_depth.pfm", good, {"motion"}},
                                {"f0000_layer2.pfm", good, {"the layer before it"}},
                                {"f0000.json", ""},
                                {"f0000.json", "{"},
                                {"f0000.json", "[1, 2]"},
                                {"f0000.json", "null"},
                                {"f0000.json", R"({"width": 2, "height": 1})"},
                                {"f0000.json", "\x01\xff"}};
    for (const Row& row : rows) {
        SCOPED_TRACE(row.file + (": " + row.text));
        folder.write(row.file, row.text);
        expect({row.file, row.parts[0], row.parts[1]});
        fs::remove(folder.path() / row.file);
        write_frame(folder, 0, view);
    }
}

// A key, values that it may not have, and parts of the message. ZERO, FLAT and HUGE are matrices without an
// inverse; the columns of FLAT are in one plane up to rounding. LENS is a camera without a projection.
constexpr const char* wrong_descriptions = R"json([
["/width", [0, -3, 2.5, "2", null, 1e300, 4294967298.0], "width"],
["/ao_radius", [0, -0.5, "wide"], "ao_radius"],
["/border", [1, [1, 0], [0, -1], [0.5, 0], [0, 0, 0], [1, 0, 1, 0], [0, 0, 0, 1]], "border"],
["/viewport", [1, [0, 0, 2], [0, 0, 0, 1], [0, 0, 2, 0], [1, 0, 2, 1], [0, 1, 2, 1], [-1, 0, 1, 1], [0.5, 0, 1, 1],
 [0, 0, "2", 1], [0, 0, 2, 1, 0], [65537, 0, 1, 1]], "viewport", "within 2 x 1"],
["/camera", [5], "camera"],
["/camera", [{"view": VIEW, "near": 0.1, "far": 10, "aspect": 2}], "fovy_rad"],
["/camera", [{"view": VIEW, "near": 0.1, "far": 10, "aspect": 2, "fovy_rad": 4.0}], "field of view"],
["/camera/view", [null], "view"], ["/camera/view", [[1, 2, 3]], "view", "16"],
["/camera/view/5", ["one"], "view", "one"], ["/camera/prev_view", [3], "prev_view"],
["/camera/view", [ZERO, FLAT, HUGE], "view", "inverted"],
["/camera/prev_view", [ZERO, FLAT, HUGE], "prev_view", "inverted"],
["/camera/proj_vk", [ZERO, FLAT, HUGE], "proj_vk", "inverted"],
["/camera/proj_vk/8", [1e5], "off centre", "expected at most 32768"],
["/camera/proj_vk/4", [0.5], "skew"], ["/camera/proj_vk/2", [0.5], "skew"], ["/camera/proj_vk/6", [0.5], "skew"],
["/camera/proj_vk", [LENS_BY_ROWS, BOX_BY_ROWS], "proj_vk", "row by row"],
["/camera/view", [BY_ROWS], "view", "row by row"], ["/camera/prev_view", [BY_ROWS], "prev_view", "row by row"],
["/camera/proj_vk/11", [1.0, -2.0], "perspective or orthographic"]])json";

TEST_F(GBufferError, Descriptions) {
    std::string text = wrong_descriptions;
    for (const auto& [name, matrix] :
         {std::pair{"VIEW", description["camera"]["view"].dump()},
          {"ZERO", "[0,0,0,0, 0,0,0,0, 0,0,0,0, 0,0,0,0]"},
          {"FLAT", "[0.1,0.2,0.3,0, 0.7,0.8,0.9,0, 0.7999999999999999,1,1.2,0, 0,0,0,1]"},
          {"HUGE", "[1e200,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]"},
          {"LENS_BY_ROWS", "[1,0,0.5,0, 0,-2,0,0, 0,0,0,1, 0,0,-1,0]"},
          {"BOX_BY_ROWS", "[1,0,0,0, 0,-2,0,0, 0,0,0.01,-0.1, 0,0,0,1]"},
          {"BY_ROWS", "[0,1,0,5, 1,0,0,0, 0,0,-1,2, 0,0,0,1]"}})
        text = base::replaced(text, name, matrix);
    for (const json& row : json::parse(text)) {
        for (const json& value : row[1]) {
            SCOPED_TRACE(row.dump() + value.dump());
            json changed = description;
            changed[json::json_pointer(row[0].get<std::string>())] = value;
            folder.write("f0000.json", changed.dump());
            expect({"f0000.json", row[2], row.size() > 3 ? row[3] : row[2]});
        }
    }
}

// Writes `names.size()` channels, interleaved in `texels`, rows from the top, in a window that begins at
// `origin`.
void write_exr(const fs::path& file, int width, int height, const std::vector<const char*>& names,
               std::vector<float> texels, Imf::PixelType type = Imf::FLOAT, Imath::V2i origin = {0, 0}) {
    const Imath::Box2i window(origin, origin + Imath::V2i(width - 1, height - 1));
    Imf::Header header(window, window);
    std::vector<half> halves(texels.begin(), texels.end());
    const std::size_t bytes = type == Imf::HALF ? sizeof(half) : sizeof(float);
    char* data =
        type == Imf::HALF ? reinterpret_cast<char*>(halves.data()) : reinterpret_cast<char*>(texels.data());
    Imf::FrameBuffer frame;
    const std::size_t pixel = names.size() * bytes;
    for (std::size_t i = 0; i < names.size(); ++i) {
        header.channels().insert(names[i], Imf::Channel(type));
        frame.insert(names[i], Imf::Slice::Make(type, data + i * bytes, window, pixel,
                                                pixel * static_cast<std::size_t>(width)));
    }
    Imf::OutputFile output(file.c_str(), header);
    output.setFrameBuffer(frame);
    output.writePixels(height);
}

using Exr = InFolder;

// Float and half, a window away from the origin, other channels beside those that are read.
TEST_F(Exr, AreReadToTheBit) {
    struct Row {
        int width;
        int height;
        std::vector<const char*> names;
        std::vector<float> texels;
        Imf::PixelType type = Imf::FLOAT;
        Imath::V2i origin{0, 0};
    };
    const std::vector<float> six{1.0F, -0.5F, 2048.0F, 0.25F, 65504.0F, 0x1p-24F};  // halves hold them
    const std::vector<Row> rows{{3, 2, {"Y"}, six},
                                {3, 2, {"R"}, six, Imf::HALF},
                                {1, 2, {"R", "G", "B"}, six},
                                {1, 2, {"X", "Y", "Z"}, six, Imf::HALF},
                                {2, 2, {"Y"}, {0.1F, -0.0F, 0x1.fffffep127F, 0x1p-149F}},
                                {2, 3, {"depth"}, six, Imf::FLOAT, {100, 50}},
                                {2, 3, {"own"}, six, Imf::FLOAT, {-7, -3}}};
    for (const Row& row : rows) {
        SCOPED_TRACE(row.names.front());
        write_exr(path("a.exr"), row.width, row.height, row.names, row.texels, row.type, row.origin);
        const auto image = read_exr(path("a.exr"), static_cast<int>(row.names.size()));
        EXPECT_EQ((std::pair<int, int>(image.width, image.height)), std::pair(row.width, row.height));
        EXPECT_EQ(bits(image.texels), bits(row.texels));
    }
    write_exr(path("a.exr"), 1, 1, {"A", "R", "G", "B"}, {9, 1, 2, 3});
    EXPECT_EQ(read_exr(path("a.exr"), 3).texels, (std::vector<float>{1, 2, 3}));
}

TEST_F(Exr, ThatCannotBeRead) {
    const auto expect = [&](const char* name, int channels, std::initializer_list<std::string> parts) {
        expect_error<std::runtime_error>([&] { (void)read_exr(path(name), channels); }, parts);
    };
    write_exr(path("a.exr"), 1, 1, {"Q", "S"}, {1, 2});
    expect("a.exr", 1, {"a.exr", "expected", "Q, S"});
    expect("a.exr", 3, {"a.exr", "R, G, B", "Q, S"});
    expect("none.exr", 1, {"none.exr"});
    write_exr(path("b.exr"), 64, 64, {"Y"}, std::vector<float>(64 * 64, 0.5F));
    const std::string whole = read_file(path("b.exr"));
    for (const std::string& text :
         {std::string("this is no image at all\n"), std::string(), whole.substr(0, 3), whole.substr(0, 40),
          whole.substr(0, whole.size() / 2)}) {
        folder.write("cut.exr", text);
        expect("cut.exr", 1, {"cut.exr"});
    }
}

}  // namespace gloam::scene::test::gbuffer_test
