// SPDX-License-Identifier: MIT
#include "effect/study/still_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "effect/study/motion_study.hpp"

namespace gloam::effect {

Limit::Limit(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent)
    : effect_(device, passes, extent) {}

std::vector<float> Limit::of(const scene::GBuffer& view, const Settings& settings) {
    // k_1 samples in the first frame, k_2 in each later frame.
    constexpr float weight_max = 8'192.0F;
    static_assert(limit_first + limit_samples < 8'192 && limit_samples % most_samples == 0);
    Settings many = settings;
    many.history = true;
    many.samples = limit_first;
    many.samples_converged = most_samples;
    many.c_spatial = 0.5F * static_cast<float>(limit_first) / weight_max;
    many.weight_max = weight_max;
    many.table_size = 1U << 24U;
    many.precision = HistoryPrecision::float32;
    many.c_rot = 0.0F;
    many.filter = Filter::none;
    effect_.begin(view, many);
    const Frame first = effect_.next();
    Frame last;
    for (std::uint32_t taken = 0; taken < limit_samples; taken += most_samples) last = effect_.next();
    std::vector<float> limit = last.occlusion;
    for (std::size_t i = 0; i < limit.size(); ++i) {
        const double before = double{first.convergence[i]} * double{weight_max};
        const double after = double{last.convergence[i]} * double{weight_max};
        if (after <= before) continue;  // known without samples
        limit[i] = static_cast<float>(
            (after * double{last.occlusion[i]} - before * double{first.occlusion[i]}) / (after - before));
    }
    return limit;
}

namespace {

std::size_t index_of(Against reference) {
    return static_cast<std::size_t>(reference);
}
std::size_t index_of(PixelClass which) {
    return static_cast<std::size_t>(which);
}

SquaredErrors squared_errors(std::span<const float> image, std::span<const float> truth, const Mask& mask) {
    if (image.size() != truth.size())
        throw std::invalid_argument("a reference of another size than the image");
    SquaredErrors errors;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double error = double{image[i]} - double{truth[i]};
        if ((!mask.empty() && mask[i] == 0) || std::isnan(error)) continue;
        errors.sum += error * error;
        ++errors.count;
    }
    return errors;
}

void add(Score::Table& to, const Score::Table& from) {
    for (std::size_t r = 0; r < references; ++r)
        for (std::size_t c = 0; c < pixel_classes; ++c) to[r][c] += from[r][c];
}

double rmse_of(std::span<const float> image, const Truth& truth) {
    return truth.empty() ? std::numeric_limits<double>::quiet_NaN() : errors_of(image, truth).rmse;
}

}  // namespace

std::string_view name_of(Against reference) {
    constexpr std::array<std::string_view, references> names{"limit", "depth", "geometry"};
    return names.at(index_of(reference));
}

std::string_view name_of(PixelClass which) {
    constexpr std::array<std::string_view, pixel_classes> names{"all", "settled", "young", "disoccluded",
                                                                "near_moving"};
    return names.at(index_of(which));
}

Mask mask_of(const PixelClasses& classes, PixelClass which) {
    switch (which) {
        case PixelClass::all:
            return {};
        case PixelClass::settled:
            return classes.settled();
        case PixelClass::disoccluded:
            return classes.disoccluded();
        case PixelClass::near_moving:
            return classes.near_moving();
        case PixelClass::young:
            break;
    }
    Mask rest(classes.settled().size(), 0);
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = (classes.settled()[i] | classes.disoccluded()[i] | classes.near_moving()[i]) == 0 ? 1 : 0;
    return rest;
}

SquaredErrors& SquaredErrors::operator+=(const SquaredErrors& other) {
    sum += other.sum;
    count += other.count;
    return *this;
}

double SquaredErrors::rmse() const {
    return count == 0 ? std::numeric_limits<double>::quiet_NaN()
                      : std::sqrt(sum / static_cast<double>(count));
}

Score& Score::operator+=(const Score& other) {
    add(raw, other.raw);
    add(filtered, other.filtered);
    return *this;
}

double Score::rmse_raw(Against reference, PixelClass which) const {
    return raw.at(index_of(reference)).at(index_of(which)).rmse();
}

double Score::rmse_filtered(Against reference, PixelClass which) const {
    return filtered.at(index_of(reference)).at(index_of(which)).rmse();
}

Score score_of(const Frame& frame, const References& references, const PixelClasses& classes) {
    Score score;
    for (const PixelClass which : all_classes) {
        const Mask mask = mask_of(classes, which);
        for (std::size_t r = 0; r < references.size(); ++r) {
            if (references[r].empty()) continue;
            score.raw[r][index_of(which)] = squared_errors(frame.occlusion, references[r], mask);
            score.filtered[r][index_of(which)] = squared_errors(frame.filtered, references[r], mask);
        }
    }
    return score;
}

std::vector<StillFrame> study_still(const gpu::Device& device, const scene::PassLibrary& passes,
                                    const scene::GBuffer& view, const Settings& settings,
                                    const References& truth, int frames,
                                    const std::function<void(double)>& progress) {
    AmbientOcclusion effect(device, passes, view.extent);
    effect.begin(standing_still(view), settings);
    std::vector<StillFrame> study;
    double samples = 0.0;
    for (int i = 0; i < frames; ++i) {
        const Frame frame = effect.next();
        const Work& work = frame.work;
        const std::uint64_t left_out = work.background + work.below_radius;
        samples += static_cast<double>(work.samples) /
                   static_cast<double>(std::max<std::uint64_t>(1, work.pixels - left_out));
        StillFrame entry{.samples = samples, .weight = std::min(samples, double{settings.weight_max})};
        for (std::size_t r = 0; r < references; ++r) {
            entry.raw.at(r) = rmse_of(frame.occlusion, truth.at(r));
            entry.filtered.at(r) = rmse_of(frame.filtered, truth.at(r));
        }
        if (!truth[0].empty()) entry.bias = errors_of(frame.occlusion, truth[0]).bias;
        study.push_back(entry);
        if (progress) progress(static_cast<double>(i + 1) / frames);
    }
    return study;
}

double convergence_slope(const std::vector<StillFrame>& frames, double weight_max) {
    double n = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    for (const StillFrame& frame : frames) {
        if (frame.samples >= weight_max || !(frame.raw[0] > 0.0)) continue;
        const double log_samples = std::log(frame.samples);
        const double log_error = 2.0 * std::log(frame.raw[0]);
        n += 1.0;
        x += log_samples;
        y += log_error;
        xx += log_samples * log_samples;
        xy += log_samples * log_error;
    }
    if (n < 2.0) return std::numeric_limits<double>::quiet_NaN();
    return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace gloam::effect
