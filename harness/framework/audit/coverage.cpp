// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "audit/audit.hpp"
#include "base/text.hpp"
#include "judge/explain.hpp"
#include "judge/session.hpp"
#include "module/include.hpp"
#include "subject/interpreted_kernel.hpp"

namespace gloam::audit {
namespace {

using namespace judge;
using namespace subject;

constexpr const char* generated = "kernel";
constexpr std::uint64_t most_steps = 100'000'000;  // about a second
constexpr std::size_t first_inputs = 1024;         // of each scenario; they contain inputs of all kinds
constexpr std::size_t first_look = 64;             // first test after this many inputs

// The lines of a source file; empty if it cannot be read or lies outside the include roots, because #line can
// name any file.
std::vector<std::string> lines_of(const std::string& file, const std::vector<std::filesystem::path>& roots) {
    std::vector<std::string> lines;
    try {
        const std::string path = std::filesystem::absolute(file).string();
        std::istringstream text(module::read_text(module::resolve_include(path, {}, roots)));
        for (std::string line; std::getline(text, line);) {
            const std::size_t first = line.find_first_not_of(" \t");
            lines.push_back(first == std::string::npos ? "" : base::one_line(line.substr(first)));
        }
    } catch (const std::exception&) {
        lines.clear();
    }
    return lines;
}

// The points of the source, without their texts.
Coverage points_of(const interpreter::Coverage& seen, std::size_t inputs) {
    Coverage all{.inputs = inputs, .points = {}};
    for (const auto& [place, way, branch, reached] : seen.points()) {
        const std::string which = branch > 1 ? fmt::format(", branch {} of the line", branch) : "";
        if (!place.file.empty() && place.file != generated)
            all.points.push_back({place.file, place.line, "", way + which, reached});
    }
    return all;
}

}  // namespace

Coverage measure_coverage(const Lab& lab, const Question& question, const RunOptions& options) {
    const KernelModule module =
        lined_module(lab, lab.source(question.file, question.function, question.signature));
    const Domain domain = domain_of(lab, question, *module.source);
    const interpreter::Program program(module.spirv);
    const std::uint64_t steps = most_steps / std::max<std::size_t>(question.scenarios.size(), 1);
    interpreter::Coverage seen(program);
    std::size_t run = 0;
    std::size_t next_look = first_look;
    bool complete = false;
    for (const auto& [scenario, share] : question.shares(options.inputs)) {
        if (complete) break;
        const auto words = image_words(module, images_of(scenario, options.seed));
        InterpretedKernel<float> kernel(program, module, words);
        const Domain::Inputs inputs =
            domain.draw(share, input_seed_of(question, scenario, options.seed), scenario.size);
        for (std::size_t i = 0; i < inputs.count() && !complete; ++i) {
            if (i >= first_inputs && kernel.machine().steps() > steps) break;
            try {
                kernel.run(inputs.row(i), seen);
            } catch (const interpreter::Error& error) {
                // An input that faults reaches what it ran; a check judges it, not this count.
                if (error.kind() == interpreter::Error::Kind::missing) throw;
            }
            if (++run < next_look) continue;
            next_look *= 2;
            complete = points_of(seen, run).is_complete();
        }
        complete = complete || points_of(seen, run).is_complete();
    }
    Coverage all = points_of(seen, run);
    std::map<std::string, std::vector<std::string>> files;
    for (Coverage::Point& point : all.points) {
        const auto [known, fresh] = files.try_emplace(point.file);
        if (fresh) known->second = lines_of(point.file, lab.options().include_roots);
        if (point.line >= 1 && point.line <= known->second.size()) point.text = known->second[point.line - 1];
    }
    return all;
}

}  // namespace gloam::audit
