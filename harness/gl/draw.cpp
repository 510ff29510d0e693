// SPDX-License-Identifier: MIT
#include "gl/draw.hpp"

#include <array>
#include <stdexcept>

#include "gl/internal/context.hpp"

namespace gloam::gl {
namespace {

using internal::Context;
using internal::Functions;

// Targets and their framebuffer, bound for drawing and reading while the object lives.
class Targets {
  public:
    Targets(const Context& context, const Draw& work)
        : gl_(context.functions), work_(work), textures_(work.targets) {
        gl_.GenTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
        gl_.GenFramebuffers(1, &framebuffer_);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        std::vector<GLenum> places;
        gl_.ActiveTexture(GL_TEXTURE0);
        for (std::size_t i = 0; i < textures_.size(); ++i) {
            gl_.BindTexture(GL_TEXTURE_2D, textures_[i]);
            gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, width(), height(), 0, GL_RGBA_INTEGER,
                           GL_UNSIGNED_INT, nullptr);
            gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            places.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
            gl_.FramebufferTexture2D(GL_FRAMEBUFFER, places.back(), GL_TEXTURE_2D, textures_[i], 0);
        }
        gl_.DrawBuffers(static_cast<GLsizei>(places.size()), places.data());
    }
    ~Targets() {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    }
    Targets(const Targets&) = delete;
    Targets& operator=(const Targets&) = delete;

    [[nodiscard]] bool complete() const {
        return gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    }

    [[nodiscard]] std::vector<std::vector<Word>> read() const {
        std::vector<std::vector<Word>> all;
        gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
        for (std::size_t i = 0; i < textures_.size(); ++i) {
            all.emplace_back(work_.width * work_.height * 4);
            gl_.ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
            gl_.ReadPixels(0, 0, width(), height(), GL_RGBA_INTEGER, GL_UNSIGNED_INT, all.back().data());
        }
        return all;
    }

  private:
    [[nodiscard]] GLsizei width() const { return static_cast<GLsizei>(work_.width); }
    [[nodiscard]] GLsizei height() const { return static_cast<GLsizei>(work_.height); }

    const Functions& gl_;
    const Draw& work_;
    std::vector<GLuint> textures_;
    GLuint framebuffer_ = 0;
};

void set_uniforms(const Functions& gl, const Draw& work) {
    const GLuint program = work.program.handle();
    gl.UseProgram(program);
    for (std::size_t i = 0; i < work.textures.size(); ++i) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        gl.BindTexture(GL_TEXTURE_2D, work.textures[i].second->handle());
        gl.Uniform1i(gl.GetUniformLocation(program, work.textures[i].first.c_str()), static_cast<GLint>(i));
    }
    for (const auto& [name, value] : work.uniforms)
        gl.Uniform1ui(gl.GetUniformLocation(program, name.c_str()), value);
}

}  // namespace

std::vector<std::vector<Word>> draw(const Device& device, const Draw& work) {
    if (work.width == 0 || work.height == 0 || work.targets == 0 ||
        work.targets > device.info().max_draw_buffers)
        throw std::invalid_argument("a draw has pixels and 1 to max_draw_buffers targets");
    const Context& context = device.context();
    const Functions& gl = context.use();
    const Targets targets(context, work);
    context.check("the targets of a fragment shader");
    if (!targets.complete()) throw CallFailed("OpenGL cannot draw to targets of four words");
    set_uniforms(gl, work);
    for (const GLenum test :
         std::array<GLenum, 5>{GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER, GL_SCISSOR_TEST})
        gl.Disable(test);
    gl.Viewport(0, 0, static_cast<GLsizei>(work.width), static_cast<GLsizei>(work.height));
    gl.BindVertexArray(context.vertex_array);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<std::vector<Word>> words = targets.read();
    context.check("a fragment shader");
    return words;
}

}  // namespace gloam::gl
