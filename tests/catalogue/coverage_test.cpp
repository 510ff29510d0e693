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

constexpr const char* layers =
    "further layers: the printed gathers look at one; tests/effect/layers_test.cpp looks at more";
constexpr const char* flushed =
    "NaN: only a device that flushes a subnormal contrast beside an infinite occlusion comes here";

// Lines that the inputs of no entry reach, with the reason; it applies to all ways of the line.
const std::map<std::pair<std::string, std::string>, std::string> unreached{
    {{"gloam/gather/pair.glsl", "vec3 further = layers > 1 ? abs(gloam_fetch_layers(pixel)) : vec3(0.0);"},
     layers},
    {{"gloam/gather/pair.glsl", "if (look == 0) return vec2(depths.first.x, depths.second.x);"}, layers},
    {{"gloam/gather/pair.glsl",
      "return look < layers ? vec2(gloam_layer_depth(depths.first.x, depths.first.yzw, look), stayed.y)"},
     layers},
    {{"gloam/gather/pair.glsl",
      ": vec2(stayed.x, gloam_layer_depth(depths.second.x, depths.second.yzw, look - layers + 1));"},
     layers},
    {{"gloam/gather/pair.glsl", "if (look == 0) return true;"}, layers},
    {{"gloam/gather/pair.glsl", "bool seen = gloam_tap_sees(look < layers ? depths.x : depths.y);"}, layers},
    {{"gloam/gather/pair.glsl",
      "return seen && (most.whole > 0.0 ? found.occluded * most.whole >= most.occluded * found.whole : "
      "found.whole > 0.0);"},
     layers},
    {{"gloam/methods/disc.glsl", "vec3 further = kernel.layers > 1 ? gloam_fetch_layers(at) : vec3(0.0);"},
     layers},
    {{"gloam/methods/gtao.glsl", "vec3 further = kernel.layers > 1 ? gloam_fetch_layers(at) : vec3(0.0);"},
     layers},
    {{"gloam/methods/hemisphere.glsl",
      "vec3 further = kernel.layers > 1 ? gloam_fetch_layers(pixel) : vec3(0.0);"},
     layers},
    {{"gloam/methods/poisson.glsl",
      "vec3 further = kernel.layers > 1 ? gloam_fetch_layers(pixel) : vec3(0.0);"},
     layers},
    {{"gloam/methods/poisson.glsl",
      "blocked = blocked || (gloam_tap_sees(depth) && in_front > kernel.bias && in_front <= "
      "settings.range);"},
     layers},
    {{"gloam/methods/sphere_proxy.glsl",
      "vec3 further = kernel.layers > 1 ? gloam_fetch_layers(at) : vec3(0.0);"},
     layers},
    {{"gloam/methods/sweep.glsl", "vec3 further = kernel.layers > 1 ? gloam_fetch_layers(at) : vec3(0.0);"},
     layers},
    {{"gloam/methods/sweep.glsl", "if (layer > 0)"}, layers},
    {{"gloam/methods/sweep.glsl",
      "side = gloam_sweep_uncover(side, half_plane, offset, tells, rises, settings.falloff);"},
     layers},
    {{"gloam/methods/sweep.glsl", "nearest = layer == 0 ? side.before : nearest;"}, layers},
    {{"gloam/gather/line_pair.glsl",
      "if (!gloam_pair_stays(looked, look, kernel.layers, found, most)) continue;"},
     layers},
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
    for (const catalogue::Entry& entry : catalogue::all_entries()) {
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
