// SPDX-License-Identifier: MIT
// vtkGloamPass: gloam's ambient occlusion in the place of vtkSSAOPass, for one renderer.
#pragma once
#include <gloam_presets.h>
#include <vtkObject.h>
#include <vtkOpenGLError.h>  // before other headers of OpenGL

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkShaderProgram.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

class vtkGloamPass : public vtkSSAOPass {
  public:
    static vtkGloamPass* New() { VTK_STANDARD_NEW_BODY(vtkGloamPass); }
    vtkTypeMacro(vtkGloamPass, vtkSSAOPass);

    // fast, balanced, quality or reference.
    void SetPreset(const std::string& name) {
        if (gloam_presets.count(name) == 0) {
            vtkErrorMacro("no preset " << name << ": expected fast, balanced, quality or reference");
            return;
        }
        Preset = {name, gloam_presets.at(name)};
        Drawn = {};
    }
    // Ends the history, where the camera jumps. ResetCamera() does so itself.
    void Cut() { gloam_cut(&Frame); }

    void Render(const vtkRenderState* s) override {
        NumberOfRenderedProps = 0;
        vtkRenderer* renderer = s->GetRenderer();
        Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
        vtkOpenGLState* state = Window->GetState();
        vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND), depth(state, GL_DEPTH_TEST);
        int x = 0, y = 0, w = 0, h = 0;
        renderer->GetTiledSizeAndOrigin(&w, &h, &x, &y);
        InitializeGraphicsResources(Window, w, h);
        for (auto* image : {ColorTexture, PositionTexture, NormalTexture, SSAOTexture, DepthTexture})
            image->Resize(w, h);
        SetArea(x, y, w, h);
        RenderDelegate(s, w, h);
        state->vtkglDisable(GL_BLEND);
        state->vtkglDisable(GL_DEPTH_TEST);
        if (NextFrame(renderer, w, h)) RenderGloam();
        SetArea(x, y, w, h);
        RenderCombine(Window);
    }

    // Images are blended by their alpha: the normal of glass does not count, and one that is 0 does: it tells
    // of a surface without light, which nothing darkens.
    bool PreReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
                                vtkAbstractMapper* mapper, vtkProp* prop) override {
        const bool done = Superclass::PreReplaceShaderValues(vertex, geometry, fragment, mapper, prop);
        vtkShaderProgram::Substitute(fragment, "//VTK::SSAO::Impl",
                                     "//VTK::SSAO::Impl\n  gl_FragData[2].a = step(1.0, gl_FragData[0].a);");
        return done;
    }

    void ReleaseGraphicsResources(vtkWindow* window) override {
        Drawn = {};
        Target->ReleaseGraphicsResources(window);
        Superclass::ReleaseGraphicsResources(window);
    }

  private:
    using Image = vtkSmartPointer<vtkTextureObject>;

    bool Half() const { return Drawn.preset.resolution == gloam_half; }
    void SetArea(int x, int y, int w, int h) {
        Window->GetState()->vtkglViewport(x, y, w, h);
        Window->GetState()->vtkglScissor(x, y, w, h);
    }

    bool NextFrame(vtkRenderer* renderer, int w, int h) {
        if (Observed != renderer)
            renderer->AddObserver(vtkCommand::ResetCameraEvent, this, &vtkGloamPass::Cut);
        Observed = renderer;
        vtkCamera* seen = renderer->GetActiveCamera();
        gloam_settings settings{Preset.second, {w, h}, 0, 1};
        settings.preset.orthographic = settings.preset.deep = seen->GetParallelProjection();
        const bool same = memcmp(&settings, &Drawn, sizeof settings) == 0;
        Drawn = settings;
        if (!same) MakeImages(settings.preset.deep != 0);
        settings.radius = float(Radius);
        vtkMatrix4x4* projection = seen->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), 0, 1);
        vtkMatrix4x4* view = seen->GetModelViewTransformMatrix();
        vtkNew<vtkMatrix4x4> moved;
        vtkMatrix4x4::Invert(view, moved);
        vtkMatrix4x4::Multiply4x4(ViewBefore, moved, moved);
        ViewBefore->DeepCopy(view);
        gloam_camera camera;
        float previous_from_current[16];
        for (int i = 0; i < 16; ++i) {
            camera.projection[i] = float(projection->GetElement(i % 4, i / 4));
            camera.view[i] = float(view->GetElement(i % 4, i / 4));
            previous_from_current[i] = float(moved->GetElement(i % 4, i / 4));
        }
        const gloam_error error = gloam_next(&Frame, settings, camera, previous_from_current);
        if (error != gloam_fine) vtkErrorMacro("gloam_next() returns " << error);
        return error == gloam_fine;
    }

    // What stands in gloam_frame.h. Not cleared: the first frame has no use for what images hold.
    void MakeImages(bool deep) {
        const auto make = [&](Image& image, GLenum stored, GLenum format, int divisor, int levels = 1) {
            image = Image::New();
            image->SetContext(Window);
            image->SetInternalFormat(stored);
            image->SetFormat(format);
            image->SetMaxLevel(levels - 1);
            image->SetLinearMagnification(stored == GL_RGB10_A2);
            image->SetMinificationFilter(stored == GL_RGB10_A2 ? vtkTextureObject::Linear
                                                               : vtkTextureObject::NearestMipmapNearest);
            image->SetWrapS(vtkTextureObject::ClampToEdge);
            image->SetWrapT(vtkTextureObject::ClampToEdge);
            const auto side = [&](int k, int level) {
                return std::max((Drawn.size[k] + divisor - 1) / divisor >> level, 1);
            };
            for (int i = levels; i-- > 0;) image->Allocate2D(side(0, i), side(1, i), 1, VTK_UNSIGNED_CHAR, i);
        };
        for (Image& image : Levels) make(image, deep ? GL_R32F : GL_R16F, GL_RED, 1, 5);
        for (Image& image : History) make(image, GL_RGB10_A2, GL_RGBA, 1);
        make(Texels, deep ? GL_RG32UI : GL_R32UI, deep ? GL_RG_INTEGER : GL_RED_INTEGER, Half() ? 2 : 1);
        Programs.clear();
    }

    template <class Parameters>
    void Draw(const std::string& pass, const Parameters& parameters,
              const std::vector<vtkTextureObject*>& written, int level = 0) {
        vtkShaderProgram*& program = Programs[pass];
        if (!program) {
            const char* kind = Drawn.preset.orthographic ? "-orthographic/" : "/";
            const char* triangle = R"(#version 330 core
                void main() { gl_Position = vec4(ivec2(gl_VertexID & 1, gl_VertexID >> 1) * 4 - 1, 0, 1); })";
            std::stringstream text;
            text << std::ifstream(GLOAM_PACKS "/" + Preset.first + kind + pass + ".frag").rdbuf();
            program = Window->GetShaderCache()->ReadyShaderProgram(triangle, text.str().c_str(), "");
        }
        Window->GetShaderCache()->ReadyShaderProgram(program);
        glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof parameters, &parameters);
        program->SetUniformi("level", level);
        const char* samplers[] = {"stored_image",       "normal_image", "depth_image",
                                  "depth_before_image", "before_image", "texel_image"};
        vtkTextureObject* images[] = {DepthTexture, NormalTexture, Levels[0], Levels[1], History[1], Texels};
        for (int i = 0; i < 6; ++i) {
            images[i]->Activate();
            program->SetUniformi(samplers[i], images[i]->GetTextureUnit());
        }
        Target->RemoveColorAttachments(2);
        for (unsigned i = 0; i < written.size(); ++i) Target->AddColorAttachment(i, written[i], 0, 0, level);
        Target->ActivateDrawBuffers(unsigned(written.size()));
        const int w = int(written[0]->GetWidth()), h = int(written[0]->GetHeight());
        SetArea(0, 0, std::max(w >> level, 1), std::max(h >> level, 1));
        glDrawArrays(GL_TRIANGLES, 0, 3);
        for (vtkTextureObject* image : images) image->Deactivate();
    }

    void RenderGloam() {
        Target->SetContext(Window);
        Target->SaveCurrentBindingsAndBuffers();
        Target->Bind();
        GLuint array = 0, buffer = 0;
        glGenVertexArrays(1, &array);
        glBindVertexArray(array);
        glGenBuffers(1, &buffer);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer);
        glBufferData(GL_UNIFORM_BUFFER, 128, nullptr, GL_STREAM_DRAW);
        for (int level = 0; level < 5; ++level) Draw("prepare", Frame.prepare, {Levels[0]}, level);
        Draw("sweep", Frame.sweep, {Texels});
        Draw(Half() ? "join" : "filter", Half() ? Frame.join : Frame.filter, {SSAOTexture, History[0]});
        glDeleteBuffers(1, &buffer);
        glDeleteVertexArrays(1, &array);
        Target->RestorePreviousBindingsAndBuffers();
        std::swap(Levels[0], Levels[1]);
        std::swap(History[0], History[1]);
    }

    std::pair<std::string, gloam_preset> Preset{"balanced", gloam_balanced};
    vtkOpenGLRenderWindow* Window = nullptr;
    vtkRenderer* Observed = nullptr;
    gloam_frame Frame{};
    gloam_settings Drawn{};                             // what programs and images are made for
    std::map<std::string, vtkShaderProgram*> Programs;  // of the shader cache
    Image Levels[2], History[2], Texels;                // of this frame and the one before
    vtkNew<vtkOpenGLFramebufferObject> Target;
    vtkNew<vtkMatrix4x4> ViewBefore;
};
