// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <span>
#include <stdexcept>

#include "base/threads.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/method_functions.hpp"
#include "effect/methods.hpp"
#include "judge/function.hpp"
#include "stress/run.hpp"

namespace gloam::stress {
namespace {

constexpr backend::Extent extent{37, 26};
constexpr float poison_radius = 0.4F;

// Which buffer holds the bad value.
struct Location {
    const char* text;
    int normal_axis = -1;  // of the normals; -1: the depth
    bool normals = true;   // the view has some

    void put(scene::GBuffer& view, std::size_t pixel, float value) const {
        (normal_axis < 0 ? view.depth[pixel] : view.normal[pixel][normal_axis]) = value;
    }
};

// The last two are left out of brief runs.
constexpr Location places[]{
    {"depth"}, {"depth, normals made of it", -1, false}, {"normal.x", 0}, {"normal.y", 1}, {"normal.z", 2}};

std::size_t index_of(glm::ivec2 pixel) {
    return static_cast<std::size_t>(pixel.y) * extent.width + static_cast<std::size_t>(pixel.x);
}

glm::ivec2 pixel_at(std::size_t index) {
    return {static_cast<int>(index % extent.width), static_cast<int>(index / extent.width)};
}

// A wall with every other field of 6 x 5 pixels a quarter unit nearer: occlusion along every edge.
scene::GBuffer steps() {
    scene::GBuffer view = wall(extent);
    for (std::size_t i = 0; i < view.depth.size(); ++i)
        if ((pixel_at(i).x / 6 + pixel_at(i).y / 5) % 2 == 1) view.depth[i] -= 0.25F;
    return view;
}

// Which pixels of an image something reaches, row by row.
using Mask = std::vector<bool>;

// Whether the ball around a pixel's surface point, and a pixel and a half more, covers the centre of
// `source`: along each axis, as an angle seen from the eye.
bool covers(const scene::GBuffer& view, std::size_t pixel, double radius, glm::ivec2 source) {
    const glm::dvec2 size(extent.width, extent.height);
    const glm::dvec2 p = glm::abs(glm::dvec2(view.camera.p00_p11()));
    for (int axis = 0; axis < 2; ++axis) {
        const auto slope = [&](double at) { return (2.0 * (at + 0.5) / size[axis] - 1.0) / p[axis]; };
        const double middle = slope(pixel_at(pixel)[axis]);
        const double distance = double{view.depth[pixel]} * std::hypot(middle, 1.0);
        const double half = radius < distance ? std::asin(radius / distance) : INFINITY;
        if (std::atan(slope(source[axis] + 1.5)) < std::atan(middle) - half ||
            std::atan(slope(source[axis] - 1.5)) > std::atan(middle) + half)
            return false;
    }
    return true;
}

// The mask and all pixels up to `pixels` away along each axis: what a filter makes of it.
Mask widened(const Mask& mask, int pixels) {
    Mask wide(mask.size());
    const glm::ivec2 last(static_cast<int>(extent.width) - 1, static_cast<int>(extent.height) - 1);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (!mask[i]) continue;
        const glm::ivec2 low = glm::max(pixel_at(i) - pixels, glm::ivec2(0));
        const glm::ivec2 high = glm::min(pixel_at(i) + pixels, last);
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) wide[index_of({x, y})] = true;
    }
    return wide;
}

// Pixels that differ by any bit. Those of the mask may; empty: none may.
double changed(const std::vector<float>& now, const std::vector<float>& before, const Mask& allowed = {}) {
    double count = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
        if (allowed.empty() || !allowed[i])
            count += subject::to_word(now[i]) == subject::to_word(before[i]) ? 0 : 1;
    return count;
}

// The passes on two devices. What all methods share is compiled once.
class Experiment {
  public:
    Experiment(const Context& context, const backend::vulkan::Device& fragile)
        : full_(!context.scope.brief),
          robust_(context.lab.device(), context.passes),
          fragile_(fragile, context.passes) {}

    // What one place suffers, over all bad values.
    void run(const Context& context, const effect::MethodInfo& method, const Location& place,
             std::size_t number) {
        settings_ = with_radius(with_method(effect::preset_named("tssao-paper").settings, method.name),
                                poison_radius);
        settings_.c_adaptive = 1.0F;  // the filter is at work in every frame
        const std::vector<Poisoned> views = poisoned(place, method.reads_normals, number);
        std::array<std::vector<effect::Frame>, 2> frames;
        base::for_each_index(2, 2, [&](std::size_t i) {
            for (const Poisoned& one : views)
                frames[i].push_back(frame_of(i == 0 ? robust_ : fragile_, one.view));
        });
        double outside_unit = 0;
        double beyond_footprint = 0;
        double changes = 0;
        double differs = 0;
        const effect::Frame& clean = frames[0][0];
        for (std::size_t i = 1; i < views.size(); ++i) {
            const effect::Frame& frame = frames[0][i];
            differs += changed(frames[1][i].occlusion, frame.occlusion) +
                       changed(frames[1][i].filtered, frame.filtered);
            for (const auto* image : {&frame.occlusion, &frame.filtered, &frame.convergence})
                for (const float value : *image) outside_unit += value >= 0.0F && value <= 1.0F ? 0 : 1;
            const Mask& allowed = views[i].allowed;
            if (allowed.empty()) continue;
            changes += changed(frame.filtered, clean.filtered);
            beyond_footprint +=
                changed(frame.occlusion, clean.occlusion, allowed) +
                changed(frame.convergence, clean.convergence, allowed) +
                changed(frame.filtered, clean.filtered, widened(allowed, settings_.filter_half_width));
        }
        const std::string varied = fmt::format("{}: {}", method.name, place.text);
        context.add(varied, "values outside [0, 1] or NaN", outside_unit, 0.0);
        context.add(varied, "pixels changed", changes, std::nullopt);
        context.add(varied, "pixels changed beyond the footprint", beyond_footprint, 0.0);
        context.add(varied, "values that differ without robustBufferAccess", differs, 0.0);
    }

  private:
    // Both sides of a step's edge, two corners and an edge of the image; briefly, one of each in turn.
    [[nodiscard]] std::vector<glm::ivec2> sources(std::size_t number) const {
        if (!full_) return {number % 2 == 0 ? glm::ivec2(18, 12) : glm::ivec2(0, 0)};
        return {{18, 12}, {17, 12}, {0, 0}, {36, 25}, {17, 0}};
    }

    // The second frame, whose history is that of the first.
    [[nodiscard]] effect::Frame frame_of(effect::AmbientOcclusion& effect, const scene::GBuffer& view) const {
        effect.begin(view, settings_);
        (void)effect.next();
        return effect.next();
    }

    // The pixels whose occlusion may depend on the depth, or on the normal, at `source`: those whose ball of
    // influence, as the eye sees it, projects onto it or onto one of its neighbours (a sample takes the
    // nearest pixel; normals from depth take the four neighbours), and `source` itself.
    [[nodiscard]] Mask footprint(const scene::GBuffer& view, bool sampled, glm::ivec2 source) const {
        const effect::Preparation beside =
            effect::preparation_of(settings_, extent).value_or(effect::Preparation{});
        const double reach = double{beside.reach} + (sampled ? double{poison_radius} : 0.0);
        Mask mask(view.depth.size());
        for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = reach > 0.0 && covers(view, i, reach, source);
        mask[index_of(source)] = true;
        return widened(mask, beside.spread);
    }

    struct Poisoned {
        scene::GBuffer view;
        Mask allowed;  // the pixels that may change; empty: all
    };

    // A view without bad values, then the same with each, in one texel and everywhere.
    [[nodiscard]] std::vector<Poisoned> poisoned(const Location& place, bool reads_normals,
                                                 std::size_t number) const {
        std::vector<Poisoned> all{{steps(), {}}};
        if (!place.normals) all[0].view.normal.clear();
        for (const float bad : bad_values) {
            for (const glm::ivec2 source : sources(++number)) {
                const Mask allowed = footprint(all[0].view, place.normal_axis < 0 || reads_normals, source);
                all.push_back({all[0].view, allowed});
                place.put(all.back().view, index_of(source), bad);
            }
            if (!full_ && number % 3 != 0) continue;
            all.push_back(all[0]);
            for (std::size_t i = 0; i < all[0].view.depth.size(); ++i) place.put(all.back().view, i, bad);
        }
        return all;
    }

    bool full_;
    effect::AmbientOcclusion robust_;
    effect::AmbientOcclusion fragile_;
    effect::Settings settings_;
};

}  // namespace

void poisoned_passes(const Context& context) {
    const subject::LabOptions& options = context.lab.options();
    backend::vulkan::Device fragile({.device = options.device,
                                     .validation = options.validation ? backend::vulkan::Validation::on
                                                                      : backend::vulkan::Validation::off,
                                     .cache_directory = options.cache_directory,
                                     .robust_buffer_access = false});
    Experiment experiment(context, fragile);
    for (const effect::MethodInfo& method : context.methods) {
        std::size_t number = 0;
        for (const Location& place : std::span(places).first(context.scope.brief ? 3 : 5)) {
            context.progress(fmt::format("{}: {}", method.name, place.text));
            experiment.run(context, method, place, number++);
        }
        for (const std::string& message : fragile.take_validation_messages())
            throw std::runtime_error("Vulkan validation: " + message);
        context.lab.require_silent_validation();
    }
}

namespace {

constexpr glm::ivec2 size{9, 7};
constexpr unsigned asked = 33;  // samples of a gather
constexpr unsigned steps_asked = 3;

using effect::GatherCamera;
using effect::GatherKernel;

// Of a method: (sum, count); reads depths by gloam_fetch_depth.
using Gather = judge::Function<effect::MethodGather>;

// The images that a method reads: depths of 3 with all bad values strewn in, or one of these everywhere,
// normals as bad as they, and for one that prepares something its image, every texel alike.
subject::ImageSet gather_images(std::optional<float> everywhere,
                                const std::optional<effect::Preparation>& preparation, float prepared) {
    const auto depth = [=](glm::ivec2 at) {
        const auto index = static_cast<std::size_t>(at.y * size.x + at.x);
        return everywhere.value_or(index % 4 == 0 ? bad_values[index / 4 % std::size(bad_values)] : 3.0F);
    };
    subject::ImageSet images{{"gloam_fetch_depth", subject::make_image<float>(size, depth)},
                             {"gloam_fetch_normal", subject::make_image<glm::vec3>(size, [&](glm::ivec2 at) {
                                  return glm::vec3(0, 0, depth(at));
                              })}};
    if (!preparation) return images;
    const glm::ivec2 texels(preparation->image.width, preparation->image.height);
    images.emplace("gloam_fetch_prepared",
                   subject::make_image<glm::vec4>(texels, [=](glm::ivec2) { return glm::vec4(prepared); }));
    return images;
}

constexpr GatherCamera camera{{1.2F, -1.5F}, size, false};

glm::vec3 position_at(glm::ivec2 pixel) {
    const glm::vec2 ndc = 2.0F * (glm::vec2(pixel) + 0.5F) / glm::vec2(size) - 1.0F;
    return {ndc / camera.p00_p11 * 3.0F, -3.0F};
}

// Every pixel of the image, and bad positions, normals, radii and angles.
std::vector<Gather::Inputs> gather_inputs(float bad) {
    const Gather::Inputs good(
        position_at(size / 2), glm::vec3(0, 0, 1), camera,
        GatherKernel{0.5F, 0.001F, 0.0F, 4'294'967'280U, asked},  // its index passes 2^32
        effect::MethodValues{
            .range = 1.0F, .epsilon = 1.0F, .thickness = 1.0F, .steps = steps_asked, .disagreement = 0.05F});
    std::vector<Gather::Inputs> inputs;
    const auto add = [&]() -> Gather::Inputs& { return inputs.emplace_back(good); };
    for (int i = 0; i < size.x * size.y; ++i) std::get<0>(add()) = position_at({i % size.x, i / size.x});
    for (int axis = 0; axis < 3; ++axis) {
        std::get<0>(add())[axis] = bad;
        std::get<1>(add())[axis] = bad;
    }
    for (const GatherKernel& other :
         {GatherKernel{bad, 0.001F, 0.0F, 0, asked}, GatherKernel{0.5F, bad, 0.0F, 0, asked},
          GatherKernel{0.5F, 0.001F, bad, 0, asked}, GatherKernel{0.5F, 0.001F, 0.0F, 0, 0}})
        std::get<GatherKernel>(add()) = other;
    auto& values = std::get<effect::MethodValues>(add());
    values.range = values.epsilon = bad;
    return inputs;
}

void poison_gather(const Context& context, const effect::MethodInfo& method) {
    const Gather gather(context.lab, method.name + ".glsl", effect::method_function);
    const auto most = static_cast<float>(effect::samples_taken(method, asked, steps_asked));
    effect::Settings settings;
    settings.method = method.name;
    settings.own.steps = steps_asked;  // of mssao: resolutions
    const auto preparation = effect::preparation_of(settings, {size.x, size.y});
    double fetches_outside = 0;
    double results_outside = 0;
    const auto call = [&](float bad, std::optional<float> everywhere, float prepared) {
        const std::vector<Gather::Inputs> inputs = gather_inputs(bad);
        std::vector<subject::Word> words;
        for (const Gather::Inputs& input : inputs) subject::append_words(input, words);
        const subject::KernelCore::Result result =
            gather.core().run(words, inputs.size(), gather_images(everywhere, preparation, prepared));
        if (result.fault) fetches_outside += static_cast<double>(result.fault->count);
        for (std::span<const subject::Word> rest = result.outputs; !rest.empty();) {
            const auto sum = subject::take_words<glm::vec2>(rest);  // (samples times occlusion, samples)
            results_outside += sum.x >= 0.0F && sum.x <= sum.y && sum.y <= most ? 0 : 1;
        }
    };
    call(1.0F, std::nullopt, 0.5F);
    for (const float bad : bad_values) {
        call(bad, bad, 0.5F);
        if (preparation) call(bad, std::nullopt, bad);
    }
    const std::string varied = fmt::format("method {}, every argument", method.name);
    context.add(varied, "fetches outside the image", fetches_outside, 0.0);
    context.add(varied, "results outside their range", results_outside, 0.0);
}

}  // namespace

void poisoned_gathers(const Context& context) {
    context.progress("fetches of methods");
    for (const effect::MethodInfo& method : context.methods) poison_gather(context, method);
    context.lab.require_silent_validation();
}

}  // namespace gloam::stress
