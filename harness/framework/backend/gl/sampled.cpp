// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <utility>

#include "backend/gl/internal/context.hpp"
#include "backend/gl/resources.hpp"
#include "backend/sampled.hpp"

namespace gloam::backend::gl {
namespace {

using backend::SampledHeader;
using backend::SampledShape;
using backend::SampledTexel;

constexpr GLenum seamless_cubes = 0x884F;  // GL_TEXTURE_CUBE_MAP_SEAMLESS; OpenGL ES always has them

struct Format {
    GLenum internal;
    GLenum channels;
    GLenum type;
};

// In the order of the enumerations.
constexpr std::array formats{Format{GL_RGBA16F, GL_RGBA, GL_FLOAT},
                             Format{GL_RGBA32I, GL_RGBA_INTEGER, GL_INT},
                             Format{GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
                             Format{GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT}};
constexpr std::array<GLenum, 5> targets{GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_3D,
                                        GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_ARRAY};
constexpr std::array<GLenum, 4> wraps{GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER};
constexpr std::array<GLenum, 4> comparisons{GL_LEQUAL, GL_GEQUAL, GL_LESS, GL_GREATER};

// The sampler's state is that of its texture.
void set_state(const internal::Functions& gl, GLenum target, const SampledHeader& header) {
    const bool linear = header.linear != 0;
    const auto set = [&](GLenum name, GLenum value) {
        gl.TexParameteri(target, name, static_cast<GLint>(value));
    };
    set(GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
    set(GL_TEXTURE_MIN_FILTER, linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        set(axis, named(wraps, header.wrap));
    if (header.texel != SampledTexel::depth) return;
    set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    set(GL_TEXTURE_COMPARE_FUNC, named(comparisons, header.compare));
}

void upload(const internal::Functions& gl, GLenum target, const SampledHeader& header,
            std::span<const Word> words) {
    const Format format = named(formats, header.texel);
    const bool depths = header.texel == SampledTexel::depth;
    const std::vector<Word> stored = depths ? backend::stored_texels(words) : std::vector<Word>{};
    const std::span<const Word> texels =
        depths ? std::span<const Word>(stored) : words.subspan(backend::sampled_header_words);
    const std::size_t texel = depths ? 1 : backend::texel_words;
    for (std::uint32_t level = 0; level < header.levels; ++level) {
        const auto size = backend::size_of_level(header, level);
        const Word* first = &texels[backend::texels_before(header, level) * texel];
        const auto side = [&](std::size_t axis) { return static_cast<GLsizei>(size.at(axis)); };
        const auto at = static_cast<GLint>(level);
        if (header.shape == SampledShape::cube) {
            for (GLenum face = 0; face < backend::cube_faces; ++face)
                gl.TexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, at, 0, 0, side(0), side(1),
                                 format.channels, format.type, first + face * size[0] * size[1] * texel);
        } else if (header.shape == SampledShape::two) {
            gl.TexSubImage2D(target, at, 0, 0, side(0), side(1), format.channels, format.type, first);
        } else {
            gl.TexSubImage3D(target, at, 0, 0, 0, side(0), side(1), side(2), format.channels, format.type,
                             first);
        }
    }
}

}  // namespace

SampledTexture::SampledTexture(const Device& device, std::span<const Word> words)
    : target_(named(targets, backend::sampled_header(words).shape)), handle_(device, Handle::Kind::texture) {
    const SampledHeader header = backend::sampled_header(words);
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    gl.BindTexture(target_, handle_.name());
    const Format format = named(formats, header.texel);
    const auto side = [](std::uint32_t length) { return static_cast<GLsizei>(length); };
    if (header.shape == SampledShape::two || header.shape == SampledShape::cube)
        gl.TexStorage2D(target_, side(header.levels), format.internal, side(header.width),
                        side(header.height));
    else
        gl.TexStorage3D(target_, side(header.levels), format.internal, side(header.width),
                        side(header.height), side(header.depth));
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    upload(gl, target_, header, words);
    set_state(gl, target_, header);
    if (device.info().id.version.api == Api::gl) gl.Enable(seamless_cubes);
    context.check("a texture");
}

void SampledTexture::bind(std::uint32_t unit) const {
    const internal::Functions& gl = handle_.device().context().use();
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(target_, handle_.name());
    gl.ActiveTexture(GL_TEXTURE0);
}

}  // namespace gloam::backend::gl
