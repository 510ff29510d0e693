// SPDX-License-Identifier: MIT
// Falloffs and estimators against closed forms: means of the references over many samples.
// tests/catalogue compares each function of the library with its reference.
#include "reference/occlusion_points.hpp"
#include "support/test.hpp"

namespace gloam::reference::means_test {

constexpr unsigned sample_count = 512 * 256;
const dvec3 up(0, 0, 1);

// Points 1 ... sample_count of Halton's sequence.
const std::vector<dvec3>& halton() {
    static const std::vector<dvec3> points = [] {
        std::vector<dvec3> all;
        for (unsigned i = 1; i <= sample_count; ++i) all.push_back(gloam_halton_3d(i));
        return all;
    }();
    return points;
}

// Over all points.
template <class Sample>
double mean(const Sample& sample) {
    double sum = 0.0;
    for (const dvec3& zeta : halton()) sum += sample(zeta);
    return sum / sample_count;
}

// Plane z = size; plane x = size; inside a closed ball of that radius that touches the point; ball of radius
// 1 at that distance, 30 degrees from the normal.
enum class Scene { ceiling, wall, inside, ball };

// The distance of what a ray from the origin hits; negative: nothing.
double hit(Scene scene, dvec3 direction, double size) {
    if (scene == Scene::ceiling) return direction.z > 0.0 ? size / direction.z : -1.0;
    if (scene == Scene::wall) return direction.x > 0.0 ? size / direction.x : -1.0;
    if (scene == Scene::inside) return 2.0 * size * direction.z;
    const dvec3 center = size * dvec3(0.5, 0.0, std::sqrt(0.75));
    const double along = dot(center, direction);
    const double miss = dot(center, center) - along * along;
    return miss <= 1.0 && along > 0.0 ? along - std::sqrt(1.0 - miss) : -1.0;
}

using Falloff = double (*)(double distance, double radius);

double one(double, double) {
    return 1.0;
}

// Cosine-weighted directions, V D; uniform ones, 2 V D cos; TSSAO-3 as printed: cosine-weighted, V D cos; the
// Monte-Carlo form of CS-2.4 as printed: uniform, V D cos.
enum class Form { cosine, uniform, cosine_printed, uniform_printed };

double rays(Scene scene, double size, Falloff falloff, Form form = Form::cosine) {
    return mean([=](dvec3 zeta) {
        zeta.y = 1.0;
        const bool uniform = form == Form::uniform || form == Form::uniform_printed;
        const dvec3 direction = uniform ? gloam_hemisphere_uniform(zeta) : gloam_hemisphere_cosine(zeta);
        const double d = hit(scene, direction, size);
        if (d < 0.0) return 0.0;
        const double weight = falloff(d, 1.0);
        if (form == Form::cosine) return weight;
        const double term = gloam_contribution_ritschel(1.0, weight, gloam_sample_cosine(direction, up));
        return form == Form::uniform ? 2.0 * term : term;
    });
}

TEST(Rays, OfScenesUnderFalloffs) {
    using enum Scene;
    constexpr Falloff step = gloam_falloff_step;
    constexpr Falloff linear = gloam_falloff_linear;
    constexpr Falloff quadratic = gloam_falloff_quadratic;
    constexpr Falloff alchemy = gloam_falloff_alchemy;
    constexpr double q = 0.25;
    struct Case {
        Scene scene;
        double size;
        Falloff falloff;
        double expected;
    };
    for (const Case& known : {Case{wall, q, step, 0.342519},
                              {wall, q, linear, 0.168214},
                              {wall, q, quadratic, 0.240864},
                              {wall, q, alchemy, 0.252626},
                              {wall, 2.0, alchemy, 0.106103},
                              {wall, q, one, 0.5},
                              {ceiling, q, step, 1 - q * q},
                              {ceiling, q, linear, (1 - q) * (1 - q)},
                              {ceiling, q, quadratic, 1 - q * q + 2 * q * q * std::log(q)},
                              {ceiling, q, one, 1.0},
                              {inside, q, linear, 2.0 / 3.0},
                              {inside, q, quadratic, 1 - q / 2},
                              {inside, 1.0, step, 0.25},
                              {inside, 1.0, linear, 1.0 / 12.0},
                              {ball, 2.0, one, 0.216506},
                              {ball, 4.0, one, 0.0541266}})
        EXPECT_NEAR(rays(known.scene, known.size, known.falloff), known.expected, 1e-3)
            << static_cast<int>(known.scene) << ' ' << known.size;
}

// Both normalised forms estimate the same; TSSAO-3 and CS-2.4 as printed miss a factor.
TEST(Rays, FormsOfTheIntegral) {
    for (const Scene scene : {Scene::ceiling, Scene::wall, Scene::inside, Scene::ball}) {
        const double size = scene == Scene::ball ? 2.0 : 0.25;
        const Falloff weight = scene == Scene::ball ? one : gloam_falloff_linear;
        EXPECT_NEAR(rays(scene, size, weight, Form::uniform), rays(scene, size, weight), 2e-3)
            << static_cast<int>(scene);
    }
    EXPECT_NEAR(rays(Scene::inside, 1.0, one, Form::cosine), 1.0, 1e-6);
    EXPECT_NEAR(rays(Scene::inside, 1.0, one, Form::uniform), 1.0, 1e-3);
    EXPECT_NEAR(rays(Scene::inside, 1.0, one, Form::uniform_printed), 0.5, 1e-3);
    EXPECT_NEAR(rays(Scene::inside, 1.0, one, Form::cosine_printed), 2.0 / 3.0, 1e-3);
    EXPECT_NEAR(rays(Scene::ceiling, 0.1, gloam_falloff_linear, Form::cosine), 0.81, 1e-3);
    EXPECT_NEAR(1.5 * rays(Scene::ceiling, 0.1, gloam_falloff_linear, Form::cosine_printed), 0.85, 1e-3);
}

}  // namespace gloam::reference::means_test
