// SPDX-License-Identifier: MIT
#include "backend/gl/program.hpp"

#include <fmt/format.h>
#include <sstream>
#include <stdexcept>

#include "backend/gl/internal/context.hpp"
#include "base/pattern.hpp"

namespace gloam::backend::gl {
namespace {

using internal::Functions;

constexpr const char* covering_triangle = R"(
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

std::string line_of(const std::string& text, std::size_t number) {
    std::istringstream lines(text);
    std::string line;
    for (std::size_t i = 0; i < number; ++i)
        if (!std::getline(lines, line)) return "";
    return line;
}

std::string one_line(std::string log) {
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) log.pop_back();
    std::string text;
    for (const char c : log) text += c == '\n' ? std::string(" | ") : std::string(1, c);
    return text.empty() ? "no message" : text;
}

// "0:12(5): error: ..." of Mesa, "ERROR: 0:12: ..." of others: the line of the first message.
std::string with_line(const ShaderText& shader, const std::string& log) {
    static const base::Pattern place(R"((?:^|[^\d])\d+:(\d+)(?:\(\d+\))?:)");
    const std::vector<std::string> found = place.first(log);
    if (found.empty()) return fmt::format("{}: {}", shader.name, one_line(log));
    const std::size_t line = std::stoul(found[1]);
    return fmt::format("{}: line {}: {} [{}]", shader.name, line, one_line(log), line_of(shader.text, line));
}

// What the driver says of a shader or a program, by the functions for it.
template <class Number, class Log>
std::string log_of(GLuint object, Number number, Log log) {
    GLint length = 0;
    number(object, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    log(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
    return text;
}

// A shader object, until it is part of a program.
class Shader {
  public:
    Shader(const internal::Functions& gl, GLenum stage, const ShaderText& shader)
        : gl_(gl), handle_(gl.CreateShader(stage)) {
        const char* const text = shader.text.c_str();
        gl_.ShaderSource(handle_, 1, &text, nullptr);
        gl_.CompileShader(handle_);
        GLint compiled = GL_FALSE;
        gl_.GetShaderiv(handle_, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) return;
        const std::string message = with_line(shader, log_of(handle_, gl_.GetShaderiv, gl_.GetShaderInfoLog));
        gl_.DeleteShader(handle_);
        throw backend::Error(message);
    }
    ~Shader() { gl_.DeleteShader(handle_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    [[nodiscard]] GLuint handle() const { return handle_; }

  private:
    const internal::Functions& gl_;
    GLuint handle_;
};

// Textures of four words a pixel, as the targets of the framebuffer that is bound.
std::vector<Handle> bound_targets(const Device& device, const Draw& work) {
    const internal::Functions& gl = device.context().use();
    std::vector<Handle> textures;
    std::vector<GLenum> places;
    gl.ActiveTexture(GL_TEXTURE0);
    for (std::size_t i = 0; i < work.targets; ++i) {
        const GLuint name = textures.emplace_back(device, Handle::Kind::texture).name();
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, static_cast<GLsizei>(work.width),
                      static_cast<GLsizei>(work.height), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        places.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, places.back(), GL_TEXTURE_2D, name, 0);
    }
    gl.DrawBuffers(static_cast<GLsizei>(places.size()), places.data());
    device.context().check("the targets of a fragment shader");
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw backend::Error("OpenGL cannot draw to targets of four words");
    return textures;
}

void set_uniforms(const internal::Functions& gl, const Draw& work) {
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

Program::Program(const Device& device, Stage stage, const ShaderText& shader)
    : handle_(device, Handle::Kind::program) {
    const internal::Functions& gl = device.context().use();
    const Shader own(gl, stage == Stage::compute ? GL_COMPUTE_SHADER : GL_FRAGMENT_SHADER, shader);
    std::unique_ptr<Shader> vertices;
    if (stage == Stage::fragment) {
        const std::string version = shader.text.substr(0, shader.text.find('\n'));
        vertices = std::make_unique<Shader>(
            gl, GL_VERTEX_SHADER, ShaderText{"vertex shader of " + shader.name, version + covering_triangle});
    }
    gl.AttachShader(handle(), own.handle());
    if (vertices) gl.AttachShader(handle(), vertices->handle());
    gl.LinkProgram(handle());
    GLint linked = GL_FALSE;
    gl.GetProgramiv(handle(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE)
        throw backend::Error(fmt::format("{}: does not link: {}", shader.name,
                                         one_line(log_of(handle(), gl.GetProgramiv, gl.GetProgramInfoLog))));
}

void dispatch(const Device& device, const Dispatch& work) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    gl.UseProgram(work.program.handle());
    for (const auto& [binding, image] : work.images) {
        gl.BindImageTexture(binding, image.get().handle(), 0, GL_FALSE, 0, GL_READ_WRITE,
                            image.get().format());
        gl.ActiveTexture(GL_TEXTURE0 + binding);
        gl.BindTexture(GL_TEXTURE_2D, image.get().handle());
    }
    gl.ActiveTexture(GL_TEXTURE0);
    for (const auto& [binding, buffer] : work.storage)
        gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.get().handle());
    for (const auto& [binding, buffer] : work.uniforms)
        gl.BindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.get().handle());
    gl.DispatchCompute(work.groups[0], work.groups[1], work.groups[2]);
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
    gl.Finish();
    context.check("a compute shader");
}

std::vector<std::vector<Word>> draw(const Device& device, const Draw& work) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    const Handle framebuffer(device, Handle::Kind::framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    const std::vector<Handle> targets = bound_targets(device, work);
    set_uniforms(gl, work);
    for (const GLenum test :
         std::array<GLenum, 5>{GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER, GL_SCISSOR_TEST})
        gl.Disable(test);
    const auto width = static_cast<GLsizei>(work.width);
    const auto height = static_cast<GLsizei>(work.height);
    gl.Viewport(0, 0, width, height);
    gl.BindVertexArray(context.vertex_array);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    std::vector<std::vector<Word>> words(work.targets, std::vector<Word>(work.width * work.height * 4));
    for (std::size_t i = 0; i < work.targets; ++i) {
        gl.ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
        gl.ReadPixels(0, 0, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, words[i].data());
    }
    context.check("a fragment shader");
    return words;
}

}  // namespace gloam::backend::gl
