// SPDX-License-Identifier: MIT
// Frames on llvmpipe, pixel by pixel: each row of known_pixels.txt is a test.
//
//   preset=fast frames=6 radius=0.6 : 67.729 0.000  1812 91 10 ...
//
// Before the colon: scene=NAME (moving), size=WIDTHxHEIGHT (83x45), frames=COUNT (4), preset=NAME, and
// settings, in their order. Behind it, of what is shown after the last frame: the mean occlusion in
// thousandths, the mean number of samples that a pixel's history holds, and the occlusion in ten-thousandths
// of 24 pixels that are spread evenly over the image.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "on_device.hpp"
#include "support/test_name.hpp"

namespace gloam::effect::known_pixels_test {

constexpr std::size_t pixel_count = 24;
constexpr int pixel_tolerance = 2;       // ten-thousandths of occlusion
constexpr double mean_tolerance = 2e-3;  // thousandths of occlusion, or samples

struct Row {
    std::string asked;
    std::string scene = "moving";
    gpu::Extent extent{83, 45};
    int frames = 4;
    Settings settings;
    double mean = 0.0;        // thousandths of occlusion
    double kept = 0.0;        // samples
    std::vector<int> pixels;  // ten-thousandths of occlusion
};

void ask(Row& row, const std::string& key, const std::string& value) {
    if (key == "scene") {
        row.scene = value;
    } else if (key == "size") {
        char by = 0;
        std::istringstream(value) >> row.extent.width >> by >> row.extent.height;
    } else if (key == "frames") {
        row.frames = std::stoi(value);
    } else if (key == "preset") {
        row.settings = preset_named(value).settings;
    } else if (key == "method") {
        row.settings = with_method(row.settings, value);
    } else if (key == "radius") {
        row.settings = with_radius(row.settings, std::stof(value));
    } else {
        set(row.settings, key, value);
    }
}

Row row_of(const std::string& line) {
    const std::size_t colon = line.find(" : ");
    Row row{.asked = line.substr(0, colon), .settings = with_radius({}, 1.5F)};
    std::istringstream asked(row.asked);
    for (std::string word; asked >> word;) {
        const std::size_t equals = word.find('=');
        ask(row, word.substr(0, equals), word.substr(equals + 1));
    }
    row.settings.output = OutputFormat::r32f;
    std::istringstream known(line.substr(colon + 3));
    known >> row.mean >> row.kept;
    for (int pixel = 0; known >> pixel;) row.pixels.push_back(pixel);
    return row;
}

std::vector<Row> known_rows() {
    std::ifstream file(KNOWN_PIXELS);
    if (!file) throw std::runtime_error(std::string("cannot read ") + KNOWN_PIXELS);
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);)
        if (line.find(" : ") != std::string::npos && !line.starts_with('#')) rows.push_back(row_of(line));
    return rows;
}

void PrintTo(const Row& row, std::ostream* out) {
    *out << row.asked;
}

// How many pixels are others, by more than the tolerance.
std::size_t others(const std::vector<int>& shown, const std::vector<int>& known) {
    if (shown.size() != known.size()) return shown.size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
        count += std::abs(shown[i] - known[i]) > pixel_tolerance ? 1 : 0;
    return count;
}

class KnownPixels : public OnDevice<testing::TestWithParam<Row>> {};

// Drivers differ where they round a place between two texels: one pixel may be another, and a few of all.
TEST_P(KnownPixels, AreShown) {
    if (!device_.info().name.starts_with("llvmpipe")) GTEST_SKIP() << "known of llvmpipe alone";
    const Row& row = GetParam();
    std::vector<scene::GBuffer> views;
    for (int i = 0; i < row.frames; ++i)
        views.push_back(drawn(row.scene, row.extent,
                              {.frame = i,
                               .motion = true,
                               .layers = row.settings.own.layers,
                               .guard = double{row.settings.guard}}));
    const Frame frame = run(views, row.settings).back();
    const std::vector<float>& shown = frame.filtered;
    const double mean = 1000.0 * mean_of(shown);
    const double kept = frame.kept.empty() ? 0.0 : mean_of(frame.kept);
    std::vector<int> pixels;
    for (std::size_t i = 0; i < pixel_count; ++i)
        pixels.push_back(
            static_cast<int>(std::lround(10000.0F * shown[(2 * i + 1) * shown.size() / (2 * pixel_count)])));
    EXPECT_TRUE(std::abs(mean - row.mean) <= mean_tolerance && std::abs(kept - row.kept) <= mean_tolerance &&
                others(pixels, row.pixels) <= 1)
        << fmt::format("{} : {:.3f} {:.3f}  {}", row.asked, mean, kept, fmt::join(pixels, " "));
}

INSTANTIATE_TEST_SUITE_P(Rows, KnownPixels, testing::ValuesIn(known_rows()),
                         [](const auto& row) { return test::test_name(row.param.asked); });

}  // namespace gloam::effect::known_pixels_test
