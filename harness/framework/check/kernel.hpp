// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "check/lab.hpp"

namespace gloam::check {

// A GLSL function that C++ can call: `Kernel<float(glm::vec2, Out<float>)>`.
//   by value: GLSL `in`; Out<T>: `out`; T&: `inout`. Types: float, int, unsigned, bool, GLM vectors and
//   matrices of float, vectors of the others, plain structs of up to 9 of these, std::array of these.
// Calls take one value for each in and inout parameter. They return the result, followed by every out and
// inout value: a plain value if there is one, a std::tuple if there are several.
template <class Function>
class Kernel {
  public:
    using Inputs = typename SignatureOf<Function>::Inputs;
    using Outputs = typename SignatureOf<Function>::Outputs;
    using Output =
        typename std::conditional_t<std::tuple_size_v<Outputs> == 1, std::tuple_element<0, Outputs>,
                                    std::type_identity<Outputs>>::type;

    // Throws like Lab::kernel.
    Kernel(const Lab& lab, const std::string& file, const std::string& function)
        : lab_(&lab), core_(lab.kernel(file, function, SignatureOf<Function>::describe())) {}

    // Evaluates all inputs in one dispatch. Throws backend::Error; std::runtime_error for an access outside
    // an image, with the image and the pixel, and for validation messages.
    [[nodiscard]] std::vector<Output> operator()(std::span<const Inputs> inputs,
                                                 const ImageSet& images = {}) const {
        return run(inputs, images, nullptr);
    }

    // The same; `stored` receives the images that the function stored to.
    [[nodiscard]] std::vector<Output> operator()(std::span<const Inputs> inputs, const ImageSet& images,
                                                 ImageSet& stored) const {
        return run(inputs, images, &stored);
    }

    // Evaluates one input.
    template <class... Arguments>
        requires std::is_constructible_v<Inputs, Arguments...> &&
                 (!std::is_convertible_v<Arguments, std::span<const Inputs>> && ...)
    [[nodiscard]] Output operator()(const Arguments&... arguments) const {
        const Inputs input(arguments...);
        return run(std::span(&input, 1), {}, nullptr).front();
    }

    // Evaluates one input of a function that reads images.
    [[nodiscard]] Output with_images(const ImageSet& images, const Inputs& input) const {
        return run(std::span(&input, 1), images, nullptr).front();
    }

    [[nodiscard]] const KernelCore& core() const { return core_; }

  private:
    std::vector<Output> run(std::span<const Inputs> inputs, const ImageSet& images, ImageSet* stored) const {
        std::vector<Word> words;
        words.reserve(inputs.size() * core_.input_words());
        for (const Inputs& input : inputs) {
            std::apply([&words](const auto&... value) { (append_words(value, words), ...); }, input);
        }
        KernelCore::Result result = core_.run(words, inputs.size(), images);
        lab_->require_silent_validation();
        if (result.fault) throw std::runtime_error(to_text(*result.fault));
        std::vector<Output> outputs;
        outputs.reserve(inputs.size());
        std::span<const Word> rest = result.outputs;
        for (std::size_t i = 0; i < inputs.size(); ++i) outputs.push_back(take(rest));
        if (stored != nullptr) *stored = std::move(result.stored);
        return outputs;
    }

    static Output take(std::span<const Word>& rest) {
        if constexpr (std::tuple_size_v<Outputs> == 1) {
            return take_words<Output>(rest);
        } else {
            Outputs all{};
            std::apply(
                [&rest](auto&... value) {
                    ((value = take_words<std::remove_cvref_t<decltype(value)>>(rest)), ...);
                },
                all);
            return all;
        }
    }

    const Lab* lab_;
    KernelCore core_;
};

}  // namespace gloam::check
