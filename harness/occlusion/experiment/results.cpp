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
using internal::Value;
using nlohmann::ordered_json;

constexpr int most = 1'000'000;  // of counts that are small
constexpr double largest = std::numeric_limits<double>::max();

// The members of each part of a record are named once, by members(): with a JsonWriter they are written, with
// a JsonReader they are read.
class JsonWriter {
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
        JsonWriter writer;
        members(writer, value);
        return std::move(writer.json);
    }

    ordered_json json = ordered_json::object();
};

class JsonReader {
  public:
    explicit JsonReader(const Value& value) : members_(value) {}

    template <class T>
    void member(const char* name, T& value) {
        const Value* found = members_.find(name);
        members_.require(name, found != nullptr);
        read(*found, value);
    }

    // What was empty was not written.
    template <class T>
    void member(const char* name, std::optional<T>& value) {
        if (const Value* found = members_.find(name)) read(*found, value.emplace());
    }
    void member(const char* name, std::string& value) {
        if (const Value* found = members_.find(name)) found->read(value);
    }

  private:
    static void read(const Value& value, std::string& text) { value.read(text); }
    static void read(const Value& value, int& count) { value.read(count, 0, most); }
    static void read(const Value& value, double& number) {
        number = std::numeric_limits<double>::quiet_NaN();  // which JSON has not
        if (!value.is_null()) value.read(number, -largest, largest);
    }
    static void read(const Value& value, std::uint64_t& count) {
        constexpr double most_counted = 9e15;
        double number = 0.0;
        value.read(number, 0.0, most_counted);
        count = static_cast<std::uint64_t>(number);
    }
    static void read(const Value& value, std::uint32_t& count) {
        int number = 0;
        value.read(number, 1, most);
        count = static_cast<std::uint32_t>(number);
    }

    template <class T>
    static void read(const Value& value, std::vector<T>& values) {
        for (const Value& element : value.elements()) read(element, values.emplace_back());
    }

    template <class T>
    static void read(const Value& value, T& part) {
        JsonReader reader(value);
        members(reader, part);
    }

    Members members_;
};

template <class Io>
void members(Io& io, Conditions& all) {
    io.member("experiment", all.experiment);
    io.member("device", all.device);
    io.member("driver", all.driver);
    io.member("frames", all.frames);
    io.member("scored", all.scored);
    io.member("repeat", all.repeat);
    io.member("rays", all.rays);
}

template <class Io>
void members(Io& io, ClassScore& all) {
    io.member("pixels", all.pixels);
    io.member("against", all.against);
    io.member("count", all.count);
    io.member("squares", all.squares);
    io.member("raw_squares", all.raw_squares);
    io.member("raw_errors", all.raw_errors);
}

template <class Io>
void members(Io& io, FrameScore& all) {
    io.member("frame", all.frame);
    io.member("samples", all.samples);
    io.member("classes", all.classes);
}

template <class Io>
void members(Io& io, ClassFlicker& all) {
    io.member("pixels", all.pixels);
    io.member("mean", all.mean);
}

template <class Io>
void members(Io& io, ClassScores& all) {
    io.member("most_samples", all.most_samples);
    io.member("frames", all.frames);
    io.member("flicker", all.flicker);
}

template <class Io>
void members(Io& io, effect::Errors& all) {
    io.member("rmse", all.rmse);
    io.member("bias", all.bias);
    io.member("percentile_99", all.percentile_99);
}

template <class Io>
void members(Io& io, Converged& all) {
    io.member("geometry", all.geometry);
    io.member("remapped", all.remapped);
    io.member("similarity", all.similarity);
    io.member("depth", all.depth);
    io.member("own", all.own);
}

template <class Io>
void members(Io& io, PointQuality& all) {
    io.member("truth", all.truth);
    io.member("occlusion", all.occlusion);
    io.member("standard_error", all.standard_error);
    io.member("shown", all.shown);
}

template <class Io>
void members(Io& io, effect::RemapBin& all) {
    io.member("count", all.count);
    io.member("visibility", all.visibility);
    io.member("truth", all.truth);
    io.member("square", all.square);
}

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
    io.member("samples", all.samples);
    io.member("memory_bytes", all.memory_bytes);
    io.member("converged", all.converged);
    io.member("by_class", all.by_class);
    io.member("bins", all.bins);
}

template <class Io>
void members(Io& io, effect::Work& all) {
    io.member("pixels", all.pixels);
    io.member("background", all.background);
    io.member("below_radius", all.below_radius);
    io.member("converged", all.converged);
    io.member("samples", all.samples);
    io.member("tiles", all.tiles);
    io.member("tiles_background", all.tiles_background);
    io.member("tiles_skipped", all.tiles_skipped);
    io.member("tiles_shaded", all.tiles_shaded);
    io.member("tiles_filtered", all.tiles_filtered);
    io.member("tiles_blank", all.tiles_blank);
    io.member("tiles_settled", all.tiles_settled);
    io.member("tiles_unfiltered", all.tiles_unfiltered);
}

template <class Io>
void members(Io& io, effect::PassTime& all) {
    io.member("pass", all.pass);
    io.member("ms", all.ms);
}

template <class Io>
void members(Io& io, FrameReading& all) {
    io.member("passes", all.passes);
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
    io.member("work", all.work);
    io.member("readings", all.readings);
}

template <class T>
T part_in(const Value& value) {
    T part;
    JsonReader reader(value);
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
    return JsonWriter::json_of(conditions).dump();
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
    const ordered_json visit = internal::parsed(line);
    add(part_in<Visit>(Value(visit, "")));
}

std::string line_of(const Visit& visit) {
    Visit written = visit;
    return JsonWriter::json_of(written).dump();
}

Record read_record(const std::string& name, std::string_view text) {
    std::size_t number = 1;
    try {
        const std::string_view first = text.substr(0, text.find('\n'));
        const bool is_document = !ordered_json::accept(first) || first.size() == text.size();
        const ordered_json heading = internal::parsed(is_document ? text : first);
        Record record(part_in<Conditions>(Value(heading, "")));
        if (heading.contains("visits")) {
            for (const Value& visit : Value(heading["visits"], "visits").elements())
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
