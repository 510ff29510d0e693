// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

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

std::string pfm_of(const std::vector<float>& texels, backend::Extent extent, int channels = 1) {
    return base::to_pfm(texels, extent.width, extent.height, channels);
}

std::string png_of(const base::RgbBytes& rgb, backend::Extent extent) {
    return base::to_png(rgb, extent.width, extent.height);
}

// As NAME.pfm, and shown as visibility as NAME.png.
void write_occlusion(record::OutputFolder& folder, const std::string& name,
                     const std::vector<float>& occlusion, backend::Extent extent) {
    folder.write(name + ".pfm", pfm_of(occlusion, extent));
    folder.write(name + ".png", pictures::to_visibility_png(occlusion, extent.width, extent.height));
}

}  // namespace

void write_gbuffer(record::OutputFolder& folder, int number, const scene::GBuffer& view) {
    const std::string prefix = scene::frame_prefix(number);
    folder.write(prefix + ".json", scene::frame_json(view, number));
    const auto add = [&](const std::string& name, const std::vector<float>& texels, int channels) {
        if (!texels.empty()) folder.write(prefix + name, pfm_of(texels, view.extent, channels));
    };
    add("_depth.pfm", view.stored ? view.stored->depth : view.depth, 1);
    add("_normal.pfm", components_of(view.stored ? view.stored->normal : view.normal), 3);
    add("_color.pfm", components_of(view.color), 3);
    add("_motion.pfm", components_of(view.motion), 3);
    if (!view.motion.empty()) add("_previous_depth.pfm", previous_depths(view), 1);
    for (std::size_t i = 0; i < view.layers.size(); ++i)
        add(fmt::format("_layer{}.pfm", i + 1), view.layers[i], 1);
}

void write_truth(record::OutputFolder& folder, const std::string& prefix, const ShadedView& traced) {
    const backend::Extent size = traced.view.extent;
    for (const auto& [name, truth] :
         {std::pair("truth", &traced.best()), std::pair("truth_depth", &*traced.depth)})
        write_occlusion(folder, prefix + name, truth->occlusion, size);
    folder.write(prefix + "truth_error.pfm", pfm_of(traced.best().standard_error, size));
}

base::RgbBytes tinted_tiles(const ShadedView& shown, const effect::Frame& frame) {
    if (shown.settings.resolution != effect::Resolution::tiles) return {};
    const std::uint32_t width = frame.extent.width;
    const std::map<effect::TileWork, glm::vec3> tints{{effect::TileWork::background, {0.5F, 0.65F, 1.0F}},
                                                      {effect::TileWork::below_pixel, {0.6F, 1.0F, 0.5F}},
                                                      {effect::TileWork::half, glm::vec3(1.0F)},
                                                      {effect::TileWork::full, {1.0F, 0.65F, 0.3F}}};
    const std::uint32_t columns = effect::tiles_of(shown.wide.extent).width;
    base::RgbBytes rgb = pictures::visibility_rgb(frame.filtered);
    for (std::uint32_t i = 0; i < rgb.size(); ++i) {
        const std::uint32_t column = (i / 3 % width + shown.wide.border.left) / effect::tile_side;
        const std::uint32_t row = (i / 3 / width + shown.wide.border.top) / effect::tile_side;
        const glm::vec3& tint = tints.at(frame.tiles[row * columns + column]);
        rgb[i] = static_cast<std::uint8_t>(static_cast<float>(rgb[i]) * tint[static_cast<int>(i % 3)]);
    }
    return rgb;
}

void write_frame(record::OutputFolder& folder, const std::string& stem, const effect::Frame& frame,
                 const base::RgbBytes& tiles) {
    write_occlusion(folder, stem + "_ao", frame.filtered, frame.extent);
    if (!tiles.empty()) folder.write(stem + "_tiles.png", png_of(tiles, frame.extent));
}

void write_bent(record::OutputFolder& folder, const std::string& stem, const effect::BentNormals& bent) {
    const std::vector<float> texels = components_of(bent.direction);
    std::vector<std::uint8_t> picture;
    for (const float value : texels)
        picture.push_back(
            static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(0.5F + 0.5F * value, 0.0F, 1.0F))));
    folder.write(stem + "_bent.pfm", pfm_of(texels, bent.extent, 3));
    folder.write(stem + "_bent.png", png_of(picture, bent.extent));
    folder.write(stem + "_cone.pfm", pfm_of(bent.half_angle, bent.extent));
}

void write_light(record::OutputFolder& folder, const std::string& stem,
                 const effect::DirectionalLight& light) {
    std::vector<float> texels = components_of(light.direct);
    const std::vector<float> bounced = components_of(light.bounced);
    std::ranges::transform(texels, bounced, texels.begin(), std::plus{});
    folder.write(stem + "_light.pfm", pfm_of(texels, light.extent, 3));
    folder.write(stem + "_light.png", png_of(base::srgb_of(texels), light.extent));
    folder.write(stem + "_bounce.pfm", pfm_of(bounced, light.extent, 3));
}

void write_pictures(record::OutputFolder& folder, const Pictures& pictures) {
    for (const auto& [name, rgb] : {std::pair("_plain.png", &pictures.plain),
                                    {"_shaded.png", &pictures.shaded},
                                    {"_true.png", &pictures.truth_lit},
                                    {"_error.png", &pictures.error}})
        if (!rgb->empty()) folder.write(pictures.name + name, png_of(*rgb, pictures.extent));
}

namespace {

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
    const std::vector<float> open;
    Pictures pictures{
        .name = std::move(name), .extent = light.extent, .visibility = pictures::visibility_rgb(occlusion)};
    for (const auto& [picture, values] :
         {std::pair(&pictures.plain, &open), {&pictures.shaded, &occlusion}, {&pictures.truth_lit, &truth}}) {
        if (picture == &pictures.truth_lit && truth.empty()) continue;
        *picture = base::srgb_of(components_of(light.mean(composite.lit(
            light.sampled(), light.light.ambient, light.light.direct,
            values->empty() ? open : light.spread(*values), multi_bounce ? light.albedo : black))));
    }
    if (truth.empty()) return pictures;
    pictures.truth = pictures::visibility_rgb(truth);
    std::vector<float> errors;
    for (std::size_t i = 0; i < truth.size(); ++i) errors.push_back(std::abs(occlusion[i] - truth[i]));
    pictures.error = base::heat_rgb(errors, brightest_error);
    return pictures;
}

double Rendered::ms() const {
    double sum = 0.0;
    for (const effect::PassTime& time : frame.times) sum += time.ms;
    return sum;
}

std::string sheet_of(const std::vector<Rendered>& runs) {
    const Rendered& first = runs.front();
    const auto& [name, extent, plain, shaded, visibility, truth, truth_lit, error, tiles] = first.pictures;
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

void add_pictures(record::Page& page, record::OutputFolder& folder, const Rendered& run,
                  const std::string& caption) {
    const Pictures& last = run.pictures;
    std::vector<record::PagePicture> all;
    for (const auto& [file, name, rgb] : {std::tuple("shaded.png", "with ambient occlusion", &last.shaded),
                                          {"plain.png", "without", &last.plain},
                                          {"truth.png", "ray-traced truth", &last.truth_lit},
                                          {"tiles.png", "tiles", &last.tiles}}) {
        folder.write(file, png_of(*rgb, last.extent));
        all.push_back({file, name});
    }
    page.choose(all, caption);
}

}  // namespace gloam::cli
