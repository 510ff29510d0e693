// SPDX-License-Identifier: MIT
#include "pass/pass.hpp"

#include <fmt/ranges.h>
#include <algorithm>
#include <bit>
#include <limits>
#include <ostream>

#include "backend/gl/device.hpp"
#include "module/include.hpp"
#include "module/module.hpp"
#include "numeric/numbers.hpp"
#include "pass/internal/work.hpp"

namespace gloam::pass {

using namespace subject;

using internal::Bound;
using internal::PassSlot;
using internal::PassWork;

namespace {

void run_on(const Lab& lab, const internal::PassInterface& pass, std::span<PassWork> works) {
    if (lab.info().type == interpreter_name)
        internal::run_interpreted(pass, works);
    else if (const auto* opengl = dynamic_cast<const backend::gl::Device*>(lab.backend().get()))
        internal::run_on_opengl(*opengl, pass, works);
    else
        internal::run_on_device(lab.device(), pass, works);
    lab.require_silent_validation();
}

module::Spirv compiled(const Lab& lab, const std::string& file) {
    std::filesystem::path path;
    try {
        path = module::resolve_include(file, {}, lab.options().include_roots);
    } catch (const std::runtime_error& error) {
        throw std::invalid_argument(file + ": " + error.what());
    }
    module::CompileOptions options = lab.compile_options();
    options.lines = lab.info().type == interpreter_name;  // its errors have a place
    module::Spirv module =
        lab.cache().compile({.name = path.string(), .text = module::read_text(path)}, options);
    if (const std::string other = module::spirv::other_number(module); !other.empty())
        throw std::invalid_argument(file + ": " + module::spirv::not_judged(other));
    return module;
}

// Two contents of what is not given, of images exact in every format. What holds both, each in its run, was
// not written.
Word canary_of(const Bound& bound, std::size_t run) {
    if (run == 0) return 0U;
    if (bound.kind != Bound::Kind::image) return 0xFFFFFFFFU;
    return bound.integers ? 1U : std::bit_cast<Word>(1.0F);
}

// Whether something is fresh.
bool fill(PassWork& work, std::size_t run) {
    bool any = false;
    for (Bound& bound : work.bindings)
        for (std::size_t w = 0; w < bound.fresh.size(); ++w)
            if (bound.fresh[w]) bound.words[w] = canary_of(bound, run), any = true;
    return any;
}

// What a binding holds after both runs.
struct Written {
    const Bound& first;
    const Bound& second;

    [[nodiscard]] bool lacks(std::size_t w) const {
        return w < first.fresh.size() && first.fresh[w] && first.words[w] == canary_of(first, 0) &&
               second.words[w] == canary_of(first, 1);
    }
};

// An image of the first of two runs; poison where nothing was written.
PassImage image_of(const std::string& name, const Written& after, const module::Type& pixel) {
    PassImage image{{.element = pixel, .size = after.first.size, .words = {}}, name, {}};
    const auto channels = static_cast<std::size_t>(pixel.rows);
    const Word poison =
        after.first.integers ? 0xFFFFFFFFU : std::bit_cast<Word>(std::numeric_limits<float>::quiet_NaN());
    for (std::size_t at = 0; at < after.first.words.size(); at += internal::texel_words) {
        bool untouched = true;
        for (std::size_t c = at; c < at + channels; ++c) untouched = untouched && after.lacks(c);
        image.unwritten.push_back(untouched);
        for (std::size_t c = at; c < at + channels; ++c)
            image.words.push_back(untouched ? poison : after.first.words[c]);
    }
    if (std::ranges::count(image.unwritten, true) == 0) image.unwritten.clear();
    return image;
}

PassResult::Values values_of(const PassSlot& slot, const Written& after) {
    const std::size_t bytes = after.first.words.size() * sizeof(Word);
    const std::size_t elements =
        slot.member.stride == 0 ? 0 : (bytes - slot.member.offset) / slot.member.stride;
    PassResult::Values values{.type = slot.type, .words = {}};
    values.type.sizes.assign(slot.type.sizes.empty() ? 0 : 1, 0U);
    for (const std::size_t place : internal::places_of(slot.member, elements)) {
        values.words.push_back(after.first.words[place / sizeof(Word)]);
        values.unwritten += after.lacks(place / sizeof(Word)) ? 1 : 0;
    }
    return values;
}

PassResult result_of(const internal::PassInterface& pass, const PassWork& first, const PassWork& second) {
    std::map<std::string, PassImage> images;
    std::map<std::string, PassResult::Values> values;
    for (const PassSlot& slot : pass.slots) {
        if (slot.kind != PassSlot::Kind::image && slot.kind != PassSlot::Kind::buffer_member) continue;
        const module::Binding& binding = pass.declared.bindings[slot.index];
        if (!binding.writes) continue;
        const Written after{first.bindings[binding.number], second.bindings[binding.number]};
        if (slot.kind == PassSlot::Kind::image)
            images.emplace(slot.name, image_of(pass.name + ": " + slot.name, after, slot.type));
        else
            values.emplace(slot.name, values_of(slot, after));
    }
    return {std::move(images), std::move(values), pass.name};
}

template <class Map>
const typename Map::mapped_type& found_in(const Map& all, const std::string& name, const std::string& pass,
                                          const char* what) {
    const auto found = all.find(name);
    if (found != all.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, value] : all) names.push_back(known);
    throw std::invalid_argument(
        fmt::format("{}: writes no {} \"{}\", expected one of: {}", pass, what, name,
                    names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace

Pass::Pass(const Lab& lab, const std::string& file) : Pass(lab, file, compiled(lab, file)) {}

Pass::Pass(const Lab& lab, const std::string& name, module::Spirv module, std::string text)
    : lab_(&lab),
      interface_(std::make_shared<const internal::PassInterface>(
          internal::interface_of(name, std::move(module), std::move(text)))) {}

PassResult Pass::run(const PassInputs& inputs, const PassOptions& options) const {
    std::vector<PassWork> works{internal::bound(*interface_, inputs, options)};
    if (fill(works.front(), 0)) (void)fill(works.emplace_back(works.front()), 1);
    run_on(*lab_, *interface_, works);
    return result_of(*interface_, works.front(), works.back());
}

void Pass::run(PassBindings& bindings) const {
    PassWork work = internal::bound(*interface_, bindings);
    run_on(*lab_, *interface_, std::span(&work, 1));
    for (auto& [number, image] : bindings.images) {
        if (number >= work.bindings.size() || !work.bindings[number].written) continue;
        const Bound& bound = work.bindings[number];
        image.words = image_of({}, {bound, bound}, image.element).words;
    }
    for (auto& [number, words] : bindings.buffers)
        if (number < work.bindings.size()) words = work.bindings[number].words;
}

const PassImage& PassResult::image(const std::string& name) const {
    return found_in(images_, name, pass_, "image");
}

const PassResult::Values& PassResult::values_of(const std::string& name, const module::Type& element) const {
    const Values& found = found_in(values_, name, pass_, "buffer member");
    module::Type expected = found.type;
    expected.sizes.clear();
    if (!(expected == element))
        throw std::invalid_argument(fmt::format("{}: \"{}\" holds {}, asked for {}", pass_, name,
                                                module::name_of(expected), module::name_of(element)));
    return found;
}

std::string PassResult::unwritten() const {
    std::string text;
    for (const auto& [name, image] : images_) {
        const auto first = std::ranges::find(image.unwritten, true);
        if (first == image.unwritten.end()) continue;
        const auto at = static_cast<int>(first - image.unwritten.begin());
        text += fmt::format("{}: {} of {} pixels were not written, the first ({}, {})\n", image.name,
                            std::ranges::count(image.unwritten, true), image.unwritten.size(),
                            at % image.size.x, at / image.size.x);
    }
    for (const auto& [name, value] : values_)
        if (value.unwritten > 0)
            text += fmt::format("{}: {}: {} of {} words were not written\n", pass_, name, value.unwritten,
                                value.words.size());
    return text;
}

namespace {

void require_alike(const PassImage& image, const Image& reference) {
    if (!(reference.element == image.element))
        throw std::invalid_argument(fmt::format("{}: is compared with {}, expected {}", image.name,
                                                module::name_of(reference.element),
                                                module::name_of(image.element)));
    if (reference.size != image.size)
        throw std::invalid_argument(fmt::format("{}: is {} x {}, the reference {} x {}", image.name,
                                                image.size.x, image.size.y, reference.size.x,
                                                reference.size.y));
}

}  // namespace

ImageComparison PassImage::compare(const Image& reference, double tolerance) const {
    require_alike(*this, reference);
    ImageComparison compared;
    const std::size_t components = scalars_of(element).size();
    const std::size_t pixels = words.size() / components;
    std::size_t worst = words.size();
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        bool outside = !unwritten.empty() && unwritten[pixel];
        for (std::size_t w = pixel * components; w < (pixel + 1) * components; ++w) {
            const double difference = numeric::absolute_error(number_at(element.scalar, words[w]),
                                                              number_at(element.scalar, reference.words[w]));
            outside = outside || difference > tolerance;
            if (difference > compared.largest) compared.largest = difference, worst = w;
        }
        compared.outside += outside ? 1 : 0;
    }
    const auto width = static_cast<std::size_t>(size.x);
    if (worst < words.size())
        compared.worst = {static_cast<int>(worst / components % width),
                          static_cast<int>(worst / components / width)};
    if (compared.outside == 0) return compared;
    const auto missing = std::ranges::count(unwritten, true);
    compared.story =
        fmt::format("{}: {} of {} pixels differ by more than {:g}{}\n", name, compared.outside, pixels,
                    tolerance, missing == 0 ? "" : fmt::format(", {} of them not written", missing));
    if (worst < words.size())
        compared.story += fmt::format(
            "  pixel ({}, {}) component {}: got {}, expected {}, difference {:.6g}\n", compared.worst.x,
            compared.worst.y, worst % components, subject::text_of(element.scalar, words[worst]),
            subject::text_of(element.scalar, reference.words[worst]), compared.largest);
    return compared;
}

std::ostream& operator<<(std::ostream& stream, const ImageComparison& comparison) {
    if (comparison) return stream << fmt::format("largest difference {:g}\n", comparison.largest);
    return stream << comparison.story;
}

}  // namespace gloam::pass
