// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/configuration_study.hpp"
#include "experiment/experiment.hpp"

namespace gloam::experiment {

// What must be equal for visits to be combined.
struct Conditions {
    std::string experiment;  // its name
    std::string device;
    std::string driver;
    int frames = 0;
    int scored = 0;
    int repeat = 0;
    int rays = 0;

    friend bool operator==(const Conditions&, const Conditions&) = default;
};

// What a candidate makes of the point of a view in closed form. Occlusion before the remap, but for `shown`.
struct PointQuality {
    double truth = 0.0;  // cosine-weighted, linear falloff
    double occlusion = 0.0;
    double standard_error = 0.0;
    std::optional<double> shown;  // nullopt: of the truth itself
};

// What one visit to a candidate in a case gave.
struct Visit {
    backend::Extent size;  // of the experiment
    Case shown;            // its name, and what tables say of it; its line has nothing else
    std::string candidate;
    std::string group;                       // of the candidate
    int round = 0;                           // 0: errors
    std::optional<FrameQuality> quality;     // nullopt: not judged
    std::optional<PointQuality> point;       // of a view in closed form
    std::vector<FrameReading> readings;      // none in round 0
    std::optional<double> own_radius_error;  // the error against the truth for the scene's own radius
    int samples_asked = 0;
};

// Visits as they came.
class Record {
  public:
    explicit Record(Conditions conditions) : conditions_(std::move(conditions)) {}

    [[nodiscard]] const Conditions& conditions() const { return conditions_; }
    [[nodiscard]] const std::vector<Visit>& visits() const { return visits_; }

    // The visit with the same size, case, candidate and round; nullptr: there is none.
    [[nodiscard]] const Visit* find(const Visit& like) const;

    // Adds a visit, or replaces the one that find() finds.
    void add(Visit visit);

    // The same for its line. Throws std::runtime_error with the place, what was expected and what was found.
    void add_line(std::string_view line);

  private:
    Conditions conditions_;
    std::vector<Visit> visits_;
    std::map<std::string, std::size_t> places_;  // of visits, by what find() compares
};

// As JSON in one line: the heading of a journal, and its other lines.
[[nodiscard]] std::string line_of(const Conditions& conditions);
[[nodiscard]] std::string line_of(const Visit& visit);

// Reads a journal, or the document of to_json(). Throws like Record::add_line(), with the name.
[[nodiscard]] Record read_record(const std::string& name, std::string_view text);

// The visits of all parts, of which there is one at least. Throws std::invalid_argument if conditions differ,
// and for a visit in two parts.
[[nodiscard]] Record joined(std::span<const Record> parts);

}  // namespace gloam::experiment
