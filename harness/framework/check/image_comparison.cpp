// SPDX-License-Identifier: MIT
#include "check/image_comparison.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <ostream>

#include "numeric/numbers.hpp"
#include "numeric/similarity.hpp"

namespace gloam::check {
namespace {

constexpr std::size_t shown = 4;  // pixels in a story

bool is_float(const Image& image) {
    return image.element.scalar == shader::Scalar::float_;
}

double value_of(const Image& image, Word word) {
    if (is_float(image)) return std::bit_cast<float>(word);
    return image.element.scalar == shader::Scalar::int_ ? std::bit_cast<std::int32_t>(word)
                                                        : double{1} * word;
}

std::string text_of(const Image& image, Word word) {
    if (is_float(image)) return numeric::to_text(std::bit_cast<float>(word));
    return fmt::format("{:g} (0x{:08x})", value_of(image, word), word);
}

// A float where it is one, so that both values have the same hexadecimal form.
std::string text_of(const Image& image, double value) {
    const auto narrow = static_cast<float>(value);
    if (!is_float(image)) return fmt::format("{:g}", value);
    return double{narrow} == value || std::isnan(value) ? numeric::to_text(narrow) : numeric::to_text(value);
}

// 1 and less is inside.
double fraction(double error, double allowed) {
    if (error == 0.0) return 0.0;
    return allowed > 0.0 ? error / allowed : numeric::infinity;
}

// A pixel by its worst component.
struct Difference {
    std::size_t pixel = 0;
    std::size_t component = 0;
    Word got = 0;
    double want = 0.0;
    double ulp = 0.0;
    double absolute = 0.0;
    double fraction = 0.0;

    [[nodiscard]] bool is_worse_than(const Difference& other) const {
        return std::array{fraction, absolute, ulp} > std::array{other.fraction, other.absolute, other.ulp};
    }
};

Difference difference_of(const Image& image, Word word, double want, const ImageBudget& budget) {
    Difference d{.got = word, .want = want};
    if (!is_float(image)) {
        d.absolute = std::abs(value_of(image, word) - want);
        d.fraction = fraction(d.absolute, 0.0);
        return d;
    }
    const auto got = std::bit_cast<float>(word);
    d.ulp = numeric::ulp_error(got, want);
    d.absolute = numeric::absolute_error(got, want);
    d.fraction = std::min(fraction(d.ulp, budget.ulp), fraction(d.absolute, budget.absolute));
    return d;
}

std::string to_text(const ImageBudget& budget) {
    if (budget.similarity > 0.0) return fmt::format("a similarity of {:g}", budget.similarity);
    return to_text(Budget{.ulp = budget.ulp, .absolute = budget.absolute});
}

class Comparer {
  public:
    Comparer(const PassImage& image, const PixelReference& reference, const ImageBudget& budget)
        : image_(image), budget_(budget), components_(scalars_of(image.element).size()) {
        compared_.pixels = image.words.size() / components_;
        for (std::size_t pixel = 0; pixel < compared_.pixels; ++pixel) add(pixel, reference);
    }

    ImageComparison take() {
        if (budget_.similarity > 0.0) judge_similarity();
        if (compared_.outside == 0) return std::move(compared_);
        if (!worst_.empty()) compared_.worst = place(worst_.front().pixel);
        compared_.story = tell();
        return std::move(compared_);
    }

  private:
    [[nodiscard]] glm::ivec2 place(std::size_t pixel) const {
        const auto width = static_cast<std::size_t>(image_.size.x);
        return {static_cast<int>(pixel % width), static_cast<int>(pixel / width)};
    }

    void add(std::size_t pixel, const PixelReference& reference) {
        std::vector<double> wanted;
        reference(place(pixel), wanted);
        wants_.insert(wants_.end(), wanted.begin(), wanted.end());
        Difference worst{.pixel = pixel};
        float error = 0.0F;
        for (std::size_t c = 0; c < components_; ++c) {
            Difference d =
                difference_of(image_, image_.words[pixel * components_ + c], wanted.at(c), budget_);
            d.pixel = pixel;
            d.component = c;
            error = std::max(error, static_cast<float>(d.absolute));
            if (d.is_worse_than(worst)) worst = d;
        }
        compared_.errors.push_back(error);
        if (!image_.unwritten.empty() && image_.unwritten[pixel]) {
            if (compared_.unwritten++ == 0) first_unwritten_ = place(pixel);
            ++compared_.outside;
        } else if (worst.fraction > 1.0) {
            if (budget_.similarity == 0.0 || std::isinf(worst.absolute)) ++compared_.outside;
            note(worst);
        }
    }

    void note(const Difference& worst) {
        if (is_float(image_) && std::isnan(std::bit_cast<float>(worst.got))) ++nan_;
        if (is_float(image_) && std::isinf(std::bit_cast<float>(worst.got))) ++infinite_;
        worst_.insert(
            std::ranges::find_if(worst_, [&](const Difference& d) { return worst.is_worse_than(d); }), worst);
        if (worst_.size() > shown) worst_.pop_back();
    }

    void judge_similarity() {
        for (std::size_t c = 0; c < components_; ++c) {
            std::vector<double> got;
            std::vector<double> want;
            for (std::size_t pixel = 0; pixel < compared_.pixels; ++pixel) {
                got.push_back(value_of(image_, image_.words[pixel * components_ + c]));
                want.push_back(wants_[pixel * components_ + c]);
            }
            least_ = std::min(
                least_, numeric::structural_similarity(got, want, static_cast<std::size_t>(image_.size.x),
                                                       static_cast<std::size_t>(image_.size.y)));
        }
        if (!(least_ >= budget_.similarity)) compared_.outside = compared_.pixels;
    }

    [[nodiscard]] std::string tell() const {
        std::string story = fmt::format("{}: {} of {} pixels outside {}", image_.name, compared_.outside,
                                        compared_.pixels, to_text(budget_));
        if (budget_.similarity > 0.0) story += fmt::format(", similarity {:.6g}", least_);
        if (nan_ + infinite_ > 0) story += fmt::format("; NaN {}, infinite {}", nan_, infinite_);
        if (compared_.unwritten > 0)
            story += fmt::format("; not written {}, the first ({}, {})", compared_.unwritten,
                                 first_unwritten_.x, first_unwritten_.y);
        story += '\n';
        for (const Difference& d : worst_) {
            const glm::ivec2 at = place(d.pixel);
            const std::string component = components_ > 1 ? fmt::format(" component {}", d.component) : "";
            const std::string ulp = is_float(image_) ? fmt::format("{:.6g} ulp, ", d.ulp) : "";
            story += fmt::format("  pixel ({}, {}){}: got {}, expected {}: {}{:.6g} absolute\n", at.x, at.y,
                                 component, text_of(image_, d.got), text_of(image_, d.want), ulp, d.absolute);
        }
        return story;
    }

    const PassImage& image_;
    ImageBudget budget_;
    std::size_t components_;
    ImageComparison compared_;
    std::vector<double> wants_;
    std::vector<Difference> worst_;  // the worst first
    glm::ivec2 first_unwritten_{0};
    std::size_t nan_ = 0;
    std::size_t infinite_ = 0;
    double least_ = 1.0;
};

}  // namespace

void PassImage::require_element(const shader::Type& type) const {
    if (!(type == element))
        throw std::invalid_argument(fmt::format("{}: is compared with {}, expected {}", name,
                                                shader::name_of(type), shader::name_of(element)));
}

ImageComparison PassImage::compare_each(const PixelReference& reference, const ImageBudget& budget) const {
    return Comparer(*this, reference, budget).take();
}

ImageComparison PassImage::compare(const Image& reference, const ImageBudget& budget) const {
    require_element(reference.element);
    if (reference.size != size)
        throw std::invalid_argument(fmt::format("{}: is {} x {}, the reference {} x {}", name, size.x, size.y,
                                                reference.size.x, reference.size.y));
    const std::size_t components = scalars_of(element).size();
    return compare_each(
        [&](glm::ivec2 pixel, std::vector<double>& values) {
            const auto first = (static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) +
                                static_cast<std::size_t>(pixel.x)) *
                               components;
            for (std::size_t c = 0; c < components; ++c)
                values.push_back(value_of(reference, reference.words[first + c]));
        },
        budget);
}

std::ostream& operator<<(std::ostream& stream, const ImageComparison& comparison) {
    if (comparison) return stream << fmt::format("{} pixels are as expected\n", comparison.pixels);
    return stream << comparison.story;
}

}  // namespace gloam::check
