// SPDX-License-Identifier: MIT
#include "report/plot.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "report/internal/plot_layout.hpp"

namespace gloam::report {
namespace {

namespace fs = std::filesystem;

// A folder of its own that goes with the object.
class Scratch {
  public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "gloam-plot-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw std::runtime_error(name + ": cannot make a folder for the plot");
        path_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

// gnuplot's single quotes: nothing in them means anything but a quote itself.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
    return result + "'";
}

std::string block(std::size_t number, const Curve& curve) {
    std::string text = fmt::format("$curve{} << END\n", number);
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const auto& [x, y] = curve.points[i];
        const std::string label = curve.labels.empty() ? "" : " \"" + curve.labels[i] + "\"";
        text +=
            std::isfinite(x) && std::isfinite(y) ? fmt::format("{} {}{}\n", x, y, label) : std::string("\n");
    }
    return text + "END\n";
}

const char* style_of(CurveStyle style) {
    switch (style) {
        case CurveStyle::points:
            return "with points pointtype 6 pointsize 0.8 linecolor rgb '#404040'";
        case CurveStyle::background:
            return "with points pointtype 7 pointsize 0.3 linecolor rgb '#b0b0b0'";
        case CurveStyle::steps:
            return "with steps linewidth 2 linecolor rgb 'black'";
        case CurveStyle::line:
            break;
    }
    return "with linespoints pointtype 7 pointsize 0.8";
}

// What is drawn of a curve: itself, and its labels, where they have not been placed.
std::string drawn_of(std::size_t number, const Curve& curve, bool placed) {
    std::string text =
        fmt::format("$curve{} using 1:2 {} title {}", number, style_of(curve.style), quoted(curve.name));
    if (!curve.labels.empty() && !placed)
        text +=
            fmt::format(", $curve{} using 1:2:3 with labels left offset 0.5,0.5 font ',9' notitle", number);
    return text;
}

std::string axis(char name, const internal::LogRange& range) {
    std::string tics;
    for (const double tic : internal::tics_of(range))
        tics += fmt::format("{}{:g}", tics.empty() ? "" : ", ", tic);
    return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\nset {0}tics ({3})\n", name, range.low,
                       range.high, tics);
}

// Axes as long as what is shown, and its labels apart from each other, with lines to their points.
std::string logarithmic(const Plot& plot) {
    std::vector<double> xs;
    std::vector<double> ys;
    for (const Curve& curve : plot.curves) {
        for (const auto& [x, y] : curve.points) {
            xs.push_back(x);
            ys.push_back(y);
        }
    }
    const internal::LogRange x = internal::range_around(xs);
    const internal::LogRange y = internal::range_around(ys);
    std::string text = axis('x', x) + axis('y', y);
    for (const internal::PlacedLabel& label : internal::placed_labels(plot, x, y)) {
        const auto& [px, py] = label.point;
        const auto& [lx, ly] = label.at;
        text += fmt::format("set label {} at graph {:.4f}, graph {:.4f} left font ',9' front\n",
                            quoted(label.text), lx, ly);
        if (lx > px && std::abs(ly - py) > 0.03)
            text += fmt::format(
                "set arrow from graph {:.4f}, graph {:.4f} to graph {:.4f}, graph {:.4f} nohead linecolor "
                "rgb '#a0a0a0' linewidth 0.5\n",
                px, py, lx, ly);
    }
    return text;
}

struct Terminal {
    const char* name;
    const char* settings;
};

constexpr Terminal svg_terminal{"svg", "size 960,540 noenhanced font 'sans-serif,12' background 'white'"};
constexpr Terminal png_terminal{
    "pngcairo", "size 1440,810 noenhanced fontscale 1.5 font 'sans-serif,12' background 'white'"};

std::string script_of(const Plot& plot, const fs::path& output, const Terminal& terminal) {
    std::string script = fmt::format("set terminal {} {}\n", terminal.name, terminal.settings);
    script += fmt::format("set output {}\nset title {}\nset xlabel {}\nset ylabel {}\n",
                          quoted(output.string()), quoted(plot.title), quoted(plot.x), quoted(plot.y));
    script += "set linetype 5 linecolor rgb '#8c564b'\n";  // for a yellow that cannot be read
    script += "set grid\nset key outside right samplen 2\n";
    script += plot.logarithmic ? logarithmic(plot) : "set yrange [0:*]\n";
    std::string drawn;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        script += block(i, plot.curves[i]);
        drawn += (i == 0 ? "" : ", ") + drawn_of(i, plot.curves[i], plot.logarithmic);
    }
    return script + "plot " + drawn + "\n";
}

void validate(const Plot& plot) {
    for (const Curve& curve : plot.curves) {
        if (curve.labels.empty() || curve.labels.size() == curve.points.size()) continue;
        throw std::invalid_argument(fmt::format("plot \"{}\", curve \"{}\": {} labels, expected {} or none",
                                                plot.title, curve.name, curve.labels.size(),
                                                curve.points.size()));
    }
}

bool has_point(const Plot& plot) {
    for (const Curve& curve : plot.curves) {
        for (const auto& [x, y] : curve.points)
            if (std::isfinite(x) && std::isfinite(y)) return true;
    }
    return false;
}

std::string drawn(const Plot& plot, const Terminal& terminal) {
    validate(plot);
    if (!has_point(plot))
        throw std::invalid_argument("plot \"" + plot.title + "\": there is no point to draw");
    const Scratch scratch;
    const fs::path script = scratch.path() / "plot.gp";
    const fs::path image = scratch.path() / "plot.image";
    std::ofstream(script) << script_of(plot, image, terminal);
    const std::string command =
        fmt::format("gnuplot '{}' >'{}' 2>&1", script.string(), (scratch.path() / "log").string());
    const int status = std::system(command.c_str());
    std::ifstream file(image, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (status == 0 && !bytes.empty()) return bytes;
    throw std::runtime_error("plot \"" + plot.title +
                             "\": gnuplot could not draw it (is gnuplot installed?)");
}

}  // namespace

std::string to_svg(const Plot& plot) {
    return drawn(plot, svg_terminal);
}

std::string to_png(const Plot& plot) {
    return drawn(plot, png_terminal);
}

}  // namespace gloam::report
