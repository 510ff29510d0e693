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
    frame,        // a frame of three short passes
    depth_truth,  // the truth of the depth buffer (D), as an image: nothing is timed
    truth         // of the geometry (G), the same
};

// A part of a description of what is measured. The experiment, a case and a candidate have one each. What a
// later one says counts.
struct Layer {
    std::optional<Kind> kind;
    PlainLoop plain;
    std::string frame;             // name of such a frame
    std::string preset;            // name or file; empty: not said
    std::string method;            // empty: the preset's
    std::optional<bool> sequence;  // with the history, in the order of the frames; otherwise each frame alone
    // Instead of a sequence each scored frame's view alone, for as many frames as the sequence would have
    // had.
    bool held = false;
    std::optional<bool> hoisted;   // the shader compiler hoists loop invariants
    std::optional<double> radius;  // in units of the scene's own
    bool enough_samples = false;   // as many as lower the error by a hundredth or more
    // Settings, lengths for a radius of 1. "x2" doubles the number that the layers before have set.
    std::vector<std::pair<std::string, std::string>> set;
    std::vector<std::string> pictures;  // of picture_kinds(), of the last scored frame; empty: not said
};

struct Candidate {
    std::string name;
    std::string group{};  // candidates of one group are alike: a method with other counts of samples
    Layer layer{};
};

// What is shown: frames of a scene or of a view, or a point with known occlusion.
struct Case {
    std::string name;
    std::string what{};  // in a few words
    std::string kind{};  // rows of tables are chosen and grouped by it
    std::string half{};  // of a view: "tuning" or "unseen"
    std::string scene{};
    bool view = false;         // `scene` is a view of scene/scene.hpp; otherwise a built-in scene or "floor"
    std::vector<int> shown{};  // for how many frames each view is shown; empty: the experiment's frames
    std::optional<int> scored{};  // the last ones of these, instead of the experiment's
    std::optional<int> every{};   // instead of the experiment's
    bool closed_form = false;     // `scene` is a view of scene/analytic_scene.hpp
    int pixels = 257;             // of a side of its image, odd
    // Views hold the motion of surfaces, not of the camera alone. nullopt: where objects move.
    std::optional<bool> motion{};
    bool still = false;                     // all views are the first frame's
    std::optional<double> rough_from{};     // share of the width from which on the depth is roughened
    double empty_until = 0.0;               // share of the width up to which there is nothing
    bool filled_later = false;              // that share is empty in the first view alone
    double target = 0.0;                    // of the table's column with a target; 0: none
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

// A column of a table.
struct Column {
    std::string title;  // "{}" is replaced by the name of the candidate, or of what it is repeated for
    std::string label;  // one of labels()
    std::string value;  // a quantity of quantities(); empty: a label
    std::string half;   // over the views of this half alone
    std::vector<std::string> cases;   // over these alone, or repeated for these; empty: over all of the row
    std::string pixels;               // of one class, of pixel_classes()
    std::string against;              // one of references()
    int frame = 0;                    // the last scored one up to this number, from 1 on; 0: all
    int over_frame = 0;               // divided by the value in that frame
    std::string of;                   // the candidate, as in candidate_of(); empty: the row's
    std::string over;                 // divided by the value of this candidate; empty: not divided
    std::string minus;                // less the value of this candidate
    std::vector<std::string> passes;  // times of passes whose names begin so; empty: of all
    std::string repeated;             // "candidates", "cases" or "sizes": a column for each
    // Of times: "median" or "least". Over cases: "most", the largest; "furthest", the one furthest from 0
    // with its case; or "of_best", the geometric mean of the ratios to the least of each case. Over the
    // scored frames: "slope", the exponent of the mean square error as a power of the samples taken, as long
    // as all samples count.
    std::string statistic = "median";
    int digits = 2;
    bool percent = false;
    bool with_sign = false;
    bool front = false;          // bold where no other candidate has both a smaller error and a smaller time
    bool target = false;         // the case's target, and whether it is met
    std::optional<double> most;  // a target of the column's own
};

// A table over the results.
struct Table {
    std::string name;  // of the block of a page; empty: it stands in the experiment's
    // "cases", "candidates", "runs" (each candidate of each case), "passes", "kinds" or "frames" (each scored
    // frame of each case)
    std::string rows;
    std::string kind;   // only the cases of this kind; empty: all
    std::string group;  // only the candidates of this group; empty: all
    // Of rows "runs" and "candidates": "front", those that no other beats in both error and time, by time; or
    // "best", the one with the least error of each group. Of rows "frames": "doubling", frames 1, 2, 4 and so
    // on. Empty: all.
    std::string keep;
    bool in_report = false;  // it stands in the report alone
    std::vector<Column> columns;
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
    // Sequences, which give as many readings as there are scored frames, take part in the first of so many
    // rounds, and that may be round 0.
    bool equal_readings = false;
    Layer layer;
    std::optional<CaseQuery> query;
    std::vector<Case> cases;  // without a query
    std::optional<CandidateQuery> candidate_query;
    std::vector<Candidate> candidates;  // those of the query come after them
    std::vector<Table> tables;
};

// "case", "what", "kind", "half", "candidate", "pass", "frame", "cases", a count.
[[nodiscard]] const std::vector<std::string>& labels();

// "visibility", "error", "convergence", "samples", "limit", "converged".
[[nodiscard]] const std::vector<std::string>& picture_kinds();

// Reads a description in JSON (docs/measurements.md). name: of the experiment, and in messages. Throws
// std::runtime_error with the name, the place and what was expected, also for members that it does not know
// and for values out of range.
[[nodiscard]] Experiment read_experiment(const std::string& name, std::string_view text);

// The number of the candidate with this name, or "#0" for the first and so on. nullopt: there is none.
[[nodiscard]] std::optional<std::size_t> candidate_of(const Experiment& experiment, std::string_view name);

// Throws std::invalid_argument for two candidates with one name, two cases with one name, kind and "what",
// and for a case or a column that names a candidate or a case that does not exist.
void require_consistent(const Experiment& experiment);

// Replaces a query by its cases, and keeps the cases with these names; all without names. half: instead of
// the query's; empty: the query's. meshes: folder of the views' meshes. Throws like scene::make_view(), and
// std::invalid_argument for an unknown name, for a half without a query of views, and if no case is left.
void choose_cases(Experiment& experiment, const std::vector<std::string>& names, const std::string& half,
                  const std::filesystem::path& meshes);

// Replaces a query of candidates by them: METHOD/SAMPLES/single and PRESET/SAMPLES/temporal. Throws
// std::invalid_argument for unknown names, and if there is none.
void choose_candidates(Experiment& experiment);

}  // namespace gloam::experiment
