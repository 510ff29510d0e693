// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiment/experiment.hpp"
#include "record/json.hpp"

namespace gloam::experiment {

const std::vector<std::string>& quantities() {
    static const std::vector<std::string> words{"depth",    "remapped", "fit",      "own_radius",
                                                "by_class", "places",   "converged"};
    return words;
}

namespace {

using record::JsonReader;

// Each reads a value within bounds.
void read(const JsonReader& value, std::string& text) {
    text = value.name();
    if (text.empty()) value.expected("a text of one line, at most 1000 bytes");
}
void read(const JsonReader& value, bool& flag) {
    flag = value.flag();
}
void read(const JsonReader& value, double& number, double least, double most) {
    number = value.json().is_number() ? value.number() : std::nan("");
    if (!(number >= least && number <= most))
        value.expected(fmt::format("a number from {:g} to {:g}", least, most));
}
void read(const JsonReader& value, int& count, int least, int most) {
    count = value.integer(least, most);
}
void read(const JsonReader& value, std::string& word, const std::vector<std::string>& words) {
    if (std::ranges::none_of(words, [&](const std::string& one) { return value.json() == one; }))
        value.expected(fmt::format("one of {}", fmt::join(words, ", ")));
    word = value.text();
}
template <class T, class... Bounds>
void read(const JsonReader& value, std::optional<T>& read_value, Bounds... bounds) {
    read(value, read_value.emplace(), bounds...);
}
template <class T, class... Bounds>
void read(const JsonReader& value, std::vector<T>& values, Bounds... bounds) {
    for (const JsonReader& element : value.elements()) read(element, values.emplace_back(), bounds...);
}

// A setting's value as text that effect::set() reads.
std::string setting_of(const JsonReader& value) {
    const nlohmann::ordered_json& json = value.json();
    if (json.is_boolean()) return json.get<bool>() ? "on" : "off";
    if (json.is_string()) return json.get<std::string>();
    if (!json.is_number()) value.expected("a number, a name, true or false");
    return json.dump();
}

// The members of an object. Those that nobody asked for are an error, because a misspelt one would be
// ignored.
class Members {
  public:
    explicit Members(const JsonReader& value) : value_(value), members_(value.members()) {}

    // nullptr: there is none.
    [[nodiscard]] const JsonReader* find(const std::string& name) {
        asked_.insert(name);
        const auto found = std::ranges::find(members_, name, [](const auto& member) { return member.first; });
        return found == members_.end() ? nullptr : &found->second;
    }

    // Reads the member if there is one.
    template <class T, class... Bounds>
    void read(const std::string& name, T& value, Bounds... bounds) {
        if (const JsonReader* member = find(name)) experiment::read(*member, value, bounds...);
    }

    void require_known() const {
        for (const auto& [name, value] : members_)
            if (!asked_.contains(name)) value.expected(fmt::format("one of {}", fmt::join(asked_, ", ")));
    }

    void require(const std::string& name, bool given) const {
        if (!given) value_.expected("an object with \"" + name + "\"");
    }

  private:
    JsonReader value_;
    std::vector<std::pair<std::string, JsonReader>> members_;
    std::set<std::string> asked_;
};

constexpr int most_frames = 1'000;
constexpr int most_rays = 65'536;

// Of Layer::pictures.
const std::vector<std::string> picture_kinds{"visibility", "error", "convergence", "samples", "converged"};

void read_layer(Members& members, Layer& layer) {
    members.read("preset", layer.preset);
    members.read("method", layer.method);
    members.read("sequence", layer.sequence);
    members.read("hoisted", layer.hoisted);
    members.read("radius", layer.radius, 1e-3, 1e3);
    members.read("enough_samples", layer.enough_samples);
    members.read("pictures", layer.pictures, picture_kinds);
    if (const JsonReader* plain = members.find("plain")) {
        std::string text;
        experiment::read(*plain, text);
        layer.kind = Kind::plain;
        try {
            layer.plain = plain_loop(text);
        } catch (const std::invalid_argument&) {
            plain->expected("SLICESxSTEPS+BLURS, such as 9x3+1");
        }
    }
    for (const auto& [name, kind] : {std::pair("depth_truth", Kind::depth_truth), {"truth", Kind::truth}}) {
        bool is = false;
        members.read(name, is);
        if (is) layer.kind = kind;
    }
    if (const JsonReader* set = members.find("set"))
        for (const auto& [name, value] : set->members()) layer.set.emplace_back(name, setting_of(value));
}

Candidate candidate_from(const JsonReader& value) {
    Members members(value);
    Candidate candidate;
    members.read("name", candidate.name);
    members.require("name", !candidate.name.empty());
    members.read("group", candidate.group);
    read_layer(members, candidate.layer);
    members.require_known();
    return candidate;
}

Case case_from(const JsonReader& value) {
    Members members(value);
    Case made;
    members.read("scene", made.scene);
    members.read("view", made.scene);
    made.closed_form = members.find("closed_form") != nullptr;
    members.read("closed_form", made.scene);
    members.require("scene", !made.scene.empty());
    made.name = made.scene;
    members.read("name", made.name);
    members.read("what", made.what);
    members.read("kind", made.kind);
    members.read("shown", made.shown, 1, most_frames);
    members.read("scored", made.scored, 1, most_frames);
    members.read("every", made.every, 1, most_frames);
    members.read("motion", made.motion);
    members.read("still", made.still);
    members.read("target", made.target, 0.0, 1e9);
    members.read("candidates", made.candidates);
    read_layer(members, made.layer);
    if (made.what.empty()) made.what = made.layer.method.empty() ? made.layer.preset : made.layer.method;
    members.require_known();
    return made;
}

void read_cases(const JsonReader& value, Experiment& experiment) {
    if (value.is_array()) {
        for (const JsonReader& element : value.elements()) experiment.cases.push_back(case_from(element));
        return;
    }
    Members members(value);
    CaseQuery& query = experiment.query.emplace();
    members.read("all", query.all, std::vector<std::string>{"views", "motion"});
    members.require("all", !query.all.empty());
    members.read("half", query.half, std::vector<std::string>{"tuning", "unseen"});
    members.read("perspective", query.perspective);
    members.require_known();
}

CandidateQuery query_from(const JsonReader& value) {
    Members members(value);
    CandidateQuery query;
    members.read("methods", query.methods);
    members.read("presets", query.presets);
    query.samples.clear();
    members.read("samples", query.samples, 1, static_cast<int>(effect::most_samples));
    members.read("single", query.single);
    members.read("sequence", query.sequence);
    members.require_known();
    return query;
}

// An element that names methods is a query, of which there may be one.
void read_candidates(const JsonReader& value, Experiment& experiment) {
    if (!value.is_array()) {
        experiment.candidate_query = query_from(value);
        return;
    }
    for (const JsonReader& element : value.elements()) {
        if (Members(element).find("methods") == nullptr) {
            experiment.candidates.push_back(candidate_from(element));
            continue;
        }
        if (experiment.candidate_query) element.expected("one query alone");
        experiment.candidate_query = query_from(element);
    }
}

Table table_from(const JsonReader& value) {
    Members members(value);
    Table table;
    members.read("name", table.name);
    members.read("in_report", table.in_report);
    members.read("each", table.each);
    std::vector<std::string> measures;
    members.read("measures", measures, quantities());
    for (const std::string& word : measures)
        table.measures.push_back(
            static_cast<Quantity>(std::ranges::find(quantities(), word) - quantities().begin()));
    if (const JsonReader* select = members.find("select"); select != nullptr && !select->is_array())
        experiment::read(*select, table.select.emplace_back());
    else
        members.read("select", table.select);
    members.require("select", !table.select.empty());
    members.require_known();
    return table;
}

void read_frames(Members& members, Experiment& experiment) {
    members.read("sizes", experiment.sizes);
    members.read("frames", experiment.frames, 1, most_frames);
    members.read("scored", experiment.scored, 1, most_frames);
    members.read("every", experiment.every, 1, most_frames);
    members.read("rounds", experiment.rounds, 0, most_frames);
    members.read("repeat", experiment.repeat, 1, most_frames);
    members.read("rays", experiment.rays, 0, most_rays);
    members.read("depth_thickness", experiment.depth_thickness, 1e-6, 1e18);
    members.read("interleaved", experiment.interleaved);
}

}  // namespace

Experiment read_experiment(const std::string& name, std::string_view text) {
    try {
        const nlohmann::ordered_json document = record::parse_json(text);
        Members members(JsonReader(document, ""));
        Experiment experiment{.name = name};
        members.read("about", experiment.about);
        read_frames(members, experiment);
        read_layer(members, experiment.layer);
        if (const JsonReader* cases = members.find("cases")) read_cases(*cases, experiment);
        if (const JsonReader* candidates = members.find("candidates"))
            read_candidates(*candidates, experiment);
        if (const JsonReader* tables = members.find("tables"))
            for (const JsonReader& table : tables->elements()) experiment.tables.push_back(table_from(table));
        members.require_known();
        if (experiment.sizes.empty()) throw std::runtime_error("sizes: expected one or more");
        if (experiment.cases.empty() && !experiment.query)
            throw std::runtime_error("cases: expected one or more");
        return experiment;
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("experiment {}: {}", name, error.what()));
    }
}

}  // namespace gloam::experiment
