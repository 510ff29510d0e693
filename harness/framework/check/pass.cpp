// SPDX-License-Identifier: MIT
#include "check/pass.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "check/internal/pass_work.hpp"
#include "shader/include.hpp"
#include "shader/module.hpp"

namespace gloam::check {

using internal::Bound;
using internal::BoundBuffer;
using internal::BoundImage;
using internal::PassSlot;
using internal::PassWork;

struct Pass::Impl {
    const Lab* lab;
    internal::PassModules modules;
    internal::PassInterface interface;
};

namespace {

shader::Spirv compiled(const Lab& lab, const std::string& file, shader::Stage stage) {
    std::filesystem::path path;
    try {
        path = shader::resolve_include(file, {}, lab.options().include_roots);
    } catch (const std::runtime_error& error) {
        throw std::invalid_argument(file + ": " + error.what());
    }
    shader::CompileOptions options = lab.compile_options();
    options.stage = stage;
    options.lines = lab.info().type == interpreter_name;  // its errors have a place
    shader::Spirv module = lab.compile({.name = path.string(), .text = shader::read_text(path)}, options);
    if (const std::string other = shader::spirv::other_number(module); !other.empty())
        throw std::invalid_argument(file + ": " + shader::spirv::not_judged(other));
    return module;
}

std::shared_ptr<const Pass::Impl> made(const Lab& lab, internal::PassModules modules) {
    internal::PassInterface interface = internal::interface_of(modules);
    if (modules.compute.empty() && interface.colors.empty())
        throw std::invalid_argument(modules.name +
                                    ": writes no colour, expected an output of the fragment shader");
    return std::make_shared<const Pass::Impl>(&lab, std::move(modules), std::move(interface));
}

// Two contents of what is not given. What holds both, each in its run, was not written.
struct Canary {
    float texel;  // exact in every format
    Word word;
};
constexpr std::array canaries{Canary{0.0F, 0U}, Canary{1.0F, 0xFFFFFFFFU}};

Word texel_of(const BoundImage& image, const Canary& canary) {
    return image.integers ? static_cast<Word>(canary.texel) : std::bit_cast<Word>(canary.texel);
}

template <class Visit>
void for_each_image(PassWork& work, const Visit& visit) {
    for (Bound& bound : work.bindings)
        if (auto* image = std::get_if<BoundImage>(&bound)) visit(*image);
    for (BoundImage& image : work.colors) visit(image);
}

// Whether something is fresh.
bool fill(PassWork& work, const Canary& canary) {
    bool any = false;
    for_each_image(work, [&](BoundImage& image) {
        if (image.fresh) std::ranges::fill(image.texels, texel_of(image, canary));
        if (image.fresh && !work.colors.empty()) work.background = canary.texel;
        any = any || image.fresh;
    });
    for (Bound& bound : work.bindings) {
        auto* buffer = std::get_if<BoundBuffer>(&bound);
        for (std::size_t w = 0; buffer != nullptr && w < buffer->words.size(); ++w)
            if (buffer->fresh[w]) buffer->words[w] = canary.word, any = true;
    }
    return any;
}

// An image of the first of two runs; poison where nothing was written.
PassImage image_of(const std::string& name, const BoundImage& first, const BoundImage& second,
                   const shader::Type& pixel) {
    PassImage image{{.element = pixel, .size = first.size, .words = {}}, name, {}};
    const auto channels = static_cast<std::size_t>(gpu::channels(first.format));
    const Word poison =
        first.integers ? 0xFFFFFFFFU : std::bit_cast<Word>(std::numeric_limits<float>::quiet_NaN());
    for (std::size_t at = 0; at < first.texels.size(); at += channels) {
        bool untouched = first.fresh;
        for (std::size_t c = at; c < at + channels; ++c)
            untouched = untouched && first.texels[c] == texel_of(first, canaries[0]) &&
                        second.texels[c] == texel_of(first, canaries[1]);
        image.unwritten.push_back(untouched);
        for (std::size_t c = 0; c < static_cast<std::size_t>(pixel.rows); ++c)
            image.words.push_back(untouched ? poison : first.texels[at + c]);
    }
    if (std::ranges::count(image.unwritten, true) == 0) image.unwritten.clear();
    return image;
}

PassResult::Values values_of(const PassSlot& slot, const BoundBuffer& first, const BoundBuffer& second) {
    const auto elements = [&] {
        const std::size_t bytes = first.words.size() * sizeof(Word);
        return slot.member.stride == 0 ? 0 : (bytes - slot.member.offset) / slot.member.stride;
    };
    PassResult::Values values{.type = slot.type, .words = {}};
    values.type.sizes.assign(slot.type.sizes.empty() ? 0 : 1, 0U);
    for (const std::size_t place : internal::places_of(slot.member, elements())) {
        const std::size_t w = place / sizeof(Word);
        values.words.push_back(first.words[w]);
        if (first.fresh[w] && first.words[w] == canaries[0].word && second.words[w] == canaries[1].word)
            ++values.unwritten;
    }
    return values;
}

PassResult result_of(const internal::PassInterface& pass, const PassWork& first, const PassWork& second) {
    std::map<std::string, PassImage> images;
    std::map<std::string, PassResult::Values> values;
    for (const PassSlot& slot : pass.slots) {
        if (slot.kind != PassSlot::Kind::image && slot.kind != PassSlot::Kind::buffer_member) continue;
        const shader::Binding& binding = pass.bindings[slot.index];
        if (!binding.writes) continue;
        const Bound& one = first.bindings[binding.number];
        const Bound& two = second.bindings[binding.number];
        if (const auto* image = std::get_if<BoundImage>(&one))
            images.emplace(slot.name, image_of(pass.name + ": " + slot.name, *image,
                                               std::get<BoundImage>(two), slot.type));
        else
            values.emplace(slot.name,
                           values_of(slot, std::get<BoundBuffer>(one), std::get<BoundBuffer>(two)));
    }
    for (std::size_t i = 0; i < pass.colors.size(); ++i) {
        const shader::Type pixel{.scalar = shader::Scalar::float_,
                                 .rows = static_cast<int>(pass.colors[i].rows)};
        images.emplace(pass.colors[i].name, image_of(pass.name + ": " + pass.colors[i].name, first.colors[i],
                                                     second.colors[i], pixel));
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

Pass::Pass(const Lab& lab, const std::string& compute_file)
    : impl_(made(lab, {.name = compute_file,
                       .compute = compiled(lab, compute_file, shader::Stage::compute),
                       .vertex = {},
                       .fragment = {}})) {}

Pass::Pass(const Lab& lab, const std::string& vertex_file, const std::string& fragment_file)
    : impl_(made(lab, {.name = vertex_file + " and " + fragment_file,
                       .compute = {},
                       .vertex = compiled(lab, vertex_file, shader::Stage::vertex),
                       .fragment = compiled(lab, fragment_file, shader::Stage::fragment)})) {}

PassResult Pass::run(const PassInputs& inputs, const PassOptions& options) const {
    const Lab& lab = *impl_->lab;
    PassWork first = internal::bound(impl_->interface, inputs, options);
    const auto run = [&](PassWork& work) {
        if (lab.info().type == interpreter_name)
            internal::run_interpreted(impl_->modules, work);
        else
            internal::run_on_device(lab.device(), impl_->modules, work);
    };
    PassWork second = first;
    const bool twice = fill(first, canaries[0]);
    run(first);
    if (twice) {
        (void)fill(second, canaries[1]);
        run(second);
    }
    lab.require_silent_validation();
    return result_of(impl_->interface, first, twice ? second : first);
}

const PassImage& PassResult::image(const std::string& name) const {
    return found_in(images_, name, pass_, "image");
}

const PassResult::Values& PassResult::values_of(const std::string& name, const shader::Type& element) const {
    const Values& found = found_in(values_, name, pass_, "buffer member");
    shader::Type expected = found.type;
    expected.sizes.clear();
    if (!(expected == element))
        throw std::invalid_argument(fmt::format("{}: \"{}\" holds {}, asked for {}", pass_, name,
                                                shader::name_of(expected), shader::name_of(element)));
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

Image mirrored(const Image& image, Mirror mirror) {
    Image result = image;
    if (mirror == Mirror::transpose) result.size = {image.size.y, image.size.x};
    const std::size_t pixel = scalars_of(image.element).size();
    for (int y = 0; y < result.size.y; ++y) {
        for (int x = 0; x < result.size.x; ++x) {
            const glm::ivec2 from = mirror == Mirror::x   ? glm::ivec2(image.size.x - 1 - x, y)
                                    : mirror == Mirror::y ? glm::ivec2(x, image.size.y - 1 - y)
                                                          : glm::ivec2(y, x);
            const auto at = [pixel](glm::ivec2 p, int width) {
                return static_cast<std::ptrdiff_t>(
                    (static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(p.x)) *
                    pixel);
            };
            std::copy_n(image.words.begin() + at(from, image.size.x), pixel,
                        result.words.begin() + at({x, y}, result.size.x));
        }
    }
    return result;
}

namespace {

const Image& image_in(const PassInputs& inputs, const std::string& name) {
    const auto found = inputs.find(name);
    if (found == inputs.end() || !found->second.image())
        throw std::invalid_argument(fmt::format("\"{}\" is not among the inputs as an image", name));
    return *found->second.image();
}

PassInputs with(PassInputs inputs, const std::string& name, const Image& image) {
    inputs.insert_or_assign(name, PassValue(image));
    return inputs;
}

ImageComparison named(ImageComparison comparison, const std::string& property) {
    if (!comparison.story.empty()) comparison.story = property + ": " + comparison.story;
    return comparison;
}

}  // namespace

ImageComparison Pass::idempotent(const PassInputs& inputs, const std::string& source,
                                 const std::string& result, const ImageBudget& budget,
                                 const PassOptions& options) const {
    const PassImage once = run(inputs, options).image(result);
    Image again = once;
    again.sampling = image_in(inputs, source).sampling;
    const PassResult twice = run(with(inputs, source, again), options);
    return named(twice.image(result).compare(static_cast<const Image&>(once), budget), "not idempotent");
}

ImageComparison Pass::symmetric(Mirror mirror, const PassInputs& inputs, const std::string& source,
                                const std::string& result, const ImageBudget& budget,
                                PassOptions options) const {
    const Image expected = mirrored(run(inputs, options).image(result), mirror);
    if (mirror == Mirror::transpose) options.size = {options.size.y, options.size.x};
    const PassInputs moved = with(inputs, source, mirrored(image_in(inputs, source), mirror));
    return named(run(moved, options).image(result).compare(expected, budget), "not symmetric");
}

ImageComparison Pass::keeps_energy(const PassInputs& inputs, const std::string& source,
                                   const std::string& result, double relative,
                                   const PassOptions& options) const {
    const PassResult done = run(inputs, options);
    const PassImage& after = done.image(result);
    const Image& before = image_in(inputs, source);
    ImageComparison comparison{.pixels = after.unwritten.size(), .story = done.unwritten()};
    if (!(before.element == after.element) || after.element.scalar != shader::Scalar::float_)
        throw std::invalid_argument(fmt::format("{}: energy of {} and {}, expected the same floats",
                                                after.name, shader::name_of(before.element),
                                                shader::name_of(after.element)));
    const std::size_t components = scalars_of(after.element).size();
    for (std::size_t c = 0; c < components; ++c) {
        std::array<double, 2> sums{};
        double magnitude = 0.0;
        for (std::size_t i = c; i < before.words.size(); i += components) {
            sums[0] += std::bit_cast<float>(before.words[i]);
            magnitude += std::abs(std::bit_cast<float>(before.words[i]));
        }
        for (std::size_t i = c; i < after.words.size(); i += components)
            sums[1] += std::bit_cast<float>(after.words[i]);
        if (std::abs(sums[1] - sums[0]) <= relative * magnitude) continue;
        comparison.story += fmt::format(
            "{}: energy is not kept: component {} of \"{}\" sums to {}, after the pass "
            "to {}, expected within {:g} of it\n",
            after.name, c, source, sums[0], sums[1], relative);
    }
    return comparison;
}

}  // namespace gloam::check
