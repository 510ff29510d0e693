// SPDX-License-Identifier: MIT
#include "gl/program.hpp"

#include <fmt/format.h>

#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "gl/internal/context.hpp"

namespace gloam::gl {
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
    static const std::regex place(R"((?:^|[^\d])\d+:(\d+)(?:\(\d+\))?:)");
    std::smatch found;
    if (!std::regex_search(log, found, place)) return fmt::format("{}: {}", shader.name, one_line(log));
    const std::size_t line = std::stoul(found[1]);
    return fmt::format("{}: line {}: {} [{}]", shader.name, line, one_line(log), line_of(shader.text, line));
}

// A shader object, until it is part of a program.
class Shader {
  public:
    Shader(const Functions& gl, GLenum stage, const ShaderText& shader)
        : gl_(gl), handle_(gl.CreateShader(stage)) {
        const char* const text = shader.text.c_str();
        gl_.ShaderSource(handle_, 1, &text, nullptr);
        gl_.CompileShader(handle_);
        GLint compiled = GL_FALSE;
        gl_.GetShaderiv(handle_, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) return;
        const std::string message = with_line(shader, log());
        gl_.DeleteShader(handle_);
        throw CompileFailed(message);
    }
    ~Shader() { gl_.DeleteShader(handle_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    [[nodiscard]] GLuint handle() const { return handle_; }

  private:
    [[nodiscard]] std::string log() const {
        GLint length = 0;
        gl_.GetShaderiv(handle_, GL_INFO_LOG_LENGTH, &length);
        std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
        gl_.GetShaderInfoLog(handle_, static_cast<GLsizei>(text.size()), nullptr, text.data());
        return text;
    }

    const Functions& gl_;
    GLuint handle_;
};

std::string link_log(const Functions& gl, GLuint program) {
    GLint length = 0;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    gl.GetProgramInfoLog(program, static_cast<GLsizei>(text.size()), nullptr, text.data());
    return one_line(text);
}

}  // namespace

Program::Program(const Device& device, Stage stage, const ShaderText& shader) : device_(&device) {
    const Functions& gl = device.context().use();
    const Shader own(gl, stage == Stage::compute ? GL_COMPUTE_SHADER : GL_FRAGMENT_SHADER, shader);
    std::unique_ptr<Shader> vertices;
    if (stage == Stage::fragment) {
        const std::string version = shader.text.substr(0, shader.text.find('\n'));
        vertices = std::make_unique<Shader>(
            gl, GL_VERTEX_SHADER, ShaderText{"vertex shader of " + shader.name, version + covering_triangle});
    }
    handle_ = gl.CreateProgram();
    gl.AttachShader(handle_, own.handle());
    if (vertices) gl.AttachShader(handle_, vertices->handle());
    gl.LinkProgram(handle_);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(handle_, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    const std::string message = fmt::format("{}: does not link: {}", shader.name, link_log(gl, handle_));
    gl.DeleteProgram(handle_);
    throw LinkFailed(message);
}

Program::~Program() {
    if (handle_ != 0) device_->context().use().DeleteProgram(handle_);
}

Program::Program(Program&& other) noexcept
    : device_(other.device_), handle_(std::exchange(other.handle_, 0U)) {}

}  // namespace gloam::gl
