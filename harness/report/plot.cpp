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
    for (const auto& [x, y] : curve.points) {
        text += std::isfinite(x) && std::isfinite(y) ? fmt::format("{} {}\n", x, y) : std::string("\n");
    }
    return text + "END\n";
}

std::string script_of(const Plot& plot, const fs::path& output) {
    std::string script = "set terminal svg size 720,400 noenhanced font 'sans-serif,12' background 'white'\n";
    script += fmt::format("set output {}\nset title {}\nset xlabel {}\nset ylabel {}\n",
                          quoted(output.string()), quoted(plot.title), quoted(plot.x), quoted(plot.y));
    script += "set grid\nset key outside right\n";
    script += plot.logarithmic ? "set logscale xy\n" : "set yrange [0:*]\n";
    std::string drawn;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        script += block(i, plot.curves[i]);
        drawn += fmt::format("{}$curve{} with linespoints pointsize 0.4 title {}", i == 0 ? "" : ", ", i,
                             quoted(plot.curves[i].name));
    }
    return script + "plot " + drawn + "\n";
}

bool has_point(const Plot& plot) {
    for (const Curve& curve : plot.curves) {
        for (const auto& [x, y] : curve.points)
            if (std::isfinite(x) && std::isfinite(y)) return true;
    }
    return false;
}

}  // namespace

std::string to_svg(const Plot& plot) {
    if (!has_point(plot))
        throw std::invalid_argument("plot \"" + plot.title + "\": there is no point to draw");
    const Scratch scratch;
    const fs::path script = scratch.path() / "plot.gp";
    const fs::path image = scratch.path() / "plot.svg";
    std::ofstream(script) << script_of(plot, image);
    const std::string command =
        fmt::format("gnuplot '{}' >'{}' 2>&1", script.string(), (scratch.path() / "log").string());
    const int status = std::system(command.c_str());
    std::ifstream file(image, std::ios::binary);
    std::string svg{std::istreambuf_iterator<char>(file), {}};
    if (status == 0 && !svg.empty()) return svg;
    throw std::runtime_error("plot \"" + plot.title +
                             "\": gnuplot could not draw it (is gnuplot installed?)");
}

}  // namespace gloam::report
