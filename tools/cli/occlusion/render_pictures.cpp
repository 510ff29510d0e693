// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "pictures/sheet.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

// Of the surface points, in the camera of the frame before; 0 at the background.
std::vector<float> previous_depths(const scene::GBuffer& view) {
    if (view.previous_position.empty()) return view.previous_depth;
    std::vector<float> depths;
    for (const glm::vec3& position : view.previous_position) depths.push_back(0.0F - position.z);
    return depths;
}

// x, y, z of each vector.
std::vector<float> components_of(const std::vector<glm::vec3>& vectors) {
    std::vector<float> texels;
    texels.reserve(3 * vectors.size());
    for (const glm::vec3& v : vectors) texels.insert(texels.end(), {v.x, v.y, v.z});
    return texels;
}

}  // namespace

void write_gbuffer(record::OutputFolder& folder, int number, const scene::GBuffer& view) {
    const std::string prefix = scene::frame_prefix(number);
    const auto write = [&](const char* name, const std::vector<float>& texels, int channels) {
        if (texels.empty()) return;
        folder.write(prefix + name, base::to_pfm(texels, view.extent.width, view.extent.height, channels));
    };
    write("_depth.pfm", view.stored ? view.stored->depth : view.depth, 1);
    write("_normal.pfm", components_of(view.stored ? view.stored->normal : view.normal), 3);
    write("_color.pfm", components_of(view.color), 3);
    write("_motion.pfm", components_of(view.motion), 3);
    if (!view.motion.empty()) write("_previous_depth.pfm", previous_depths(view), 1);
    for (std::size_t i = 0; i < view.layers.size(); ++i)
        write(fmt::format("_layer{}.pfm", i + 1).c_str(), view.layers[i], 1);
    folder.write(prefix + ".json", scene::frame_json(view, number));
}

void write_images(record::OutputFolder& folder, const std::string& stem, const effect::Frame& frame) {
    const auto [width, height] = frame.extent;
    folder.write(stem + "_ao.pfm", base::to_pfm(frame.filtered, width, height, 1));
    folder.write(stem + "_ao.png", pictures::to_visibility_png(frame.filtered, width, height));
}

void write_tiles(record::OutputFolder& folder, const std::string& stem, const effect::Frame& frame,
                 const scene::GBuffer& view) {
    const std::map<effect::TileWork, glm::vec3> tints{{effect::TileWork::background, {0.5F, 0.65F, 1.0F}},
                                                      {effect::TileWork::below_pixel, {0.6F, 1.0F, 0.5F}},
                                                      {effect::TileWork::half, glm::vec3(1.0F)},
                                                      {effect::TileWork::full, {1.0F, 0.65F, 0.3F}}};
    const auto [width, height] = frame.extent;
    const std::uint32_t columns = effect::tiles_of(view.extent).width;
    base::RgbBytes rgb = pictures::visibility_rgb(frame.filtered);
    for (std::uint32_t i = 0; i < rgb.size(); ++i) {
        const std::uint32_t column = (i / 3 % width + view.border.left) / effect::tile_side;
        const std::uint32_t row = (i / 3 / width + view.border.top) / effect::tile_side;
        const glm::vec3& tint = tints.at(frame.tiles[row * columns + column]);
        rgb[i] = static_cast<std::uint8_t>(static_cast<float>(rgb[i]) * tint[static_cast<int>(i % 3)]);
    }
    folder.write(stem + "_tiles.png", base::to_png(rgb, width, height));
}

void write_truth(record::OutputFolder& folder, const std::string& prefix, gpu::Extent size,
                 const ViewTruth& traced) {
    const auto write = [&](const std::string& name, const std::vector<float>& image) {
        folder.write(prefix + name + ".pfm", base::to_pfm(image, size.width, size.height, 1));
        folder.write(prefix + name + ".png", pictures::to_visibility_png(image, size.width, size.height));
    };
    write("truth", traced.best().occlusion);
    write("truth_depth", traced.depth->occlusion);
    folder.write(prefix + "truth_error.pfm",
                 base::to_pfm(traced.best().standard_error, size.width, size.height, 1));
}

void write_bent_normals(record::OutputFolder& folder, const std::string& stem,
                        const effect::BentNormals& bent) {
    const auto [width, height] = bent.extent;
    const std::vector<float> texels = components_of(bent.direction);
    std::vector<std::uint8_t> picture;
    for (const float value : texels)
        picture.push_back(
            static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(0.5F + 0.5F * value, 0.0F, 1.0F))));
    folder.write(stem + "_bent.pfm", base::to_pfm(texels, width, height, 3));
    folder.write(stem + "_bent.png", base::to_png(picture, width, height));
    folder.write(stem + "_cone.pfm", base::to_pfm(bent.half_angle, width, height, 1));
}

void write_light(record::OutputFolder& folder, const std::string& stem,
                 const effect::DirectionalLight& light) {
    const auto [width, height] = light.extent;
    std::vector<float> texels = components_of(light.direct);
    const std::vector<float> bounced = components_of(light.bounced);
    std::ranges::transform(texels, bounced, texels.begin(), std::plus{});
    folder.write(stem + "_light.pfm", base::to_pfm(texels, width, height, 3));
    folder.write(stem + "_light.png", base::to_png(base::srgb_of(texels), width, height));
    folder.write(stem + "_bounce.pfm", base::to_pfm(bounced, width, height, 3));
}

namespace {

std::string png_of(const Pictures& pictures, const base::RgbBytes& rgb) {
    return base::to_png(rgb, pictures.extent.width, pictures.extent.height);
}

// "sweep, 3.2 ms, error 0.031".
std::string caption_of(const Rendered& run) {
    std::string text = run.name;
    if (std::isfinite(run.ms())) text += fmt::format(", {:.3g} ms", run.ms());
    if (run.error) text += fmt::format(", error {:.3f}", *run.error);
    return text;
}

constexpr double brightest_error = 0.25;  // at the bright end of the heat map

}  // namespace

Pictures pictures_of(const effect::Composite& composite, std::string name,
                     const pictures::PictureLight& light, const std::vector<float>& occlusion,
                     const effect::Truth& truth, bool multi_bounce) {
    const std::vector<glm::vec3> black;
    const std::vector<glm::vec3>& albedo = multi_bounce ? light.albedo : black;
    const auto lit = [&](const std::vector<float>& values) {
        const std::vector<float> samples = values.empty() ? values : light.spread(values);
        return base::srgb_of(components_of(light.mean(
            composite.lit(light.sampled(), light.light.ambient, light.light.direct, samples, albedo))));
    };
    Pictures pictures{.name = std::move(name),
                      .extent = light.extent,
                      .plain = lit({}),
                      .shaded = lit(occlusion),
                      .visibility = pictures::visibility_rgb(occlusion),
                      .truth = {},
                      .truth_lit = {},
                      .error = {}};
    if (truth.empty()) return pictures;
    pictures.truth = pictures::visibility_rgb(truth);
    pictures.truth_lit = lit({truth.begin(), truth.end()});
    std::vector<float> errors;
    for (std::size_t i = 0; i < truth.size(); ++i) errors.push_back(std::abs(occlusion[i] - truth[i]));
    pictures.error = base::heat_rgb(errors, brightest_error);
    return pictures;
}

void write_pictures(record::OutputFolder& folder, const Pictures& pictures) {
    folder.write(pictures.name + "_plain.png", png_of(pictures, pictures.plain));
    folder.write(pictures.name + "_shaded.png", png_of(pictures, pictures.shaded));
    if (pictures.error.empty()) return;
    folder.write(pictures.name + "_true.png", png_of(pictures, pictures.truth_lit));
    folder.write(pictures.name + "_error.png", png_of(pictures, pictures.error));
}

double Rendered::ms() const {
    double sum = 0.0;
    for (const effect::PassTime& time : frame.times) sum += time.ms;
    return sum;
}

std::string sheet_of(const std::vector<Rendered>& runs) {
    const Rendered& first = runs.front();
    const auto& [name, extent, plain, shaded, visibility, truth, truth_lit, error] = first.pictures;
    std::vector<pictures::SheetPicture> sheet;
    if (runs.size() == 1) {
        sheet = {{plain, "Light without ambient occlusion"},
                 {shaded, "With ambient occlusion"},
                 {visibility, "Occlusion alone: " + caption_of(first)}};
        if (!error.empty())
            sheet.push_back({error, fmt::format("Error against the truth: black 0, pale yellow {} and more",
                                                brightest_error)});
        return pictures::to_sheet_png(sheet, extent.width, extent.height, 2);
    }
    if (!truth.empty()) sheet.push_back({truth, "truth: " + first.report["truth"].get<std::string>()});
    for (const Rendered& run : runs) sheet.push_back({run.pictures.visibility, caption_of(run)});
    return pictures::to_sheet_png(sheet, extent.width, extent.height, 4);
}

void add_pictures(record::Page& page, record::OutputFolder& folder, const std::string& prefix,
                  const Rendered& run) {
    const Pictures& last = run.pictures;
    std::vector<record::PagePicture> all;
    const auto add = [&](const char* name, const base::RgbBytes& rgb, const std::string& caption) {
        folder.write(prefix + name, png_of(last, rgb));
        all.push_back({prefix + name, caption});
    };
    add("shaded.png", last.shaded, "with ambient occlusion");
    add("plain.png", last.plain, "without");
    if (!last.truth_lit.empty()) add("truth.png", last.truth_lit, "ray-traced truth");
    add("visibility.png", last.visibility, "the occlusion alone");
    if (!last.error.empty()) add("error.png", last.error, "its error");
    page.choose(all, caption_of(run) +
                         (last.error.empty()
                              ? ""
                              : fmt::format("; its error: pale yellow is {} and more", brightest_error)));
}

}  // namespace gloam::cli
