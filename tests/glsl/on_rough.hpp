// SPDX-License-Identifier: MIT
#pragma once

#include "gathers.hpp"
#include "library_calls.hpp"

// A view in which no mistake hides behind a symmetry: a tilted plane with up to four rough surfaces before
// and behind it, an image higher than wide, pixels that are not square, points up to its borders.
namespace gloam::test::rough_view {

inline constexpr float radius = 0.8F;
inline constexpr glm::ivec2 size(29, 47);

inline Camera camera(bool orthographic) {
    return {orthographic ? glm::vec2(0.55F, -0.8F) : glm::vec2(1.6F, -2.3F), size, orthographic};
}

// The plane under a pixel, view space. The shaded points lie on it.
inline glm::vec3 normal() {
    return glm::normalize(glm::vec3(0.35F, -0.25F, 1.0F));
}
inline glm::vec3 point(glm::ivec2 pixel, const Camera& camera) {
    const glm::vec2 ndc = (2.0F * glm::vec2(pixel) + 1.0F - glm::vec2(size)) / glm::vec2(size);
    const glm::vec2 side = ndc / camera.p00_p11;
    const glm::vec3 n = normal();
    if (camera.orthographic) return {side, -3.0F - (n.x * side.x + n.y * side.y) / n.z};
    return glm::vec3(side, -1.0F) * (-3.0F * n.z / glm::dot(glm::vec3(side, -1.0F), n));
}

// In [0, 1), another one for each pixel and number.
inline float noise(glm::ivec2 pixel, std::uint32_t number) {
    std::uint32_t bits = static_cast<std::uint32_t>(pixel.x) * 374761393U +
                         static_cast<std::uint32_t>(pixel.y) * 668265263U + number * 2246822519U;
    bits = (bits ^ (bits >> 13)) * 1274126177U;
    bits = (bits ^ (bits >> 15)) * 2654435761U;
    return static_cast<float>(bits >> 16) / 65536.0F;
}

// Depth of a surface from 0.9 radii before the plane to 0.7 behind it; 0, no surface, in a pixel of 16.
inline Depths surface(std::uint32_t number, const Camera& camera) {
    return [number, camera](glm::ivec2 pixel) {
        const float n = noise(pixel, number);
        return n > 15.0F / 16.0F ? 0.0F : -point(pixel, camera).z - radius * (1.7F * n - 0.7F);
    };
}
inline float none(glm::ivec2) {
    return 0.0F;
}

// The images that a method reads; the surfaces in the order of the layers.
inline check::ImageSet view(const std::vector<Depths>& surfaces) {
    const auto behind = [&](glm::ivec2 p, std::size_t layer) {
        return layer < surfaces.size() ? surfaces[layer](p) : 0.0F;
    };
    check::ImageSet images = view_of(size, surfaces.at(0), [](glm::ivec2 p) {
        return normal() + glm::vec3(noise(p, 8), noise(p, 9), 0) - 0.5F;
    });
    images.emplace("gloam_fetch_layers", check::make_image<glm::vec3>(size, [&](glm::ivec2 p) {
                       return glm::vec3(behind(p, 1), behind(p, 2), behind(p, 3));
                   }));
    images.emplace(
        "gloam_fetch_prepared",
        check::make_image<glm::vec4>(
            size, [](glm::ivec2 p) { return glm::vec4(noise(p, 4), noise(p, 5), noise(p, 6), noise(p, 7)); },
            check::Border::clamp));
    return images;
}

// Pixel of a shaded point.
inline glm::ivec2 pixel_of(std::size_t number) {
    const int across = size.x / 5 + 1;
    return {1 + 5 * (static_cast<int>(number) % across), 1 + 6 * (static_cast<int>(number) / across)};
}

// Points all over the image, each with other samples.
inline std::vector<GatherInputs> points(const Camera& camera, const Method& method) {
    std::vector<GatherInputs> all;
    for (unsigned i = 0; pixel_of(i).y < size.y; ++i) {
        const Samples samples{.radius = radius,
                              .bias = 0.02F,
                              .angle = 0.13F * static_cast<float>(i),
                              .first = 16 * i,
                              .count = 16};
        all.emplace_back(point(pixel_of(i), camera), normal(), camera, samples, method);
    }
    return all;
}

}  // namespace gloam::test::rough_view

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

// A method on the rough view. layers: of its settings. farthest: of its kernel. level: the prepared image has
// one value.
class OnRough {
  public:
    using Inputs = GatherInputs;
    static constexpr Method settings{.range = 0.7F,
                                     .epsilon = 0.3F,
                                     .intensity = 0.3F,
                                     .thickness = 0.4F,
                                     .angle_bias = 0.1F,
                                     .steps = 4,
                                     .disagreement = 0.05F,
                                     .feature_thickness = 1e18F};

    OnRough(const std::string& method, int layers, float farthest = infinity, bool level = false)
        : gathers_(layers, farthest), gather_(gathers_[method]), level_(level) {}
    OnRough(const std::string& method, int layers, const Changes& changes)
        : gathers_(layers),
          gather_(gathers_.in_file(changed(gathers_.functions(), method, changes))),
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
    Gathers gathers_;
    check::Function<Gather> gather_;
    bool level_;
};

inline const std::vector<Camera> cameras{rough_view::camera(false), rough_view::camera(true)};

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
