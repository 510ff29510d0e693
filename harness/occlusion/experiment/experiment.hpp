// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "effect/settings.hpp"
#include "effect/study/plain_slices.hpp"

namespace gloam::experiment {

// Single frames of the plain loop over slices, and how often its blur is applied.
struct PlainLoop {
    effect::SliceTaps taps;
    int blurs = 0;
};

// Parses SLICESxSTEPS+BLURS, at most 64 slices and steps and 9 blurs. Throws std::invalid_argument with the
// text otherwise.
[[nodiscard]] PlainLoop plain_loop(std::string_view text);

// What is measured.
enum class Kind {
    effect,       // the effect with settings
    plain,        // the plain loop
    depth_truth,  // the truth of the depth buffer (D), as an image: nothing is timed
    truth         // of the geometry (G), the same
};

// A part of a description of what is measured. The experiment, a case and a candidate have one each. What a
// later one says counts.
struct Layer {
    std::optional<Kind> kind;
    PlainLoop plain;
    std::string preset;            // name or file; empty: not said
    std::string method;            // empty: the preset's
    std::optional<bool> sequence;  // with the history, in the order of the frames; otherwise each frame alone
    std::optional<bool> hoisted;   // the shader compiler hoists loop invariants
    std::optional<double> radius;  // in units of the scene's own
    bool enough_samples = false;   // as many as lower the error by a hundredth or more
    // Settings, lengths for a radius of 1. "x2" doubles the number that the layers before have set.
    std::vector<std::pair<std::string, std::string>> set;
    // Of the last scored frame: "visibility", "error", "convergence", "samples", "converged"; empty: not
    // said.
    std::vector<std::string> pictures;
};

struct Candidate {
    std::string name;
    std::string group{};  // candidates of one group are alike: a method with other counts of samples
    Layer layer{};
};

// What is shown: frames of a scene or of a view, or a point with known occlusion.
struct Case {
    std::string name;
    std::string what{};  // in a few words; of a description without: its method or preset
    std::string kind{};  // rows of tables are chosen and grouped by it
    std::string half{};  // of a view: "tuning" or "unseen"
    std::string scene{};
    std::vector<int> shown{};     // for how many frames each view is shown; empty: the experiment's frames
    std::optional<int> scored{};  // the last ones of these, instead of the experiment's
    std::optional<int> every{};   // instead of the experiment's
    bool closed_form = false;     // `scene` is a view of scene/analytic_scene.hpp
    // Views hold the motion of surfaces, not of the camera alone. nullopt: where objects move.
    std::optional<bool> motion{};
    bool still = false;                     // all views are the first frame's
    double target = 0.0;                    // for tables; 0: none
    std::vector<std::string> candidates{};  // names of those that are measured; empty: all
    Layer layer{};
};

// All views of scene/scene.hpp, or those of one half.
struct CaseQuery {
    std::string all;           // "motion": the views of that kind; else all others
    std::string half;          // empty: both
    bool perspective = false;  // without orthographic cameras
};

// A choice of candidates that a short description stands for: methods, with each count of samples, and
// presets as they are; frames alone and sequences. Without counts each method as it is, followed by its
// presets whose names end with "quality".
struct CandidateQuery {
    std::vector<std::string> methods;  // empty: all, unless there are presets; "all": all
    std::vector<std::string> presets;  // "all": all
    std::vector<int> samples{16};
    bool single = true;
    bool sequence = true;
};

// What is measured only for a table that says so, because it costs time.
enum class Quantity { depth, remapped, fit, own_radius, by_class, places, converged };
// Their words, in this order.
[[nodiscard]] const std::vector<std::string>& quantities();

// A table over the results: the rows of a SELECT.
struct Table {
    std::vector<Quantity> measures;
    std::string name;        // of the block of a page; empty: it stands in the experiment's
    bool in_report = false;  // it stands in the report alone
    std::string each;        // a SELECT of the names that lines of the other are repeated for; empty: none
    std::vector<std::string> select;  // its lines, "{}" where a name stands
};

struct Experiment {
    std::string name;
    std::string about;               // one line
    std::vector<std::string> sizes;  // WIDTHxHEIGHT of the images
    int frames = 1;                  // of each case
    int scored = 1;                  // the last ones of these
    int every = 1;                   // of these, from one that counts to the next
    int rounds = 1;                  // that are timed
    int repeat = 1;                  // runs of a timed frame
    int rays = 0;                    // of the truth, for each pixel; 0: no errors
    double depth_thickness = std::numeric_limits<double>::infinity();  // of the surface of (D), in radii
    bool interleaved = false;  // a round visits all cases; otherwise each case has its rounds
    Layer layer;
    std::optional<CaseQuery> query;
    std::vector<Case> cases;  // without a query
    std::optional<CandidateQuery> candidate_query;
    std::vector<Candidate> candidates;  // those of the query come after them
    std::vector<Table> tables;
};

// Reads a description in JSON (docs/experiments.md). name: of the experiment, and in messages. Throws
// std::runtime_error with the name, the place and what was expected, also for members that it does not know
// and for values out of range.
[[nodiscard]] Experiment read_experiment(const std::string& name, std::string_view text);

// Throws std::invalid_argument for two candidates with one name, two cases with one name, kind and "what",
// for a case or a table that names a candidate that does not exist, for a table that is no SELECT, and for
// one that reads a quantity that it does not measure.
void require_consistent(const Experiment& experiment);

// Replaces a query by its cases, and keeps the cases with these names; all without names. half: instead of
// the query's; empty: the query's. meshes: folder of the views' meshes. Throws like scene::make_scene(), and
// std::invalid_argument for an unknown name, for a half without a query of views, and if no case is left.
void choose_cases(Experiment& experiment, const std::vector<std::string>& names, const std::string& half,
                  const std::filesystem::path& meshes);

// Replaces a query of candidates by them: METHOD/SAMPLES/single and PRESET/SAMPLES/temporal. Throws
// std::invalid_argument for unknown names, and if there is none.
void choose_candidates(Experiment& experiment);

}  // namespace gloam::experiment
