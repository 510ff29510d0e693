// SPDX-License-Identifier: MIT
#include "subject/own_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>
#include <string_view>

#include "interpreter/machine.hpp"
#include "module/module.hpp"
#include "module/reflection.hpp"
#include "subject/internal/refused.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

constexpr double usual_low = 1e-6;
constexpr double usual_high = 1e6;
constexpr long usual_integer = 1000;
constexpr long usual_index = 7;  // most integer parameters are indices, counts or modes
constexpr long largest_unsigned = 1L << 31;

// Of a float type, those of its numbers.
Range usual_range(Scalar scalar) {
    const numeric::FloatFormat& format = format_of(scalar);
    return {std::max(usual_low, format.smallest_normal()), std::min(usual_high, format.largest())};
}

// Values of any type in a range.
Values values_in(Scalar scalar, const Range& range) {
    if (shader::is_float(scalar)) return uniform(range.low, range.high, scalar);
    return integers(static_cast<long>(range.low), static_cast<long>(range.high));
}

Values scalar_values(Scalar scalar, const std::optional<Range>& range) {
    if (range && scalar != Scalar::bool_) return values_in(scalar, *range);
    const Range usual = usual_range(scalar);
    switch (scalar) {
        case Scalar::float_:
        case Scalar::float16_:
            // Most parameters of shader functions are shares, colours or coordinates.
            return either(uniform(0, 1, scalar),
                          signed_log_uniform(usual.low, usual.high, scalar).and_special(scalar));
        case Scalar::int_:
            return either(integers(0, usual_index),
                          either(log_integers(usual_integer), integers(-usual_integer, usual_integer)));
        case Scalar::bool_:
            return booleans();
        default:
            return either(integers(0, usual_index), log_integers(largest_unsigned));
    }
}

Values values_of(const shader::Type& type, const std::optional<Range>& range) {
    std::vector<Values> scalars;
    for (const Scalar scalar : scalars_of(type)) scalars.push_back(scalar_values(scalar, range));
    return scalars.size() == 1 ? scalars.front() : vector(scalars);
}

// "float[5000] has more than 4096 scalars", "sampler2DMS is not judged: ..."; empty if a kernel can pass it.
std::string obstacle(const shader::Type& type) {
    if (type.scalar == Scalar::oversized)
        return fmt::format("{} has more than {} scalars", type.name, shader::most_scalars);
    if (type.scalar == Scalar::unsupported)
        return fmt::format("{} is not judged: gloam judges {}", shader::name_of(type),
                           internal::judged_samplers);
    for (const shader::Member& member : type.members)
        if (const std::string inside = obstacle(member.type); !inside.empty())
            return fmt::format("in {}, {}", shader::name_of(type), inside);
    return {};
}

// Why no kernel can call a function; empty if one can.
std::string why_not(const shader::Function& function, const shader::Excerpt& excerpt,
                    const backend::Team& team) {
    for (const char* ours : {"gloam_kernel_", "GloamGenerated"})
        if (excerpt.text.find(ours) != std::string::npos)
            return fmt::format("it uses a name with {}, as only the generated kernel may", ours);
    if (!function.other_number.empty()) return shader::spirv::not_judged(function.other_number);
    std::size_t scalars = shader::scalar_count(function.result);
    for (const shader::Parameter& p : function.parameters) {
        if (const std::string what = obstacle(p.type); !what.empty() && p.global)
            return fmt::format("values of \"{}\" cannot be drawn: {}", p.name, what);
        else if (!what.empty())
            return fmt::format("values of the parameter type {} cannot be drawn: {}", shader::name_of(p.type),
                               what);
        scalars += shader::scalar_count(p.type);
        if (!p.image.empty() && team.kind != backend::Team::Kind::alone)
            return fmt::format("the image \"{}\" is shared by the invocations that run it together", p.name);
        if (!p.global || !p.image.empty()) continue;
        const shader::Access access = excerpt.globals.at(p.name);
        const bool reads = access == shader::Access::reads || access == shader::Access::uniform;
        if (p.direction != shader::Direction::in && reads)
            return fmt::format("it assigns to \"{}\", which a shader can only read", p.name);
        if (access == shader::Access::buffer && excerpt.needs == shader::Needs::group)
            return fmt::format("the buffer \"{}\", which it may write, is shared by its group", p.name);
    }
    if (const std::string what = obstacle(function.result); !what.empty())
        return fmt::format("a result of type {} cannot be read: {}", shader::name_of(function.result), what);
    constexpr std::uint32_t most = interpreter::Machine<float>::most_invocations;
    if (team.count() > most)
        return fmt::format("its work group has {} invocations, expected at most {}", team.count(), most);
    if (scalars * team.count() > shader::most_scalars)
        return fmt::format("its parameters and its result have more than {} scalars", shader::most_scalars);
    if (Signature{.result = function.result, .parameters = function.parameters}.output_words() == 0)
        return "it has no result and no out parameter, and it writes no buffer or stage output";
    return {};
}

std::string without_blanks(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    return text;
}

bool is_named(const std::string& definition, const std::string& name) {
    const std::string plain = without_blanks(name);
    const std::string whole = without_blanks(definition);
    return whole == plain || whole.starts_with(plain + "(");
}

// "f(vec2, float)"
std::string definition_of(const shader::Function& function) {
    std::string types;
    for (const shader::Parameter& p : function.parameters)
        if (!p.global) types += (types.empty() ? "" : ", ") + shader::name_of(p.type);
    return fmt::format("{}({})", function.name, types);
}

// Sorts the functions of one file.
class Sorting {
  public:
    Sorting(const OwnFile& file, const std::vector<std::string>& names) : file_(file), names_(names) {}

    void add(const shader::Excerpt& excerpt, const std::vector<shader::Function>& compiled,
             const backend::Team& team) {
        std::vector<std::pair<shader::Function, std::string>> own;  // and its comment
        std::size_t k = 0;
        for (const shader::Function& function : compiled) {
            if (function.name != excerpt.function || !function.defined) continue;
            const bool known = k < excerpt.definitions.size();  // not made by a macro
            if (!known || !excerpt.definitions[k].empty())
                own.emplace_back(with_globals(function, excerpt), known ? excerpt.comments[k] : "");
            ++k;
        }
        const auto unserved = std::ranges::find_if(compiled, [](const shader::Function& function) {
            return !function.defined && !image_prototype(function);
        });
        for (const auto& [function, comment] : own) {
            const std::string definition = definition_of(function);
            if (!wants(definition)) continue;
            const shader::Function called = together(function, team);
            std::string why = why_not(function, excerpt, team);
            if (why.empty() && unserved != compiled.end())
                why = fmt::format("it calls {}, which has no body; expected T name(ivec2)",
                                  definition_of(*unserved));
            if (why.empty()) {
                all_.found.push_back(
                    {{file_.name, called, images_of(excerpt, function), false, excerpt.text, team},
                     own.size() > 1 ? definition : function.name,
                     comment});
            } else {
                all_.left_out.push_back({definition, why});
            }
        }
    }

    void refuse(const shader::Excerpt& excerpt, const std::string& errors) {
        for (const std::string& definition : excerpt.definitions)
            if (!definition.empty() && wants(definition))
                all_.left_out.push_back(internal::refused(excerpt, definition, errors));
    }

    OwnFunctions take() {
        const auto unmet = std::ranges::find_if(names_, [this](const std::string& name) {
            return std::ranges::none_of(seen_, [&](const auto& one) { return is_named(one, name); });
        });
        if (unmet == names_.end()) return std::move(all_);
        std::string known;
        for (const auto& excerpt : file_.excerpts.functions)
            known += (known.empty() ? "" : ", ") + excerpt.function;
        throw std::invalid_argument(fmt::format("{}: no function {}; it defines: {}", file_.name, *unmet,
                                                known.empty() ? "none" : known));
    }

  private:
    bool wants(const std::string& definition) {
        seen_.push_back(definition);
        return names_.empty() || std::ranges::any_of(names_, [&](const std::string& name) {
                   return is_named(definition, name);
               });
    }

    const OwnFile& file_;
    const std::vector<std::string>& names_;
    std::vector<std::string> seen_;
    OwnFunctions all_;
};

// Pixels of a prototype: positive numbers of usual size. Accesses outside read the border.
Image random_image(const ImagePrototype& prototype, glm::ivec2 size, numeric::Random& random) {
    Image image{.element = prototype.element, .size = size, .border = Border::clamp, .words = {}};
    for (int pixel = 0; pixel < size.x * size.y; ++pixel) {
        for (const Scalar scalar : scalars_of(prototype.element)) {
            const double value = random.uniform(0.1, 10.0);
            image.words.push_back(shader::is_float(scalar) ? float_word(scalar, value)
                                                           : static_cast<Word>(random.below(2)));
        }
    }
    return image;
}

// Texels of a sampler. Floats are multiples of 1/64, which 16 bits represent.
Image random_texels(const ImagePrototype& prototype, glm::ivec2 size, Image::Sampling sampling,
                    numeric::Random& random) {
    constexpr unsigned layers = 3;
    using backend::SampledShape;
    const SampledShape shape = backend::shape_of_sampler(prototype.sampler);
    const bool is_depth = backend::texel_of_sampler(prototype.sampler) == backend::SampledTexel::depth;
    const bool is_cube = backend::is_cube(shape);
    if (shape == SampledShape::three || shape == SampledShape::layers) sampling.depth = layers;
    if (is_cube) sampling.depth = backend::cube_faces * (shape == SampledShape::cube ? 1 : layers);
    if (is_cube) size.y = size.x;
    const backend::SampledHeader header{.width = static_cast<Word>(size.x),
                                        .height = static_cast<Word>(size.y),
                                        .depth = sampling.depth,
                                        .levels = sampling.levels,
                                        .shape = shape};
    const bool floats = prototype.element.scalar == Scalar::float_;
    const std::uint64_t values = is_depth ? 9 : 640;  // depths are eighths, 0 and 1 among them
    const float unit = is_depth ? 8.0F : 64.0F;
    sampling.linear = sampling.linear && floats;
    Image image{.element = prototype.element, .size = size, .words = {}, .sampling = sampling};
    for (std::size_t i = 0; i < backend::texels_before(header, header.levels) * backend::texel_words; ++i) {
        const auto value = static_cast<Word>(random.below(values));
        image.words.push_back(floats ? to_word(static_cast<float>(value) / unit) : value);
    }
    return image;
}

ImageScenario random_scenario(const std::vector<ImagePrototype>& images, const std::string& name,
                              glm::ivec2 size, const Image::Sampling& sampling) {
    const auto make = [images, sampling](glm::ivec2 pixels, numeric::Random& random) {
        ImageSet set;
        for (const ImagePrototype& image : images)
            set.emplace(image.name, image.sampled ? random_texels(image, pixels, sampling, random)
                                                  : random_image(image, pixels, random));
        return set;
    };
    return {.name = name, .size = size, .make = make};
}

}  // namespace

std::vector<ImageScenario> random_scenarios(const std::vector<ImagePrototype>& all) {
    std::vector<ImagePrototype> images;  // that have a content
    std::ranges::copy_if(all, std::back_inserter(images),
                         [](const auto& image) { return image.layered.empty(); });
    using backend::Compare;
    using backend::Wrap;
    if (images.empty()) return {};
    if (std::ranges::none_of(images, &ImagePrototype::sampled))
        return {random_scenario(images, "5 x 4, random", {5, 4}, {})};
    return {random_scenario(images, "5 x 4, random, linear, repeat", {5, 4}, {.linear = true}),
            random_scenario(images, "4 x 4, random, linear, edge, 3 levels", {4, 4},
                            {.linear = true, .wrap = Wrap::edge, .levels = 3, .compare = Compare::greater}),
            random_scenario(images, "5 x 4, random, nearest, mirrored, 2 levels", {5, 4},
                            {.wrap = Wrap::mirrored, .levels = 2, .compare = Compare::less})};
}

namespace {

// The invocations that run a function of the excerpt together.
backend::Team team_for(const shader::Excerpt& excerpt, const std::string& file,
                       const shader::SpirvCache& cache) {
    if (excerpt.needs == shader::Needs::nobody) return {};
    if (excerpt.needs == shader::Needs::quad) return backend::quad_team;
    constexpr std::uint32_t usual = 64;
    if (!excerpt.has_group_size) return {.kind = backend::Team::Kind::group, .size = {usual, 1, 1}};
    shader::Source whole = probe_of(file, excerpt.text);
    whole.text += "\nvoid main() {}\n";
    return {.kind = backend::Team::Kind::group,
            .size = shader::reflect(cache.compile(whole, {.variant = {}})).local_size};
}

}  // namespace

OwnFunctions own_functions(const LabOptions& options, const std::vector<std::string>& names) {
    const std::string& file = options.file->name;
    Sorting sorting(*options.file, names);
    const shader::SpirvCache cache = shader_cache(options);
    for (const shader::Excerpt& excerpt : options.file->excerpts.functions) {
        const bool asked = names.empty() || std::ranges::any_of(names, [&](const std::string& name) {
                               return without_blanks(name.substr(0, name.find('('))) == excerpt.function;
                           });
        if (!asked) continue;
        try {
            const backend::Team team = team_for(excerpt, file, cache);
            const shader::CompileOptions in_stage{.stage = stage_of(team), .variant = {}};
            sorting.add(excerpt, cache.functions(probe_of(file, excerpt.text), in_stage), team);
        } catch (const shader::CompileError& error) {
            sorting.refuse(excerpt, error.what());
        }
    }
    OwnFunctions all = sorting.take();
    std::erase_if(all.found, [&](const OwnFunction& own) {
        const std::string why = why_not_run(own, cache);
        if (!why.empty()) all.left_out.push_back({own.name, "gloam cannot run it: " + why});
        return !why.empty();
    });
    return all;
}

Domain domain_of(const OwnFunction& own, const Ranges& ranges) {
    std::vector<Values> parameters;
    for (const shader::Parameter& parameter : own.function.parameters) {
        if (parameter.direction == shader::Direction::out) continue;
        const auto found = ranges.find(parameter.name);
        const std::optional<Range> range =
            found == ranges.end() ? std::nullopt : std::optional(found->second);
        const bool in_quad = own.team.kind == backend::Team::Kind::quad && is_of_each(parameter);
        parameters.push_back(in_quad ? neighbours(shader::element_of(parameter.type),
                                                  values_of(shader::element_of(parameter.type), range),
                                                  parameter.name == fragment_coordinate)
                                     : values_of(parameter.type, range));
    }
    return Domain(std::move(parameters));
}

bool OwnFunction::is_property() const {
    static const std::regex line(R"((^|\n)[\s/*]*must hold[\s.*/]*(\n|$))", std::regex::icase);
    const std::vector<shader::Scalar> outputs = signature().output_scalars();
    return (function.name.starts_with("test_") || std::regex_search(comment, line)) &&
           std::ranges::count(outputs, shader::Scalar::bool_) == std::ssize(outputs);
}

}  // namespace gloam::check
