// SPDX-License-Identifier: MIT
#include "cli/render_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/image.hpp"
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

}  // namespace

std::vector<float> components_of(const std::vector<glm::vec3>& vectors) {
    std::vector<float> texels;
    texels.reserve(3 * vectors.size());
    for (const glm::vec3& v : vectors) texels.insert(texels.end(), {v.x, v.y, v.z});
    return texels;
}

void write_gbuffer(report::OutputFolder& folder, int number, const scene::GBuffer& view) {
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

void write_images(report::OutputFolder& folder, const std::string& stem, const effect::Frame& frame) {
    const auto [width, height] = frame.extent;
    folder.write(stem + "_ao.pfm", base::to_pfm(frame.filtered, width, height, 1));
    folder.write(stem + "_ao.png", report::to_visibility_png(frame.filtered, width, height));
}

namespace {

constexpr std::size_t methods_in_a_row = 4;

std::string png_of(const Pictures& pictures, const base::RgbBytes& rgb) {
    return base::to_rgb_png(rgb, pictures.extent.width, pictures.extent.height);
}

std::vector<report::SheetPicture> pictures_of_one(const Rendered& run) {
    const Pictures& last = run.pictures.back();
    std::vector<report::SheetPicture> sheet{{last.plain, "Light without ambient occlusion"},
                                            {last.shaded, "With ambient occlusion"},
                                            {last.visibility, "Occlusion alone: " + caption_of(run.report)}};
    if (!last.error.empty()) {
        sheet.push_back({last.error, fmt::format("Error against the truth: black 0, pale yellow {} and more",
                                                 brightest_error)});
    }
    return sheet;
}

}  // namespace

Pictures pictures_of(const effect::Composite& composite, std::string name, const scene::PictureLight& light,
                     const std::vector<float>& occlusion, const effect::Truth& truth, bool multi_bounce) {
    const std::vector<glm::vec3> black;
    const std::vector<glm::vec3>& albedo = multi_bounce ? light.albedo : black;
    const auto lit = [&](const std::vector<float>& values) {
        const std::vector<float> samples = values.empty() ? values : light.spread(values);
        return base::srgb_of(
            components_of(light.mean(composite.lit(light.sampled(), light.light, samples, albedo))));
    };
    Pictures pictures{.name = std::move(name),
                      .extent = light.extent,
                      .plain = lit({}),
                      .shaded = lit(occlusion),
                      .visibility = report::visibility_rgb(occlusion),
                      .truth = {},
                      .truth_lit = {},
                      .error = {}};
    if (truth.empty()) return pictures;
    pictures.truth = report::visibility_rgb(truth);
    pictures.truth_lit = lit({truth.begin(), truth.end()});
    pictures.none_error = effect::errors_of(std::vector<float>(truth.size(), 0.0F), truth).rmse;
    std::vector<float> errors;
    for (std::size_t i = 0; i < truth.size(); ++i) errors.push_back(std::abs(occlusion[i] - truth[i]));
    pictures.error = base::heat_rgb(errors, brightest_error);
    return pictures;
}

void write_pictures(report::OutputFolder& folder, const Pictures& pictures) {
    folder.write(pictures.name + "_plain.png", png_of(pictures, pictures.plain));
    folder.write(pictures.name + "_shaded.png", png_of(pictures, pictures.shaded));
    if (!pictures.error.empty()) folder.write(pictures.name + "_error.png", png_of(pictures, pictures.error));
}

double frame_ms(const RenderReport& report) {
    double sum = 0.0;
    for (const effect::PassTime& time : report.frames.back().times) sum += time.ms;
    return sum;
}

std::optional<double> frame_error(const RenderReport& report) {
    const auto& errors = report.frames.back().errors;
    if (!errors) return std::nullopt;
    return errors->filtered.rmse;
}

std::string caption_of(const RenderReport& report) {
    const std::string measured = time_and_error_of(report);
    return measured.empty() ? report.name : report.name + ", " + measured;
}

std::string time_and_error_of(const RenderReport& report) {
    std::string text;
    if (const double ms = frame_ms(report); std::isfinite(ms)) text = fmt::format("{:.3g} ms", ms);
    if (const auto error = frame_error(report))
        text += fmt::format("{}error {:.3f}", text.empty() ? "" : ", ", *error);
    return text;
}

std::string sheet_of(const std::vector<Rendered>& runs) {
    std::vector<report::SheetPicture> sheet;
    if (runs.size() == 1) {
        sheet = pictures_of_one(runs.front());
    } else {
        if (!runs.empty() && !runs.front().pictures.back().truth.empty())
            sheet.push_back({runs.front().pictures.back().truth, "truth: " + runs.front().report.truth});
        for (const Rendered& run : runs)
            sheet.push_back({run.pictures.back().visibility, caption_of(run.report)});
    }
    const gpu::Extent extent = runs.empty() ? gpu::Extent{} : runs.front().pictures.back().extent;
    const std::size_t columns = runs.size() == 1 ? 2 : methods_in_a_row;
    return report::to_sheet_png(sheet, extent.width, extent.height, columns);
}

namespace {

constexpr std::uint32_t least_crop_width = 240;  // pixels on a cropped sheet
constexpr std::size_t bar_width = 2;             // pixels

base::RgbBytes magnified(const base::RgbBytes& rgb, gpu::Extent extent, const Crop& crop,
                         std::uint32_t zoom) {
    base::RgbBytes part;
    part.reserve(std::size_t{3} * crop.extent.width * zoom * crop.extent.height * zoom);
    for (std::uint32_t y = 0; y < crop.extent.height * zoom; ++y) {
        for (std::uint32_t x = 0; x < crop.extent.width * zoom; ++x) {
            const std::size_t from = std::size_t{crop.top + y / zoom} * extent.width + crop.left + x / zoom;
            for (std::size_t k = 0; k < 3; ++k) part.push_back(rgb.at(3 * from + k));
        }
    }
    return part;
}

}  // namespace

std::string cropped_sheet_of(const std::vector<Rendered>& runs, const Crop& crop) {
    std::vector<report::SheetPicture> lit;
    std::vector<report::SheetPicture> alone;
    for (const Rendered& run : runs) {
        const Pictures& last = run.pictures.back();
        if (lit.empty()) {
            lit.push_back({last.plain, "no occlusion"});
            alone.push_back({base::RgbBytes(last.visibility.size(), 255), ""});
            if (!last.truth.empty()) alone.back().caption = fmt::format("error {:.3f}", last.none_error);
        }
        lit.push_back({last.shaded, run.report.name});
        alone.push_back({last.visibility, time_and_error_of(run.report)});
    }
    const Pictures& first = runs.at(0).pictures.back();
    if (!first.truth.empty()) {
        lit.push_back({first.truth_lit, "truth"});
        alone.push_back({first.truth, runs.front().report.truth});
    }
    const std::size_t columns = lit.size();
    const std::uint32_t zoom = std::max(1U, (least_crop_width + crop.extent.width - 1) / crop.extent.width);
    lit.insert(lit.end(), alone.begin(), alone.end());
    for (report::SheetPicture& picture : lit) picture.rgb = magnified(picture.rgb, first.extent, crop, zoom);
    return report::to_sheet_png(lit, crop.extent.width * zoom, crop.extent.height * zoom, columns);
}

base::RgbBytes wiped(const Pictures& pictures, double share) {
    const auto width = static_cast<double>(pictures.extent.width);
    const auto bar =
        static_cast<std::size_t>(std::lround(width * (0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * share))));
    base::RgbBytes rgb = pictures.shaded;
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        const std::size_t x = i / 3 % pictures.extent.width;
        if (x < bar) rgb[i] = x + bar_width < bar ? pictures.plain[i] : 255;
    }
    return rgb;
}

namespace {

// Writes one picture and returns its file name.
std::string write(report::OutputFolder& folder, const Pictures& pictures, const std::string& name,
                  const base::RgbBytes& rgb) {
    folder.write(name, base::to_rgb_png(rgb, pictures.extent.width, pictures.extent.height));
    return name;
}

report::PageTable comparison(const std::vector<Rendered>& runs) {
    report::PageTable table{
        .columns = {{.title = "run"},
                    {.title = "ms",
                     .meaning = "time of all passes of the last frame on the device",
                     .numeric = true},
                    {.title = "error",
                     .meaning = "root mean square error of the occlusion against the truth, 0 to 1",
                     .numeric = true},
                    {.title = "samples", .meaning = "taken for each pixel in a frame", .numeric = true}},
        .rows = {}};
    for (const Rendered& run : runs) {
        const effect::Settings& settings = run.report.frames.back().settings;
        const double ms = frame_ms(run.report);
        const auto error = frame_error(run.report);
        table.rows.push_back({{run.report.name},
                              {std::isfinite(ms) ? fmt::format("{:.3f}", ms) : "-", ms},
                              {error ? fmt::format("{:.4f}", *error) : "-", error},
                              {fmt::format("{}", settings.samples), static_cast<double>(settings.samples)}});
    }
    return table;
}

}  // namespace

void add_pictures(report::Page& page, report::OutputFolder& folder, const std::string& prefix,
                  const Rendered& run) {
    const Pictures& last = run.pictures.back();
    const std::string plain = write(folder, last, prefix + "plain.png", last.plain);
    const std::string shaded = write(folder, last, prefix + "shaded.png", last.shaded);
    page.compare({plain, "without ambient occlusion"}, {shaded, "with ambient occlusion"},
                 caption_of(run.report));
    std::vector<report::PagePicture> more{
        {write(folder, last, prefix + "visibility.png", last.visibility), "the occlusion alone"}};
    if (!last.error.empty()) {
        more.push_back({write(folder, last, prefix + "error.png", last.error),
                        fmt::format("its error: black 0, pale yellow {} and more", brightest_error)});
    }
    page.pictures(more);
    if (run.pictures.size() < 2) return;
    std::vector<report::PagePicture> views;
    for (const Pictures& view : run.pictures) {
        const std::string name = fmt::format("{}view{:04}.png", prefix, views.size());
        views.push_back({write(folder, view, name, view.shaded), fmt::format("view {}", views.size())});
    }
    page.turntable(views, fmt::format("{} views around it", views.size()));
}

void write_gallery(report::OutputFolder& folder, const std::vector<Rendered>& runs) {
    const RenderReport& first = runs.front().report;
    report::Page page(fmt::format("{}: ambient occlusion", first.source));
    page.paragraph(fmt::format("Rendered on {}.{}", first.device.name,
                               first.truth.empty() ? "" : " The truth is the " + first.truth + "."));
    if (runs.size() > 1) page.table(comparison(runs));
    for (const Rendered& run : runs) {
        page.heading(run.report.name);
        add_pictures(page, folder, run.report.name + "_", run);
    }
    folder.write("index.html", page.html());
}

}  // namespace gloam::cli
