// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <glm/glm.hpp>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "judge/question.hpp"
#include "subject/lab.hpp"
#include "subject/signature.hpp"

namespace gloam::pass {

using backend::Word;

namespace internal {
struct PassInterface;
}

// What a pass is given under a name: an image, a scalar, vector, matrix, array or plain struct of those, or a
// std::vector of one of them for an array.
class PassValue {
  public:
    PassValue(subject::Image image) : image_(std::move(image)) {}
    // A value by the words of its scalars.
    PassValue(module::Type type, std::vector<Word> words)
        : type_(std::move(type)), words_(std::move(words)) {}

    template <class T>
        requires(!std::derived_from<T, subject::Image>)
    PassValue(const T& value) : type_(subject::type_of<T>()) {
        subject::append_words(value, words_);
    }

    template <class T>
    PassValue(const std::vector<T>& elements) : type_(subject::type_of<T>()) {
        type_.sizes.insert(type_.sizes.begin(), static_cast<std::uint32_t>(elements.size()));
        for (const T& element : elements) subject::append_words(element, words_);
    }

    [[nodiscard]] const std::optional<subject::Image>& image() const { return image_; }
    [[nodiscard]] const module::Type& type() const { return type_; }
    [[nodiscard]] const std::vector<Word>& words() const { return words_; }

  private:
    std::optional<subject::Image> image_;
    module::Type type_;
    std::vector<Word> words_;
};

// By the names of the shader: of images and samplers; of members of uniform blocks, storage buffers and push
// constants ("Block.member" where several have the name); of specialization constants (or their number).
using PassInputs = std::map<std::string, PassValue>;

struct PassOptions {
    glm::ivec2 size{0};                     // of the outputs; 0 x 0: that of the given images
    std::array<std::uint32_t, 3> groups{};  // zeros: enough for a pixel per invocation
};

// The same by the numbers of a shader's bindings, as plans of frames have it. An image that is read and not
// given is one pixel of zeros. A run changes the images and buffers as the pass does.
struct PassBindings {
    std::map<std::uint32_t, subject::Image> images;
    std::map<std::uint32_t, std::vector<Word>> buffers;
    std::vector<std::byte> push_constants;
    std::vector<backend::Constant> constants;
    std::array<std::uint32_t, 3> groups{};
};

// The differences of two images.
struct ImageComparison {
    double largest = 0.0;     // of a component; infinite where it is NaN in one image alone
    glm::ivec2 worst{-1};     // the pixel of that difference; -1: the images are equal
    std::size_t outside = 0;  // pixels that differ by more than the tolerance, or were not written
    std::string story;        // why it fails, in lines for people; empty: it passes

    [[nodiscard]] explicit operator bool() const { return story.empty(); }
};
std::ostream& operator<<(std::ostream& stream, const ImageComparison& comparison);

// An image that a pass wrote. `at<T>(pixel)` reads it.
struct PassImage : subject::Image {
    std::string name;             // "blur.comp: result"
    std::vector<bool> unwritten;  // by pixel; empty: all are written

    // Compares it with another image: a reference, or the output of another pass. A component may differ by
    // `tolerance`. Throws std::invalid_argument for another size or type.
    [[nodiscard]] ImageComparison compare(const subject::Image& reference, double tolerance = 0.0) const;
};

// What a pass wrote.
class PassResult {
  public:
    struct Values {
        module::Type type;
        std::vector<Word> words;
        std::size_t unwritten = 0;
    };

    PassResult(std::map<std::string, PassImage> images, std::map<std::string, Values> values,
               std::string pass)
        : images_(std::move(images)), values_(std::move(values)), pass_(std::move(pass)) {}

    // An image that the pass writes. Throws std::invalid_argument, with the names of all, for another name.
    [[nodiscard]] const PassImage& image(const std::string& name) const;

    // A member of a storage buffer that the pass may write: its elements, or one value. Throws
    // std::invalid_argument for an unknown name and another type.
    template <class T>
    [[nodiscard]] std::vector<T> values(const std::string& name) const {
        const Values& found = values_of(name, subject::type_of<T>());
        std::vector<T> values;
        for (std::span<const Word> rest = found.words; !rest.empty();)
            values.push_back(subject::take_words<T>(rest));
        return values;
    }

    // One line for each output with texels or words that the pass did not write, with the first of them.
    // Empty: everything was written, or given and kept.
    [[nodiscard]] std::string unwritten() const;

  private:
    [[nodiscard]] const Values& values_of(const std::string& name, const module::Type& element) const;

    std::map<std::string, PassImage> images_;
    std::map<std::string, Values> values_;
    std::string pass_;
};

// A whole compute shader with its own main(), run on images and buffers by name. An output that is not given
// and that the shader cannot read starts as nothing: what the pass does not write is found (two runs with
// different contents) and fails every comparison. The interpreter reports accesses outside an image, races
// and barriers that not all invocations reach. OpenGL gets what SPIRV-Cross makes of the shader.
// The lab must outlive it.
class Pass {
  public:
    // The file is searched in the lab's include roots. Throws std::invalid_argument for a file that is not
    // there, and for an interface that is not supported; source::CompileError.
    Pass(const subject::Lab& lab, const std::string& file);
    // Of a module. text: the same shader for OpenGL, whose first free uniform block has the push constants.
    Pass(const subject::Lab& lab, const std::string& name, module::Spirv module, std::string text = {});

    // Throws std::invalid_argument, in one line with what was expected, for a name that is unknown or not
    // given and a value of another type or size; backend::Error; backend::Unsupported for what OpenGL lacks;
    // std::runtime_error for validation messages.
    [[nodiscard]] PassResult run(const PassInputs& inputs, const PassOptions& options = {}) const;
    void run(PassBindings& bindings) const;

  private:
    const subject::Lab* lab_;
    std::shared_ptr<const internal::PassInterface> interface_;
};

}  // namespace gloam::pass
