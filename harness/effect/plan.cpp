// SPDX-License-Identifier: MIT
#include "effect/plan.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/half_resolution.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/planned_images.hpp"
#include "effect/internal/prepared_image.hpp"
#include "effect/internal/sample_table.hpp"
#include "effect/internal/shown_image.hpp"
#include "effect/internal/tiles.hpp"
#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

// A frame of a view. Plans of several moments are compared to find the parameters that depend on the view.
struct Moment {
    View view;
    View previous;
    bool odd = false;    // one of the frames in which the histories are swapped
    bool still = false;  // nothing has moved since the last frame
};

scene::CameraFrame camera_of(const PlanOptions& options, double fovy) {
    // Nothing of two views with other angles is the same.
    scene::Camera camera{
        .target = {0.3 * fovy, 0.2 * fovy, -1.0}, .fovy_rad = fovy, .view_height = fovy, .near = 0.1 * fovy};
    if (options.orthographic) camera.projection = scene::Projection::orthographic;
    scene::Camera previous = camera;
    previous.eye = {fovy, 0.5 * fovy, 2.0 * fovy};
    const double aspect = static_cast<double>(options.view.width) / static_cast<double>(options.view.height);
    return scene::make_frame(camera, aspect, previous);
}

std::vector<std::byte> copy_of(std::span<const std::byte> bytes) {
    return {bytes.begin(), bytes.end()};
}

template <class Parameters>
std::vector<std::byte> bytes_of_parameters(const Parameters& parameters) {
    return copy_of(std::as_bytes(std::span(&parameters, 1)));
}

constexpr std::array<std::uint32_t, 2> a_tile{tile_side, tile_side};
constexpr std::array<std::uint32_t, 2> tiles_of_filter{tile_side * filter_tiles, tile_side};
constexpr std::array<std::uint32_t, 2> tile_of_tiles{tile_side * tile_side, tile_side* tile_side};

std::array<std::int32_t, 2> pair_of(gpu::Extent extent) {
    return {static_cast<std::int32_t>(extent.width), static_cast<std::int32_t>(extent.height)};
}

class Planner {
  public:
    Planner(const Settings& settings, const PlanOptions& options, const Moment& moment)
        : settings_(settings),
          options_(options),
          given_(moment),
          moment_(moment),
          half_(settings.resolution == Resolution::half),
          table_(tabulates_samples(settings)) {
        moment_.view = working_view(moment.view, settings.resolution);
        moment_.previous = working_view(moment.previous, settings.resolution);
        preparation_ = preparation_of(settings, moment_.view.extent);
        plan_.tile = tile_side * divisor();
    }

    Plan run() {
        plan_.images = planned_images(settings_, options_, given_.view.extent);
        name_results(settings_, plan_);
        buffers();
        passes();
        if (!shows_alone(settings_)) plan_.exchanged.push_back({"history_before", "history_after"});
        if (options_.tiles) plan_.exchanged.push_back({"tile_states_before", "tile_states_after"});
        return std::move(plan_);
    }

  private:
    // Whether samples watch for moving objects.
    [[nodiscard]] bool watches() const {
        return options_.moving_objects && settings_.invalidation != Invalidation::none;
    }
    [[nodiscard]] bool converts() const { return options_.encoding != scene::Encoding{}; }
    [[nodiscard]] std::uint32_t divisor() const { return half_ ? 2 : 1; }
    // Linear depth and view-space normals of the view's size.
    [[nodiscard]] std::string full_depth() const { return converts() ? "linear_depth" : "depth"; }
    [[nodiscard]] std::string full_normal() const { return converts() ? "view_normal" : "normal"; }
    // What the passes read.
    [[nodiscard]] std::string depth() const { return half_ ? "half_depth" : full_depth(); }
    [[nodiscard]] std::string normal() const { return half_ ? "half_normal" : full_normal(); }
    [[nodiscard]] std::string positions() const {
        return present(half_ ? "half_previous_position" : "previous_position");
    }
    [[nodiscard]] std::string layers() const { return present(half_ ? "half_layers" : "layers"); }

    void buffers() {
        plan_.buffers.push_back({.name = "method",
                                 .meaning = "the method's settings",
                                 .bytes = sizeof(MethodValues),
                                 .contents = bytes_of_parameters(settings_.own)});
        if (!options_.tiles) {
            plan_.buffers.push_back({.name = nothing_buffer,
                                     .meaning = "for bindings that these settings do not read",
                                     .bytes = 256});
            return;
        }
        const auto [columns, rows, layers] = groups_for(moment_.view.extent);
        const std::size_t tiles = std::size_t{columns} * rows;
        const auto of_tiles = [&](const char* name, const char* meaning, std::size_t bytes) {
            plan_.buffers.push_back(
                {.name = name, .meaning = meaning, .bytes = bytes * tiles, .bytes_a_tile = bytes});
        };
        of_tiles("tile_states_before", "what is known about the tiles after the previous frame",
                 sizeof(TileState));
        of_tiles("tile_states_after", "the same after this frame", sizeof(TileState));
        plan_.buffers.back().refilled = true;
        of_tiles("tile_lists", "which tiles the passes run on, and their indirect dispatches",
                 tile_lists * sizeof(std::uint32_t));
        plan_.buffers.back().contents = empty_lists();
        plan_.buffers.back().bytes += plan_.buffers.back().contents.size();
        plan_.buffers.back().refilled = true;
        of_tiles("open_tiles", "tiles in which nothing can block; the plan does not search for them",
                 sizeof(std::uint32_t));
    }

    void pass(const char* name, PassSource source, std::vector<std::string> resources,
              std::vector<std::byte> parameters, std::array<std::uint32_t, 2> pixels) {
        plan_.passes.push_back({.name = name,
                                .source = std::move(source),
                                .resources = std::move(resources),
                                .parameters = std::move(parameters),
                                .pixels = {pixels[0] * divisor(), pixels[1] * divisor()},
                                .divisor = divisor()});
    }

    // Lets the last pass run over images of the view's size.
    void in_full() {
        plan_.passes.back().pixels = a_tile;
        plan_.passes.back().divisor = 1;
    }

    // Lets the last pass run over a list, if the plan has lists.
    void over(TileLists list) {
        if (!options_.tiles) return;
        plan_.passes.back().list = offset_of(list);
        plan_.passes.back().pixels = {};
    }

    [[nodiscard]] std::string present(const char* image) const {
        const auto has = [&](const PlannedImage& other) { return other.name == image; };
        return std::ranges::any_of(plan_.images, has) ? image : nothing_image;
    }
    // The history into which the samples are blended.
    [[nodiscard]] std::string history() const {
        return settings_.history ? "history_reprojected" : present("history_before");
    }
    [[nodiscard]] std::string lists() const { return options_.tiles ? "tile_lists" : nothing_buffer; }
    [[nodiscard]] std::string states() const { return options_.tiles ? "tile_states_after" : nothing_buffer; }

    void passes() {
        if (table_) {
            const std::uint32_t last = last_tabulated(settings_);
            pass("sample_table", sample_table_source(method_named(settings_.method).points), {"sample_table"},
                 bytes_of_parameters(SampleTableParameters{1, last}), {});
            plan_.passes.back().turn = Turn::once;
            plan_.passes.back().groups = {(last + sample_table_group - 1) / sample_table_group, 1, 1};
        }
        if (converts()) inputs();
        if (!options_.normals) {
            pass("normals_from_depth", normals_source(), {full_depth(), full_normal()},
                 bytes_of_parameters(normal_parameters(given_.view)), a_tile);
            in_full();
        }
        if (half_) halve();
        if (options_.tiles) selection();
        if (settings_.history) reprojection();
        preparation();
        occlusion();
        if (filters(settings_)) filter();
        if (half_) {
            upsample();
        } else if (remaps(settings_)) {
            remap();
        }
    }

    void inputs() {
        const InputProgram program{options_.encoding, options_.orthographic, options_.normals};
        pass("take_inputs", input_source(program), {"depth", present("normal"), full_depth(), full_normal()},
             bytes_of_parameters(input_parameters(given_.view)), a_tile);
        in_full();
    }

    // Both passes have an invocation for each half-size pixel; their constants are those of the view.
    void halve() {
        const HalveProgram program{.orthographic = options_.orthographic,
                                   .previous_orthographic = options_.orthographic,
                                   .moving_objects = options_.moving_objects,
                                   .layers = settings_.layers > 1};
        pass("halve_inputs", halve_source(program),
             {full_depth(), full_normal(), present("previous_position"), present("layers"), depth(), normal(),
              positions(), layers()},
             bytes_of_parameters(halve_parameters(given_.view, given_.previous)), a_tile);
        plan_.passes.back().divisor = 1;
    }

    void upsample() {
        if (!filters(settings_) || filters_early(settings_)) upsample("upsample", false);
        if (!filters(settings_)) return;
        const std::size_t first = plan_.passes.size();
        upsample(filters_early(settings_) ? "upsample_filtered" : "upsample", true);
        only_early(first);
    }

    void upsample(const char* name, bool filtered) {
        const UpsampleProgram program = upsample_program_for(settings_, filtered, options_.orthographic);
        pass(name, upsample_source(program),
             {full_depth(), depth(), program.history ? "history_after" : "filtered", "upsampled"},
             bytes_of_parameters(upsample_parameters(given_.view, settings_)), a_tile);
        plan_.passes.back().divisor = 1;
    }

    void selection() {
        std::uint32_t written = moment_.odd ? image_second_history : image_first_history;
        if (settings_.history) written |= image_reprojected;
        if (filters(settings_)) written |= image_filtered;
        if (shows_alone(settings_)) written = image_filtered;
        if (remaps(settings_) && !half_)
            written |= image_mapped | (filters(settings_) ? image_filtered_mapped : 0U);
        const gpu::Extent band = settings_.guard_history ? gpu::Extent{} : moment_.view.border;
        const SelectParameters parameters{.size = pair_of(moment_.view.extent),
                                          .band = pair_of(band),
                                          .written = written,
                                          .background = settings_.skip_background ? 1U : 0U,
                                          .settled = settings_.skip_settled && moment_.still ? 1U : 0U,
                                          .open_tiles = 0};
        pass("select_tiles", selection_source(1),
             {depth(), "tile_states_before", "tile_states_after", "tile_lists", "open_tiles"},
             bytes_of_parameters(parameters), tile_of_tiles);
    }

    void reprojection() {
        const ReprojectionProgram program{.precision = settings_.precision,
                                          .moving_objects = options_.moving_objects,
                                          .listed = options_.tiles,
                                          .taps = settings_.taps,
                                          .nearest_index = settings_.nearest_index,
                                          .orthographic = options_.orthographic,
                                          .previous_orthographic = options_.orthographic,
                                          .keeps_displacement = watches()};
        ReprojectionParameters parameters =
            reprojection_parameters(moment_.view, moment_.previous, settings_);
        if (half_)
            parameters.previous_from_current = half_previous_from_current(given_.view, given_.previous);
        pass(
            "reproject", reprojection_source(program),
            {depth(), positions(), "history_before", "history_reprojected", lists(), present("displacement")},
            bytes_of_parameters(parameters), a_tile);
        plan_.passes.back().turn = Turn::moved;
        over(TileLists::shaded);
    }

    void preparation() {
        if (!preparation_) return;
        const PreparationProgram program = preparation_program_for(settings_);
        for (const PreparationPass& step : preparation_->passes) {
            // A group of 8 x 8 texels of half the resolution covers 16 x 16 pixels of the view, and so on.
            std::uint32_t side = tile_side;
            while (step.invocations.width * (side / tile_side) + side / tile_side <=
                   moment_.view.extent.width)
                side *= 2;
            pass(step.name.c_str(), preparation_source(step.file, program, preparation_->format),
                 {depth(), normal(), history(), "prepared", "method", layers(), "prepared"},
                 bytes_of_parameters(preparation_parameters(moment_.view, settings_, step.level)),
                 {side, side});
        }
    }

    void occlusion() {
        Program program = program_for(settings_);
        program.moving_objects = watches();
        program.orthographic = options_.orthographic;
        program.listed = options_.tiles;
        program.shows = options_.tiles && filters(settings_);
        OcclusionParameters parameters = occlusion_parameters(moment_.view, settings_);
        parameters.still = moment_.still ? 1 : 0;
        const Counting counts = options_.tiles ? Counting::each_group : Counting::none;
        pass("ambient_occlusion", occlusion_source(program, counts, 1),
             {depth(), normal(), history(), present("history_after"), states(), present("displacement"),
              "method", present("prepared"), layers(), lists(), present("filtered"), present("sample_table")},
             bytes_of_parameters(parameters), a_tile);
        over(TileLists::shaded);
    }

    // Lets the passes from this one on run in early frames alone, if the filter does.
    void only_early(std::size_t first) {
        if (!filters_early(settings_)) return;
        for (std::size_t i = first; i < plan_.passes.size(); ++i) plan_.passes[i].turn = Turn::early;
    }

    void filter() {
        const std::size_t first = plan_.passes.size();
        if (options_.tiles) {
            const std::int32_t reach = filter_reach(settings_);
            const SelectFilteredParameters parameters{pair_of(moment_.view.extent), {reach, reach}};
            pass("select_filtered_tiles", {.file = "tiles/select_filtered.comp"},
                 {"tile_states_after", "tile_lists"}, bytes_of_parameters(parameters), tile_of_tiles);
        }
        const auto along = [&](const char* name, TileLists list, const char* from, const char* to) {
            FilterProgram program =
                filter_program_for(settings_, options_.tiles ? std::optional(list) : std::nullopt);
            program.along_y = list == TileLists::filtered_y;
            program.orthographic = options_.orthographic;
            pass(name, filter_source(program), {depth(), "history_after", to, normal(), lists(), from},
                 bytes_of_parameters(filter_parameters(moment_.view, settings_)), tiles_of_filter);
            over(list);
        };
        along("filter_x", TileLists::filtered_x, "filtered", "half_filtered");
        along("filter_y", TileLists::filtered_y, "half_filtered", "filtered");
        only_early(first);
    }

    void remap() {
        const auto map = [&](const char* name, TileLists list, std::optional<HistoryPrecision> history,
                             const char* from, const char* to) {
            const auto listed = options_.tiles ? std::optional(list) : std::nullopt;
            pass(name, remap_source(history, listed, settings_.output), {depth(), from, to, lists()},
                 bytes_of_parameters(remap_parameters(moment_.view, settings_)),
                 list == TileLists::filtered_y ? tiles_of_filter : a_tile);
            over(list);
        };
        if (shows_alone(settings_)) return map("remap", TileLists::shaded, {}, "filtered", "mapped");
        if (!filters(settings_) || filters_early(settings_))
            map("remap", TileLists::shaded, settings_.precision, "history_after", "mapped");
        if (!filters(settings_)) return;
        const std::size_t first = plan_.passes.size();
        map("remap_filtered", TileLists::shaded, {}, "filtered", "filtered_mapped");
        if (options_.tiles)
            map("remap_filtered_tiles", TileLists::filtered_y, {}, "filtered", "filtered_mapped");
        only_early(first);
    }

    const Settings& settings_;
    const PlanOptions& options_;
    const Moment& given_;  // of the engine's view
    Moment moment_;        // of the view whose images the passes read
    bool half_;
    std::optional<Preparation> preparation_;
    bool table_;
    Plan plan_;
};

}  // namespace

Plan plan_of(const Settings& settings, const PlanOptions& options) {
    validate(settings);
    PlanOptions other_options = options;
    other_options.view = {options.view.width / 2 + 3, options.view.height / 3 + 5};
    const View view{camera_of(options, 0.9), options.view, {}};
    const View other{camera_of(other_options, 1.3), other_options.view, {6, 8}};
    Plan plan = Planner(settings, options, {view, view, false, false}).run();
    const Moment odd{view, view, true, false};
    const Moment elsewhere{other, {camera_of(options, 1.1), options.view, {}}, true, true};
    const Plan second = Planner(settings, options, odd).run();
    const Plan compared = Planner(settings, options, elsewhere).run();
    // Two frames with nothing but the settings in common: bytes that differ depend on the view.
    for (std::size_t i = 0; i < plan.passes.size(); ++i) {
        PlannedPass& pass = plan.passes[i];
        pass.odd_parameters = second.passes[i].parameters;
        for (std::size_t byte = 0; byte < pass.parameters.size(); ++byte)
            pass.of_view.push_back(pass.odd_parameters[byte] != compared.passes[i].parameters.at(byte));
    }
    return plan;
}

}  // namespace gloam::effect
