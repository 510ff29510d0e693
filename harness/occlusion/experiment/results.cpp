// SPDX-License-Identifier: MIT
#include "experiment/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "experiment/internal/json_value.hpp"

namespace gloam::experiment {
namespace {

using internal::Members;
using nlohmann::ordered_json;

constexpr int most = 1'000'000;  // of counts that are small
constexpr double largest = std::numeric_limits<double>::max();

// The members of each part of a record are named once, by members(): with a MemberWriter they are written,
// with a MemberReader they are read.
class MemberWriter {
  public:
    template <class T>
    void member(const char* name, T& value) {
        if constexpr (std::is_class_v<T> && requires { value.has_value(); }) {
            if (value) member(name, *value);
        } else if constexpr (std::is_same_v<T, std::string>) {
            if (!value.empty()) json[name] = value;
        } else if constexpr (std::is_arithmetic_v<T>) {
            json[name] = value;
        } else {
            json[name] = json_of(value);
        }
    }

    template <class T>
    static ordered_json json_of(std::vector<T>& values) {
        ordered_json all = ordered_json::array();
        for (T& value : values) all.push_back(json_of(value));
        return all;
    }

    template <class T>
    static ordered_json json_of(T& value) {
        MemberWriter writer;
        members(writer, value);
        return std::move(writer.json);
    }

    ordered_json json = ordered_json::object();
};

class MemberReader {
  public:
    explicit MemberReader(const JsonReader& value) : members_(value) {}

    template <class T>
    void member(const char* name, T& value) {
        const JsonReader* found = members_.find(name);
        members_.require(name, found != nullptr);
        read(*found, value);
    }

    // What was empty was not written.
    template <class T>
    void member(const char* name, std::optional<T>& value) {
        if (const JsonReader* found = members_.find(name)) read(*found, value.emplace());
    }
    void member(const char* name, std::string& value) {
        if (const JsonReader* found = members_.find(name)) read(*found, value);
    }

  private:
    static void read(const JsonReader& value, std::string& text) { internal::read(value, text); }
    static void read(const JsonReader& value, int& count) { count = value.integer(0, most); }
    static void read(const JsonReader& value, double& number) {  // JSON has no NaN
        number = value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.number(-largest, largest);
    }
    static void read(const JsonReader& value, std::uint64_t& count) {
        constexpr double most_counted = 9e15;
        count = static_cast<std::uint64_t>(value.number(0.0, most_counted));
    }
    static void read(const JsonReader& value, std::uint32_t& count) {
        count = static_cast<std::uint32_t>(value.integer(1, most));
    }

    template <class T>
    static void read(const JsonReader& value, std::vector<T>& values) {
        for (const JsonReader& element : value.elements()) read(element, values.emplace_back());
    }

    template <class T>
    static void read(const JsonReader& value, T& part) {
        MemberReader reader(value);
        members(reader, part);
    }

    Members members_;
};

// The members of a part that have their own names in the text.
#define GLOAM_MEMBER(name) io.member(#name, all.name);
#define GLOAM_MEMBERS(Part, ...)                                             \
    template <class Io>                                                      \
    void members(Io& io, Part& all) {                                        \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(GLOAM_MEMBER, __VA_ARGS__)) \
    }

GLOAM_MEMBERS(Conditions, experiment, device, driver, frames, scored, repeat, rays)
GLOAM_MEMBERS(ClassScore, pixels, against, count, squares, raw_squares, raw_errors)
GLOAM_MEMBERS(FrameScore, frame, samples, classes)
GLOAM_MEMBERS(ClassFlicker, pixels, mean)
GLOAM_MEMBERS(ClassScores, frames, flicker)
GLOAM_MEMBERS(effect::Errors, rmse, bias, percentile_99)
GLOAM_MEMBERS(Converged, geometry, remapped, similarity, depth, own)
GLOAM_MEMBERS(PointQuality, truth, occlusion, standard_error, shown)
GLOAM_MEMBERS(effect::TileShares, background, below_pixel, half, full)
GLOAM_MEMBERS(effect::RemapBin, count, visibility, truth, square)
GLOAM_MEMBERS(effect::PassTime, pass, ms)
GLOAM_MEMBERS(FrameReading, passes)

template <class Io>
void members(Io& io, FrameQuality& all) {
    io.member("rmse", all.geometry);
    io.member("rmse_raw", all.raw_geometry);
    io.member("rmse_depth", all.depth);
    io.member("rmse_depth_raw", all.raw_depth);
    io.member("bias", all.bias);
    io.member("percentile_99", all.percentile_99);
    io.member("similarity", all.similarity);
    io.member("flicker", all.flicker);
    io.member("rmse_remapped", all.remapped);
    io.member("tiles", all.tiles);
    io.member("samples", all.samples);
    io.member("memory_bytes", all.memory_bytes);
    io.member("converged", all.converged);
    io.member("by_class", all.by_class);
    io.member("bins", all.bins);
}

template <class Io>
void members(Io& io, Visit& all) {
    io.member("width", all.size.width);
    io.member("height", all.size.height);
    io.member("case", all.shown.name);
    io.member("what", all.shown.what);
    io.member("kind", all.shown.kind);
    io.member("half", all.shown.half);
    io.member("target", all.shown.target);
    io.member("candidate", all.candidate);
    io.member("group", all.group);
    io.member("round", all.round);
    io.member("samples_asked", all.samples_asked);
    io.member("quality", all.quality);
    io.member("point", all.point);
    io.member("rmse_own_radius", all.own_radius_error);
    io.member("readings", all.readings);
}

template <class T>
T part_in(const JsonReader& value) {
    T part;
    MemberReader reader(value);
    members(reader, part);
    return part;
}

// What find() compares.
std::string key_of(const Visit& visit) {
    return fmt::format("{} {} {}\n{}\n{}\n{}\n{}", visit.size.width, visit.size.height, visit.round,
                       visit.shown.name, visit.shown.kind, visit.shown.what, visit.candidate);
}

}  // namespace

std::string Record::heading() const {
    Conditions conditions = conditions_;
    return MemberWriter::json_of(conditions).dump();
}

const Visit* Record::find(const Visit& like) const {
    const auto found = places_.find(key_of(like));
    return found == places_.end() ? nullptr : &visits_[found->second];
}

void Record::add(Visit visit) {
    const auto [place, is_new] = places_.try_emplace(key_of(visit), visits_.size());
    if (is_new)
        visits_.push_back(std::move(visit));
    else
        visits_[place->second] = std::move(visit);
}

void Record::add_line(std::string_view line) {
    const ordered_json visit = record::parse_json(line);
    add(part_in<Visit>(JsonReader(visit, "")));
}

std::string size_text(gpu::Extent extent) {
    return fmt::format("{} x {}", extent.width, extent.height);
}

std::string line_of(const Visit& visit) {
    Visit written = visit;
    return MemberWriter::json_of(written).dump();
}

Record read_record(const std::string& name, std::string_view text) {
    std::size_t number = 1;
    try {
        const std::string_view first = text.substr(0, text.find('\n'));
        const bool is_document = !ordered_json::accept(first) || first.size() == text.size();
        const ordered_json heading = record::parse_json(is_document ? text : first);
        Record record(part_in<Conditions>(JsonReader(heading, "")));
        if (heading.contains("visits")) {
            for (const JsonReader& visit : JsonReader(heading["visits"], "visits").elements())
                record.add(part_in<Visit>(visit));
            return record;
        }
        for (std::size_t at = first.size() + 1; at < text.size();) {
            ++number;
            const std::size_t end = std::min(text.find('\n', at), text.size());
            record.add_line(text.substr(at, end - at));
            at = end + 1;
        }
        return record;
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}, line {}: {}", name, number, error.what()));
    }
}

Record joined(std::span<const Record> parts) {
    if (parts.empty()) throw std::invalid_argument("no results: expected one or more");
    Record whole(parts.front().conditions());
    for (const Record& part : parts) {
        if (part.conditions() != whole.conditions())
            throw std::invalid_argument(
                fmt::format("results of {} and of {}: expected the same", whole.heading(), part.heading()));
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
