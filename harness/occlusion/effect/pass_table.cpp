// SPDX-License-Identifier: MIT
#include "effect/internal/frame.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

// of_view: the members that depend on the view or the frame.
template <class Parameters, class... Members>
Constants constants(const Parameters& all, Members Parameters::*... of_view) {
    const auto bytes = std::as_bytes(std::span(&all, 1));
    Constants result{{bytes.begin(), bytes.end()}, std::vector<bool>(sizeof all, false)};
    [[maybe_unused]] const auto mark = [&](const auto& member) {
        const auto first = std::as_bytes(std::span(&member, 1)).data() - bytes.data();
        std::fill_n(result.of_view.begin() + first, sizeof member, true);
    };
    (mark(all.*of_view), ...);
    return result;
}

// The source of a pass without definitions and constants.
std::function<PassSource(const Moment&)> file(const char* name) {
    return [name](const Moment&) { return PassSource{.file = name}; };
}

std::vector<PassRow> rows_of_inputs() {
    return {{.name = "take_inputs",
             .when = [](const Moment& m) { return m.new_view && m.converted; },
             .source = [](const Moment& m) { return input_source(m); },
             .resources = {"stored_depth", "stored_normal", "depth", "normal"},
             .fill =
                 [](const Moment& m) {
                     using P = InputParameters;
                     return constants(input_parameters(m.view), &P::view_from_world, &P::p22_p32, &P::size);
                 }},
            {.name = "normals_from_depth",
             .when = [](const Moment& m) { return m.new_view && !m.has_normals; },
             .source = file("normals_from_depth.comp"),
             .resources = {"depth", "normal"},
             .fill =
                 [](const Moment& m) {
                     using P = NormalParameters;
                     return constants(normal_parameters(m.view), &P::p00_p11, &P::size);
                 }},
            {.name = "positions_from_motion",
             .when = [](const Moment& m) { return m.new_view && m.from_motion; },
             .source = [](const Moment& m) { return motion_source(m.view, m.before); },
             .resources = {"depth", "motion", "positions"},
             .fill =
                 [](const Moment& m) {
                     using P = MotionParameters;
                     return constants(motion_parameters(m.view, m.before), &P::previous_from_current,
                                      &P::p00_p11, &P::previous_p00_p11, &P::size, &P::motion_unit);
                 }}};
}

// The pass that takes the samples.
PassRow row_of_samples() {
    return {.name = "ambient_occlusion",
            .when = [](const Moment&) { return 1; },
            .source = [](const Moment& m) { return occlusion_source(m); },
            .resources = {"depth", "normal", "history", "history_after", "positions", "method", "prepared",
                          "layers", "filtered"},
            .fill =
                [](const Moment& m) {
                    using P = OcclusionParameters;
                    return constants(occlusion_parameters(m.view, m.settings), &P::p00_p11, &P::size,
                                     &P::border);
                }};
}

std::vector<PassRow> rows_of_samples() {
    return {
        {.name = "reproject",
         .when = [](const Moment& m) { return m.moves_history(); },
         .source = [](const Moment& m) { return reprojection_source(m); },
         .resources = {"depth", "positions", "history_before", "history_reprojected"},
         .fill =
             [](const Moment& m) {
                 using P = ReprojectionParameters;
                 return constants(reprojection_parameters(m), &P::previous_from_current, &P::p00_p11,
                                  &P::previous_p00_p11, &P::size);
             },
         .turn = Turn::moved},
        {.name = "preparation",
         .when = [](const Moment& m) { return m.preparation ? m.preparation->passes.size() : 0; },
         .source = [](const Moment& m) { return preparation_source(m, m.preparation->passes[m.step].file); },
         .resources = {"depth", "normal", "history", "prepared", "method", "layers", "prepared"},
         .fill =
             [](const Moment& m) {
                 using P = PreparationParameters;
                 const int level = m.preparation->passes[m.step].level;
                 return constants(preparation_parameters(m.view, m.settings, level), &P::p00_p11, &P::size,
                                  &P::border);
             },
         .groups = [](const Moment& m) { return groups_for(m.preparation->passes[m.step].invocations); },
         .own_name = [](const Moment& m) { return m.preparation->passes[m.step].name; }},
        row_of_samples()};
}

// A pass of the filter along one axis.
PassRow row_of_filter(const char* name, bool along_y, const char* from, const char* to) {
    return {.name = name,
            .when = [](const Moment& m) { return m.filtered; },
            .source = [along_y](const Moment& m) { return filter_source(m, along_y); },
            .resources = {"history_after", to, "normal", from},
            .fill =
                [](const Moment& m) {
                    using P = FilterParameters;
                    return constants(filter_parameters(m.view, m.settings), &P::p00_p11, &P::size);
                }};
}

std::vector<PassRow> rows_of_filter() {
    return {row_of_filter("filter_x", false, "filtered", "half_filtered"),
            row_of_filter("filter_y", true, "half_filtered", "filtered")};
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
            .resources = {"depth", from, to},
            .fill =
                [](const Moment& m) {
                    const Settings& s = m.settings;
                    const RemapParameters all{vector_of_size(m.view.extent), s.remap_a, s.remap_b, s.remap_c};
                    return constants(all, &RemapParameters::size);
                }};
}

// The pixels of a block share one pattern of samples (interleaved sampling): the first pass takes each
// pixel's part, the second gathers those of the block.
PassRow row_of_directions(const char* name, std::vector<const char*> images) {
    std::vector<const char*> resources{"depth", "normal", "method"};
    resources.insert(resources.end(), images.begin(), images.end());
    return {.name = name,
            .when = [](const Moment& m) { return m.bent_normals; },
            .source = [name](const Moment&) { return directional_source(name, bent_interleave); },
            .resources = std::move(resources),
            .fill =
                [](const Moment& m) {
                    using P = DirectionalParameters;
                    // world_from_view is for the passes of light: these do not read it.
                    return constants(directional_parameters(m.view, m.settings), &P::p00_p11, &P::size);
                }};
}

std::vector<PassRow> rows_of_directions() {
    return {row_of_directions("bent_normals", {"bent_parts"}),
            row_of_directions("bent_gather", {"bent_normal", "bent_parts"})};
}

std::vector<PassRow> rows_of_results() {
    return {
        row_of_remap("remap", true, "occlusion", "mapped",
                     [](const Moment& m) { return m.maps_images() && (!m.filtered || m.shows_unfiltered); }),
        row_of_remap("remap_filtered", false, "filtered", "filtered_mapped",
                     [](const Moment& m) { return m.maps_images() && m.filtered; })};
}

}  // namespace

const std::vector<PassRow>& pass_table() {
    static const std::vector<PassRow> table = [] {
        std::vector<PassRow> all;
        for (const auto& rows :
             {rows_of_inputs(), rows_of_samples(), rows_of_filter(), rows_of_results(), rows_of_directions()})
            all.insert(all.end(), rows.begin(), rows.end());
        return all;
    }();
    return table;
}

}  // namespace gloam::effect
