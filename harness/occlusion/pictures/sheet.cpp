// SPDX-License-Identifier: MIT
#include "pictures/sheet.hpp"

#include <stb_truetype.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

namespace gloam::pictures {
namespace {

std::uint8_t visibility_byte(float occlusion) {
    if (!(occlusion > 0.0F)) return 255;
    return static_cast<std::uint8_t>(std::lround(255.0F * (1.0F - std::fmin(occlusion, 1.0F))));
}

constexpr std::uint8_t paper = 228;       // light grey: pictures of open surfaces are white
constexpr std::uint32_t least_text = 13;  // pixels from line to line
constexpr std::size_t most_lines = 3;     // of a caption

struct Canvas {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint8_t> rgb;

    Canvas(std::size_t w, std::size_t h) : width(w), height(h), rgb(3 * w * h, paper) {}

    // Darkens a pixel. ink: 0 none, 255 black.
    void darken(std::size_t x, std::size_t y, std::uint8_t ink) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            std::uint8_t& value = rgb[3 * (y * width + x) + channel];
            value = static_cast<std::uint8_t>(value - value * ink / 255);
        }
    }
};

// Glyphs of one size.
class Font {
  public:
    // Empty if the file does not exist or is not a font.
    static std::optional<Font> of_height(float pixels) {
        Font font;
        std::ifstream file(GLOAM_FONT, std::ios::binary);
        font.file_.assign(std::istreambuf_iterator<char>(file), {});
        if (font.file_.empty()) return std::nullopt;
        if (stbtt_InitFont(&font.info_, font.data(), stbtt_GetFontOffsetForIndex(font.data(), 0)) == 0)
            return std::nullopt;
        font.scale_ = stbtt_ScaleForPixelHeight(&font.info_, pixels);
        return font;
    }

    // As much of a text as fits into a line, to the last space if there is one.
    [[nodiscard]] std::string_view line_of(std::string_view text, std::size_t width) const {
        float x = 0.0F;
        for (std::size_t i = 0; i < text.size(); ++i) {
            x += advance_of(text[i]);
            if (x <= static_cast<float>(width)) continue;
            const std::size_t space = text.rfind(' ', i);
            return text.substr(0, space == std::string_view::npos ? i : space);
        }
        return text;
    }

    // Draws a line of Latin-1 text.
    void draw(Canvas& canvas, std::string_view text, std::size_t left, std::size_t top) {
        int ascent = 0;
        stbtt_GetFontVMetrics(&info_, &ascent, nullptr, nullptr);
        const int baseline =
            static_cast<int>(top) + static_cast<int>(std::ceil(scale_ * static_cast<float>(ascent)));
        float x = static_cast<float>(left);
        for (const char c : text) {
            draw_glyph(canvas, static_cast<unsigned char>(c), x, baseline);
            x += advance_of(c);
        }
    }

  private:
    [[nodiscard]] const unsigned char* data() const {
        return reinterpret_cast<const unsigned char*>(file_.data());
    }

    [[nodiscard]] float advance_of(char c) const {
        int advance = 0;
        stbtt_GetCodepointHMetrics(&info_, static_cast<unsigned char>(c), &advance, nullptr);
        return scale_ * static_cast<float>(advance);
    }

    void draw_glyph(Canvas& canvas, int code, float at, int baseline) {
        int x0 = 0;
        int y0 = 0;
        int x1 = 0;
        int y1 = 0;
        const float whole = std::floor(at);
        stbtt_GetCodepointBitmapBoxSubpixel(&info_, code, scale_, scale_, at - whole, 0.0F, &x0, &y0, &x1,
                                            &y1);
        const int width = x1 - x0;
        const int height = y1 - y0;
        if (width <= 0 || height <= 0) return;
        std::vector<unsigned char> ink(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        stbtt_MakeCodepointBitmapSubpixel(&info_, ink.data(), width, height, width, scale_, scale_,
                                          at - whole, 0.0F, code);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const int to_x = static_cast<int>(whole) + x0 + x;
                const int to_y = baseline + y0 + y;
                if (to_x < 0 || to_y < 0 || to_x >= static_cast<int>(canvas.width) ||
                    to_y >= static_cast<int>(canvas.height))
                    continue;
                canvas.darken(static_cast<std::size_t>(to_x), static_cast<std::size_t>(to_y),
                              ink[static_cast<std::size_t>(y * width + x)]);
            }
        }
    }

    std::string file_;
    stbtt_fontinfo info_{};
    float scale_ = 1.0F;
};

void copy(Canvas& canvas, const SheetPicture& picture, std::size_t left, std::size_t top, std::size_t width) {
    const std::size_t rows = picture.rgb.size() / (3 * width);
    for (std::size_t y = 0; y < rows; ++y) {
        const auto row = picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * y * width);
        std::copy_n(row, 3 * width,
                    canvas.rgb.begin() + static_cast<std::ptrdiff_t>(3 * ((top + y) * canvas.width + left)));
    }
}

// The lines of a caption; what does not fit is left out.
std::vector<std::string_view> lines_of(const Font& font, std::string_view caption, std::size_t width) {
    std::vector<std::string_view> lines;
    while (!caption.empty() && lines.size() < most_lines) {
        lines.push_back(font.line_of(caption, width));
        if (lines.back().empty()) break;  // not even a letter fits
        caption.remove_prefix(lines.back().size());
        if (caption.starts_with(' ')) caption.remove_prefix(1);
    }
    return lines;
}

}  // namespace

base::RgbBytes visibility_rgb(std::span<const float> occlusion) {
    base::RgbBytes rgb;
    rgb.reserve(3 * occlusion.size());
    for (const float value : occlusion) rgb.insert(rgb.end(), 3, visibility_byte(value));
    return rgb;
}

std::string to_visibility_png(std::span<const float> occlusion, std::uint32_t width, std::uint32_t height) {
    std::vector<std::uint8_t> grey;
    grey.reserve(occlusion.size());
    for (const float value : occlusion) grey.push_back(visibility_byte(value));
    return base::to_png(grey, width, height, 1);
}

std::string to_sheet_png(std::span<const SheetPicture> pictures, std::uint32_t width, std::uint32_t height,
                         std::size_t columns) {
    columns = std::min(columns, pictures.size());
    const std::size_t rows = (pictures.size() + columns - 1) / columns;
    const std::size_t line = std::max(least_text, width / 26);
    const std::size_t gap = line / 2;
    std::optional<Font> font = Font::of_height(static_cast<float>(line));
    std::vector<std::vector<std::string_view>> captions(pictures.size());
    std::size_t lines = 1;
    for (std::size_t i = 0; font && i < pictures.size(); ++i) {
        captions[i] = lines_of(*font, pictures[i].caption, width);
        lines = std::max(lines, captions[i].size());
    }
    const std::size_t cell_height = height + lines * line + 2 * gap;
    Canvas canvas(columns * (width + gap) + gap, rows * cell_height + gap);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const std::size_t left = gap + i % columns * (width + gap);
        const std::size_t top = gap + i / columns * cell_height;
        copy(canvas, pictures[i], left, top, width);
        std::size_t below = top + height + gap / 2;
        for (const std::string_view text : captions[i]) {
            font->draw(canvas, text, left, below);
            below += line;
        }
    }
    return base::to_png(canvas.rgb, static_cast<std::uint32_t>(canvas.width),
                        static_cast<std::uint32_t>(canvas.height));
}

}  // namespace gloam::pictures
