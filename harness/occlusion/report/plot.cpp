// SPDX-License-Identifier: MIT
#include "report/plot.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/process.hpp"
#include "base/text.hpp"
#include "report/internal/plot_layout.hpp"

namespace gloam::report {
namespace {

const base::ProcessLimits limits{.memory_bytes = std::uint64_t{4} << 30,
                                 .cpu = std::chrono::seconds(60),
                                 .patience = std::chrono::seconds(120)};

// Encodes an untrusted text for gnuplot's double quotes. All characters except letters and spaces become the
// numbers of their bytes. That includes digits, because gnuplot would read a digit behind such a number as a
// part of it. Control characters become spaces. The text can neither end the string nor run a command.
std::string encoded(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = byte < 0x80U && std::isalpha(byte) != 0;
        if (plain || byte < 0x20U || byte == 0x7fU || c == ' ') {
            result += plain ? c : ' ';
        } else {
            result += fmt::format("\\{:03o}", byte);
        }
    }
    return result + "\"";
}

std::string block(std::size_t number, const Curve& curve) {
    std::string text = fmt::format("$curve{} << END\n", number);
    for (const auto& [x, y] : curve.points)
        text += std::isfinite(x) && std::isfinite(y) ? fmt::format("{} {}\n", x, y) : std::string("\n");
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

std::string drawn_of(std::size_t number, const Curve& curve) {
    return fmt::format("$curve{} using 1:2 {} title {}", number, style_of(curve.style), encoded(curve.name));
}

// The labels of a plot that does not move them apart.
std::string labels_of(const Plot& plot) {
    std::string text;
    for (const Curve& curve : plot.curves) {
        for (std::size_t i = 0; i < curve.labels.size(); ++i) {
            const auto& [x, y] = curve.points[i];
            if (!std::isfinite(x) || !std::isfinite(y)) continue;
            text += fmt::format("set label {} at first {}, first {} left offset 0.5,0.5 font ',9'\n",
                                encoded(curve.labels[i]), x, y);
        }
    }
    return text;
}

std::string axis(char name, const internal::LogRange& range) {
    std::string tics;
    for (const double tic : internal::tics_of(range))
        tics += fmt::format("{}{:g}", tics.empty() ? "" : ", ", tic);
    return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\nset {0}tics ({3})\n", name, range.low,
                       range.high, tics);
}

// Axes with the range of the data, and labels moved apart, with lines to their points.
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
                            encoded(label.text), lx, ly);
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

std::string script_of(const Plot& plot, const Terminal& terminal) {
    std::string script = fmt::format("set terminal {} {}\n", terminal.name, terminal.settings);
    script += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", encoded(plot.title),
                          encoded(plot.x), encoded(plot.y));
    script += "set linetype 5 linecolor rgb '#8c564b'\n";  // instead of a yellow that is hard to read
    script += "set grid\nset key outside right samplen 2\n";
    script += plot.logarithmic ? logarithmic(plot) : "set yrange [0:*]\n" + labels_of(plot);
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
    // The script comes on standard input, the image on standard output: no file, no shell.
    base::ProcessResult gnuplot;
    try {
        gnuplot = base::run_process({"gnuplot", "-d"}, script_of(plot, terminal), limits);
    } catch (const std::system_error& error) {
        throw std::runtime_error(
            fmt::format("plot \"{}\": {} (is gnuplot installed?)", plot.title, error.what()));
    }
    if (gnuplot.succeeded() && !gnuplot.output.empty()) return std::move(gnuplot.output);
    throw std::runtime_error(
        fmt::format("plot \"{}\": gnuplot could not draw it: {}", plot.title, base::one_line(gnuplot.how())));
}

}  // namespace

std::string to_svg(const Plot& plot) {
    return drawn(plot, svg_terminal);
}

std::string to_png(const Plot& plot) {
    return drawn(plot, png_terminal);
}

}  // namespace gloam::report
