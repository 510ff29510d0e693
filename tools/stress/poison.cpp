// SPDX-License-Identifier: MIT
#include "stress/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "check/function.hpp"
#include "effect/method_functions.hpp"
#include "effect/methods.hpp"
#include "stress/long_run.hpp"
#include "stress/views.hpp"

namespace gloam::stress {
namespace {

constexpr Sequence sequence_of(unsigned k, float weight_max) {
    return {.pattern = third,
            .seed = 0,
            .first = 0,
            .frames = 1,
            .k = k,
            .table_size = 2048,
            .weight_max = weight_max};
}

constexpr Sequence sequence = sequence_of(32, 500.0F);
constexpr glm::vec4 good{0.5F, 500.0F, 64.0F, 3.0F};
constexpr glm::vec4 empty{0.0F, 0.0F, 0.0F, 3.0F};

// Whether a texel remembers anything, as gloam_history_unpack states it.
bool usable(const glm::vec4& texel) {
    const auto positive = [](float x) { return std::isfinite(x) && x > 0.0F; };
    return texel.x >= 0.0F && texel.x <= 1.0F && positive(texel.y) && positive(texel.w);
}

// Subnormals may be flushed, so what is made of them is not judged here beyond its range.
bool subnormal(float x) {
    return std::fpclassify(x) == FP_SUBNORMAL;
}

// A texel that the next frame can go on with.
bool safe(const glm::vec4& texel) {
    const bool depth = texel.w > 0.0F;  // +infinity for background
    return texel.x >= 0.0F && texel.x <= 1.0F && texel.y >= 0.0F && texel.y <= sequence.weight_max &&
           texel.z >= 0.0F && texel.z < static_cast<float>(sequence.table_size) && depth;
}

using Frame = check::Function<glm::vec4(glm::vec4, float, Sequence)>;

// Each channel of a good history made bad; one frame.
Rows texels(const Frame& frame) {
    const glm::vec4 fresh = frame(empty, 0.25F, sequence);
    std::size_t unsafe = 0;
    std::size_t not_fresh = 0;
    for (const float bad : bad_values()) {
        for (int channel = 0; channel < 4; ++channel) {
            glm::vec4 texel = good;
            texel[channel] = bad;
            const glm::vec4 after = frame(texel, 0.25F, sequence);
            unsafe += safe(after) ? 0 : 1;
            if (usable(texel) || subnormal(bad)) continue;
            not_fresh += after == fresh ? 0 : 1;
        }
    }
    const std::string varied = "history texel, one channel";
    return {{poison_name, varied, "unsafe after one frame", static_cast<double>(unsafe), 0.0},
            {poison_name, varied, "not healed (a fresh start) after one frame",
             static_cast<double>(not_fresh), 0.0}};
}

// Bad contributions: NaN and infinities leave the history as it is, others count as the nearer end of [0, 1].
Rows contributions(const Frame& frame) {
    std::size_t unsafe = 0;
    std::size_t wrong = 0;
    for (const float bad : bad_values()) {
        const glm::vec4 after = frame(good, bad, sequence);
        unsafe += safe(after) ? 0 : 1;
        const float read = std::isfinite(bad) ? glm::clamp(bad, 0.0F, 1.0F) : 0.0F;
        const float expected = std::isfinite(bad) ? frame(good, read, sequence).x : good.x;
        wrong += subnormal(bad) || after.x == expected ? 0 : 1;
    }
    const std::string varied = "contribution of one frame";
    return {{poison_name, varied, "unsafe after one frame", static_cast<double>(unsafe), 0.0},
            {poison_name, varied, "damage other than stated", static_cast<double>(wrong), 0.0}};
}

// Frames until a history that is plausible but wrong (occlusion 1, full weight) is right within 1/255.
Row healing(const Accumulate& accumulate, unsigned k, float weight_max) {
    const double alpha = k / (double{weight_max} + k);
    const double stated = std::ceil(std::log(255.0) / -std::log1p(-alpha));
    Sequence all = sequence_of(k, weight_max);
    const double right = contribution(all, 0);
    const auto healed = [&](unsigned frames) {
        all.frames = frames;
        const auto [texel, range] =
            accumulate(glm::vec4(1.0F, weight_max, 0.0F, 3.0F), all, glm::vec2(1.0F, 0.0F));
        return std::abs(double{texel.x} - right) < 1.0 / 255.0;
    };
    unsigned low = 0;
    unsigned high = 60'000;
    if (!healed(high)) return {poison_name, "wrong history", "frames to heal", INFINITY, stated};
    while (high - low > 1) {
        const unsigned middle = (low + high) / 2;
        (healed(middle) ? high : low) = middle;
    }
    return {poison_name, fmt::format("wrong but plausible history, k {}, w_max {}", k, weight_max),
            "frames until right within 1/255", static_cast<double>(high), stated};
}

}  // namespace

Rows poisoned_history(const Context& context) {
    context.progress(fmt::format("{}: history", poison_name));
    const Frame frame(context.lab, accumulate_file, "stress_frame");
    const Accumulate accumulate(context.lab, accumulate_file, "stress_accumulate");
    Rows rows = texels(frame);
    for (const Row& row : contributions(frame)) rows.push_back(row);
    rows.push_back(healing(accumulate, 32, 500.0F));
    rows.push_back(healing(accumulate, 8, 1500.0F));
    return rows;
}

namespace {

constexpr glm::ivec2 size{9, 7};

// Samples of a gather.
constexpr unsigned asked = 33;

using effect::GatherCamera;
using effect::GatherKernel;

// Of a method: (sum, count); reads depths by gloam_fetch_depth.
using Gather = check::Function<effect::MethodGather>;

// What a method prepares for an image of that size; one of mssao for `resolutions`.
std::optional<effect::Preparation> gather_preparation(const effect::MethodInfo& method,
                                                      unsigned resolutions) {
    effect::Settings settings;
    settings.method = method.name;
    settings.own.steps = resolutions;
    return effect::preparation_of(settings, {size.x, size.y});
}

// The images that a method reads: depths, normals as bad as they, and for one that prepares something its
// image, every texel alike.
check::ImageSet gather_images(check::Image depths, const std::optional<effect::Preparation>& preparation,
                              float prepared) {
    check::Image normals = check::make_image<glm::vec3>(
        depths.size, [&](glm::ivec2 at) { return glm::vec3(0, 0, depths.at<float>(at)); });
    check::ImageSet images{{"gloam_fetch_depth", std::move(depths)},
                           {"gloam_fetch_normal", std::move(normals)}};
    if (!preparation) return images;
    const glm::ivec2 texels(preparation->image.width, preparation->image.height);
    images.emplace("gloam_fetch_prepared",
                   check::make_image<glm::vec4>(texels, [=](glm::ivec2) { return glm::vec4(prepared); }));
    return images;
}

constexpr GatherCamera camera{{1.2F, -1.5F}, size, false};

// Fetches outside an image, and results that are outside their range, over all calls.
struct Count {
    std::size_t fetches_outside = 0;
    std::size_t results_outside = 0;
};

// The function on all inputs; `good` judges one result.
template <class Kernel, class Good>
void call(const Kernel& kernel, const std::vector<typename Kernel::Inputs>& inputs,
          const check::ImageSet& images, Good&& good, Count& count) {
    std::vector<check::Word> words;
    for (const auto& input : inputs)
        std::apply([&words](const auto&... value) { (check::append_words(value, words), ...); }, input);
    const check::KernelCore::Result result = kernel.core().run(words, inputs.size(), images);
    if (result.fault) count.fetches_outside += result.fault->count;
    std::span<const check::Word> rest = result.outputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto output = check::take_words<typename Kernel::Output>(rest);
        count.results_outside += good(output) ? 0 : 1;
    }
}

// Depth 3 with a bad value at one pixel, or everywhere.
check::Image depths(float bad, glm::ivec2 at, bool everywhere) {
    return check::make_image<float>(size,
                                    [=](glm::ivec2 pixel) { return everywhere || pixel == at ? bad : 3.0F; });
}

glm::vec3 position_at(glm::ivec2 pixel, float depth) {
    const glm::vec2 ndc = 2.0F * (glm::vec2(pixel) + 0.5F) / glm::vec2(size) - 1.0F;
    return {ndc / camera.p00_p11 * depth, -depth};
}

template <class Visit>
void for_each_pixel(Visit&& visit) {
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) visit(glm::ivec2(x, y));
}

// Images of bad depths: at the middle, at a corner, everywhere.
template <class Visit>
void for_each_image(Visit&& visit) {
    for (const float bad : bad_values()) {
        visit(bad, depths(bad, size / 2, false));
        visit(bad, depths(bad, glm::ivec2(0), false));
        visit(bad, depths(bad, glm::ivec2(0), true));
    }
}

// Every pixel of the image, and bad positions, normals, radii and angles.
std::vector<Gather::Inputs> gather_inputs(float bad, unsigned steps) {
    const auto method_of_length = [steps](float length) {
        return effect::MethodValues{
            .range = length, .epsilon = length, .thickness = 1.0F, .steps = steps, .disagreement = 0.05F};
    };
    const GatherKernel kernel{0.5F, 0.001F, 0.0F, 4'294'967'280U, asked};  // its index passes 2^32
    const glm::vec3 position = position_at(size / 2, 3.0F);
    const glm::vec3 normal(0, 0, 1);
    std::vector<Gather::Inputs> inputs;
    for_each_pixel([&](glm::ivec2 at) {
        inputs.emplace_back(position_at(at, 3.0F), normal, camera, kernel, method_of_length(1.0F));
    });
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 moved = position;
        glm::vec3 turned = normal;
        moved[axis] = bad;
        turned[axis] = bad;
        inputs.emplace_back(moved, normal, camera, kernel, method_of_length(1.0F));
        inputs.emplace_back(position, turned, camera, kernel, method_of_length(1.0F));
    }
    inputs.emplace_back(position, normal, camera, GatherKernel{bad, 0.001F, 0.0F, 0, asked},
                        method_of_length(1.0F));
    inputs.emplace_back(position, normal, camera, GatherKernel{0.5F, bad, 0.0F, 0, asked},
                        method_of_length(1.0F));
    inputs.emplace_back(position, normal, camera, GatherKernel{0.5F, 0.001F, bad, 0, asked},
                        method_of_length(1.0F));
    inputs.emplace_back(position, normal, camera, GatherKernel{0.5F, 0.001F, 0.0F, 0, 0},
                        method_of_length(1.0F));
    inputs.emplace_back(position, normal, camera, kernel, method_of_length(bad));
    return inputs;
}

// (samples times occlusion, samples) of a gather of so many at most.
bool good_sum(glm::vec2 sum, std::uint32_t most) {
    return sum.x >= 0.0F && sum.x <= sum.y && sum.y <= static_cast<float>(most);
}

Count gathers(const check::Lab& lab, const effect::MethodInfo& method) {
    const Gather gather(lab, method.name + ".glsl", effect::method_function);
    const unsigned steps = 3;
    const std::uint32_t most = effect::samples_taken(method, asked, steps);
    const auto preparation = gather_preparation(method, steps);
    Count count;
    for_each_image([&](float bad, const check::Image& image) {
        for (const float prepared : {bad, 0.5F}) {
            call(
                gather, gather_inputs(bad, steps), gather_images(image, preparation, prepared),
                [most](glm::vec2 sum) { return good_sum(sum, most); }, count);
            if (!preparation) break;
        }
    });
    return count;
}

void append_rows(const std::string& function, const Count& count, Rows& rows) {
    const std::string varied = fmt::format("{}, every argument", function);
    rows.push_back(
        {poison_name, varied, "fetches outside the image", static_cast<double>(count.fetches_outside), 0.0});
    rows.push_back({poison_name, varied, "results outside their range",
                    static_cast<double>(count.results_outside), 0.0});
}

}  // namespace

Rows poisoned_gathers(const Context& context) {
    context.progress(fmt::format("{}: fetches of methods", poison_name));
    Rows rows;
    for (const effect::MethodInfo& method : methods_of(context))
        append_rows("method " + method.name, gathers(context.lab, method), rows);
    context.lab.require_silent_validation();
    return rows;
}

Rows poison(const Context& context) {
    Rows rows = poisoned_passes(context);
    for (const auto& part : {poisoned_gathers, poisoned_history}) {
        append(rows, part(context));
    }
    return rows;
}

}  // namespace gloam::stress
