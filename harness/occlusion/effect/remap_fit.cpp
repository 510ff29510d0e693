// SPDX-License-Identifier: MIT
#include "effect/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gloam::effect {
namespace {

// a, log b and log c of a remap.
using Parameters = std::array<double, 3>;

Remap remap_of(const Parameters& p) {
    return {p[0], std::exp(p[1]), std::exp(p[2])};
}

struct Vertex {
    Parameters at{};
    double cost = 0.0;
};

// The squared error over all pixels. NaN, which occurs far from the minimum, counts as infinite.
double squares_of(std::span<const RemapBin> bins, const Remap& remap) {
    double sum = 0.0;
    for (const RemapBin& bin : bins) {
        if (bin.count == 0.0) continue;
        const double y = remap(bin.visibility / bin.count);
        sum += bin.count * y * y - 2.0 * y * bin.truth + bin.square;
    }
    return std::isfinite(sum) ? sum : HUGE_VAL;
}

// The simplex method of Nelder and Mead.
class Simplex {
  public:
    Simplex(std::span<const RemapBin> bins, const Parameters& start) : bins_(bins) {
        corners_[0] = at(start);
        for (std::size_t i = 0; i < start.size(); ++i) {
            Parameters moved = start;
            moved[i] += 0.2;
            corners_[i + 1] = at(moved);
        }
    }

    Parameters best(int steps) {
        for (int i = 0; i < steps; ++i) step();
        sort();
        return corners_.front().at;
    }

  private:
    [[nodiscard]] Vertex at(const Parameters& p) const { return {p, squares_of(bins_, remap_of(p))}; }

    void sort() { std::ranges::stable_sort(corners_, {}, &Vertex::cost); }

    // The worst vertex, reflected by a factor through the centre of the others; a negative factor moves it
    // towards them.
    [[nodiscard]] Vertex moved(double factor) const {
        Parameters p{};
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double middle = (corners_[0].at[i] + corners_[1].at[i] + corners_[2].at[i]) / 3.0;
            p[i] = middle + factor * (middle - corners_[3].at[i]);
        }
        return at(p);
    }

    void step() {
        sort();
        const Vertex reflected = moved(1.0);
        if (reflected.cost < corners_[0].cost) {
            const Vertex expanded = moved(2.0);
            corners_[3] = expanded.cost < reflected.cost ? expanded : reflected;
        } else if (reflected.cost < corners_[2].cost) {
            corners_[3] = reflected;
        } else {
            const Vertex contracted = moved(reflected.cost < corners_[3].cost ? 0.5 : -0.5);
            if (contracted.cost < corners_[3].cost) {
                corners_[3] = contracted;
            } else {
                shrink();
            }
        }
    }

    void shrink() {
        for (std::size_t k = 1; k < corners_.size(); ++k) {
            Parameters p = corners_[k].at;
            for (std::size_t i = 0; i < p.size(); ++i) p[i] = 0.5 * (p[i] + corners_[0].at[i]);
            corners_[k] = at(p);
        }
    }

    std::span<const RemapBin> bins_;
    std::array<Vertex, 4> corners_{};
};

}  // namespace

double Remap::operator()(double visibility) const {
    const double base = b * (visibility + a);
    if (!(base > 0.0)) return c == 0.0 ? 1.0 : 0.0;
    return std::min(1.0, std::pow(base, c));
}

void add_to_bins(std::span<RemapBin> bins, std::span<const float> occlusion, std::span<const float> truth) {
    const std::size_t count = bins.size();
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!std::isfinite(truth[i])) continue;
        const double x = std::clamp(1.0 - double{occlusion[i]}, 0.0, 1.0);
        const double y = 1.0 - double{truth[i]};
        RemapBin& bin = bins[std::min(count - 1, static_cast<std::size_t>(x * static_cast<double>(count)))];
        bin.count += 1.0;
        bin.visibility += x;
        bin.truth += y;
        bin.square += y * y;
    }
}

Remap best_remap(std::span<const RemapBin> bins) {
    if (std::ranges::all_of(bins, [](const RemapBin& bin) { return bin.count == 0.0; })) return {};
    // Restarted from its result, because a simplex can collapse beside the minimum.
    Parameters best{0.0, 0.0, 0.0};
    for (int round = 0; round < 3; ++round) best = Simplex(bins, best).best(150);
    const Remap fit = remap_of(best);
    return squares_of(bins, fit) < squares_of(bins, Remap{}) ? fit : Remap{};
}

double remapped_rmse(std::span<const RemapBin> bins, const Remap& remap) {
    double count = 0.0;
    for (const RemapBin& bin : bins) count += bin.count;
    return std::sqrt(std::max(squares_of(bins, remap), 0.0) / count);
}

Remap best_remap(std::span<const float> occlusion, std::span<const float> truth) {
    std::vector<RemapBin> bins(4096);
    add_to_bins(bins, occlusion, truth);
    const Remap fit = best_remap(bins);
    const bool better = errors_of(remapped(occlusion, fit), truth).rmse < errors_of(occlusion, truth).rmse;
    return better ? fit : Remap{};
}

std::vector<float> remapped(std::span<const float> occlusion, const Remap& remap) {
    std::vector<float> result;
    result.reserve(occlusion.size());
    for (const float value : occlusion)
        result.push_back(static_cast<float>(1.0 - remap(1.0 - double{value})));
    return result;
}

}  // namespace gloam::effect
