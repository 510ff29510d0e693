// SPDX-License-Identifier: MIT
// packed_fragment gl|es FRAGMENT_SHADER PICTURE.pgm: the ambient occlusion of a wall on a floor, drawn by the
// packed shader in a context of OpenGL 3.3 or OpenGL ES 3.0 without a window.
// packed_fragment gl|es --compile SHADER: functions without a main are compiled.
// packed_fragment gl|es --method FRAGMENT_SHADER FRAME RADIUS RENDERED.pfm: the occlusion of a frame that
// `gloam render --write-gbuffer` has written (FRAME: the files' path up to f0000), compared with what it
// rendered.
#define GL_GLES_PROTOTYPES 0
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "../gbuffers.hpp"

namespace {

// Of the wall on a floor.
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

struct Size {
    GLsizei width;
    GLsizei height;
};

// Without texels: what is drawn to.
void texture(Size size, GLint internal, GLenum format, GLenum type, const void* texels) {
    GLuint name = 0;
    GL(GENTEXTURES, GenTextures)(1, &name);
    GL(BINDTEXTURE, BindTexture)(GL_TEXTURE_2D, name);
    GL(TEXIMAGE2D, TexImage2D)(GL_TEXTURE_2D, 0, internal, size.width, size.height, 0, format, type, texels);
    GL(TEXPARAMETERI, TexParameteri)(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    GL(TEXPARAMETERI, TexParameteri)(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    if (texels != nullptr) return;
    GLuint target = 0;
    GL(GENFRAMEBUFFERS, GenFramebuffers)(1, &target);
    GL(BINDFRAMEBUFFER, BindFramebuffer)(GL_FRAMEBUFFER, target);
    GL(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)
    (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
}

// A uniform of the program in use.
GLint uniform(GLuint program, const char* name) {
    return GL(GETUNIFORMLOCATION, GetUniformLocation)(program, name);
}

// Draws a triangle over the whole target, and reads the first of its four channels, rows from the first.
template <class Value>
std::vector<Value> drawn(Size size, GLenum type) {
    GLuint nothing = 0;
    GL(GENVERTEXARRAYS, GenVertexArrays)(1, &nothing);
    GL(BINDVERTEXARRAY, BindVertexArray)(nothing);
    GL(VIEWPORT, Viewport)(0, 0, size.width, size.height);
    GL(DRAWARRAYS, DrawArrays)(GL_TRIANGLES, 0, 3);
    std::vector<Value> texels(std::size_t{4} * static_cast<std::size_t>(size.width * size.height));
    GL(READPIXELS, ReadPixels)(0, 0, size.width, size.height, GL_RGBA, type, texels.data());
    require(GL(GETERROR, GetError)() == GL_NO_ERROR, "OpenGL reports an error");
    std::vector<Value> values;
    for (std::size_t i = 0; i < texels.size(); i += 4) values.push_back(texels[i]);
    return values;
}

// 0 to 255, rows from the bottom.
std::vector<std::uint8_t> wall_on_floor(GLuint program) {
    const Size size{width, height};
    const std::vector<float> depth = depths();
    texture(size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    texture(size, GL_R32F, GL_RED, GL_FLOAT, depth.data());
    GL(USEPROGRAM, UseProgram)(program);
    GL(UNIFORM1I, Uniform1i)(uniform(program, "engine_depth"), 0);
    GL(UNIFORM2F, Uniform2f)(uniform(program, "p00_p11"), p00, p11);
    GL(UNIFORM1F, Uniform1f)(uniform(program, "radius"), 1.0F);
    return drawn<std::uint8_t>(size, GL_UNSIGNED_BYTE);
}

// The occlusion of a frame; images have their rows from the top, and so has the result.
std::vector<float> of_frame(GLuint program, const std::string& frame, float radius) {
    const Picture depth = read_pfm(frame + "_depth.pfm", 1);
    const Picture normal = read_pfm(frame + "_normal.pfm", 3);
    const std::vector<float> projection = numbers_of(read_file(frame + ".json"), "proj_vk");
    const Size size{static_cast<GLsizei>(depth.width), static_cast<GLsizei>(depth.height)};
    texture(size, GL_RGBA32F, GL_RGBA, GL_FLOAT, nullptr);
    texture(size, GL_R32F, GL_RED, GL_FLOAT, depth.values.data());
    GL(ACTIVETEXTURE, ActiveTexture)(GL_TEXTURE1);
    texture(size, GL_RGB32F, GL_RGB, GL_FLOAT, normal.values.data());
    GL(USEPROGRAM, UseProgram)(program);
    GL(UNIFORM1I, Uniform1i)(uniform(program, "engine_depth"), 0);
    GL(UNIFORM1I, Uniform1i)(uniform(program, "engine_normal"), 1);
    GL(UNIFORM2F, Uniform2f)
    (uniform(program, "p00_p11"), projection.at(0), projection.at(5));
    GL(UNIFORM1F, Uniform1f)(uniform(program, "radius"), radius);
    return drawn<float>(size, GL_FLOAT);
}

// Drivers round differently, and a tap within rounding of a pixel's border falls to either side.
void compare(const std::vector<float>& occlusion, const std::string& file) {
    const std::vector<float> rendered = read_pfm(file, 1).values;
    require(occlusion.size() == rendered.size(), "the images differ in size");
    double sum = 0.0;
    float greatest = 0.0F;
    std::size_t apart = 0;
    for (std::size_t i = 0; i < rendered.size(); ++i) {
        const float difference = std::abs(occlusion[i] - rendered[i]);
        sum += occlusion[i];
        greatest = std::max(greatest, difference);
        if (!(difference <= 1e-4F)) ++apart;
    }
    const double mean = sum / static_cast<double>(rendered.size());
    std::printf("mean occlusion %.4f; %zu of %zu pixels differ by more than 1e-4, the most by %g\n", mean,
                apart, rendered.size(), static_cast<double>(greatest));
    require(mean > 0.01 && 100 * apart <= rendered.size(), "that is not what gloam has rendered");
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

// The program of a context that it makes.
GLuint program_of(bool es, const std::string& fragment) {
    make_context(es);
    return program(es ? "#version 300 es\n" : "#version 330\n", fragment);
}

void run(const std::vector<std::string>& words) {
    require(words.size() == 3 || words.size() == 6, "usage: see the head of main.cpp");
    const bool es = words[0] == "es";
    if (words[1] == "--method") {
        require(words.size() == 6, "--method takes a shader, a frame, a radius and a picture");
        const GLuint shader = program_of(es, text_of(words[2].c_str()));
        compare(of_frame(shader, words[3], std::strtof(words[4].c_str(), nullptr)), words[5]);
    } else if (words[1] == "--compile") {  // functions without a main
        make_context(es);
        (void)compiled(GL_FRAGMENT_SHADER, text_of(words[2].c_str()));
    } else {
        const std::vector<std::uint8_t> values = wall_on_floor(program_of(es, text_of(words[1].c_str())));
        write(words[2].c_str(), values);
        check(values);
    }
}

}  // namespace

int main(int count, char** arguments) {
    try {
        run({arguments + 1, arguments + count});
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "packed_fragment: %s\n", error.what());
        return 2;
    }
}
