// SPDX-License-Identifier: MIT
#include "effect/internal/sample_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

constexpr std::uint32_t columns = 256;             // SAMPLE_TABLE_COLUMNS of samples/table.glsl
constexpr std::uint32_t group_size = 64;           // of sample_table.comp
constexpr std::uint32_t most_tabulated = 131'072;  // 2 MiB

std::uint32_t most_of_frame(const Settings& settings) {
    return std::max(settings.samples, settings.samples_converged);
}

// A frame starts below the size of the table and goes on to its own end.
std::uint32_t last_of(const Settings& settings) {
    return settings.table_size - 1 + most_of_frame(settings);
}

}  // namespace

bool tabulates_samples(const Settings& settings) {
    return settings.sample_table && !method_named(settings.method).points.empty() &&
           last_of(settings) < most_tabulated;
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
    const gpu::Extent extent{columns, last_of(settings) / columns + 1};
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
    const shader::Spirv spirv = library_.compile("sample_table.comp", {sample_point_of(samples_)},
                                                 {{"gloam/sampling/hemisphere_cosine_point.glsl",
                                                   fmt::format("gloam/sampling/{}_point.glsl", samples_)}});
    return pipelines_
        .emplace(samples_,
                 gpu::ComputePipeline(*device_, {.spirv = spirv,
                                                 .bindings = {gpu::BindingKind::storage_image},
                                                 .push_constant_bytes = sizeof(SampleTableParameters)}))
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
                     .groups = {(count + group_size - 1) / group_size, 1, 1}});
}

}  // namespace gloam::effect
