// SPDX-License-Identifier: MIT
#include <limits>
#include <nlohmann/json.hpp>

#include "scene/frame_files.hpp"

namespace gloam::scene::test {
namespace gbuffer_error_test {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string depth_2x1 = "Pf\n2 1\n-1\n" + bytes({1.0F, 2.0F}, true);

// A folder with a frame 0 of 2 x 1 pixels that can be read.
class GBufferError : public ::testing::Test {
  protected:
    GBufferError() {
        (void)folder.write("f0000.json", description().dump());
        (void)folder.write("f0000_depth.pfm", depth_2x1);
        (void)read_gbuffer(folder.path(), 0);
    }

    static json description() {
        return json::parse(frame_json({.extent = {2, 1}, .camera = make_frame({}, 2.0)}, 0));
    }

    void expect(std::initializer_list<const char*> parts) const {
        expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); }, parts);
    }

    // The error of a description that was changed at a place.
    void expect_json(const char* pointer, const json& value, std::initializer_list<const char*> parts) const {
        SCOPED_TRACE(std::string(pointer) + " = " + value.dump());
        json changed = description();
        changed[json::json_pointer(pointer)] = value;
        (void)folder.write("f0000.json", changed.dump());
        expect(parts);
    }

    Folder folder;
};

TEST_F(GBufferError, MissingFiles) {
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 1); }, {"f0001.json"});
    fs::remove(folder.path() / "f0000_depth.pfm");
    expect({"f0000_depth.pfm", "missing"});
    expect_error<std::runtime_error>([&] { (void)frames_of(folder.path() / "none"); }, {"none"});
    const Folder empty;
    expect_error<std::runtime_error>([&] { (void)frames_of(empty.path()); },
                                     {empty.path().c_str(), "f0000.json"});
}

TEST_F(GBufferError, FrameNumbers) {
    for (const int frame : {-1, 10000})
        expect_error<std::invalid_argument>([&] { (void)read_gbuffer(folder.path(), frame); },
                                            {"frame", "9999"});
}

TEST_F(GBufferError, SizesThatDisagree) {
    (void)folder.write("f0000_depth.pfm", "Pf\n1 2\n-1\n" + bytes({1.0F, 2.0F}, true));
    expect({"f0000_depth.pfm", "1x2", "expected 2x1"});
    (void)folder.write("f0000_depth.pfm", depth_2x1);
    (void)folder.write("f0000_normal.pfm", "PF\n1 1\n-1\n" + bytes({0, 0, 1}, true));
    expect({"f0000_normal.pfm", "1x1", "expected 2x1"});
    (void)folder.write("f0000_normal.pfm", depth_2x1);
    expect({"f0000_normal.pfm", "1 channel", "3 channels"});
}

TEST_F(GBufferError, CutShort) {
    (void)folder.write("f0000_depth.pfm", depth_2x1.substr(0, depth_2x1.size() - 1));
    expect({"f0000_depth.pfm", "cut short"});
}

TEST_F(GBufferError, BothKindsOffered) {
    (void)folder.write("f0000_depth.exr", "anything");
    expect({"f0000_depth.pfm", "f0000_depth.exr"});
}

TEST_F(GBufferError, MalformedJson) {
    for (const char* text :
         {"", "{", "[1, 2]", "null", "{\"width\": 2, \"height\": 1}", "{\"width\": }", "\x01\xff"}) {
        SCOPED_TRACE(text);
        (void)folder.write("f0000.json", text);
        expect({"f0000.json"});
    }
}

TEST_F(GBufferError, WrongValues) {
    for (const json& bad :
         {json(0), json(-3), json(2.5), json("2"), json(nullptr), json(1e300), json(4294967298.0)})
        expect_json("/width", bad, {"f0000.json", "width"});
    for (const json& bad : {json(0), json(-0.5), json("wide")})
        expect_json("/ao_radius", bad, {"f0000.json", "ao_radius"});
    for (const json& bad : {json(1), json({1, 0}), json({0, -1}), json({0.5, 0}), json({0, 0, 0})})
        expect_json("/border", bad, {"f0000.json", "border"});
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

// The library knows symmetric perspective and orthographic projections only.
TEST_F(GBufferError, ProjectionsOfAnotherKind) {
    expect_json("/camera/proj_vk/8", 1.5, {"f0000.json", "off centre"});
    expect_json("/camera/proj_vk/4", 0.5, {"f0000.json", "skew"});
    expect_json("/camera/proj_vk/11", 1.0, {"f0000.json", "perspective or orthographic"});
}

TEST_F(GBufferError, NeitherProjectionNorPlanes) {
    json changed = description();
    changed["camera"] = {{"view", changed["camera"]["view"]}, {"near", 0.1}, {"far", 10}, {"aspect", 2}};
    (void)folder.write("f0000.json", changed.dump());
    expect({"f0000.json", "fovy_rad"});
    changed["camera"]["fovy_rad"] = 4.0;
    (void)folder.write("f0000.json", changed.dump());
    expect({"f0000.json", "field of view"});
}

}  // namespace gbuffer_error_test
}  // namespace gloam::scene::test
