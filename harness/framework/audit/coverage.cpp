// SPDX-License-Identifier: MIT
#include "audit/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

#include "base/text.hpp"
#include "judge/explain.hpp"
#include "judge/session.hpp"
#include "module/include.hpp"
#include "subject/interpreted_kernel.hpp"

namespace gloam::check {
namespace {

constexpr const char* generated = "kernel";
constexpr std::uint64_t most_steps = 100'000'000;  // about a second
constexpr std::size_t first_inputs = 1024;         // of each scenario; they contain inputs of all kinds
constexpr std::size_t first_look = 64;             // first test after this many inputs

using Roots = std::vector<std::filesystem::path>;

// The lines of a source file; empty if it cannot be read or lies outside the include roots, because #line can
// name any file.
std::vector<std::string> lines_of(const std::string& file, const Roots& roots) {
    std::vector<std::string> lines;
    try {
        const std::string path = std::filesystem::absolute(file).string();
        std::istringstream text(shader::read_text(shader::resolve_include(path, {}, roots)));
        for (std::string line; std::getline(text, line);) {
            const std::size_t first = line.find_first_not_of(" \t");
            lines.push_back(first == std::string::npos ? "" : base::one_line(line.substr(first)));
        }
    } catch (const std::exception&) {
        lines.clear();
    }
    return lines;
}

bool is_of_source(const interpreter::Place& place) {
    return !place.file.empty() && place.file != generated;
}

// The same program with the images of each scenario.
class Measurement {
  public:
    Measurement(const Lab& lab, const Question& question, const RunOptions& options)
        : lab_(lab),
          question_(question),
          options_(options),
          module_(lined_module(lab, lab.source(question.file, question.function, question.signature))),
          domain_(domain_of(lab, question, *module_.source)),
          program_(module_.spirv),
          seen_(program_) {}

    Coverage run() {
        const std::size_t scenarios = std::max<std::size_t>(question_.scenarios.size(), 1);
        for_each_scenario(question_, options_.inputs, [&](const ImageScenario& scenario, std::size_t share) {
            if (!complete_) run(scenario, share, most_steps / scenarios);
        });
        Coverage all = summary();
        std::map<std::string, std::vector<std::string>> files;
        for (Coverage::Point& point : all.points) {
            const auto [known, fresh] = files.try_emplace(point.file);
            if (fresh) known->second = lines_of(point.file, lab_.options().include_roots);
            if (point.line >= 1 && point.line <= known->second.size())
                point.text = known->second[point.line - 1];
        }
        return all;
    }

  private:
    void run(const ImageScenario& scenario, std::size_t share, std::uint64_t steps) {
        const ImageSet images = images_of(scenario, options_.seed);
        const auto words = image_words(module_, images);
        InterpretedKernel<float> kernel(program_, module_, words);
        const Domain::Inputs inputs =
            domain_.draw(share, input_seed_of(question_, scenario, options_.seed), scenario.size);
        for (std::size_t i = 0; i < inputs.count() && !complete_; ++i) {
            if (i >= first_inputs && kernel.machine().steps() > steps) break;
            try {
                kernel.run(inputs.row(i), seen_);
            } catch (const interpreter::Error& error) {
                // An input that faults reaches what it ran; a check judges it, not this count.
                if (error.kind() == interpreter::Error::Kind::missing) throw;
            }
            if (++run_ < next_look_) continue;
            next_look_ *= 2;
            complete_ = is_complete();
        }
        complete_ = complete_ || is_complete();
    }

    [[nodiscard]] bool is_complete() const { return summary().is_complete(); }

    [[nodiscard]] Coverage summary() const {
        Coverage all{.inputs = run_, .points = {}};
        for (const interpreter::Coverage::Line& line : seen_.lines()) {
            if (is_of_source(line.place))
                all.points.push_back({line.place.file, line.place.line, "", "", line.reached});
        }
        for (const interpreter::Coverage::Way& way : seen_.ways()) {
            if (!is_of_source(way.place)) continue;
            const std::string number =
                way.branch == 1 ? "" : fmt::format(", branch {} of the line", way.branch);
            all.points.push_back({way.place.file, way.place.line, "", way.way + number, way.reached});
        }
        return all;
    }

    const Lab& lab_;
    const Question& question_;
    const RunOptions& options_;
    KernelModule module_;
    Domain domain_;
    interpreter::Program program_;
    interpreter::Coverage seen_;
    std::size_t run_ = 0;
    std::size_t next_look_ = first_look;
    bool complete_ = false;
};

}  // namespace

bool Coverage::is_complete() const {
    return std::ranges::all_of(points, &Point::reached);
}

std::string to_text(const Coverage& coverage) {
    std::array<std::size_t, 2> all{};  // lines, ways
    std::array<std::size_t, 2> reached{};
    std::string missed;
    std::set<std::pair<std::string, unsigned>> missed_lines;
    for (const Coverage::Point& point : coverage.points) {
        const std::size_t kind = point.way.empty() ? 0 : 1;
        ++all.at(kind);
        reached.at(kind) += point.reached ? 1 : 0;
        // If a branch was not reached, its missed line is reported and not its ways.
        if (point.reached || (kind == 1 && missed_lines.contains({point.file, point.line}))) continue;
        if (kind == 0) missed_lines.insert({point.file, point.line});
        missed += fmt::format("\n    {}:{} {}: {}", base::one_line(point.file), point.line,
                              kind == 0 ? "not reached" : "never " + point.way, point.text);
    }
    return fmt::format("lines {} of {}, ways of branches {} of {}, {} inputs{}", reached[0], all[0],
                       reached[1], all[1], coverage.inputs, missed);
}

Coverage measure_coverage(const Lab& lab, const Question& question, const RunOptions& options) {
    return Measurement(lab, question, options).run();
}

}  // namespace gloam::check
