// SPDX-License-Identifier: MIT
#include "effect/internal/sample_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

constexpr std::uint32_t columns = 256;             // SAMPLE_TABLE_COLUMNS of samples/table.glsl
constexpr std::uint32_t most_tabulated = 131'072;  // 2 MiB

std::uint32_t most_of_frame(const Settings& settings) {
    return std::max(settings.samples, settings.samples_converged);
}

}  // namespace

// A frame starts at an index below the size of the table, and continues past it if needed.
std::uint32_t last_tabulated(const Settings& settings) {
    return settings.table_size - 1 + most_of_frame(settings);
}

gpu::Extent sample_table_extent(const Settings& settings) {
    return {columns, last_tabulated(settings) / columns + 1};
}

PassSource sample_table_source(const std::string& samples) {
    return {.file = "sample_table.comp",
            .defines = {sample_point_of(samples)},
            .replaced = {{"gloam/sampling/hemisphere_cosine_point.glsl",
                          fmt::format("gloam/sampling/{}_point.glsl", samples)}}};
}

bool tabulates_samples(const Settings& settings) {
    return settings.sample_table && !method_named(settings.method).points.empty() &&
           last_tabulated(settings) < most_tabulated;
}

std::string sample_point_of(std::string_view points) {
    return fmt::format("SAMPLE_POINT gloam_{}_point", points);
}

SampleTable::SampleTable(const gpu::Device& device, const scene::PassLibrary& library)
    : device_(&device), library_(library) {}

void SampleTable::take(const Settings& settings) {
    most_ = most_of_frame(settings);
    table_size_ = settings.table_size;
    used_ = tabulates_samples(settings);
    if (!used_) return;
    const std::string& samples = method_named(settings.method).points;
    const gpu::Extent extent = sample_table_extent(settings);
    const bool fits = image_ && image_->extent().height >= extent.height;
    if (!fits) image_.emplace(*device_, extent, gpu::Format::rgba32f);
    if (!fits || samples != samples_) filled_ = 0;
    samples_ = samples;
}

std::uint32_t SampleTable::last_needed() const {
    return std::min(taken_, table_size_ - 1) + most_;
}

void SampleTable::advance() {
    if (used_) filled_ = std::max(filled_, last_needed());
    taken_ = std::min(taken_ + most_, table_size_);
}

const gpu::ComputePipeline& SampleTable::pipeline() {
    const auto known = pipelines_.find(samples_);
    if (known != pipelines_.end()) return known->second;
    return pipelines_
        .emplace(samples_, pipeline_of(*device_, library_, sample_table_source(samples_),
                                       {gpu::BindingKind::storage_image}, sizeof(SampleTableParameters)))
        .first->second;
}

void SampleTable::append_step(std::vector<Step>& steps) {
    if (!used_ || last_needed() <= filled_) return;
    range_ = {.first = filled_ + 1, .last = last_needed()};
    const std::uint32_t count = range_.last - range_.first + 1;
    steps.push_back({.name = "sample_table",
                     .pipeline = &pipeline(),
                     .resources = {*image_},
                     .parameters = bytes_of(range_),
                     .groups = {(count + sample_table_group - 1) / sample_table_group, 1, 1}});
}

}  // namespace gloam::effect
