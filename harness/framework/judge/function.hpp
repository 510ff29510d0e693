// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "judge/explain.hpp"
#include "judge/run.hpp"
#include "subject/lab.hpp"

namespace gloam::judge {

// The outcome of Function::property().
struct PropertyResult {
    std::size_t inputs = 0;  // that were tried
    std::vector<Word>
        words;          // the simplest input found for which the property does not hold; empty: it holds
    std::string story;  // that input and the outputs, for people

    [[nodiscard]] bool passed() const { return story.empty(); }
    [[nodiscard]] explicit operator bool() const { return passed(); }
};
std::ostream& operator<<(std::ostream& stream, const PropertyResult& result);

// Whether a property of an input (its words) holds for its outputs (theirs).
using HoldsFor = std::function<bool(std::span<const Word> input, std::span<const Word> outputs)>;

// Draws inputs of the question's domain, runs them, and asks for each; an input that fails is shrunk inside
// the domain. Throws like KernelCore::run().
[[nodiscard]] PropertyResult check_property(const subject::KernelCore& core, const Question& question,
                                            const HoldsFor& holds, const RunOptions& options);

// A GLSL function that C++ can call and check: `Function<float(glm::vec2, Out<float>)> f(lab, "f.glsl",
// "f")`.
//   by value: GLSL `in`; Out<T>: `out`; T&: `inout`. Types: float, int, unsigned, bool, GLM vectors and
//   matrices of float, vectors of the others, std::array and plain structs of up to 10 of these.
// Calls take one value for each in and inout parameter. They return the result, followed by every out and
// inout value: a plain value if there is one, a std::tuple if there are several. The lab must outlive it.
template <class Type>
class Function {
  public:
    using Inputs = typename subject::SignatureOf<Type>::Inputs;
    using Outputs = typename subject::SignatureOf<Type>::Outputs;
    using Output =
        typename std::conditional_t<std::tuple_size_v<Outputs> == 1, std::tuple_element<0, Outputs>,
                                    std::type_identity<Outputs>>::type;

    // Throws like Lab::kernel.
    Function(const subject::Lab& lab, std::string file, std::string function)
        : lab_(&lab),
          file_(std::move(file)),
          function_(std::move(function)),
          core_(lab.kernel(file_, function_, subject::SignatureOf<Type>::describe())) {}

    // Compares the results for many inputs with a reference, within a budget. `reference` takes the inputs in
    // double (see make_reference()). Throws like run().
    template <class Reference>
    [[nodiscard]] Answer compare(Reference reference, const subject::Domain& domain,
                                 const Budget& budget = {}, const RunOptions& options = {}) const {
        Question asked = question(domain);
        asked.reference = make_reference<Type>(std::move(reference));
        asked.budget = budget;
        return judge::run(*lab_, asked, options);
    }

    // Checks whether Vulkan's precision rules permit the results for the module that the driver was given: no
    // reference, no tolerance. Throws like run(): of a group whose invocations race, or do not all reach a
    // barrier, interpreter::Error, which names the two lines.
    [[nodiscard]] Answer check_rules(const subject::Domain& domain, const RunOptions& options = {}) const {
        return judge::run(*lab_, question(domain), options);
    }

    // Checks that `holds(inputs..., outputs...)` is true for the inputs of a domain; several outputs can also
    // be one std::tuple. The simplest input that was found to fail is reported. Not for functions that read
    // images. Throws like operator().
    template <class Holds>
    [[nodiscard]] PropertyResult property(const subject::Domain& domain, const Holds& holds,
                                          const RunOptions& options = {}) const {
        const auto holds_for = [&holds](std::span<const Word> input, std::span<const Word> outputs) {
            const Inputs in = subject::take_words<Inputs>(input);
            const Outputs out = subject::take_words<Outputs>(outputs);
            const auto apart = [&](const auto&... value) {
                if constexpr (std::is_invocable_v<const Holds&, decltype(value)...>) {
                    return static_cast<bool>(holds(value...));
                } else {
                    const auto together = [&](const auto&... one) {
                        static_assert(std::is_invocable_v<const Holds&, decltype(one)..., const Outputs&>,
                                      "holds takes the inputs, then the outputs, or a std::tuple of these");
                        return static_cast<bool>(holds(one..., out));
                    };
                    return std::apply(together, in);
                }
            };
            return std::apply(apart, std::tuple_cat(in, out));
        };
        return check_property(core_, question(domain), holds_for, options);
    }

    // One input, operation by operation (judge/explain.hpp).
    template <class... Arguments>
        requires std::is_constructible_v<Inputs, Arguments...>
    [[nodiscard]] Explanation explain(const Arguments&... arguments) const {
        const Inputs input(arguments...);
        std::vector<Word> words;
        subject::append_words(input, words);
        return judge::explain(lab_->compile_options(), *core_.module().source, words);
    }

    // Evaluates all inputs in one dispatch. Throws backend::Error; std::runtime_error for an access outside
    // an image, with the image and the pixel, and for validation messages.
    [[nodiscard]] std::vector<Output> operator()(std::span<const Inputs> inputs,
                                                 const subject::ImageSet& images = {}) const {
        std::vector<Word> words;
        words.reserve(inputs.size() * core_.input_words());
        for (const Inputs& input : inputs) subject::append_words(input, words);
        const subject::KernelCore::Result result = core_.run(words, inputs.size(), images);
        lab_->require_silent_validation();
        if (result.fault) throw std::runtime_error(to_text(*result.fault));
        std::vector<Output> outputs;
        outputs.reserve(inputs.size());
        std::span<const Word> rest = result.outputs;
        for (std::size_t i = 0; i < inputs.size(); ++i) outputs.push_back(subject::take_words<Output>(rest));
        return outputs;
    }

    // Evaluates one input.
    template <class... Arguments>
        requires std::is_constructible_v<Inputs, Arguments...> &&
                 (!std::is_convertible_v<Arguments, std::span<const Inputs>> && ...)
    [[nodiscard]] Output operator()(const Arguments&... arguments) const {
        const Inputs input(arguments...);
        return (*this)(std::span(&input, 1)).front();
    }

    // Evaluates one input of a function that reads images.
    [[nodiscard]] Output with_images(const subject::ImageSet& images, const Inputs& input) const {
        return (*this)(std::span(&input, 1), images).front();
    }

    [[nodiscard]] const subject::KernelCore& core() const { return core_; }
    [[nodiscard]] const subject::Lab& lab() const { return *lab_; }

    // With the names of the shader.
    [[nodiscard]] subject::Signature signature() const { return core_.module().source->signature(); }

    // What compare() and check_rules() ask on a domain, without a reference.
    [[nodiscard]] Question question(const subject::Domain& domain) const {
        return {.file = file_,
                .function = function_,
                .signature = signature(),
                .domain = domain.fitted(signature(), function_)};
    }

  private:
    const subject::Lab* lab_;
    std::string file_;
    std::string function_;
    subject::KernelCore core_;
};

}  // namespace gloam::judge
