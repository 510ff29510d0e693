// SPDX-License-Identifier: MIT
#include "experiment/results.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "record/members.hpp"
#include "record/output.hpp"

namespace gloam::effect {

GLOAM_MEMBERS(Errors, rmse, bias, percentile_99)
GLOAM_MEMBERS(TileShares, background, below_pixel, half, full)
GLOAM_MEMBERS(RemapBin, count, visibility, truth, square)
GLOAM_MEMBERS(PassTime, pass, ms)

}  // namespace gloam::effect

namespace gloam::record {

template <>
constexpr Form form_of<experiment::Conditions> = Form::sparse;
template <>
constexpr Form form_of<experiment::Visit> = Form::sparse;

}  // namespace gloam::record

namespace gloam::experiment {

using nlohmann::ordered_json;

GLOAM_MEMBERS(Conditions, experiment, device, driver, frames, scored, repeat, rays)
GLOAM_MEMBERS(ClassScore, pixels, against, count, squares, raw_squares, raw_errors)
GLOAM_MEMBERS(FrameScore, frame, samples, classes)
GLOAM_MEMBERS(ClassFlicker, pixels, mean)
GLOAM_MEMBERS(ClassScores, frames, flicker)
GLOAM_MEMBERS(Converged, geometry, remapped, similarity, depth, own)
GLOAM_MEMBERS(PointQuality, truth, occlusion, standard_error, shown)
GLOAM_MEMBERS(FrameReading, passes)

template <class Io>
void members(Io& io, FrameQuality& all) {
    record::each(io, "rmse", all.geometry, "rmse_raw", all.raw_geometry, "rmse_depth", all.depth,
                 "rmse_depth_raw", all.raw_depth, "bias", all.bias, "percentile_99", all.percentile_99,
                 "similarity", all.similarity, "flicker", all.flicker, "rmse_remapped", all.remapped, "tiles",
                 all.tiles, "samples", all.samples, "memory_bytes", all.memory_bytes, "converged",
                 all.converged, "by_class", all.by_class, "bins", all.bins);
}

template <class Io>
void members(Io& io, Visit& all) {
    record::each(io, "width", all.size.width, "height", all.size.height, "case", all.shown.name, "what",
                 all.shown.what, "kind", all.shown.kind, "half", all.shown.half, "target", all.shown.target,
                 "candidate", all.candidate, "group", all.group, "round", all.round, "samples_asked",
                 all.samples_asked, "quality", all.quality, "point", all.point, "rmse_own_radius",
                 all.own_radius_error, "readings", all.readings);
    io.require(all.size.width > 0 && all.size.height > 0, "a size of at least 1 x 1");
}

namespace {

// What find() compares.
std::string key_of(const Visit& visit) {
    return fmt::format("{} {} {}\n{}\n{}\n{}\n{}", visit.size.width, visit.size.height, visit.round,
                       visit.shown.name, visit.shown.kind, visit.shown.what, visit.candidate);
}

}  // namespace

const Visit* Record::find(const Visit& like) const {
    const auto found = places_.find(key_of(like));
    return found == places_.end() ? nullptr : &visits_[found->second];
}

void Record::add(Visit visit) {
    const auto [place, is_new] = places_.try_emplace(key_of(visit), visits_.size());
    if (is_new) visits_.emplace_back();
    visits_[place->second] = std::move(visit);
}

void Record::add_line(std::string_view line) {
    add(record::from_line<Visit>(line));
}

std::string line_of(const Conditions& conditions) {
    return record::json_of(conditions).dump();
}

std::string line_of(const Visit& visit) {
    return record::json_of(visit).dump();
}

Record read_record(const std::string& name, std::string_view text) {
    std::optional<Record> record;
    const auto take = [&](std::string_view line) {
        if (record) return record->add_line(line);
        const ordered_json heading = record::parse_json(line);
        const record::JsonReader reader(heading, "");
        record.emplace(record::from_json<Conditions>(reader));
        if (reader.has("visits"))
            for (const record::JsonReader& visit : reader.member("visits").elements())
                record->add(record::from_json<Visit>(visit));
    };
    const std::string_view first = text.substr(0, text.find('\n'));
    const bool is_journal = ordered_json::accept(first) && first.size() < text.size();
    record::take_lines(name, text, take, is_journal ? '\n' : '\0');
    return *record;
}

Record joined(std::span<const Record> parts) {
    Record whole(parts.front().conditions());
    for (const Record& part : parts) {
        if (part.conditions() != whole.conditions())
            throw std::invalid_argument(fmt::format("results of {} and of {}: expected the same",
                                                    line_of(whole.conditions()), line_of(part.conditions())));
        for (const Visit& visit : part.visits()) {
            if (whole.find(visit) != nullptr)
                throw std::invalid_argument(
                    fmt::format("{}/{}: in two results, expected in one", visit.shown.name, visit.candidate));
            whole.add(visit);
        }
    }
    return whole;
}

}  // namespace gloam::experiment
