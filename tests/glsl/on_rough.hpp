// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rough_view.hpp"
#include "support/lab.hpp"

// A method on the rough view: its results, and relations between them.
namespace gloam::test {

using Results = std::vector<glm::vec2>;
using Surfaces = std::vector<Depths>;

// Pieces of a text, each with what takes its place.
using Changes = std::vector<std::pair<std::string, std::string>>;

// The file of a method whose text is changed, in the folder of the methods.
inline std::string changed(const MethodFunctions& functions, const std::string& method,
                           const Changes& changes) {
    std::string text = packed_method(functions, functions.file(method));
    text.erase(0, text.find('\n') + 1);  // #version
    for (const auto& [before, after] : changes) {
        const std::size_t at = text.find(before);
        if (at == std::string::npos) throw std::runtime_error(method + " has no " + before);
        text.replace(at, before.size(), after);
    }
    std::ofstream(functions.folder() / "changed.glsl") << text;
    return "changed.glsl";
}

// A method on the rough view. layers, farthest: of its kernel. level: the prepared image has one value.
class OnRough {
  public:
    using Inputs = check::Kernel<Gather>::Inputs;
    static constexpr Method settings{
        .range = 0.7F, .epsilon = 0.3F, .intensity = 0.3F, .thickness = 0.4F, .angle_bias = 0.1F, .steps = 4};

    OnRough(const std::string& method, int layers, float farthest = std::numeric_limits<float>::infinity(),
            bool level = false)
        : functions_(layers, farthest),
          gather_(lab_, functions_.file(method), effect::method_function),
          level_(level) {}
    OnRough(const std::string& method, int layers, const Changes& changes)
        : functions_(layers),
          gather_(lab_, changed(functions_, method, changes), effect::method_function),
          level_(false) {}

    static std::vector<Inputs> points(const Camera& camera) { return rough_view::points(camera, settings); }
    [[nodiscard]] glm::vec2 at(const Inputs& point, const Surfaces& surfaces) const {
        check::ImageSet images = rough_view::view(surfaces);
        if (level_) {
            const auto half = [](glm::ivec2) { return glm::vec4(0.5F); };
            images.insert_or_assign("gloam_fetch_prepared",
                                    check::make_image<glm::vec4>(rough_view::size, half));
        }
        return gather_.with_images(images, point);
    }
    Results operator()(const Camera& camera, const Surfaces& surfaces) const {
        return (*this)(points(camera), surfaces);
    }
    Results operator()(const std::vector<Inputs>& points, const Surfaces& surfaces) const {
        return gather_(points, rough_view::view(surfaces));
    }

  private:
    MethodFunctions functions_;
    check::Lab lab_ = functions_.lab();
    check::Kernel<Gather> gather_;
    bool level_;
};

inline const std::vector<Camera> cameras{rough_view::camera(false), rough_view::camera(true)};

// Whether a method's text calls a function.
inline bool calls(const std::string& method, const std::string& function) {
    const MethodFunctions functions(4);
    return packed_method(functions, functions.file(method)).find(function + "(") != std::string::npos;
}

// Fails unless the results are the same to the bit at each point.
inline void expect_same(const Results& got, const Results& want, const Camera& camera,
                        const std::string& what) {
    ASSERT_EQ(got.size(), want.size());
    for (std::size_t i = 0; i < got.size(); ++i)
        ASSERT_EQ(got[i], want[i]) << (camera.orthographic ? "orthographic, " : "perspective, ") << what
                                   << ", point " << i << ": " << got[i].x << ", expected " << want[i].x;
}

// The last line of a method's function. Changed texts return negative results where something is not as it
// should be.
inline constexpr const char* method_result = "return estimate.samples * vec2(estimate.occlusion, 1.0);";

}  // namespace gloam::test
