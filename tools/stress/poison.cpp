// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "effect/method_functions.hpp"
#include "effect/methods.hpp"
#include "judge/function.hpp"
#include "stress/run.hpp"
#include "stress/views.hpp"

namespace gloam::stress {
namespace {

constexpr glm::ivec2 size{9, 7};
constexpr unsigned asked = 33;  // samples of a gather
constexpr unsigned steps_asked = 3;

using effect::GatherCamera;
using effect::GatherKernel;

// Of a method: (sum, count); reads depths by gloam_fetch_depth.
using Gather = check::Function<effect::MethodGather>;

// What a method prepares for the image; mssao for so many resolutions.
std::optional<effect::Preparation> gather_preparation(const effect::MethodInfo& method) {
    effect::Settings settings;
    settings.method = method.name;
    settings.own.steps = steps_asked;
    return effect::preparation_of(settings, {size.x, size.y});
}

// The images that a method reads: depths of 3 with all bad values strewn in, or one of these everywhere,
// normals as bad as they, and for one that prepares something its image, every texel alike.
check::ImageSet gather_images(std::optional<float> everywhere,
                              const std::optional<effect::Preparation>& preparation, float prepared) {
    const auto depth = [=](glm::ivec2 at) {
        const auto index = static_cast<std::size_t>(at.y * size.x + at.x);
        return everywhere.value_or(index % 4 == 0 ? bad_values()[index / 4 % bad_values().size()] : 3.0F);
    };
    check::ImageSet images{{"gloam_fetch_depth", check::make_image<float>(size, depth)},
                           {"gloam_fetch_normal", check::make_image<glm::vec3>(size, [&](glm::ivec2 at) {
                                return glm::vec3(0, 0, depth(at));
                            })}};
    if (!preparation) return images;
    const glm::ivec2 texels(preparation->image.width, preparation->image.height);
    images.emplace("gloam_fetch_prepared",
                   check::make_image<glm::vec4>(texels, [=](glm::ivec2) { return glm::vec4(prepared); }));
    return images;
}

constexpr GatherCamera camera{{1.2F, -1.5F}, size, false};

glm::vec3 position_at(glm::ivec2 pixel) {
    const glm::vec2 ndc = 2.0F * (glm::vec2(pixel) + 0.5F) / glm::vec2(size) - 1.0F;
    return {ndc / camera.p00_p11 * 3.0F, -3.0F};
}

// Every pixel of the image, and bad positions, normals, radii and angles.
std::vector<Gather::Inputs> gather_inputs(float bad) {
    const auto values = [](float length) {
        return effect::MethodValues{.range = length,
                                    .epsilon = length,
                                    .thickness = 1.0F,
                                    .steps = steps_asked,
                                    .disagreement = 0.05F};
    };
    const GatherKernel kernel{0.5F, 0.001F, 0.0F, 4'294'967'280U, asked};  // its index passes 2^32
    const glm::vec3 position = position_at(size / 2);
    const glm::vec3 normal(0, 0, 1);
    std::vector<Gather::Inputs> inputs;
    for (int i = 0; i < size.x * size.y; ++i)
        inputs.emplace_back(position_at({i % size.x, i / size.x}), normal, camera, kernel, values(1.0F));
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 moved = position;
        glm::vec3 turned = normal;
        moved[axis] = bad;
        turned[axis] = bad;
        inputs.emplace_back(moved, normal, camera, kernel, values(1.0F));
        inputs.emplace_back(position, turned, camera, kernel, values(1.0F));
    }
    for (const GatherKernel& other :
         {GatherKernel{bad, 0.001F, 0.0F, 0, asked}, GatherKernel{0.5F, bad, 0.0F, 0, asked},
          GatherKernel{0.5F, 0.001F, bad, 0, asked}, GatherKernel{0.5F, 0.001F, 0.0F, 0, 0}})
        inputs.emplace_back(position, normal, camera, other, values(1.0F));
    inputs.emplace_back(position, normal, camera, kernel, values(bad));
    return inputs;
}

Rows gathers(const check::Lab& lab, const effect::MethodInfo& method) {
    const Gather gather(lab, method.name + ".glsl", effect::method_function);
    const auto most = static_cast<float>(effect::samples_taken(method, asked, steps_asked));
    const auto preparation = gather_preparation(method);
    std::size_t fetches_outside = 0;
    std::size_t results_outside = 0;
    const auto call = [&](float bad, std::optional<float> everywhere, float prepared) {
        const std::vector<Gather::Inputs> inputs = gather_inputs(bad);
        std::vector<check::Word> words;
        for (const Gather::Inputs& input : inputs) check::append_words(input, words);
        const check::KernelCore::Result result =
            gather.core().run(words, inputs.size(), gather_images(everywhere, preparation, prepared));
        if (result.fault) fetches_outside += result.fault->count;
        for (std::span<const check::Word> rest = result.outputs; !rest.empty();) {
            const auto sum = check::take_words<glm::vec2>(rest);  // (samples times occlusion, samples)
            results_outside += sum.x >= 0.0F && sum.x <= sum.y && sum.y <= most ? 0 : 1;
        }
    };
    call(1.0F, std::nullopt, 0.5F);
    for (const float bad : bad_values()) {
        call(bad, bad, 0.5F);
        if (preparation) call(bad, std::nullopt, bad);
    }
    const std::string varied = fmt::format("method {}, every argument", method.name);
    return {{poison_name, varied, "fetches outside the image", static_cast<double>(fetches_outside), 0.0},
            {poison_name, varied, "results outside their range", static_cast<double>(results_outside), 0.0}};
}

}  // namespace

Rows poisoned_gathers(const Context& context) {
    context.progress(fmt::format("{}: fetches of methods", poison_name));
    Rows rows;
    for (const effect::MethodInfo& method : methods_of(context)) append(rows, gathers(context.lab, method));
    context.lab.require_silent_validation();
    return rows;
}

Rows poison(const Context& context) {
    Rows rows = poisoned_passes(context);
    append(rows, poisoned_gathers(context));
    append(rows, poisoned_history(context));
    return rows;
}

}  // namespace gloam::stress
