// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "numeric/random.hpp"
#include "subject/signature.hpp"

namespace gloam::subject {

// The state on which a draw may depend.
struct DrawContext {
    numeric::Random& random;
    glm::ivec2 image_size{1};  // of the run's images, for pixel coordinates
};

// How the values of one parameter are chosen: at random, or from a few fixed values that every run includes.
struct Values {
    struct Fixed {
        std::vector<Word> words;
        bool branch = false;  // at or beside a branch point
    };

    std::function<void(DrawContext&, std::vector<Word>&)> draw;  // appends one value
    std::vector<Fixed> fixed;
    // Whether a value may be drawn; empty: unknown. A search for worse inputs stays inside.
    std::function<bool(std::span<const Word>)> contains;
    // Positions of the words that hold sizes of the run's images, two words each.
    std::vector<std::size_t> image_sizes;
    bool only_drawn = false;   // see only_as_drawn
    std::vector<bool> floats;  // whether each word is that of a float; empty: unknown

    // Of one value.
    [[nodiscard]] std::size_t words() const;
    // Whether a value may be an input: it is a fixed value, or it may be drawn.
    [[nodiscard]] bool admits(std::span<const Word> words) const;

    // Each returns the same values with more fixed ones.
    // Adds every special value of a float type (numeric::special_values): as a scalar, in each component of a
    // vector, and in all components.
    [[nodiscard]] Values and_special(module::Scalar scalar = module::Scalar::float_) const;
    // Adds branch points of a float parameter: each point and the floats one ULP on either side.
    [[nodiscard]] Values and_near(std::initializer_list<double> points,
                                  module::Scalar scalar = module::Scalar::float_) const;
    // Adds branch points of an integer parameter: each point and its two neighbours (as int; unsigned wraps).
    [[nodiscard]] Values and_near_integers(std::initializer_list<long> points) const;

    // The same values without degenerate inputs (Domain::and_degenerate). For a parameter whose documented
    // values are only the drawn ones, for example the result of another function, or the size of the image
    // that contains a pixel.
    [[nodiscard]] Values only_as_drawn() const;

    template <class T>
    [[nodiscard]] Values and_value(const T& value, bool branch = false) const {
        Values more = *this;
        Fixed fixed_value{.words = {}, .branch = branch};
        append_words(value, fixed_value.words);
        more.fixed.push_back(std::move(fixed_value));
        return more;
    }
};

// Numbers of a float type, uniform in [low, high]. Fixed values: the ends; if 0 is between them, also both
// zeros and the smallest normal and subnormal numbers of each sign.
[[nodiscard]] Values uniform(double low, double high, module::Scalar scalar = module::Scalar::float_);
// Numbers whose logarithm is uniform in [log low, log high], 0 < low < high.
[[nodiscard]] Values log_uniform(double low, double high, module::Scalar scalar = module::Scalar::float_);
// The same with either sign.
[[nodiscard]] Values signed_log_uniform(double low, double high,
                                        module::Scalar scalar = module::Scalar::float_);
// float with any bit pattern.
[[nodiscard]] Values any_float();
// int or uint: integers in [low, high]; the ends are fixed values.
[[nodiscard]] Values integers(long low, long high);
// int or uint: 0, or a value in [1, high] whose logarithm is uniform.
[[nodiscard]] Values log_integers(long high);
[[nodiscard]] Values booleans();
// vecN or ivecN with independent components. A fixed value of the component is set in each component alone
// and in all.
[[nodiscard]] Values vector(int components, const Values& component);
// A vector with separate values for each component, or a structure with values for each member.
[[nodiscard]] Values vector(const std::vector<Values>& components);
// Directions, uniform on the unit circle (2) or sphere (3), or unit quaternions (4); the axes as fixed
// values.
[[nodiscard]] Values unit_vector(int components);
// A unit vector times a length.
[[nodiscard]] Values vector_of_length(int components, const Values& length);
// ivec2: a pixel of the run's image, corners included; and the size of the image.
[[nodiscard]] Values image_pixel();
[[nodiscard]] Values image_size();
// One of two kinds of values with equal probability; the fixed values of both.
[[nodiscard]] Values either(const Values& a, const Values& b);
// The values of a quad's four invocations (0, 0), (1, 0), (0, 1), (1, 1), each of this type, from those of
// one. In half of the quads floats change by small steps along x and y, the same in both rows and columns, in
// a quarter they are drawn apart, in the rest all are equal; so are integers and bools, unless they are drawn
// apart. Each fixed value is that of all four. `pixels`: of a vec4 that is the coordinate of a pixel: x and y
// are those of a quad.
[[nodiscard]] Values neighbours(const module::Type& type, const Values& one, bool pixels = false);
// The variable for gl_FragCoord in a function of a file (source::Excerpt).
inline constexpr const char* fragment_coordinate = "gloam_FragCoord";
// Values of T made by any function of a numeric::Random&.
template <class T, class Make>
[[nodiscard]] Values made_by(Make make) {
    Values values;
    values.draw = [make](DrawContext& context, std::vector<Word>& words) {
        append_words(static_cast<T>(make(context.random)), words);
    };
    for (const module::Scalar scalar : scalars_of(type_of<T>()))
        values.floats.push_back(module::is_float(scalar));
    return values;
}
// Always the same value.
template <class T>
[[nodiscard]] Values constant(const T& value) {
    return made_by<T>([value](numeric::Random&) { return value; });
}

// The inputs of a check: one Values for each in and inout parameter, in order, and the relations between
// them.
class Domain {
  public:
    Domain() : Domain(std::vector<Values>{}) {}
    // Throws std::invalid_argument for a fixed value of another type than those that are drawn.
    Domain(std::initializer_list<Values> parameters) : Domain(std::vector<Values>(parameters)) {}
    explicit Domain(std::vector<Values> parameters);

    // Adds a relation for branch points that depend on another parameter. In one of sixteen inputs, float
    // parameter `target` becomes float parameter `source` times `factor`, or one of the floats one ULP beside
    // it. Positions count in and inout parameters from 0. Throws std::invalid_argument for a position out of
    // range.
    [[nodiscard]] Domain tied(std::size_t target, std::size_t source, double factor = 1.0) const;

    // Adds a function that may change the words of every input after it was drawn, for example to keep min <=
    // max.
    [[nodiscard]] Domain adjusted(std::function<void(std::span<Word>)> adjust) const;

    // The domain of this function: numbers that are drawn for a float16_t are rounded to one. Throws
    // std::invalid_argument for entries that are not of its parameters.
    [[nodiscard]] Domain fitted(const Signature& signature, const std::string& function) const;

    // Adds an input that every run includes, for example the worst one that a search found. It is passed to
    // the function without adjustment, with the size of the run's images.
    [[nodiscard]] Domain and_words(const std::vector<Word>& words) const;

    // Adds inputs that independent draws hardly ever produce: vectors that are equal, opposite or parallel to
    // each other or lie along an axis; numbers of a struct or array that are zero, negative, infinite or NaN;
    // images whose sides are 0 or 1. Parameters with Values::only_as_drawn are not changed. `only_vectors`:
    // no change of one number. Throws std::invalid_argument, as the next one does, if this is no domain of a
    // function with this signature.
    [[nodiscard]] Domain and_degenerate(const Signature& signature, bool only_vectors = false) const;

    // Adds inputs in which one float is one of the numbers, of either sign, or a float beside it: those at
    // which a function branches. Values that contain infinity take every number; those that have no test, or
    // are only drawn, none.
    [[nodiscard]] Domain and_numbers(const Signature& signature, std::span<const float> numbers) const;

    struct Inputs {
        std::vector<Word> words;   // one input after another
        std::vector<bool> branch;  // input was placed at a branch point
        std::size_t width = 0;     // words of one input

        void add(std::span<const Word> row, bool at_branch = false);
        // Those at the positions that are wanted.
        [[nodiscard]] Inputs where(const std::function<bool(std::size_t)>& wanted) const;
        [[nodiscard]] std::size_t count() const { return branch.size(); }
        [[nodiscard]] std::span<const Word> row(std::size_t i) const {
            return std::span(words).subspan(i * width, width);
        }
    };

    // Draws `count` inputs; the same seed gives the same inputs on every machine. They begin with the given
    // inputs. Then every fixed value and every degenerate change occurs at least once; if there are too many,
    // a part of them takes half of the inputs. The rest is a mixture of random inputs, inputs with one fixed
    // value, inputs with fixed values only, and degenerate inputs. Inputs with added numbers come last, at
    // most an eighth of all.
    [[nodiscard]] Inputs draw(std::size_t count, std::uint64_t seed,
                              glm::ivec2 image_size = glm::ivec2(1)) const;

    // For a search: inputs as drawn, before adjustment; and the adjustment of such an input.
    [[nodiscard]] Inputs draw_unadjusted(std::size_t count, std::uint64_t seed,
                                         glm::ivec2 image_size = glm::ivec2(1)) const;
    void adjust(std::span<Word> row) const;

    // Whether an input certainly belongs to this domain: each parameter has a value that its Values admit, or
    // its value in `known`, an input that was drawn; and no adjustment would change it.
    [[nodiscard]] bool holds(std::span<const Word> input, std::span<const Word> known) const;

    [[nodiscard]] const std::vector<Values>& parameters() const { return *parameters_; }

  private:
    struct Tie {
        std::size_t target;
        std::size_t source;
        double factor;
    };
    // What may be changed in an input after it was drawn, so that it becomes a degenerate one.
    struct Degenerate {
        struct Change {
            std::size_t word;
            Word (*changed)(Word before);
        };
        // A float becomes a number if its parameter still has one of its Values then.
        struct Number {
            std::size_t word;
            Word bits;
            std::size_t parameter;
            bool anywhere;  // the float may be infinite, and therefore any number
        };
        struct Vector {
            std::size_t first;
            std::size_t size;
            std::optional<std::size_t> parameter;  // whose Values decide; none: it may not be changed
        };
        std::vector<Change> changes;
        std::vector<Number> numbers;
        std::vector<Vector> vectors;
    };
    class Drawing;
    void require_fits(const Signature& signature, const std::string& function = "the function") const;

    std::shared_ptr<const std::vector<Values>> parameters_;  // by all domains that are made of this one
    std::vector<Tie> ties_;
    std::vector<std::function<void(std::span<Word>)>> adjustments_;
    std::vector<std::vector<Word>> given_;
    Degenerate degenerate_;
};

// The range of values for a float or integer parameter, ends included.
struct Range {
    double low = 0.0;
    double high = 0.0;

    // Whether the ends are finite floats, the lower one first.
    [[nodiscard]] bool is_valid() const {
        constexpr double most = std::numeric_limits<float>::max();
        return -most <= low && low <= high && high <= most;
    }
};
// The nearest number that an int or uint can have.
[[nodiscard]] inline long nearest_integer(double x) {
    return std::lround(std::clamp(x, -0x1p31, 0x1p32 - 1.0));
}
// Ranges by the names of parameters and of members: "sphere", "sphere.radius".
using Ranges = std::map<std::string, Range>;
// That of a member, else of what it is a member of; nullopt: there is none.
[[nodiscard]] std::optional<Range> range_of(const Ranges& ranges, const std::string& name);

// Parses "x=0:1" as a name and a range. Throws std::invalid_argument for any other text, or low > high.
[[nodiscard]] std::pair<std::string, Range> range_from(const std::string& text);

}  // namespace gloam::subject
