// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "stress/run.hpp"
#include "stress/views.hpp"

namespace gloam::stress {
namespace {

constexpr gpu::Extent extent{37, 26};
constexpr float poison_radius = 0.4F;

// Which buffer holds the bad value.
enum class Target { depth, depth_alone, normal_x, normal_y, normal_z };

struct Place {
    Target target;
    const char* text;
    [[nodiscard]] bool is_depth() const { return target == Target::depth || target == Target::depth_alone; }
};

std::vector<Place> places(Extent extent) {
    std::vector<Place> all{{Target::depth, "depth"},
                           {Target::depth_alone, "depth, normals made of it"},
                           {Target::normal_x, "normal.x"}};
    if (extent == Extent::full) {
        all.push_back({Target::normal_y, "normal.y"});
        all.push_back({Target::normal_z, "normal.z"});
    }
    return all;
}

void put(scene::GBuffer& view, Target target, std::size_t pixel, float value) {
    if (target == Target::depth || target == Target::depth_alone) {
        view.depth[pixel] = value;
    } else {
        view.normal[pixel][static_cast<int>(target) - static_cast<int>(Target::normal_x)] = value;
    }
}

// The passes on one device. What all methods share is compiled once.
class Passes {
  public:
    Passes(const gpu::Device& device, const scene::PassLibrary& library) : effect_(device, library, extent) {}

    void choose(const effect::MethodInfo& method) {
        settings_ = with_radius(with_method(effect::preset_named("tssao-paper").settings, method.name),
                                poison_radius);
        settings_.c_adaptive = 1.0F;  // the filter is at work in every frame
        reads_normals_ = method.reads_normals;
    }

    // The second frame, whose history is that of the first.
    [[nodiscard]] effect::Frame run(const scene::GBuffer& view) {
        effect_.begin(view, settings_);
        (void)effect_.next();
        return effect_.next();
    }

    // The pixels whose occlusion may depend on the depth, or on the normal, at `source`.
    [[nodiscard]] Mask footprint(const scene::GBuffer& view, bool depth, glm::ivec2 source) const {
        const effect::Preparation beside =
            effect::preparation_of(settings_, extent).value_or(effect::Preparation{});
        const bool sampled = depth || reads_normals_;
        const double reach = sampled ? double{poison_radius + beside.reach} : double{beside.reach};
        const bool alone = !sampled && beside.reach == 0.0F;
        const Mask mask = alone ? single_pixel(extent, source) : depth_footprint(view, reach, source);
        return widened(mask, extent, beside.spread);
    }

    [[nodiscard]] int filter_half_width() const { return settings_.filter_half_width; }

  private:
    effect::AmbientOcclusion effect_;
    effect::Settings settings_;
    bool reads_normals_ = false;
};

// What one place suffered, over all bad values.
struct Damage {
    std::size_t outside_unit = 0;
    std::size_t beyond_footprint = 0;
    std::size_t differs_without_robustness = 0;
    int reach = 0;
    int allowed_reach = 0;
};

Mask changed(const std::vector<float>& now, const std::vector<float>& before) {
    Mask mask(now.size());
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = check::to_word(now[i]) != check::to_word(before[i]);
    return mask;
}

std::size_t count_beyond(const Mask& mask, const Mask& allowed) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) count += mask[i] && !allowed[i] ? 1 : 0;
    return count;
}

class Experiment {
  public:
    Experiment(const Context& context, const gpu::Device& fragile)
        : full_(context.extent == Extent::full),
          robust_(context.lab.device(), context.passes),
          fragile_(fragile, context.passes) {}

    [[nodiscard]] Damage run(const effect::MethodInfo& method, const Place& place) {
        robust_.choose(method);
        fragile_.choose(method);
        scene::GBuffer view = steps(extent);
        if (place.target == Target::depth_alone) view.normal.clear();
        const effect::Frame clean = robust_.run(view);
        Damage damage;
        std::size_t number = 0;
        for (const float bad : bad_values()) {
            for (const glm::ivec2 source : sources(number++))
                one_texel(view, place, bad, source, clean, damage);
            everywhere(view, place, bad, damage);
        }
        return damage;
    }

  private:
    // Both sides of a step's edge, two corners and an edge of the image; briefly, a step's edge and a corner
    // in turn.
    [[nodiscard]] std::vector<glm::ivec2> sources(std::size_t number_of_value) const {
        if (!full_) return {number_of_value % 2 == 0 ? glm::ivec2(18, 12) : glm::ivec2(0, 0)};
        return {{18, 12}, {17, 12}, {0, 0}, {36, 25}, {17, 0}};
    }

    [[nodiscard]] effect::Frame both(const scene::GBuffer& view, Damage& damage) {
        effect::Frame frame = robust_.run(view);
        const effect::Frame other = fragile_.run(view);
        const Mask none(frame.filtered.size());
        damage.differs_without_robustness += count_beyond(changed(other.occlusion, frame.occlusion), none) +
                                             count_beyond(changed(other.filtered, frame.filtered), none);
        for (const auto& image : {frame.occlusion, frame.filtered, frame.convergence})
            damage.outside_unit += outside_unit(image);
        return frame;
    }

    void one_texel(scene::GBuffer view, const Place& place, float value, glm::ivec2 source,
                   const effect::Frame& clean, Damage& damage) {
        const Mask allowed = robust_.footprint(view, place.is_depth(), source);
        const Mask wide = widened(allowed, extent, robust_.filter_half_width());
        put(view, place.target,
            static_cast<std::size_t>(source.y) * extent.width + static_cast<std::size_t>(source.x), value);
        const effect::Frame frame = both(view, damage);
        const Mask filtered = changed(frame.filtered, clean.filtered);
        damage.beyond_footprint += count_beyond(changed(frame.occlusion, clean.occlusion), allowed) +
                                   count_beyond(changed(frame.convergence, clean.convergence), allowed) +
                                   count_beyond(filtered, wide);
        damage.reach = std::max(damage.reach, reach_of(filtered, extent, source));
        damage.allowed_reach = std::max(damage.allowed_reach, reach_of(wide, extent, source));
    }

    void everywhere(scene::GBuffer view, const Place& place, float value, Damage& damage) {
        for (std::size_t i = 0; i < view.depth.size(); ++i) put(view, place.target, i, value);
        (void)both(view, damage);
    }

    bool full_;
    Passes robust_;
    Passes fragile_;
};

void append_rows(const std::string& varied, const Damage& damage, Rows& rows) {
    const auto count = [](std::size_t n) { return static_cast<double>(n); };
    rows.push_back({poison_name, varied, "values outside [0, 1] or NaN", count(damage.outside_unit), 0.0});
    rows.push_back(
        {poison_name, varied, "pixels changed beyond the footprint", count(damage.beyond_footprint), 0.0});
    rows.push_back({poison_name, varied, "farthest pixel changed, pixels", static_cast<double>(damage.reach),
                    static_cast<double>(damage.allowed_reach)});
    rows.push_back({poison_name, varied, "values that differ without robustBufferAccess",
                    count(damage.differs_without_robustness), 0.0});
}

gpu::DeviceOptions without_robustness(const check::LabOptions& options) {
    return {.device = options.device,
            .validation = options.validation ? gpu::Validation::on : gpu::Validation::off,
            .cache_directory = options.cache_directory,
            .robust_buffer_access = false};
}

void require_silent(gpu::Device& device) {
    const std::vector<std::string> messages = device.take_validation_messages();
    if (!messages.empty()) throw std::runtime_error("Vulkan validation: " + messages.front());
}

}  // namespace

std::function<Rows(const effect::MethodInfo&)> poisoned_passes_of(const Context& context) {
    const auto fragile = std::make_shared<gpu::Device>(without_robustness(context.lab.options()));
    const auto experiment = std::make_shared<Experiment>(context, *fragile);
    return [context, fragile, experiment](const effect::MethodInfo& method) {
        Rows rows;
        for (const Place& place : places(context.extent)) {
            const std::string varied = fmt::format("{}: {}", method.name, place.text);
            context.progress(fmt::format("{}: {}", poison_name, varied));
            append_rows(varied, experiment->run(method, place), rows);
        }
        require_silent(*fragile);
        context.lab.require_silent_validation();
        return rows;
    };
}

Rows poisoned_passes(const Context& context) {
    const auto rows_of = poisoned_passes_of(context);
    Rows rows;
    for (const effect::MethodInfo& method : methods_of(context)) append(rows, rows_of(method));
    return rows;
}

}  // namespace gloam::stress
