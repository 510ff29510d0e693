// SPDX-License-Identifier: MIT
// opengl_frame GBUFFERS OUT RADIUS linear|buffer: the ambient occlusion of a sequence, by the fragment
// shaders that `gloam pack --effect --version 330` wrote, or 300es. An engine has what stands above `struct
// Images`.
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <gloam_frame.h>

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "gbuffers.hpp"

// A context of OpenGL 3.3 or OpenGL ES 3.0, without a window.
void make_context(bool es) {
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    eglInitialize(display, nullptr, nullptr);
    eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, es ? 0 : 3, EGL_NONE};
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        throw std::runtime_error("EGL makes no context of that version");
}

struct Format {
    GLint stored;
    GLenum channels, type;
};
constexpr Format r8{GL_R8, GL_RED, GL_UNSIGNED_BYTE}, r16f{GL_R16F, GL_RED, GL_FLOAT},
    r32f{GL_R32F, GL_RED, GL_FLOAT}, rgba32f{GL_RGBA32F, GL_RGBA, GL_FLOAT},
    r32ui{GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT}, rg32ui{GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT},
    rgb10_a2{GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV};

// Clamped to the edge, filled with zeros. divisor: of the size, rounded up.
struct Texture {
    Texture(const Format& format, const int size[2], int divisor = 1, int levels = 1)
        : width((size[0] + divisor - 1) / divisor), height((size[1] + divisor - 1) / divisor) {
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D, name);
        const std::vector<char> zeros(std::size_t(16) * width * height);
        for (int level = 0; level < levels; ++level)
            glTexImage2D(GL_TEXTURE_2D, level, format.stored, std::max(width >> level, 1),
                         std::max(height >> level, 1), 0, format.channels, format.type, zeros.data());
        const GLint nearest = levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST;
        const GLint filter = format.stored == GL_RGB10_A2 ? GL_LINEAR : GL_NEAREST;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter == GL_LINEAR ? filter : nearest);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glTexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
    }
    Texture(const Texture&) = delete;
    ~Texture() { glDeleteTextures(1, &name); }
    int width, height;
    GLuint name = 0;
};

void copy(const Picture& picture, const Texture& texture, GLenum channels) {
    glBindTexture(GL_TEXTURE_2D, texture.name);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, picture.width, picture.height, channels, GL_FLOAT,
                    picture.values.data());
}

std::string text_of(const std::string& file) {
    return read_file(EFFECT "/" + file);
}

void attach(GLuint program, GLenum stage, const std::string& text) {
    const GLuint shader = glCreateShader(stage);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    char log[4096] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    if (*log != 0) std::fprintf(stderr, "%s\n", log);
    glAttachShader(program, shader);
    glDeleteShader(shader);
}

// What stands in gloam_frame.h, for views of one size.
struct Images {
    explicit Images(const gloam_settings& s)
        : depth(r32f, s.size),
          normal(rgba32f, s.size),
          levels(s.preset.deep ? r32f : r16f, s.size, 1, 5),
          levels_before(s.preset.deep ? r32f : r16f, s.size, 1, 5),
          texels(s.preset.deep ? rg32ui : r32ui, s.size, s.preset.resolution == gloam_full ? 1 : 2),
          history(rgb10_a2, s.size),
          history_before(rgb10_a2, s.size),
          shown(r8, s.size),
          marks(r8, s.size, 8),
          full_texels(s.preset.deep ? rg32ui : r32ui, s.size,
                      s.preset.resolution == gloam_tiles ? 1 : s.size[0] + s.size[1]) {}
    Texture depth, normal, levels, levels_before, texels, history, history_before, shown;
    Texture marks, full_texels;  // for tiles alone
};

// Draws a triangle over what it is given to write, or in tiles: the marked ones, or all others. side: pixels
// of a tile in what is written.
struct Pass {
    enum Area { whole, marked, others };
    explicit Pass(const std::string& name, Area drawn = whole, int side = 8) : area(drawn), side(side) {
        const std::string text = text_of(name + ".frag");
        const std::string triangle = text.substr(0, text.find('\n')) + R"(
            void main() { gl_Position = vec4(ivec2(gl_VertexID & 1, gl_VertexID >> 1) * 4 - 1, 0, 1); })";
        attach(program, GL_VERTEX_SHADER, area == whole ? triangle : text_of("tiles.vert"));
        attach(program, GL_FRAGMENT_SHADER, text);
        glLinkProgram(program);
        GLint links = 0;
        glGetProgramiv(program, GL_LINK_STATUS, &links);
        if (links == 0) throw std::runtime_error("a pass does not link");
    }
    // texels: those that it reads.
    template <class Parameters>
    void draw(const Parameters& parameters, const Images& of, const Texture& texels,
              const std::vector<const Texture*>& written, int level = 0) const {
        glUseProgram(program);
        glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof parameters, &parameters);
        glUniform1i(glGetUniformLocation(program, "level"), level);
        glUniform1f(glGetUniformLocation(program, "marked"), area == marked ? 1.0F : 0.0F);
        GLint unit = 0;
        for (const auto& [sampler, texture] : {std::pair{"stored_image", &of.depth},
                                               {"normal_image", &of.normal},
                                               {"depth_image", &of.levels},
                                               {"depth_before_image", &of.levels_before},
                                               {"before_image", &of.history_before},
                                               {"mark_image", &of.marks},
                                               {"texel_image", &texels}}) {  // those that it has
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, texture->name);
            glUniform1i(glGetUniformLocation(program, sampler), unit++);
        }
        constexpr GLenum places[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
        for (const GLenum& place : places) {
            const std::size_t i = &place - places;
            const GLuint name = i < written.size() ? written[i]->name : 0;
            glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, name, level);
        }
        glDrawBuffers(GLsizei(written.size()), places);
        const Texture& all = *written[0];
        const int columns = (all.width + side - 1) / side, rows = (all.height + side - 1) / side;
        if (area == whole)
            glViewport(0, 0, std::max(all.width >> level, 1), std::max(all.height >> level, 1));
        else
            glViewport(0, 0, side * columns, side * rows);
        glDrawArrays(GL_TRIANGLES, 0, area == whole ? 3 : 6 * columns * rows);
    }
    Area area;
    int side;
    GLuint program = glCreateProgram();
};

struct Passes {
    Passes() {
        const bool tiles = PRESET.resolution == gloam_tiles;
        if (tiles) mark.emplace("mark");
        if (tiles) refine.emplace("refine", Pass::marked);
        if (tiles) halve.emplace("halve", Pass::marked, 4);
        if (PRESET.resolution != gloam_full) join.emplace("join", tiles ? Pass::others : Pass::whole);
        if (PRESET.resolution != gloam_half) filter.emplace("filter", tiles ? Pass::marked : Pass::whole);
        GLuint name = 0;
        glGenBuffers(1, &name);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, name);
        glBufferData(GL_UNIFORM_BUFFER, 128, nullptr, GL_STREAM_DRAW);
        glGenFramebuffers(1, &name);
        glBindFramebuffer(GL_FRAMEBUFFER, name);
        glGenVertexArrays(1, &name);
        glBindVertexArray(name);
    }
    void draw(const gloam_frame& frame, Images& of) const {
        for (int level = 0; level < 5; ++level)
            prepare.draw(frame.prepare, of, of.texels, {&of.levels}, level);
        sweep.draw(frame.sweep, of, of.texels, {&of.texels});
        if (mark) mark->draw(frame.mark, of, of.texels, {&of.marks});
        if (refine) refine->draw(frame.sweep, of, of.texels, {&of.full_texels});
        if (halve) halve->draw(frame.sweep, of, of.full_texels, {&of.texels});
        std::vector<const Texture*> joined{&of.shown, &of.history};
        if (refine) joined.push_back(&of.full_texels);
        if (join) join->draw(frame.join, of, of.texels, joined);
        const Texture& filtered = refine ? of.full_texels : of.texels;
        if (filter) filter->draw(frame.filter, of, filtered, {&of.shown, &of.history});
        std::swap(of.levels.name, of.levels_before.name);
        std::swap(of.history.name, of.history_before.name);
    }
    Pass prepare{"prepare"}, sweep{"sweep"};
    std::optional<Pass> mark, refine, halve, join, filter;
};

void run(char** arguments) {
    make_context(text_of("sweep.frag").starts_with("#version 300 es"));
    const Passes passes;
    std::optional<Images> images;
    each_frame(arguments, [&](const gloam_frame& frame, const Picture& depth, const Picture& normal) {
        if (!images || images->depth.width != depth.width || images->depth.height != depth.height)
            images.emplace(frame.settings);
        copy(depth, images->depth, GL_RED);
        copy(normal, images->normal, GL_RGBA);
        passes.draw(frame, *images);
        std::vector<unsigned char> shown(4 * depth.values.size());  // of the framebuffer: R8 as RGBA
        glReadPixels(0, 0, depth.width, depth.height, GL_RGBA, GL_UNSIGNED_BYTE, shown.data());
        if (glGetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL reports an error");
        for (std::size_t i = 0; i < depth.values.size(); ++i) shown[i] = shown[4 * i];
        return shown;
    });
}

int main(int count, char** arguments) {
    return run_example(count, arguments, run);
}
