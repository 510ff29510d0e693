// SPDX-License-Identifier: MIT
#include "subject/lab.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include "backend/gl/device.hpp"
#include "backend/gl/kernel.hpp"
#include "base/text.hpp"
#include "module/include.hpp"
#include "module/module.hpp"
#include "module/spirv.hpp"
#include "module/steps.hpp"
#include "subject/internal/kernel_text.hpp"

namespace gloam::subject {
namespace {

void require_opengl_options(const LabOptions& options, source::Language language) {
    if (!options.variant.runs_on_opengl(source::usual_stage(language) == source::Stage::compute))
        throw std::invalid_argument(
            fmt::format("{}: OpenGL devices have the variant shipped only, and those with compute shaders "
                        "its steps, not {}",
                        options.device, options.variant.name));
    if (options.validation)
        throw std::invalid_argument(options.device + ": the validation layers are of Vulkan");
}

// A whole shader, with a #version line, cannot be included: its functions are excerpts of it. Others are
// included as they are.
std::shared_ptr<const OwnFile> whole_shader(const LabOptions& options, const std::string& file) {
    if (options.file) return options.file;
    const std::filesystem::path path = module::resolve_include(file, {}, options.include_roots);
    std::string text = module::read_text(path);
    if (text.find("#version") == std::string::npos) return nullptr;
    auto own = std::make_shared<const OwnFile>(path, std::move(text), options.include_roots);
    return own->excerpts.version.empty() ? nullptr : own;
}

// The functions that a text defines and declares, as a kernel of the signature has them.
std::vector<module::Function> functions_for(const Signature& signature, std::vector<module::Function> all,
                                            const source::Excerpt* excerpt) {
    for (module::Function& one : all) {
        if (excerpt != nullptr) one = with_globals(std::move(one), *excerpt);
        if (!one.defined) continue;
        for (std::size_t i = 0; i < std::min(one.parameters.size(), signature.parameters.size()); ++i)
            one.parameters[i].uniform = signature.parameters[i].uniform;
        one = together(std::move(one), signature.team);
    }
    return all;
}

// Whether a compiled function has this signature: the same types (structures by layout) and directions.
bool matches(const Signature& signature, const module::Function& function) {
    return signature.result == function.result &&
           std::ranges::equal(signature.parameters, function.parameters, [](const auto& a, const auto& b) {
               return a.type == b.type && a.direction == b.direction && a.global == b.global;
           });
}

// The vertex shader before the kernel of a quad.
constexpr const char* quad_vertices =
    "#version 450\nvoid main() {\n    vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);\n"
    "    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);\n}\n";

std::shared_ptr<backend::Backend> opened(const LabOptions& options) {
    // A browser's SwiftShader is no driver that the loader finds by itself. The environment's choice stays.
    if (base::lower(options.device).starts_with("swiftshader")) backend::vulkan::add_swiftshader();
    if (options.device == interpreter_name) return interpreter_backend();
    if (backend::gl::is_device_name(options.device))
        return std::make_shared<backend::gl::Device>(options.device);
    return std::make_shared<backend::vulkan::Device>(backend::vulkan::DeviceOptions{
        .device = options.device,
        .validation = options.validation ? backend::vulkan::Validation::on : backend::vulkan::Validation::off,
        .cache_directory = options.cache_directory,
        .timeout = options.timeout});
}

}  // namespace

std::optional<ImagePrototype> image_prototype(const module::Function& function) {
    const auto& p = function.parameters;
    const bool by_pixel =
        p.size() == 1 && p[0].type == type_of<glm::ivec2>() && p[0].direction == source::Direction::in;
    if (!by_pixel || function.result.scalar == module::Scalar::void_) return std::nullopt;
    return ImagePrototype{{}, function.name, function.result};
}

namespace {

module::Type texel_type(const std::string& sampler) {
    if (sampler.starts_with('i')) return type_of<glm::ivec4>();
    return sampler.starts_with('u') ? type_of<glm::uvec4>() : type_of<glm::vec4>();
}

// A translator gives separate samplers other names: "_image_sampler".
bool is_of(const std::string& resource, const ImagePrototype& image) {
    if (!image.layered.empty()) return resource == image.name;
    if (!image.sampled) return false;
    const std::string& name = image.variable.empty() ? image.name : image.variable;
    return resource == name || resource == "_" + name + "_sampler";
}

}  // namespace

std::vector<ImagePrototype> image_prototypes(const std::vector<module::Function>& functions,
                                             const std::string& file) {
    std::vector<ImagePrototype> images;
    for (const module::Function& function : functions) {
        if (function.defined) continue;
        const auto image = image_prototype(function);
        if (!image)
            throw std::invalid_argument(
                fmt::format("{}: cannot serve the prototype \"{}\": expected T name(ivec2)", file,
                            module::to_glsl(function)));
        images.push_back(*image);
    }
    return images;
}

std::vector<ImagePrototype> images_of(const source::Excerpt& excerpt, const module::Function& function) {
    std::vector<ImagePrototype> images;
    for (std::size_t i = 0; i < excerpt.bound.size(); ++i) {
        const auto& [name, type, format, written] = excerpt.bound[i];
        const std::string macro = source::binding_macro(i);
        if (format.empty())
            images.push_back({{.sampled = true}, name, texel_type(type), type, {}, macro});
        else
            images.push_back({{.layered = format}, name, pixels_of(format), {}, {}, macro});
    }
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const auto& [type, name] = std::tie(function.parameters[i].type, function.parameters[i].name);
        if (type.scalar == module::Scalar::sampler)
            images.push_back(
                {{.sampled = true}, name, texel_type(type.name), type.name, internal::argument_name(i)});
    }
    return images;
}

source::Source probe_of(const std::string& file, const std::string& excerpt) {
    std::string text = "#version 450\n";
    for (std::size_t i = 0; excerpt.find(source::binding_macro(i)) != std::string::npos; ++i)
        text += fmt::format("#define {} {}\n", source::binding_macro(i), i);
    return {.name = "signature of " + file,
            .text = text + (excerpt.empty() ? fmt::format("#include \"{}\"\n", file) : excerpt)};
}

module::SpirvCache shader_cache(const LabOptions& options) {
    return module::SpirvCache(options.cache_directory.empty() ? std::filesystem::path{}
                                                              : options.cache_directory / "spirv");
}

Lab::Lab(LabOptions options) : Lab(options, opened(options)) {}

Lab::Lab(LabOptions options, std::shared_ptr<backend::Backend> device)
    : options_(std::move(options)), device_(std::move(device)), cache_(shader_cache(options_)) {
    if (options_.file) options_.include_roots = options_.file->include_roots;
    if (const auto text_language = language()) require_opengl_options(options_, *text_language);
}

const backend::vulkan::Device& Lab::device() const {
    if (const auto* vulkan = dynamic_cast<const backend::vulkan::Device*>(device_.get())) return *vulkan;
    throw std::runtime_error(info().name + " runs functions, not passes: expected a Vulkan device");
}

std::optional<source::Language> Lab::language() const {
    return source::language_from(info().glsl);
}

KernelCore Lab::core(KernelModule module) const {
    module.samplers = info().samplers;
    module.subgroup_size = std::max(info().subgroup_size, 1U);
    // Of a compiler that is judged, both modules run on the interpreter. A variant's optimizer may fold what
    // it knows with any rounding.
    module.rounds_to_even = !options_.variant.steps.empty() && info().name == interpreter_name;
    return {*device_, std::move(module)};
}

module::CompileOptions Lab::compile_options(source::Stage stage) const {
    return {.stage = stage,
            .include_roots = options_.include_roots,
            .variant = options_.variant,
            .lines = options_.file != nullptr};
}

module::CompileOptions Lab::judged_options(source::Stage stage) const {
    module::CompileOptions options = compile_options(stage);
    options.variant.optimization = module::Optimization::none;
    return options;
}

KernelSource Lab::source(const std::string& file, const std::string& function,
                         const Signature& signature) const {
    const std::shared_ptr<const OwnFile> whole = whole_shader(options_, file);
    const source::Excerpt* excerpt = whole ? whole->find(function) : nullptr;
    const std::string text = excerpt == nullptr ? "" : excerpt->text;
    const std::vector<module::Function> all = functions_for(
        signature, cache_.functions(probe_of(file, text), compile_options(stage_of(signature.team))),
        excerpt);
    std::vector<std::string> named;
    for (const module::Function& candidate : all) {
        if (candidate.name != function || !candidate.defined) continue;
        if (matches(signature, candidate)) {
            std::vector<ImagePrototype> images;
            if (excerpt != nullptr) images = images_of(*excerpt, candidate);
            std::ranges::copy(image_prototypes(all, file), std::back_inserter(images));
            return {.file = file,
                    .function = candidate,
                    .images = std::move(images),
                    .preserve_nan = keeps_nan(),
                    .text = text,
                    .team = signature.team};
        }
        named.push_back(to_glsl({candidate.result, candidate.parameters}, candidate.name));
    }
    if (!named.empty())
        throw std::invalid_argument(
            fmt::format("{}: the signature of {} differs: C++ has \"{}\", GLSL has \"{}\"", file, function,
                        to_glsl(signature, function), fmt::join(named, "\", \"")));
    for (const module::Function& candidate : all)
        if (candidate.defined) named.push_back(candidate.name);
    throw std::invalid_argument(
        fmt::format("{}: no function {}; it defines: {}", file, function,
                    named.empty() ? "none" : fmt::format("{}", fmt::join(named, ", "))));
}

KernelCore Lab::kernel(const std::string& file, const std::string& function,
                       const Signature& signature) const {
    const KernelSource made_of = source(file, function, signature);
    const source::Source text{.name = "kernel of " + function, .text = kernel_code(made_of)};
    KernelModule module =
        kernel_module(made_of, compile_kernel(text, made_of.images, stage_of(made_of.team)));
    if (made_of.team.kind == backend::Team::Kind::quad)
        module.vertex_spirv = cache_.compile({.name = "vertices of a quad", .text = quad_vertices},
                                             {.stage = source::Stage::vertex});
    if (const auto text_language = language()) {
        if (module::has_float16(module.spirv))
            throw backend::Unsupported(function + ": needs float16_t, which OpenGL has no standard type for");
        module.text = gl_kernel_code(*text_language, made_of, options_.include_roots);
        module.judged_by_rules = internal::has_precision_rules(*text_language, module.spirv);
    }
    take_steps(module, text);
    if (const auto text_language = language(); text_language && !options_.variant.steps.empty())
        module.text = module::opengl_text(module.spirv, *text_language, backend::gl::kernel_run_binding);
    return core(std::move(module));
}

KernelCore Lab::constant_kernel(const KernelSource& source, std::span<const Word> inputs,
                                std::size_t count) const {
    const module::Variant::Constants constants = options_.variant.constants;
    const bool literals = constants == module::Variant::Constants::literals;
    const source::Source text{.name = fmt::format("kernel of {} with {}", source.function.name,
                                                  literals ? "literals" : "specialization constants"),
                              .text = constant_kernel_code(source, constants, inputs, count)};
    KernelModule module = kernel_module(source, compile_kernel(text, source.images));
    module.input_words = 0;
    module.fixed_inputs = count;
    for (std::size_t word = 0; !literals && word < inputs.size(); ++word)
        module.constants.push_back({.id = static_cast<std::uint32_t>(word), .bits = inputs[word]});
    take_steps(module, text);
    return core(std::move(module));
}

void Lab::take_steps(KernelModule& module, const source::Source& text) const {
    const auto stage = stage_of(module.team);
    if (options_.variant.optimization != module::Optimization::none)
        module.before = cache_.compile(text, judged_options(stage));
    if (options_.variant.steps.empty()) return;
    const auto glsl = [&] { return module::pack({text}, {.stage = stage}, options_.include_roots); };
    module::Spirv after = module::all_taken(options_.variant.steps, {.module = module.spirv, .glsl = glsl});
    module::Spirv given = std::exchange(module.spirv, std::move(after));
    if (module.before.empty()) module.before = std::move(given);
}

module::Spirv Lab::compile_kernel(const source::Source& text, const std::vector<ImagePrototype>& images,
                                  source::Stage stage) const {
    module::Spirv module = cache_.compile(text, compile_options(stage));
    if (const std::string other = module::spirv::other_number(module); !other.empty())
        throw backend::Unsupported(text.name + ": " + module::spirv::not_judged(other));
    for (const module::Resource& resource : module::used_resources(module)) {
        constexpr std::string_view ours = "GloamGenerated";  // a step may keep one of the two names
        if (resource.block.starts_with(ours) || resource.name.starts_with(ours)) continue;
        const auto bound = [&](const ImagePrototype& image) { return is_of(resource.name, image); };
        if (std::ranges::any_of(images, bound)) continue;
        throw std::invalid_argument(fmt::format(
            "{}: uses the {} \"{}\", expected no bindings of its own: a function is given what it "
            "reads by parameters and by prototypes T name(ivec2)",
            text.name, resource.kind, resource.name.empty() ? resource.block : resource.name));
    }
    return module;
}

void Lab::require_silent_validation() const {
    const std::vector<std::string> messages = device_->take_validation_messages();
    if (!messages.empty())
        throw std::runtime_error(fmt::format("Vulkan validation: {}", fmt::join(messages, " | ")));
}

}  // namespace gloam::subject
