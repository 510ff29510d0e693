// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <nlohmann/json.hpp>

#include "scene/image_files.hpp"
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
    EXPECT_EQ(got.extent, want.extent);
    EXPECT_EQ(got.depth, want.depth);
    EXPECT_EQ(got.normal, want.normal);
    EXPECT_EQ(got.motion, want.motion);
    EXPECT_EQ(got.camera.view, want.camera.view);
    EXPECT_EQ(got.camera.proj_vk, want.camera.proj_vk);
    EXPECT_EQ(got.camera.previous_view, want.camera.previous_view);
    EXPECT_EQ(got.ao_radius, want.ao_radius);
    EXPECT_EQ(got.border, want.border);
}

using GBufferTest = InFolder;

TEST_F(GBufferTest, WhatIsWrittenIsRead) {
    int frame = 0;
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const bool reversed : {false, true}) {
            GBuffer gbuffer = example({.eye = {1, 2, 3}, .projection = projection, .reversed_z = reversed});
            if (reversed)
                gbuffer.border =
                    projection == Projection::perspective ? Border(gpu::Extent{1, 0}) : Border(0, 0, 2, 1);
            if (reversed) gbuffer.camera.previous_view = make_frame({.eye = {1, 2, 3.5}}, 1.5).view;
            write_frame(folder, frame, gbuffer);
            expect_same(read_gbuffer(folder.path(), frame), gbuffer);
            ++frame;
        }
    }
    EXPECT_EQ(frames_of(folder.path()), (std::vector{0, 1, 2, 3}));
}

// Images with the frame at a place of its own in them.
TEST_F(GBufferTest, AViewportIsTheFrameAlone) {
    GBuffer images = example();
    images.previous_depth = images.depth;
    const GBuffer frame = images;
    for (const glm::ivec2& lacks : {glm::ivec2(3, 1), glm::ivec2(-1, -2)}) {
        images.off_centre = lacks;
        images = centred(std::move(images));
    }
    write_frame(folder, 0, images);
    json description = json::parse(frame_json(frame, 0));
    description.update({{"width", 7}, {"height", 5}, {"viewport", {3, 1, 3, 2}}});
    folder.write("f0000.json", description.dump());
    expect_same(read_gbuffer(folder.path(), 0), frame);
    EXPECT_EQ(read_gbuffer(folder.path(), 0).previous_depth, frame.previous_depth);
    folder.write("f0000_depth.pfm", pfm_text({3, 2}, frame.depth));
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); }, {"3x2", "expected 7x5"});
}

TEST_F(GBufferTest, InfiniteFarPlane) {
    for (const bool reversed : {false, true}) {
        const GBuffer gbuffer =
            example({.far = std::numeric_limits<double>::infinity(), .reversed_z = reversed});
        write_frame(folder, 7, gbuffer);
        expect_same(read_gbuffer(folder.path(), 7), gbuffer);
    }
}

TEST_F(GBufferTest, WithoutNormalsMotionAndRadius) {
    GBuffer gbuffer = example();
    gbuffer.normal.clear();
    gbuffer.motion.clear();
    gbuffer.ao_radius.reset();
    write_frame(folder, 0, gbuffer);
    expect_same(read_gbuffer(folder.path(), 0), gbuffer);
}

// A frame of one pixel, written by hand, with what `change` does to its description.
template <class Change>
GBuffer one_pixel(Change change) {
    const TemporaryDirectory folder;
    json description = json::parse(frame_json({.extent = {1, 1}, .camera = make_frame({}, 1.0)}, 0));
    change(description);
    folder.write("f0000.json", description.dump());
    folder.write("f0000_depth.pfm", "Pf\n1 1\n-1\n" + bytes({2.5F}, true));
    return read_gbuffer(folder.path(), 0);
}

void expect_close(const glm::mat4& got, const glm::mat4& want) {
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(got[i / 4][i % 4], want[i / 4][i % 4], 1e-6F) << i;
}

TEST_F(GBufferTest, EitherProjectionWillDo) {
    for (const Camera& camera :
         {Camera{}, Camera{.reversed_z = true}, Camera{.projection = Projection::orthographic}}) {
        const CameraFrame want = make_frame(camera, 1.0);
        const glm::dmat4 gl = gl_from_vk(want.proj_vk);
        const auto gbuffer = one_pixel([&](json& description) {
            description["camera"].erase("proj_vk");
            for (int i = 0; i < 16; ++i)
                description["camera"]["proj_gl"][static_cast<std::size_t>(i)] = gl[i / 4][i % 4];
        });
        expect_close(gbuffer.camera.proj_vk, want.proj_vk);
    }
}

TEST_F(GBufferTest, PlanesAndAngleWhenThereIsNoProjection) {
    const auto lens = [](json& description, const json& far) {
        json& camera = description["camera"];
        camera = {{"view", camera["view"]}, {"near", 0.25}, {"far", far}, {"fovy_rad", 1.1}, {"aspect", 1.0}};
    };
    const auto finite = one_pixel([&](json& description) { lens(description, 40.0); });
    expect_close(finite.camera.proj_vk,
                 make_frame({.fovy_rad = 1.1, .near = 0.25, .far = 40.0}, 1.0).proj_vk);
    // Beside a projection they are not looked at.
    const auto unused = one_pixel([](json& description) { description["camera"]["near"] = -5; });
    expect_close(unused.camera.proj_vk, make_frame({}, 1.0).proj_vk);
}

TEST_F(GBufferTest, OptionalKeys) {
    const auto without = one_pixel([](json& description) {
        description["camera"]["prev_view"] = nullptr;
        description["unknown"] = {{"key", "is ignored"}};
        description.erase("frame");
    });
    EXPECT_FALSE(without.camera.previous_view);
    EXPECT_FALSE(without.ao_radius);
    EXPECT_EQ(without.depth, std::vector{2.5F});
}

TEST_F(GBufferTest, DepthThatIsNoneIsBackground) {
    GBuffer gbuffer = example();
    write_frame(folder, 0, gbuffer);
    folder.write("f0000_depth.pfm",
                 "Pf\n3 2\n-1\n" + bytes({0.0F, -0.0F, -1.0F, nan, 3.0F, -infinity}, true));
    const GBuffer read = read_gbuffer(folder.path(), 0);
    EXPECT_EQ(read.depth, (std::vector{infinity, 3.0F, infinity, infinity, infinity, infinity}));
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(read.normal[i] == glm::vec3(0), i != 1) << i;
}

TEST_F(GBufferTest, NormalsAreUnitOrZeroAndMotionFinite) {
    GBuffer gbuffer = example();
    gbuffer.depth.assign(6, 1.0F);
    gbuffer.normal = {{0, 0, 1.001F},   {nan, 0, 1},    {0, 0, 0},
                      {infinity, 0, 0}, {0, 0.999F, 0}, {0.6F, 0, 0.8F}};
    gbuffer.motion[1] = {nan, 0, 1};
    write_frame(folder, 0, gbuffer);
    const GBuffer read = read_gbuffer(folder.path(), 0);
    EXPECT_EQ(read.normal, (std::vector<glm::vec3>{
                               {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0.6F, 0, 0.8F}}));
    EXPECT_EQ(read.motion[0], gbuffer.motion[0]);
    EXPECT_EQ(read.motion[1], glm::vec3(0));
}

TEST_F(GBufferTest, FramesAreFoundByName) {
    for (const char* name : {"f0010.json", "f0002.json", "f0003_depth.pfm", "f12.json", "f00001.json",
                             "xf0001.json", "f0004.json.part"})
        folder.write(name, "{}");
    EXPECT_EQ(frames_of(folder.path()), (std::vector{2, 10}));
}

const std::string depth_2x1 = "Pf\n2 1\n-1\n" + bytes({1.0F, 2.0F}, true);

// A folder with a frame 0 of 2 x 1 pixels that can be read.
class GBufferError : public InFolder {
  protected:
    GBufferError() {
        folder.write("f0000.json", description().dump());
        folder.write("f0000_depth.pfm", depth_2x1);
        (void)read_gbuffer(folder.path(), 0);
    }

    static json description() {
        return json::parse(frame_json({.extent = {2, 1}, .camera = make_frame({}, 2.0)}, 0));
    }

    void expect(std::initializer_list<std::string> parts) const {
        expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); }, parts);
    }

    // The error of a description that was changed at a place.
    void expect_json(const char* pointer, const json& value, std::initializer_list<std::string> parts) const {
        SCOPED_TRACE(std::string(pointer) + " = " + value.dump());
        json changed = description();
        changed[json::json_pointer(pointer)] = value;
        folder.write("f0000.json", changed.dump());
        expect(parts);
    }
};

TEST_F(GBufferError, MissingFiles) {
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 1); }, {"f0001.json"});
    fs::remove(folder.path() / "f0000_depth.pfm");
    expect({"f0000_depth.pfm", "missing"});
    expect_error<std::runtime_error>([&] { (void)frames_of(folder.path() / "none"); }, {"none"});
    const TemporaryDirectory empty;
    expect_error<std::runtime_error>([&] { (void)frames_of(empty.path()); },
                                     {empty.path().c_str(), "f0000.json"});
}

TEST_F(GBufferError, FrameNumbers) {
    for (const int frame : {-1, 10000})
        expect_error<std::invalid_argument>([&] { (void)read_gbuffer(folder.path(), frame); },
                                            {"frame", "9999"});
}

TEST_F(GBufferError, SizesThatDisagree) {
    folder.write("f0000_depth.pfm", "Pf\n1 2\n-1\n" + bytes({1.0F, 2.0F}, true));
    expect({"f0000_depth.pfm", "1x2", "expected 2x1"});
    folder.write("f0000_depth.pfm", depth_2x1);
    folder.write("f0000_normal.pfm", "PF\n1 1\n-1\n" + bytes({0, 0, 1}, true));
    expect({"f0000_normal.pfm", "1x1", "expected 2x1"});
    folder.write("f0000_normal.pfm", depth_2x1);
    expect({"f0000_normal.pfm", "1 channel", "3 channels"});
}

TEST_F(GBufferError, CutShort) {
    folder.write("f0000_depth.pfm", depth_2x1.substr(0, depth_2x1.size() - 1));
    expect({"f0000_depth.pfm", "cut short"});
}

TEST_F(GBufferError, BothKindsOffered) {
    folder.write("f0000_depth.exr", "anything");
    expect({"f0000_depth.pfm", "f0000_depth.exr"});
}

TEST_F(GBufferError, MalformedJson) {
    for (const char* text :
         {"", "{", "[1, 2]", "null", "{\"width\": 2, \"height\": 1}", "{\"width\": }", "\x01\xff"}) {
        SCOPED_TRACE(text);
        folder.write("f0000.json", text);
        expect({"f0000.json"});
    }
}

TEST_F(GBufferError, WrongValues) {
    for (const json& bad :
         {json(0), json(-3), json(2.5), json("2"), json(nullptr), json(1e300), json(4294967298.0)})
        expect_json("/width", bad, {"f0000.json", "width"});
    for (const json& bad : {json(0), json(-0.5), json("wide")})
        expect_json("/ao_radius", bad, {"f0000.json", "ao_radius"});
    for (const json& bad : {json(1), json({1, 0}), json({0, -1}), json({0.5, 0}), json({0, 0, 0}),
                            json({1, 0, 1, 0}), json({0, 0, 0, 1})})
        expect_json("/border", bad, {"f0000.json", "border"});
    for (const json& bad : {json(1), json({0, 0, 2}), json({0, 0, 0, 1}), json({0, 0, 2, 0}),
                            json({1, 0, 2, 1}), json({0, 1, 2, 1}), json({-1, 0, 1, 1}), json({0.5, 0, 1, 1}),
                            json({0, 0, "2", 1}), json({0, 0, 2, 1, 0}), json({65537, 0, 1, 1})})
        expect_json("/viewport", bad, {"f0000.json", "viewport", "within 2 x 1"});
    expect_json("/camera", 5, {"f0000.json", "camera"});
    expect_json("/camera/view", nullptr, {"f0000.json", "view"});
    expect_json("/camera/view", json::array({1, 2, 3}), {"f0000.json", "view", "16"});
    expect_json("/camera/view/5", "one", {"f0000.json", "view", "one"});
    expect_json("/camera/prev_view", 3, {"f0000.json", "prev_view"});
}

TEST_F(GBufferError, MatricesThatCannotBeInverted) {
    const json zero = std::vector<double>(16, 0.0);
    // Columns in one plane up to rounding: the determinant is not exactly 0.
    const json flat{0.1, 0.2, 0.3, 0, 0.7, 0.8, 0.9, 0, 0.1 + 0.7, 0.2 + 0.8, 0.3 + 0.9, 0, 0, 0, 0, 1};
    const json huge{1e200, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    for (const char* key : {"view", "prev_view", "proj_vk"}) {
        for (const json& bad : {zero, flat, huge})
            expect_json(("/camera/" + std::string(key)).c_str(), bad, {"f0000.json", key, "inverted"});
    }
}

TEST_F(GBufferError, ProjectionsOfAnotherKind) {
    expect_json("/camera/proj_vk/8", 1e5, {"f0000.json", "off centre", "expected at most 32768"});
    for (const char* element : {"/camera/proj_vk/4", "/camera/proj_vk/2", "/camera/proj_vk/6"})
        expect_json(element, 0.5, {"f0000.json", "skew"});
    expect_json("/camera/proj_vk/11", 1.0, {"f0000.json", "perspective or orthographic"});
}

TEST_F(GBufferError, NeitherProjectionNorPlanes) {
    json changed = description();
    changed["camera"] = {{"view", changed["camera"]["view"]}, {"near", 0.1}, {"far", 10}, {"aspect", 2}};
    folder.write("f0000.json", changed.dump());
    expect({"f0000.json", "fovy_rad"});
    changed["camera"]["fovy_rad"] = 4.0;
    folder.write("f0000.json", changed.dump());
    expect({"f0000.json", "field of view"});
}

namespace fs = std::filesystem;

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

// Values that half precision holds.
const std::vector<float> six{1.0F, -0.5F, 2048.0F, 0.25F, 65504.0F, 0x1p-24F};

using Exr = InFolder;

TEST_F(Exr, FloatAndHalf) {
    const fs::path file = folder.path() / "a.exr";
    for (const auto type : {Imf::FLOAT, Imf::HALF}) {
        for (const char* name : {"Y", "R"}) {
            write_exr(file, 3, 2, {name}, six, type);
            const auto image = read_exr(file, 1);
            EXPECT_EQ(image.width, 3U);
            EXPECT_EQ(image.height, 2U);
            EXPECT_EQ(image.channels, 1);
            EXPECT_EQ(image.texels, six);
        }
        write_exr(file, 1, 2, {"R", "G", "B"}, six, type);
        const auto image = read_exr(file, 3);
        EXPECT_EQ(image.width, 1U);
        EXPECT_EQ(image.height, 2U);
        EXPECT_EQ(image.channels, 3);
        EXPECT_EQ(image.texels, six);
    }
}

TEST_F(Exr, FloatKeepsEveryBit) {
    const fs::path file = folder.path() / "a.exr";
    const std::vector<float> values{0.1F, -0.0F, 0x1.fffffep127F, 0x1p-149F};
    write_exr(file, 2, 2, {"Y"}, values);
    EXPECT_EQ(bits(read_exr(file, 1).texels), bits(values));
}

TEST_F(Exr, AWindowAwayFromTheOrigin) {
    const fs::path file = folder.path() / "a.exr";
    for (const Imath::V2i& origin : {Imath::V2i(100, 50), Imath::V2i(-7, -3)}) {
        write_exr(file, 2, 3, {"Y"}, six, Imf::FLOAT, origin);
        EXPECT_EQ(read_exr(file, 1).texels, six);
    }
}

TEST_F(Exr, OtherChannelsAreNotRead) {
    const fs::path file = folder.path() / "a.exr";
    write_exr(file, 1, 1, {"A", "R", "G", "B"}, {9, 1, 2, 3});
    EXPECT_EQ(read_exr(file, 3).texels, (std::vector<float>{1, 2, 3}));
}

TEST_F(Exr, WhatIsMissing) {
    const fs::path file = folder.path() / "a.exr";
    write_exr(file, 1, 1, {"Q", "S"}, {1, 2});
    expect_error<std::runtime_error>([&] { (void)read_exr(file, 1); }, {"a.exr", "expected", "Q, S"});
    expect_error<std::runtime_error>([&] { (void)read_exr(file, 3); }, {"a.exr", "R, G, B", "Q, S"});
    expect_error<std::runtime_error>([&] { (void)read_exr(folder.path() / "none.exr", 1); }, {"none.exr"});
}

TEST_F(Exr, Damaged) {
    const fs::path file = folder.path() / "a.exr";
    write_exr(file, 64, 64, {"Y"}, std::vector<float>(64 * 64, 0.5F));
    const std::string whole = read_file(file);
    for (const std::size_t length : {std::size_t{0}, std::size_t{3}, std::size_t{40}, whole.size() / 2}) {
        const auto cut = folder.write("cut.exr", whole.substr(0, length));
        expect_error<std::runtime_error>([&] { (void)read_exr(cut, 1); }, {"cut.exr"});
    }
    const auto text = folder.write("text.exr", "this is no image at all\n");
    expect_error<std::runtime_error>([&] { (void)read_exr(text, 1); }, {"text.exr"});
}

}  // namespace gloam::scene::test::gbuffer_test
