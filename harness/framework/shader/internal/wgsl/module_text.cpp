// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/module_text.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <sstream>

#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

std::set<std::string> words_of(const char* text) {
    std::istringstream stream(text);
    std::set<std::string> words;
    for (std::string word; stream >> word;) words.insert(word);
    return words;
}

// Sections "Keywords" and "Reserved Words" of the specification of WGSL, and its predeclared types.
constexpr const char* reserved_words =
    "alias break case const const_assert continue continuing default diagnostic discard else enable false fn "
    "for if let loop override requires return struct switch true var while "
    "NULL Self abstract active alignas alignof as asm asm_fragment async attribute auto await become "
    "cast catch class co_await co_return co_yield coherent column_major common compile compile_fragment "
    "concept const_cast consteval constexpr constinit crate debugger decltype delete demote "
    "demote_to_helper do dynamic_cast enum explicit export extends extern external fallthrough filter "
    "final finally friend from fxgroup get goto groupshared highp impl implements import inline instanceof "
    "interface layout lowp macro macro_rules match mediump meta mod module move mut mutable namespace new "
    "nil noexcept noinline nointerpolation non_coherent noncoherent noperspective null nullptr of operator "
    "package packoffset partial pass patch pixelfragment precise precision premerge priv protected pub "
    "public readonly ref regardless register reinterpret_cast require resource restrict self set shared "
    "sizeof smooth snorm static static_assert static_cast std subroutine super target template this "
    "thread_local throw trait try type typedef typeid typename typeof union unless unorm unsafe unsized "
    "use using varying virtual volatile wgsl where with writeonly yield "
    "array atomic bool f16 f32 i32 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 ptr "
    "sampler sampler_comparison texture_1d texture_2d texture_3d texture_cube texture_storage_2d u32 vec2 "
    "vec3 vec4 vec2f vec3f vec4f vec2i vec3i vec4i vec2u vec3u vec4u mat2x2f mat2x3f mat2x4f mat3x2f "
    "mat3x3f mat3x4f mat4x2f mat4x3f mat4x4f function private workgroup uniform storage read write "
    "read_write";

constexpr const char* builtin_functions =
    "bitcast all any select arrayLength abs acos acosh asin asinh atan atanh atan2 ceil clamp cos cosh "
    "countLeadingZeros countOneBits countTrailingZeros cross degrees determinant distance dot exp exp2 "
    "extractBits faceForward firstLeadingBit firstTrailingBit floor fma fract frexp insertBits inverseSqrt "
    "ldexp length log log2 max min mix modf normalize pow quantizeToF16 radians reflect refract reverseBits "
    "round saturate sign sin sinh smoothstep sqrt step tan tanh transpose trunc dpdx dpdy fwidth "
    "textureDimensions textureLoad textureStore textureSampleLevel textureNumLevels atomicLoad atomicStore "
    "atomicAdd atomicMax atomicMin atomicAnd atomicOr atomicXor atomicExchange pack4x8snorm pack4x8unorm "
    "pack2x16snorm pack2x16unorm pack2x16float unpack4x8snorm unpack4x8unorm unpack2x16snorm "
    "unpack2x16unorm unpack2x16float storageBarrier textureBarrier workgroupBarrier";

}  // namespace

bool is_reserved(const std::string& word) {
    static const std::set<std::string> words = words_of(reserved_words);
    return words.contains(word);
}

bool is_builtin(const std::string& word) {
    static const std::set<std::string> words = words_of(builtin_functions);
    return words.contains(word);
}

std::string identifier(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const bool usable = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
        if (usable) result += c;
    }
    while (!result.empty() &&
           (result.front() == '_' || std::isdigit(static_cast<unsigned char>(result.front()))))
        result.erase(result.begin());
    if (result.empty()) return "unnamed";
    if (is_reserved(result)) result += '_';
    return result;
}

std::string Names::take(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !taken_.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
    return name;
}

ModuleText::ModuleText(const Module& module, const Facts& facts, const CommentOf& comment_of)
    : module_(module), facts_(facts), comment_of_(comment_of) {
    name_all();
}

std::string ModuleText::comment(const std::string& block, const std::string& name,
                                const std::string& indent) const {
    if (!comment_of_) return "";
    const std::string text = comment_of_(block, name);
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        result += indent + text.substr(at, end - at) + "\n";
        at = end + 1;
    }
    return result;
}

void ModuleText::name_all() {
    const auto free = [this](const std::string& wanted) {
        const std::string name = identifier(wanted);
        return names.take(is_builtin(name) ? name + "_" : name);
    };
    // Functions first: their names are what users call.
    for (const Function& function : module_.functions)
        names_[function.id] = free(module_.name_of(function.id));
    for (const Id id : module_.type_order)
        if (module_.type(id).kind == TypeKind::structure) names.reserve(identifier(module_.name_of(id)));
    for (const Variable& variable : module_.variables) {
        std::string name = module_.name_of(variable.id);
        if (name.empty()) {  // a block without a name: its own in small letters
            name = module_.name_of(variable.type);
            if (!name.empty()) name.front() = static_cast<char>(std::tolower(name.front()));
        }
        names_[variable.id] = free(name);
        if (module_.type(variable.type).kind == TypeKind::sampled_image && facts_.is_sampled(variable.id))
            sampler_names_[variable.id] = free(names_[variable.id] + "_sampler");
    }
    for (const Id id : module_.constant_order)
        if (module_.decorations_of(id).spec_id) names_[id] = free(module_.name_of(id));
}

std::string ModuleText::type(Id id) {
    const Type& t = module_.type(id);
    switch (t.kind) {
        case TypeKind::boolean:
            return "bool";
        case TypeKind::integer:
            return t.is_signed ? "i32" : "u32";
        case TypeKind::real:
            if (t.width == 16) need_extension("f16");
            return t.width == 16 ? "f16" : "f32";
        case TypeKind::vector:
            if (module_.is_bool(id)) return fmt::format("vec{}<bool>", t.count);
            return fmt::format("vec{}{}", t.count, type(t.element) == "f16" ? 'h' : type(t.element).front());
        case TypeKind::matrix:
            return fmt::format("mat{}x{}{}", t.count, module_.type(t.element).count, type(t.element).back());
        case TypeKind::array:
        case TypeKind::runtime_array:
            return array(t);
        case TypeKind::structure:
            return structure(id);
        case TypeKind::pointer:
            return fmt::format("ptr<function, {}>", type(t.element));
        default:
            throw NotTranslated("an image or a sampler in an array");
    }
}

std::string ModuleText::array(const Type& t) {
    const Layout element = layout_of(module_, t.element);
    const std::uint32_t stride =
        (element.size + element.alignment - 1) / element.alignment * element.alignment;
    if (t.array_stride != 0 && t.array_stride != stride)
        throw WgslError(fmt::format("an array of {} with a stride of {} bytes: WGSL has {}", type(t.element),
                                    t.array_stride, stride));
    if (t.kind == TypeKind::runtime_array) return fmt::format("array<{}>", type(t.element));
    return fmt::format("array<{}, {}>", type(t.element), fixed_length(t));
}

std::string ModuleText::fixed_length(const Type& array) {
    if (!module_.integer(array.length))
        throw WgslError(
            "an array whose length is a specialization constant, in a variable that is not shared");
    return array_length(array);
}

std::string ModuleText::array_length(const Type& array) {
    if (const auto length = module_.integer(array.length)) return std::to_string(*length);
    return constant(array.length).text;
}

// The type with atomic scalars.
std::string ModuleText::atomic_type(Id id) {
    const Type& t = module_.type(id);
    if (t.kind == TypeKind::array)
        return fmt::format("array<{}, {}>", atomic_type(t.element), fixed_length(t));
    if (t.kind == TypeKind::runtime_array) return fmt::format("array<{}>", atomic_type(t.element));
    return fmt::format("atomic<{}>", type(id));
}

std::string ModuleText::member_name(Id id, std::uint32_t member) {
    auto& names = member_names_[id];
    if (names.empty()) {
        Names taken;
        for (const Member& m : module_.type(id).members)
            names.push_back(taken.take(identifier(m.name.empty() ? "member" : m.name)));
    }
    return names.at(member);
}

// A structure is written where it is used first, those inside it before. Two structures of one name and equal
// text are one in WGSL: GLSL makes one for each layout.
std::string ModuleText::structure(Id id) {
    const auto known = structure_names_.find(id);
    if (known != structure_names_.end()) return known->second;
    const Type& t = module_.type(id);
    std::string body;
    std::uint32_t at = 0;
    for (std::uint32_t m = 0; m < t.members.size(); ++m) {
        const std::string said = comment(module_.name_of(id), t.members[m].name, "    ");
        const bool behind = std::ranges::count(said, '\n') == 1;
        body += (behind ? "" : said) + "    " + member_text(id, m, at) + "," +
                (behind ? "  " + comment(module_.name_of(id), t.members[m].name, "") : "\n");
        const Layout layout = layout_of(module_, t.members[m].type);
        at = std::max(at, t.members[m].offset) + layout.size;
    }
    const std::string wanted = identifier(module_.name_of(id));
    const auto same = structure_by_body_.find(wanted + "{" + body);
    if (same != structure_by_body_.end()) return structure_names_[id] = same->second;
    const bool first =
        std::ranges::none_of(structure_names_, [&](const auto& other) { return other.second == wanted; });
    const std::string name = first ? wanted : names.take(wanted);
    structure_by_body_[wanted + "{" + body] = name;
    structures_ += comment("", module_.name_of(id), "") + fmt::format("struct {} {{\n{}}}\n\n", name, body);
    return structure_names_[id] = name;
}

std::string ModuleText::member_text(Id id, std::uint32_t index, std::uint32_t at) {
    const Member& member = module_.type(id).members[index];
    const Layout layout = layout_of(module_, member.type);
    const std::uint32_t usual = (at + layout.alignment - 1) / layout.alignment * layout.alignment;
    std::string attributes;
    if (member.offset != 0 && member.offset < usual)
        throw WgslError(fmt::format("the member {} is at an offset that WGSL cannot have", member.name));
    if (member.offset > usual) {
        std::uint32_t alignment = layout.alignment;
        while ((at + alignment - 1) / alignment * alignment < member.offset) alignment *= 2;
        if ((at + alignment - 1) / alignment * alignment != member.offset)
            throw WgslError(fmt::format("the member {} is at an offset that WGSL cannot have", member.name));
        attributes = fmt::format("@align({}) ", alignment);
    }
    if (member.matrix.row_major)
        throw WgslError(fmt::format("the member {} is a matrix of rows", member.name));
    const std::string text = facts_.is_atomic(id, index) ? atomic_type(member.type) : type(member.type);
    return fmt::format("{}{}: {}", attributes, member_name(id, index), text);
}

ImageUse ModuleText::image_use(Id variable) const {
    if (!facts_.is_written(variable)) return ImageUse::texture;
    return facts_.is_read(variable) ? ImageUse::reads_and_writes : ImageUse::writes;
}

std::string ModuleText::variable_type(const Variable& variable) {
    if (module_.is_opaque(variable.type)) return opaque_type(variable.id, variable.type);
    const auto text = [&](Id id) { return facts_.is_atomic(variable.id) ? atomic_type(id) : type(id); };
    const Type& t = module_.type(variable.type);
    if (t.kind == TypeKind::array && variable.storage == SpvStorageClassWorkgroup)
        return fmt::format("array<{}, {}>", text(t.element), array_length(t));
    return text(variable.type);
}

namespace {

const char* format_name(std::uint32_t format) {
    switch (format) {
        case SpvImageFormatRgba32f:
            return "rgba32float";
        case SpvImageFormatRgba16f:
            return "rgba16float";
        case SpvImageFormatR32f:
            return "r32float";
        case SpvImageFormatRg32f:
            return "rg32float";
        case SpvImageFormatRgba8:
            return "rgba8unorm";
        case SpvImageFormatRgba8Snorm:
            return "rgba8snorm";
        case SpvImageFormatRgba32ui:
            return "rgba32uint";
        case SpvImageFormatRgba16ui:
            return "rgba16uint";
        case SpvImageFormatRgba8ui:
            return "rgba8uint";
        case SpvImageFormatRg32ui:
            return "rg32uint";
        case SpvImageFormatR32ui:
            return "r32uint";
        case SpvImageFormatRgba32i:
            return "rgba32sint";
        case SpvImageFormatRgba16i:
            return "rgba16sint";
        case SpvImageFormatRg32i:
            return "rg32sint";
        case SpvImageFormatR32i:
            return "r32sint";
        default:
            return nullptr;
    }
}

// What names of texture types say of the dimensions; empty where there is no such type.
std::string shape_of(const Type& image) {
    const std::string layers = image.arrayed ? "_array" : "";
    switch (image.dimension) {
        case SpvDim1D:
            return image.arrayed ? "" : "1d";
        case SpvDim2D:
            return "2d" + layers;
        case SpvDim3D:
            return "3d";
        case SpvDimCube:
            return "cube" + layers;
        default:
            return "";
    }
}

}  // namespace

std::string ModuleText::enabled() const {
    std::string text;
    for (const std::string& extension : extensions_) text += "enable " + extension + ";\n";
    // GLSL allows them where only some invocations of a subgroup run.
    if (extensions_.contains("subgroups")) text += "diagnostic(off, subgroup_uniformity);\n";
    if (derivatives_) text += "diagnostic(off, derivative_uniformity);\n";
    return text.empty() ? text : text + "\n";
}

std::string ModuleText::opaque_type(Id variable, Id declared) {
    if (module_.type(declared).kind == TypeKind::sampler) return "sampler";
    const std::string name = module_.name_of(variable);
    const Type& t = module_.image_type(declared);
    const std::string shape = shape_of(t);
    const ImageUse use = image_use(variable);
    const bool cube = t.dimension == SpvDimCube;
    if (shape.empty() || t.depth || (t.multisampled && t.arrayed) || (use != ImageUse::texture && cube))
        throw NotTranslated(fmt::format("the kind of image of {}", name));
    if (use == ImageUse::texture)
        return fmt::format("texture_{}{}<{}>", t.multisampled ? "multisampled_" : "", shape, type(t.element));
    const char* format = format_name(t.format);
    if (format == nullptr)
        throw WgslError(fmt::format("the image {} has a format that storage textures of WGSL lack", name));
    const std::string_view view = format;
    const bool both = use == ImageUse::reads_and_writes;
    if (both && view != "r32float" && view != "r32uint" && view != "r32sint")
        throw WgslError(
            fmt::format("the image {} is read and written in the format {}: WGSL allows that for "
                        "formats of one channel of 32 bits",
                        name, view));
    return fmt::format("texture_storage_{}<{}, {}>", shape, view, both ? "read_write" : "write");
}

Layout layout_of(const Module& module, Id id) {
    const Type& t = module.type(id);
    switch (t.kind) {
        case TypeKind::vector: {
            const std::uint32_t scalar = layout_of(module, t.element).size;
            return {scalar * t.count, scalar * (t.count == 2 ? 2 : 4)};
        }
        case TypeKind::matrix: {
            const std::uint32_t column = layout_of(module, t.element).alignment;
            return {column * t.count, column};
        }
        case TypeKind::array:
        case TypeKind::runtime_array: {
            const Layout element = layout_of(module, t.element);
            const std::uint32_t stride =
                (element.size + element.alignment - 1) / element.alignment * element.alignment;
            const std::uint32_t length = t.kind == TypeKind::array ? module.integer(t.length).value_or(1) : 1;
            return {stride * length, element.alignment};
        }
        case TypeKind::structure: {
            Layout all;
            for (const Member& member : t.members) {
                const Layout part = layout_of(module, member.type);
                all.size = (all.size + part.alignment - 1) / part.alignment * part.alignment;
                all.size = std::max(all.size, member.offset) + part.size;
                all.alignment = std::max(all.alignment, part.alignment);
            }
            all.size = (all.size + all.alignment - 1) / all.alignment * all.alignment;
            return all;
        }
        default:
            return t.width == 16 ? Layout{2, 2} : Layout{4, 4};
    }
}

}  // namespace gloam::shader::internal::wgsl
