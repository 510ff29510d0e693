// SPDX-License-Identifier: MIT
// packed_fragment gl|es FRAGMENT_SHADER PICTURE.pgm: the ambient occlusion of a wall on a floor, drawn by the
// packed shader in a context of OpenGL 3.3 or OpenGL ES 3.0 without a window.
#define GL_GLES_PROTOTYPES 0
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr int width = 96;
constexpr int height = 64;
constexpr float p00 = 1.2F;
constexpr float p11 = 1.8F;

void require(bool condition, const char* what) {
    if (!condition) throw std::runtime_error(what);
}

// A function of OpenGL by its name.
template <class Function>
Function gl(const char* name) {
    const auto function = reinterpret_cast<Function>(eglGetProcAddress(name));
    require(function != nullptr, name);
    return function;
}
#define GL(type, name) gl<PFNGL##type##PROC>("gl" #name)

void make_context(bool es) {
    const auto platform =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    require(platform != nullptr, "EGL has no eglGetPlatformDisplayEXT");
    EGLDisplay display = platform(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    require(display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) != EGL_FALSE,
            "EGL has no display without a window");
    require(eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) != EGL_FALSE, "EGL does not know that API");
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, es ? 0 : 3, EGL_NONE};
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    require(context != EGL_NO_CONTEXT &&
                eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_FALSE,
            "EGL makes no context of that version");
}

GLuint compiled(GLenum stage, const std::string& text) {
    const GLuint shader = GL(CREATESHADER, CreateShader)(stage);
    const char* const source = text.c_str();
    GL(SHADERSOURCE, ShaderSource)(shader, 1, &source, nullptr);
    GL(COMPILESHADER, CompileShader)(shader);
    GLint good = 0;
    GL(GETSHADERIV, GetShaderiv)(shader, GL_COMPILE_STATUS, &good);
    std::string log(4096, '\0');
    GL(GETSHADERINFOLOG, GetShaderInfoLog)(shader, 4096, nullptr, log.data());
    require(good != 0, log.c_str());
    return shader;
}

GLuint program(const std::string& version, const std::string& fragment) {
    const GLuint program = GL(CREATEPROGRAM, CreateProgram)();
    const std::string vertex =
        version +
        "void main() {\n    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : "
        "-1.0, 0.0, 1.0);\n}\n";
    GL(ATTACHSHADER, AttachShader)(program, compiled(GL_VERTEX_SHADER, vertex));
    GL(ATTACHSHADER, AttachShader)(program, compiled(GL_FRAGMENT_SHADER, fragment));
    GL(LINKPROGRAM, LinkProgram)(program);
    GLint good = 0;
    GL(GETPROGRAMIV, GetProgramiv)(program, GL_LINK_STATUS, &good);
    require(good != 0, "the program does not link");
    return program;
}

// Eye-linear depth of a floor one unit below the eye and a wall four units in front of it, rows from the
// bottom.
std::vector<float> depths() {
    std::vector<float> all;
    for (int y = 0; y < height; ++y) {
        const float slope = (2.0F * (static_cast<float>(y) + 0.5F) / height - 1.0F) / p11;
        const float floor = slope < 0.0F ? -1.0F / slope : 1e9F;
        all.insert(all.end(), width, std::fmin(floor, 4.0F));
    }
    return all;
}

void texture(GLint internal, GLenum format, GLenum type, const void* texels) {
    GLuint name = 0;
    GL(GENTEXTURES, GenTextures)(1, &name);
    GL(BINDTEXTURE, BindTexture)(GL_TEXTURE_2D, name);
    GL(TEXIMAGE2D, TexImage2D)(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, texels);
    GL(TEXPARAMETERI, TexParameteri)(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    GL(TEXPARAMETERI, TexParameteri)(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    if (texels != nullptr) return;
    GLuint target = 0;  // drawn to
    GL(GENFRAMEBUFFERS, GenFramebuffers)(1, &target);
    GL(BINDFRAMEBUFFER, BindFramebuffer)(GL_FRAMEBUFFER, target);
    GL(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)
    (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
}

// One channel, 0 to 255, rows from the bottom.
std::vector<std::uint8_t> drawn(GLuint program) {
    const std::vector<float> depth = depths();
    texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    texture(GL_R32F, GL_RED, GL_FLOAT, depth.data());
    GL(USEPROGRAM, UseProgram)(program);
    const auto location = GL(GETUNIFORMLOCATION, GetUniformLocation);
    GL(UNIFORM1I, Uniform1i)(location(program, "engine_depth"), 0);
    GL(UNIFORM2F, Uniform2f)(location(program, "p00_p11"), p00, p11);
    GL(UNIFORM1F, Uniform1f)(location(program, "radius"), 1.0F);
    GLuint nothing = 0;
    GL(GENVERTEXARRAYS, GenVertexArrays)(1, &nothing);
    GL(BINDVERTEXARRAY, BindVertexArray)(nothing);
    GL(VIEWPORT, Viewport)(0, 0, width, height);
    GL(DRAWARRAYS, DrawArrays)(GL_TRIANGLES, 0, 3);
    std::vector<std::uint8_t> texels(std::size_t{4} * width * height);
    GL(READPIXELS, ReadPixels)(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    require(GL(GETERROR, GetError)() == GL_NO_ERROR, "OpenGL reports an error");
    std::vector<std::uint8_t> values;
    for (std::size_t i = 0; i < texels.size(); i += 4) values.push_back(texels[i]);
    return values;
}

void write(const char* file, const std::vector<std::uint8_t>& values) {
    std::ofstream stream(file, std::ios::binary);
    stream << "P5\n" << width << " " << height << "\n255\n";
    for (int y = height; y-- > 0;)
        stream.write(reinterpret_cast<const char*>(&values[static_cast<std::size_t>(y) * width]), width);
    require(bool(stream.flush()), "the picture cannot be written");
}

// Darkest where floor and wall meet, open away from there.
void check(const std::vector<std::uint8_t>& values) {
    const auto mean_of_row = [&](int y) {
        int sum = 0;
        for (int x = 8; x < width - 8; ++x)
            sum += values[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
        return sum / (width - 16);
    };
    const int edge = static_cast<int>((1.0F - p11 / 4.0F) / 2.0F * height);
    std::printf("visibility of 255: floor %d, edge %d, wall %d\n", mean_of_row(2), mean_of_row(edge),
                mean_of_row(height - 4));
    require(mean_of_row(edge) < 200 && mean_of_row(2) > 245 && mean_of_row(height - 4) > 245,
            "that is no ambient occlusion");
}

std::string text_of(const char* file) {
    std::ifstream stream(file);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    require(!text.empty(), "the shader cannot be read");
    return text;
}

}  // namespace

int main(int count, char** arguments) {
    try {
        require(count == 4,
                "usage: packed_fragment gl|es FRAGMENT_SHADER PICTURE.pgm, or gl|es --compile SHADER");
        const bool es = std::string(arguments[1]) == "es";
        const bool only_compiles = std::string(arguments[2]) == "--compile";
        const std::string fragment = text_of(arguments[only_compiles ? 3 : 2]);
        make_context(es);
        if (only_compiles) {  // functions without a main
            (void)compiled(GL_FRAGMENT_SHADER, fragment);
            return 0;
        }
        const std::vector<std::uint8_t> values =
            drawn(program(es ? "#version 300 es\n" : "#version 330\n", fragment));
        write(arguments[3], values);
        check(values);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "packed_fragment: %s\n", error.what());
        return 2;
    }
}
