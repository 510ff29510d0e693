// SPDX-License-Identifier: MIT
#include "scene/read_gbuffer.hpp"

#include <fmt/format.h>
#include <passes/frame/gloam_frame.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "base/text.hpp"
#include "base/version.hpp"

namespace gloam::scene {
namespace {

using nlohmann::json;

constexpr std::size_t longest_description = std::size_t{1} << 20;  // bytes
constexpr std::size_t longest_message = 300;
constexpr std::size_t longest_quote = 40;
constexpr double longest_side = 65536.0;  // pixels

// Throws without the file's name; read_frame_json adds it. found: instead of what was expected.
[[noreturn]] void refuse(const char* key, const std::string& what, const json* found = nullptr) {
    std::string text = fmt::format("\"{}\"{}", key, what);
    if (found != nullptr)
        text += ", found " +
                base::shortened(found->dump(-1, ' ', false, json::error_handler_t::replace), longest_quote);
    throw std::runtime_error(text);
}

// The value of a key; nullptr where it is missing or null.
const json* given(const json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() || found->is_null() ? nullptr : &*found;
}

double number(const json& object, const char* key) {
    const json* value = given(object, key);
    if (value == nullptr) refuse(key, " is missing, expected a number");
    if (!value->is_number()) refuse(key, ": expected a number", value);
    return value->get<double>();
}

// A list of whole pixels; empty if it is none.
std::vector<std::uint32_t> pixels_in(const json& list) {
    const auto whole = [](const json& value) {
        return value.is_number_unsigned() && value.get<double>() <= longest_side;
    };
    if (!list.is_array() || !std::ranges::all_of(list, whole)) return {};
    return list.get<std::vector<std::uint32_t>>();
}

std::uint32_t side(const json& object, const char* key) {
    const double value = number(object, key);
    if (!(value >= 1.0 && value <= longest_side && value == std::floor(value)))
        refuse(key, ": expected whole pixels from 1 to 65536", &object[key]);
    return static_cast<std::uint32_t>(value);
}

// Whether single precision holds the elements and the columns span a volume larger than rounding errors.
bool is_invertible(const glm::dmat4& matrix) {
    double box = 1.0;
    for (int column = 0; column < 4; ++column) {
        const double length = glm::length(matrix[column]);
        if (!(length <= std::numeric_limits<float>::max())) return false;
        box *= length;
    }
    return std::abs(glm::determinant(matrix)) > 1e-12 * box;
}

// A matrix with an inverse: sixteen numbers, column after column; nothing where the key is not given.
std::optional<glm::dmat4> matrix(const json& object, const char* key) {
    const json* values = given(object, key);
    if (values == nullptr) return std::nullopt;
    if (!values->is_array() || values->size() != 16) refuse(key, ": expected an array of 16 numbers");
    glm::dmat4 result(0.0);
    for (int i = 0; i < 16; ++i) {
        const json& value = (*values)[static_cast<std::size_t>(i)];
        if (!value.is_number()) refuse(key, ": expected 16 numbers", &value);
        result[i / 4][i % 4] = value.get<double>();
    }
    if (!is_invertible(result)) refuse(key, ": the matrix cannot be inverted");
    const bool projects = std::string_view(key).starts_with("proj");
    if (gloam_by_rows(&glm::mat4(result)[0][0], projects))
        refuse(key, ": the matrix is written row by row, expected column by column");
    return result;
}

glm::mat4 projection_from_planes(const json& camera) {
    if (given(camera, "fovy_rad") == nullptr)
        refuse("proj_vk", " is missing, expected a matrix, \"proj_gl\", or \"fovy_rad\" with its planes");
    const double fovy = number(camera, "fovy_rad");
    const double near = number(camera, "near");
    const double far = given(camera, "far") ? number(camera, "far") : std::numeric_limits<double>::infinity();
    return make_frame({.fovy_rad = fovy, .near = near, .far = far}, number(camera, "aspect")).proj_vk;
}

// What an image lacks to have the projection's axis in its middle (GBuffer::off_centre).
glm::dvec2 off_centre_of(const glm::mat4& projection, backend::Extent extent) {
    const bool orthographic = projection[2][3] == 0.0F;
    const glm::dvec4 offset(orthographic ? -projection[3] : projection[2]);
    const bool skewed = projection[0][1] != 0.0F || projection[1][0] != 0.0F || projection[0][2] != 0.0F ||
                        projection[1][2] != 0.0F;  // the last two: an oblique near plane
    const bool shape = projection[0][0] != 0.0F && projection[1][1] != 0.0F && !skewed;
    const bool in_front = projection[3][2] * (projection[2][2] + 0.5F) > 0.0F;  // the middle of its depths
    const bool kind = orthographic ? projection[3][3] == 1.0F : projection[2][3] == -1.0F && in_front;
    if (!shape || !kind) refuse("camera", ": expected a perspective or orthographic projection without skew");
    const glm::dvec2 lacks = glm::dvec2(offset) * glm::dvec2(extent.width, extent.height);
    if (std::abs(lacks.x) <= longest_side && std::abs(lacks.y) <= longest_side) return lacks;
    refuse("camera",
           fmt::format(": the projection is off centre by {:.4g} and {:.4g} pixels, expected at most {}",
                       0.5 * lacks.x, 0.5 * lacks.y, 0.5 * longest_side));
}

CameraFrame camera_of(const json& camera) {
    if (!camera.is_object()) refuse("camera", ": expected an object");
    const auto view = matrix(camera, "view");
    if (!view) refuse("view", " is missing, expected an array of 16 numbers");
    const auto vk = matrix(camera, "proj_vk");
    const auto gl = vk ? std::nullopt : matrix(camera, "proj_gl");
    using Single = std::optional<glm::mat4>;
    return {.view = glm::mat4(*view),
            .proj_vk = vk   ? glm::mat4(*vk)
                       : gl ? glm::mat4(vk_from_gl(*gl))
                            : projection_from_planes(camera),
            .previous_view = Single(matrix(camera, "prev_view")),
            .previous_from_current = Single(matrix(camera, "previous_from_current"))};
}

// Makes a left-handed camera right-handed (scale 1, 1, -1); tells whether it was left-handed.
bool turned(CameraFrame& camera) {
    if (!gloam_is_left(&camera.proj_vk[0][0])) return false;
    gloam_mirror(&camera.proj_vk[0][0], 0, 1);
    gloam_mirror(&camera.view[0][0], 1, 0);
    if (camera.previous_view) gloam_mirror(&(*camera.previous_view)[0][0], 1, 0);
    if (camera.previous_from_current) gloam_mirror(&(*camera.previous_from_current)[0][0], 1, 1);
    return true;
}

// Guard band: pixels on the left and right, and at top and bottom, or on each of the four sides.
Border border_of(const json& root, backend::Extent extent) {
    const json* given_border = given(root, "border");
    if (given_border == nullptr) return {};
    std::vector<std::uint32_t> n = pixels_in(*given_border);
    if (n.size() == 2) n.insert(n.end(), {n[0], n[1]});
    if (n.size() == 4 && n[0] + n[2] < extent.width && n[1] + n[3] < extent.height)
        return {n[0], n[1], n[2], n[3]};
    refuse("border", ": expected two or four whole numbers of pixels that leave a frame of at least one",
           given_border);
}

// What is around the viewport in an image.
Border around_viewport(const json& root, backend::Extent image) {
    const json* viewport = given(root, "viewport");
    if (viewport == nullptr) return {};
    const std::vector<std::uint32_t> n = pixels_in(*viewport);
    if (n.size() == 4 && n[2] > 0 && n[3] > 0 && n[0] + n[2] <= image.width && n[1] + n[3] <= image.height)
        return {n[0], n[1], image.width - n[0] - n[2], image.height - n[1] - n[3]};
    refuse("viewport",
           fmt::format(": expected [x, y, width, height], whole pixels within {} x {}", image.width,
                       image.height),
           viewport);
}

FrameDescription parse(const std::string& text) {
    base::require_bounded_json(text);
    const json root = json::parse(text);
    if (!root.is_object() || given(root, "camera") == nullptr)
        throw std::runtime_error("expected an object with \"camera\" in it");
    const backend::Extent image{side(root, "width"), side(root, "height")};
    const Border around = around_viewport(root, image);
    GBuffer view{.extent = frame_of({.extent = image, .border = around}),
                 .camera = camera_of(root["camera"])};
    const bool left_handed = turned(view.camera);
    const glm::dvec2 off_centre = off_centre_of(view.camera.proj_vk, view.extent);
    view.border = border_of(root, view.extent);
    const json* radius = given(root, "ao_radius");
    if (radius != nullptr) view.ao_radius = number(root, "ao_radius");
    if (radius != nullptr && !(*view.ao_radius > 0.0)) refuse("ao_radius", ": expected a length > 0", radius);
    return {view, around, off_centre, left_handed};
}

json to_json(const glm::dmat4& matrix) {
    json values = json::array();
    for (int i = 0; i < 16; ++i) values.push_back(matrix[i / 4][i % 4]);
    return values;
}

}  // namespace

FrameDescription read_frame_json(const std::filesystem::path& file) {
    const std::string text = base::read_file(file, longest_description);
    try {
        return parse(text);
    } catch (const json::exception& error) {
        // The parser's own message would quote the whole last token.
        throw std::runtime_error(file.string() +
                                 ": malformed JSON: " + base::shortened(error.what(), longest_message));
    } catch (const std::exception& error) {
        throw std::runtime_error(file.string() + ": " + error.what());
    }
}

std::string frame_json(const GBuffer& gbuffer, int frame) {
    const CameraFrame& camera = gbuffer.camera;
    const Planes planes = planes_of(camera.proj_vk);
    const glm::dvec2 scale = glm::abs(glm::dvec2(camera.p00_p11()));
    nlohmann::ordered_json root{{"gloam", base::version()},
                                {"width", gbuffer.extent.width},
                                {"height", gbuffer.extent.height},
                                {"frame", frame}};
    if (gbuffer.ao_radius) root["ao_radius"] = *gbuffer.ao_radius;
    const Border& border = gbuffer.border;
    if (border != Border(border.each_side()))
        root["border"] = {border.left, border.top, border.right, border.bottom};
    else if (border != Border{})
        root["border"] = {border.left, border.top};
    root["camera"] = {{"near", planes.near}, {"far", planes.far}};
    if (!camera.orthographic()) root["camera"]["fovy_rad"] = 2.0 * std::atan(1.0 / scale.y);
    root["camera"]["aspect"] = scale.y / scale.x;
    root["camera"]["view"] = to_json(camera.view);
    root["camera"]["proj_vk"] = to_json(camera.proj_vk);
    root["camera"]["proj_gl"] = to_json(gl_from_vk(camera.proj_vk));
    root["camera"]["prev_view"] = camera.previous_view ? to_json(*camera.previous_view) : json(nullptr);
    if (camera.previous_from_current)
        root["camera"]["previous_from_current"] = to_json(*camera.previous_from_current);
    return root.dump(2) + "\n";
}

}  // namespace gloam::scene
