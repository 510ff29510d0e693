// SPDX-License-Identifier: MIT
#include "effect/internal/study_frame.hpp"

#include <utility>

#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

// The source of a pass without definitions and constants.
std::function<PassSource(const Moment&)> file(const char* name) {
    return [name](const Moment&) { return PassSource{.file = name}; };
}

std::vector<PassRow> rows_of_inputs() {
    return {{.name = "take_inputs",
             .when = [](const Moment& m) { return m.new_view && m.converted; },
             .source = file("study/take_inputs.comp"),
             .resources = {"stored_depth", "stored_normal", "depth", "normal"}},
            {.name = "normals_from_depth",
             .when = [](const Moment& m) { return m.new_view && !m.has_normals; },
             .source = file("study/normals_from_depth.comp"),
             .resources = {"depth", "normal"}}};
}

std::vector<PassRow> rows_of_samples() {
    return {
        {.name = "reproject",
         .when = [](const Moment& m) { return m.moves_history(); },
         .source = file("study/reproject.comp"),
         .resources = {"depth", "previous_position", "history_before", "history_reprojected"}},
        {.name = "preparation",
         .when = [](const Moment& m) { return m.preparation ? m.preparation->passes.size() : 0; },
         .source = [](const Moment& m) { return preparation_source(m, m.preparation->passes[m.step].file); },
         .resources = {"depth", "normal", "history", "prepared", "method", "layers", "prepared"},
         .own = {{"level", [](const Moment& m) { return m.preparation->passes[m.step].level; }}},
         .groups = [](const Moment& m) { return groups_for(m.preparation->passes[m.step].invocations); },
         .own_name = [](const Moment& m) { return m.preparation->passes[m.step].name; }},
        {.name = "ambient_occlusion",
         .when = [](const Moment&) { return 1; },
         .source = occlusion_source,
         .resources = {"depth", "normal", "history", "history_after", "previous_position", "method",
                       "prepared", "layers", "filtered"}}};
}

// A pass of the filter along one axis.
PassRow row_of_filter(const char* name, bool along_y, const char* from, const char* to) {
    return {.name = name,
            .when = [](const Moment& m) { return filters(m.settings); },
            .source = [](const Moment& m) { return filter_source(m.settings); },
            .resources = {"history_after", to, "normal", from},
            .own = {{"along_y", [along_y](const Moment&) { return along_y; }}}};
}

// A pass that remaps an image for display.
PassRow row_of_remap(const char* name, bool of_history, const char* from, const char* to,
                     std::function<bool(const Moment&)> when) {
    return {.name = name,
            .when = std::move(when),
            .source =
                [of_history](const Moment& m) {
                    return remap_source(m.settings, of_history && !shows_alone(m.settings));
                },
            .resources = {"depth", from, to}};
}

std::vector<PassRow> rows_of_results() {
    return {row_of_filter("filter_x", false, "filtered", "half_filtered"),
            row_of_filter("filter_y", true, "half_filtered", "filtered"),
            row_of_remap("remap", true, "occlusion", "mapped",
                         [](const Moment& m) {
                             return remaps(m.settings) && (!filters(m.settings) || m.shows_unfiltered);
                         }),
            row_of_remap("remap_filtered", false, "filtered", "filtered_mapped",
                         [](const Moment& m) { return remaps(m.settings) && filters(m.settings); })};
}

}  // namespace

const std::vector<PassRow>& pass_table() {
    static const std::vector<PassRow> table = [] {
        std::vector<PassRow> all;
        for (const auto& rows : {rows_of_inputs(), rows_of_samples(), rows_of_results()})
            all.insert(all.end(), rows.begin(), rows.end());
        return all;
    }();
    return table;
}

}  // namespace gloam::effect
