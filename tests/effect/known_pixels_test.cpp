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
    std::string known;  // what follows
    std::string scene = "moving";
    backend::Extent extent{83, 45};
    int frames = 4;
    Settings settings;
    double mean = 0.0;        // thousandths of occlusion
    double kept = 0.0;        // samples
    std::vector<int> pixels;  // ten-thousandths of occlusion
};

Row row_of(const std::string& line) {
    const std::size_t colon = line.find(" : ");
    Row row{.asked = line.substr(0, colon), .settings = with_radius({}, 1.5F)};
    std::istringstream asked(row.asked);
    for (std::string word; asked >> word;) {
        const std::string value = word.substr(word.find('=') + 1);
        char by = 0;
        if (word.starts_with("scene=")) {
            row.scene = value;
        } else if (word.starts_with("size=")) {
            std::istringstream(value) >> row.extent.width >> by >> row.extent.height;
        } else if (word.starts_with("frames=")) {
            row.frames = std::stoi(value);
        } else {
            row.settings = with(row.settings, word);
        }
    }
    row.settings.output = OutputFormat::r32f;
    row.known = line.substr(colon);
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
    const scene::DrawOptions options{
        .motion = true, .layers = row.settings.own.layers, .guard = double{row.settings.guard}};
    const Frame frame = run(sequence_of(row.scene, row.extent, row.frames, options), row.settings).back();
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

// No two of them are equal, so that each setting that has one changes what is shown.
TEST(KnownPixels, HaveARowForEverySetting) {
    std::map<std::string, std::string> rows;
    for (const Row& row : known_rows()) {
        const auto [same, is_new] = rows.emplace(row.known, row.asked);
        EXPECT_TRUE(is_new) << row.asked << " shows what " << same->second << " shows";
    }
    for (const Setting& setting : setting_table()) {
        // Those of frame_test.cpp and engine_inputs_test.cpp.
        if (std::set<std::string>{"passes", "skips", "bent_normals", "output"}.contains(setting.name))
            continue;
        EXPECT_TRUE(std::ranges::any_of(rows,
                                        [&](const auto& row) {
                                            return (' ' + row.second).find(' ' + setting.name + '=') !=
                                                   std::string::npos;
                                        }))
            << setting.name << ": which value changes something?";
    }
}

}  // namespace gloam::effect::known_pixels_test
