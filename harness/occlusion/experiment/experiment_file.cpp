// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "base/text.hpp"
#include "experiment/experiment.hpp"
#include "experiment/table.hpp"

namespace gloam::experiment {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t most_elements = 1'000;
constexpr int most_frames = 1'000;
constexpr int most_rays = 65'536;
constexpr std::size_t longest_quote = 40;

// A value of the file and its place. Every reader throws std::runtime_error with the place, what was expected
// and what was found.
class Value {
  public:
    Value(const ordered_json& json, std::string where) : json_(&json), where_(std::move(where)) {}

    [[noreturn]] void expected(const std::string& what) const {
        const std::string found = json_->dump(-1, ' ', false, ordered_json::error_handler_t::replace);
        throw std::runtime_error(fmt::format("{}{}expected {}, found {}", where_, where_.empty() ? "" : ": ",
                                             what, base::shortened(found, longest_quote)));
    }

    void read(std::string& text) const {
        if (!json_->is_string() || !base::is_name(json_->get<std::string>()))
            expected("a text of one line, at most 1000 bytes");
        text = json_->get<std::string>();
    }

    void read(bool& flag) const {
        if (!json_->is_boolean()) expected("true or false");
        flag = json_->get<bool>();
    }

    void read(double& number, double least, double most) const {
        if (!json_->is_number() || !(json_->get<double>() >= least) || !(json_->get<double>() <= most))
            expected(fmt::format("a number from {:g} to {:g}", least, most));
        number = json_->get<double>();
    }

    void read(int& count, int least, int most) const {
        if (!json_->is_number_integer() || json_->get<double>() < least || json_->get<double>() > most)
            expected(fmt::format("a whole number from {} to {}", least, most));
        count = json_->get<int>();
    }

    // One of these words.
    void read(std::string& word, const std::vector<std::string>& words) const {
        if (!json_->is_string() || std::ranges::count(words, json_->get<std::string>()) == 0)
            expected(fmt::format("one of {}", fmt::join(words, ", ")));
        word = json_->get<std::string>();
    }

    template <class T, class... Bounds>
    void read(std::optional<T>& value, Bounds... bounds) const {
        read(value.emplace(), bounds...);
    }

    template <class T, class... Bounds>
    void read(std::vector<T>& values, Bounds... bounds) const {
        for (const Value& element : elements()) element.read(values.emplace_back(), bounds...);
    }

    [[nodiscard]] bool is_array() const { return json_->is_array(); }

    [[nodiscard]] std::vector<Value> elements() const {
        if (!json_->is_array() || json_->size() > most_elements)
            expected(fmt::format("an array of at most {} elements", most_elements));
        std::vector<Value> all;
        for (const ordered_json& element : *json_)
            all.emplace_back(element, fmt::format("{}[{}]", where_, all.size()));
        return all;
    }

    [[nodiscard]] std::vector<std::pair<std::string, Value>> members() const {
        if (!json_->is_object()) expected("an object");
        std::vector<std::pair<std::string, Value>> all;
        for (const auto& [name, value] : json_->items())
            all.emplace_back(name, Value(value, where_.empty() ? name : where_ + "." + name));
        return all;
    }

    // A setting's value as text that effect::set() reads.
    [[nodiscard]] std::string setting() const {
        if (json_->is_boolean()) return json_->get<bool>() ? "on" : "off";
        if (json_->is_string()) return json_->get<std::string>();
        if (!json_->is_number()) expected("a number, a name, true or false");
        return json_->dump();
    }

  private:
    const ordered_json* json_;
    std::string where_;
};

// The members of an object. Those that nobody asked for are an error, because a misspelt one would be
// ignored.
class Members {
  public:
    explicit Members(const Value& value) : value_(value), members_(value.members()) {}

    // nullptr: there is none.
    [[nodiscard]] const Value* find(const std::string& name) {
        asked_.insert(name);
        const auto found = std::ranges::find(members_, name, [](const auto& member) { return member.first; });
        return found == members_.end() ? nullptr : &found->second;
    }

    // Reads the member if there is one.
    template <class T, class... Bounds>
    void read(const std::string& name, T& value, Bounds... bounds) {
        if (const Value* member = find(name)) member->read(value, bounds...);
    }

    // The same, in place of the elements that there are.
    void read_instead(const std::string& name, std::vector<std::string>& values) {
        if (find(name) != nullptr) values.clear();
        read(name, values);
    }

    void require_known() const {
        for (const auto& [name, value] : members_)
            if (!asked_.contains(name)) value.expected(fmt::format("one of {}", fmt::join(asked_, ", ")));
    }

    void require(const std::string& name, bool given) const {
        if (!given) value_.expected("an object with \"" + name + "\"");
    }

  private:
    Value value_;
    std::vector<std::pair<std::string, Value>> members_;
    std::set<std::string> asked_;
};

void read_layer(Members& members, Layer& layer) {
    members.read("preset", layer.preset);
    members.read("method", layer.method);
    members.read("sequence", layer.sequence);
    members.read("hoisted", layer.hoisted);
    members.read("radius", layer.radius, 1e-3, 1e3);
    members.read("enough_samples", layer.enough_samples);
    if (const Value* plain = members.find("plain")) {
        std::string text;
        plain->read(text);
        layer.kind = Kind::plain;
        try {
            layer.plain = plain_loop(text);
        } catch (const std::invalid_argument&) {
            plain->expected("SLICESxSTEPS+BLURS, such as 9x3+1");
        }
    }
    if (const Value* copied = members.find("copied")) {
        std::string text;
        copied->read(text, {"float32", "float16", "packed"});
        layer.kind = Kind::copy;
        layer.copied = text == "float32"   ? effect::HistoryPrecision::float32
                       : text == "float16" ? effect::HistoryPrecision::float16
                                           : effect::HistoryPrecision::packed;
    }
    bool effect = false;
    members.read("effect", effect);
    if (effect) layer.kind = Kind::effect;
    bool depth_truth = false;
    members.read("depth_truth", depth_truth);
    if (depth_truth) layer.kind = Kind::depth_truth;
    if (const Value* set = members.find("set"))
        for (const auto& [name, value] : set->members()) layer.set.emplace_back(name, value.setting());
}

Candidate candidate_from(const Value& value) {
    Members members(value);
    Candidate candidate;
    members.read("name", candidate.name);
    members.require("name", !candidate.name.empty());
    read_layer(members, candidate.layer);
    members.require_known();
    return candidate;
}

Case case_from(const Value& value) {
    Members members(value);
    Case made;
    members.read("scene", made.scene);
    if (const Value* view = members.find("view")) {
        view->read(made.scene);
        made.view = true;
    }
    members.require("scene", !made.scene.empty());
    made.name = made.scene;
    members.read("name", made.name);
    members.read("what", made.what);
    members.read("kind", made.kind);
    members.read("shown", made.shown, 1, most_frames);
    members.read("scored", made.scored, 1, most_frames);
    members.read("motion", made.motion);
    members.read("still", made.still);
    members.read("rough_from", made.rough_from, 0.0, 1.0);
    members.read("empty_until", made.empty_until, 0.0, 1.0);
    members.read("filled_later", made.filled_later);
    members.read("scale", made.scale, 1, 16);
    members.read("objects", made.objects, 1, 1000);
    members.read("value", made.value, 0.0, 1e18);
    members.read("target", made.target, 0.0, 1e9);
    members.read("candidates", made.candidates);
    read_layer(members, made.layer);
    members.require_known();
    return made;
}

void read_cases(const Value& value, Experiment& experiment) {
    if (value.is_array()) {
        for (const Value& element : value.elements()) experiment.cases.push_back(case_from(element));
        return;
    }
    Members members(value);
    CaseQuery& query = experiment.query.emplace();
    std::string which;
    members.read("all", which, std::vector<std::string>{"views", "moving scenes"});
    members.require("all", !which.empty());
    query.views = which == "views";
    members.read("half", query.half, std::vector<std::string>{"tuning", "unseen"});
    members.read("perspective", query.perspective);
    members.read("target", query.target, 0.0, 1e9);
    members.require_known();
}

Column column_from(const Value& value) {
    Members members(value);
    Column column;
    members.read("title", column.title);
    members.read("label", column.label,
                 std::vector<std::string>{"case", "what", "kind", "half", "candidate", "pass", "cases"});
    members.read("value", column.value, quantities());
    members.require("value", column.value.empty() != column.label.empty());
    members.read("half", column.half, std::vector<std::string>{"tuning", "unseen"});
    members.read("of", column.of);
    members.read("over", column.over);
    members.read("over_case", column.over_case);
    members.read("minus", column.minus);
    members.read("passes", column.passes);
    column.over_passes = column.passes;
    members.read_instead("over_passes", column.over_passes);
    members.read("repeated", column.repeated, std::vector<std::string>{"candidates", "sizes"});
    members.read("statistic", column.statistic,
                 std::vector<std::string>{"median", "least", "quartiles", "exponent", "list"});
    members.read("digits", column.digits, 0, 9);
    members.read("percent", column.percent);
    members.read("front", column.front);
    members.read("target", column.target);
    members.require_known();
    return column;
}

Table table_from(const Value& value) {
    Members members(value);
    Table table;
    members.read("rows", table.rows,
                 std::vector<std::string>{"cases", "candidates", "runs", "passes", "kinds", "growth"});
    members.read("name", table.name);
    members.read("kind", table.kind);
    const Value* columns = members.find("columns");
    members.require("rows", !table.rows.empty());
    members.require("columns", columns != nullptr);
    for (const Value& column : columns->elements()) table.columns.push_back(column_from(column));
    members.require_known();
    return table;
}

void read_frames(Members& members, Experiment& experiment) {
    members.read("sizes", experiment.sizes);
    members.read("frames", experiment.frames, 1, most_frames);
    members.read("scored", experiment.scored, 1, most_frames);
    members.read("rounds", experiment.rounds, 0, most_frames);
    members.read("repeat", experiment.repeat, 1, most_frames);
    members.read("rays", experiment.rays, 0, most_rays);
    members.read("depth_thickness", experiment.depth_thickness, 1e-6, 1e18);
    members.read("interleaved", experiment.interleaved);
}

// A query's cases are not known yet.
void require_cases(const Experiment& experiment) {
    for (const Table& table : experiment.tables)
        for (const Column& column : table.columns)
            if (!experiment.query && !column.over_case.empty() &&
                std::ranges::find(experiment.cases, column.over_case, &Case::name) == experiment.cases.end())
                throw std::runtime_error(
                    fmt::format("over_case: \"{}\", expected the name of a case", column.over_case));
}

ordered_json parsed(std::string_view text) {
    base::require_bounded_json(text);
    ordered_json document = ordered_json::parse(text, nullptr, false);
    if (document.is_discarded()) throw std::runtime_error("no JSON");
    if (!document.is_object()) throw std::runtime_error("expected an object");
    return document;
}

}  // namespace

Experiment read_experiment(const std::string& name, std::string_view text) {
    try {
        const ordered_json document = parsed(text);
        Members members(Value(document, ""));
        Experiment experiment{.name = name};
        members.read("about", experiment.about);
        read_frames(members, experiment);
        read_layer(members, experiment.layer);
        if (const Value* cases = members.find("cases")) read_cases(*cases, experiment);
        if (const Value* candidates = members.find("candidates"))
            for (const Value& candidate : candidates->elements())
                experiment.candidates.push_back(candidate_from(candidate));
        if (const Value* tables = members.find("tables"))
            for (const Value& table : tables->elements()) experiment.tables.push_back(table_from(table));
        members.require_known();
        if (experiment.sizes.empty()) throw std::runtime_error("sizes: expected one or more");
        if (experiment.cases.empty() && !experiment.query)
            throw std::runtime_error("cases: expected one or more");
        require_cases(experiment);
        return experiment;
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("experiment {}: {}", name, error.what()));
    }
}

}  // namespace gloam::experiment
