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
            return "with points pointtype 7 pointsize 0.7";
        case CurveStyle::background:
            return "with points pointtype 7 pointsize 0.3 linecolor rgb '#b0b0b0'";
        case CurveStyle::steps:
            return "with steps linewidth 2 linecolor rgb 'black'";
        case CurveStyle::line:
            break;
    }
    return "with linespoints pointsize 0.4";
}

// What is drawn of a curve: itself, and its labels.
std::string drawn_of(std::size_t number, const Curve& curve) {
    std::string text =
        fmt::format("$curve{} using 1:2 {} title {}", number, style_of(curve.style), quoted(curve.name));
    if (!curve.labels.empty())
        text +=
            fmt::format(", $curve{} using 1:2:3 with labels left offset 0.5,0.5 font ',9' notitle", number);
    return text;
}

struct Terminal {
    const char* name;
    const char* settings;
};

constexpr Terminal svg_terminal{"svg", "size 720,400 noenhanced font 'sans-serif,12' background 'white'"};
constexpr Terminal png_terminal{"pngcairo",
                                "size 1080,600 noenhanced font 'sans-serif,12' background 'white'"};

std::string script_of(const Plot& plot, const fs::path& output, const Terminal& terminal) {
    std::string script = fmt::format("set terminal {} {}\n", terminal.name, terminal.settings);
    script += fmt::format("set output {}\nset title {}\nset xlabel {}\nset ylabel {}\n",
                          quoted(output.string()), quoted(plot.title), quoted(plot.x), quoted(plot.y));
    script += "set grid\nset key outside right\n";
    script += plot.logarithmic ? "set logscale xy\n" : "set yrange [0:*]\n";
    std::string drawn;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        script += block(i, plot.curves[i]);
        drawn += (i == 0 ? "" : ", ") + drawn_of(i, plot.curves[i]);
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
