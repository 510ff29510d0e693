// SPDX-License-Identifier: MIT
#include "audit/internal/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "judge/reproduction.hpp"

namespace gloam::audit::internal {
namespace {

using namespace subject;

constexpr std::size_t drawn_part = 2;   // one of this many inputs is drawn
constexpr std::size_t random_part = 4;  // one of this many drawn ones has no special value
constexpr std::size_t most_examples = 128;
constexpr std::size_t most_traced = 64;
constexpr std::size_t generation = 64;  // inputs of one round of a climb
constexpr std::array losses{Concern::digits, Concern::drivers};

using Candidate = Moves::Candidate;

// The same domain without fixed values.
Domain without_special(const Domain& domain) {
    std::vector<Values> parameters = domain.parameters();
    for (Values& values : parameters) values.fixed.clear();
    return Domain(std::move(parameters));
}

// Runs inputs and keeps the worst of each concern.
class Search {
  public:
    Search(AuditRuns& runs, const AuditOptions& options)
        : runs_(runs), options_(options), slots_(slots_of(runs.question())) {}

    AuditSearch run() {
        const std::size_t draws = std::max<std::size_t>(options_.inputs / drawn_part, random_part);
        const std::size_t random = draws / random_part;
        const Domain::Inputs usual =
            without_special(runs_.question().domain).draw(random, options_.seed, runs_.image_size());
        runs_.set_usual(usual);
        found_.random = draw(usual, true, 0.25);
        Moves moves(runs_.question(), draws - random, runs_.image_size(), options_.seed, options_.seed);
        (void)draw(moves.drawn(), false, 0.5);
        try_remainders(moves.drawn());
        if (moves.drawn().count() > 0) try_decimals(moves.drawn().row(0));
        try_places(usual);
        const std::size_t rest = (options_.inputs - draws) / 2;
        climb(moves, Concern::digits, rest, 0.75);
        climb(moves, Concern::drivers, rest, 1.0);
        return std::move(found_);
    }

  private:
    [[nodiscard]] bool has_steps(double share) const {
        return static_cast<double>(runs_.instructions()) < share * static_cast<double>(options_.steps);
    }

    // Calls visit(slot, k) for each float of an input.
    template <class Visit>
    void for_each_float(const Visit& visit) const {
        for (const Slot& slot : slots_)
            for (std::size_t k = 0; k < slot.count; ++k)
                if (scalars_of(slot.parameter->type).at(k) == module::Scalar::float_) visit(slot, k);
    }

    // A row with another number in a slot; nullopt if the domain has no such number.
    static std::optional<std::vector<Word>> with(std::span<const Word> row, const Slot& slot, std::size_t k,
                                                 float number) {
        std::vector<Word> words(row.begin(), row.end());
        words[slot.first + k] = to_word(number);
        if (!slot.values->admits(std::span(words).subspan(slot.first, slot.count))) return std::nullopt;
        return words;
    }

    // What rounding leaves of zero, where a number may have both signs: fract() of a small negative one is 1.
    // It shows an index beyond a table; nobody means such numbers, so it shows nothing else.
    void try_remainders(const Domain::Inputs& drawn) {
        constexpr std::size_t most_rows = 16;
        for (std::size_t i = 0; i < std::min(drawn.count(), most_rows) && has_steps(0.5); ++i)
            for_each_float([&](const Slot& slot, std::size_t k) {
                const auto usual = with(drawn.row(i), slot, k, 0x1p-6F);
                if (!usual || !with(drawn.row(i), slot, k, -0x1p-6F)) return;
                for (const float tiny : {-0x1p-30F, 0x1p-30F}) {
                    std::vector<Word> words = *usual;
                    words[slot.first + k] = to_word(tiny);
                    runs_.question().domain.adjust(words);
                    if (shows(Concern::fault, runs_.read(words))) keep(Concern::fault, words, false);
                }
            });
    }

    // Numbers as people write them: int(x * 10.0) decides otherwise in double for 0.7, and for few floats
    // that are drawn.
    void try_decimals(std::span<const Word> row) {
        constexpr int most_steps = 100;
        for_each_float([&](const Slot& slot, std::size_t k) {
            for (const double unit : {0.1, 1.0})
                for (int i = -most_steps; i <= most_steps && has_steps(0.5); ++i)
                    if (auto words = with(row, slot, k, static_cast<float>(i * unit))) try_parting(*words);
        });
    }

    void try_parting(std::vector<Word>& words) {
        runs_.question().domain.adjust(words);
        const Reading reading = runs_.read(words);
        if (reading.fault.empty() && !runs_.is_undefined(words, reading) && runs_.parting_of(words, reading))
            keep(Concern::parting, words, false);
    }

    // Where the function goes wrong at one number only.
    void try_places(const Domain::Inputs& drawn) {
        constexpr double share = 0.6;
        for (std::vector<Word>& words :
             places_of(runs_.question(), runs_.numbers(), drawn, options_.inputs / 2)) {
            if (!has_steps(share)) break;
            runs_.question().domain.adjust(words);
            (void)keep_broken(words, runs_.read(words), false);
        }
    }

    // Returns how many were run.
    std::size_t draw(const Domain::Inputs& drawn, bool random, double share) {
        std::size_t i = 0;
        for (; i < drawn.count() && has_steps(share); ++i) {
            const std::vector<Word> words(drawn.row(i).begin(), drawn.row(i).end());
            const Reading reading = run(words, true, random);
            if (!reading.fault.empty()) continue;
            for (const Concern concern : losses)
                pools_[concern].push_back({words, runs_.largest(concern, reading).relative});
        }
        for (auto& [concern, pool] : pools_) Moves::keep_the_worst(pool);
        return i;
    }

    void climb(Moves& moves, Concern concern, std::size_t inputs, double share) {
        const auto run_all = [&](std::vector<Candidate>& candidates) {
            for (Candidate& candidate : candidates) {
                const Reading reading = run(candidate.words, false, false);
                if (reading.fault.empty()) candidate.score = runs_.largest(concern, reading).relative;
            }
        };
        moves.climb(pools_[concern], inputs, generation, run_all, [&] { return has_steps(share); });
    }

    // `drawn`: before adjustment. `draws`: it does not come from a climb.
    Reading run(const std::vector<Word>& drawn, bool draws, bool random) {
        std::vector<Word> words = drawn;
        runs_.question().domain.adjust(words);
        Reading reading = runs_.read(words);
        ++found_.inputs;
        if (reading.too_long) ++found_.too_long;
        if (found_.traced.size() < most_traced) found_.traced.push_back(words);
        const bool undefined = keep_broken(words, reading, random);
        if (draws && !undefined && runs_.is_undefined(words, AuditRuns::Gaps::open))
            keep(Concern::unspecified, words, random);
        if (!reading.fault.empty()) return reading;
        if (draws && !undefined && runs_.parting_of(words, reading)) keep(Concern::parting, words, random);
        for (const Concern concern : losses) {
            Candidate& worst = found_.worst[concern];
            const double score = runs_.largest(concern, reading).relative;
            if (score > worst.score) worst = {words, score};
        }
        return reading;
    }

    // Returns whether a result is undefined.
    bool keep_broken(const std::vector<Word>& words, const Reading& reading, bool random) {
        for (const Concern concern : {Concern::fault, Concern::is_false, Concern::not_finite})
            if ((concern != Concern::is_false || runs_.question().must_hold) && shows(concern, reading))
                keep(concern, words, random);
        const bool undefined = runs_.is_undefined(words, reading);
        if (undefined) keep(Concern::undefined, words, random);
        return undefined;
    }

    void keep(Concern concern, const std::vector<Word>& words, bool random) {
        Examples& examples = found_.examples[concern];
        if (random) ++examples.shown;
        auto& kept = random ? examples.random : examples.others;
        if (kept.size() < most_examples) kept.push_back(words);
    }

    AuditRuns& runs_;
    const AuditOptions& options_;
    std::vector<Slot> slots_;
    AuditSearch found_;
    std::map<Concern, std::vector<Candidate>> pools_;  // of losses
};

}  // namespace

AuditSearch search(AuditRuns& runs, const AuditOptions& options) {
    return Search(runs, options).run();
}

double digits_of(double relative, double unit) {
    return relative > unit ? std::log10(relative / unit) : 0.0;
}

bool shows(Concern concern, const OutputReading& output) {
    const bool finite = std::isfinite(output.value);
    if (concern == Concern::is_false) return output.value == 0.0;
    if (concern == Concern::not_finite) return !finite;
    return finite && (output.permitted.is_anything() || output.permitted.nan);
}

bool shows(Concern concern, const Reading& reading) {
    if (concern == Concern::fault) return !reading.fault.empty();
    return std::ranges::any_of(reading.outputs,
                               [&](const OutputReading& output) { return shows(concern, output); });
}

std::vector<Word> simplified(const AuditRuns& runs, const std::vector<Word>& words,
                             const std::function<bool(const std::vector<Word>&)>& still) {
    const auto first_still = [&](std::span<const std::vector<Word>> inputs) -> std::optional<judge::Sample> {
        const auto found = std::ranges::find_if(inputs, still);
        return found == inputs.end() ? std::nullopt : std::optional(judge::Sample{.inputs = *found});
    };
    return still(words) ? shrink(runs.question(), {.inputs = words}, first_still).inputs : words;
}

}  // namespace gloam::audit::internal
