// SPDX-License-Identifier: MIT
// Every line and every branch of the library is reached by the inputs of some entry, but for those listed
// here with the reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "catalogue/catalogue.hpp"
#include "check/measure_coverage.hpp"
#include "support/lab.hpp"

namespace gloam {
namespace coverage_test {

// The file below glsl/, the text of the line, and the way of the branch (empty: the line itself).
using Point = std::tuple<std::string, std::string, std::string>;

constexpr const char* unusable =
    "no weight so far: the chords of volumetric all have a length; tests/glsl/layers_test.cpp tries it";
constexpr const char* flushed =
    "NaN: only a device that flushes a subnormal contrast beside an infinite occlusion comes here";

// Lines that the inputs of no entry reach, with the reason; it applies to all ways of the line.
const std::map<std::pair<std::string, std::string>, std::string> unreached{
    {{"gloam/gather/pair.glsl",
      "return seen && (most.whole > 0.0 ? found.occluded * most.whole >= most.occluded * found.whole : "
      "found.whole > 0.0);"},
     unusable},
    {{"gloam/occlusion/hbao.glsl", "return visibility > 0.0 ? visibility : (visibility <= 0.0 ? 0.0 : 1.0);"},
     flushed}};

std::string below_glsl(const std::string& file) {
    const std::size_t at = file.rfind("glsl/gloam/");
    return at == std::string::npos ? file : file.substr(at + std::string("glsl/").size());
}

TEST(CatalogueCoverage, WhatCanBeReachedIs) {
    const check::Lab lab({.device = std::string(check::interpreter_name),
                          .include_roots = {GLOAM_GLSL_DIR},
                          .cache_directory = test::cache_directory()});
    std::map<Point, bool> reached;
    std::map<Point, std::string> seen_by;
    for (const catalogue::Entry& entry : catalogue::all_entries(GLOAM_GLSL_DIR)) {
        const check::Coverage coverage = check::measure_coverage(lab, entry.question, {});
        EXPECT_FALSE(coverage.points.empty()) << entry.description.id;
        for (const check::Coverage::Point& point : coverage.points) {
            const Point key{below_glsl(point.file), point.text, point.way};
            reached[key] = reached[key] || point.reached;
            seen_by.try_emplace(key, entry.description.id);
        }
    }
    EXPECT_GT(reached.size(), 2000U);
    std::set<std::pair<std::string, std::string>> excused;
    for (const auto& [point, is_reached] : reached) {
        if (is_reached) continue;
        const auto& [file, text, way] = point;
        const bool listed = unreached.contains({file, text});
        if (listed) excused.insert({file, text});
        EXPECT_TRUE(listed) << file << ": " << text << " is never " << (way.empty() ? "reached" : way)
                            << ", not by " << seen_by[point] << " either";
    }
    for (const auto& [line, reason] : unreached)
        EXPECT_TRUE(excused.contains(line)) << line.first << ": " << line.second << " is reached";
}

}  // namespace coverage_test
}  // namespace gloam
