// SPDX-License-Identifier: MIT
#pragma once
// A node whose children are drawn with ambient occlusion, made of their depth alone. For one view, of any
// size.
#include <gloam_frame.h>
#include <osg/BufferIndexBinding>
#include <osg/Camera>
#include <osg/Geometry>
#include <osg/PolygonMode>
#include <osg/Program>
#include <osg/Texture2D>
#include <osgUtil/CullVisitor>

#include <map>
#include <string>
#include <vector>

class GloamAO : public osg::Camera {
  public:
    // effect: the folder of `gloam pack --effect --normals none --version 330`; for orthographic cameras its
    // folder orthographic is of the same with `--orthographic`. radius: of influence, world units.
    GloamAO(std::string effect, const gloam_preset& preset, float radius)
        : radius(radius), effect_(std::move(effect)), settings_{preset, {0, 0}, 0, 1}, deep_(preset.deep) {
        const osg::Vec2 corners[] = {{-1, -1}, {3, -1}, {-1, 3}};
        triangle_->setVertexAttribArray(0, new osg::Vec2Array(3, corners), osg::Array::BIND_PER_VERTEX);
        triangle_->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
        triangle_->setCullingActive(false);
    }
    float radius;
    osg::ref_ptr<osg::Texture2D> color, depth;  // of the children, once drawn
    osg::ref_ptr<osg::Texture2D> shown;         // 1 where blocked, 0 where open
    osg::ref_ptr<osg::RefMatrix> projection;    // with which they were drawn
    void restart() { gloam_cut(&frame_); }      // where the camera jumps

    void accept(osg::NodeVisitor& visitor) override {
        osgUtil::CullVisitor* const cull = visitor.asCullVisitor();
        if (cull == nullptr || !visitor.validNodeMask(*this)) return Camera::accept(visitor);
        gloam_settings seen = settings_;
        seen.size[0] = int(cull->getViewport()->width());
        seen.size[1] = int(cull->getViewport()->height());
        seen.preset.orthographic = (*cull->getProjectionMatrix())(3, 3) != 0;
        seen.preset.deep = deep_ || seen.preset.orthographic;
        if (memcmp(&seen, &settings_, sizeof seen) != 0) make(seen);
        setClearColor(cull->getCurrentCamera()->getClearColor());
        Camera::accept(visitor);
        const bool drawn = next(*cull->getModelViewMatrix());
        if (drawn) turn_ = 1 - turn_;
        cull->pushStateSet(states_[turn_]);
        for (const auto& pass : passes_[turn_])
            if (drawn) pass->accept(visitor);
        triangle_->accept(visitor);
        cull->popStateSet();
    }
    // In the cull, OSG finds the near and far plane of this projection.
    void traverse(osg::NodeVisitor& visitor) override {
        if (visitor.asCullVisitor() != nullptr) projection = visitor.asCullVisitor()->getProjectionMatrix();
        Camera::traverse(visitor);
    }

  private:
    bool next(const osg::Matrixd& view) {
        // OSG multiplies rows by matrices: products are reversed, in memory all is as the header expects.
        const osg::Matrixd change = osg::Matrixd::inverse(view) * before_;
        before_ = view;
        settings_.radius = radius;
        gloam_camera camera;
        float previous[16];
        for (int i = 0; i < 16; ++i) {
            const double* const p = projection->ptr() + i;
            camera.projection[i] = float(i % 4 == 2 ? 0.5 * (p[0] + p[1]) : p[0]);  // z from 0 to 1
            camera.view[i] = float(view.ptr()[i]);
            previous[i] = float(change.ptr()[i]);
        }
        if (gloam_next(&frame_, settings_, camera, previous) != gloam_fine) return false;
        for (const auto& [from, count, data] : data_) {
            std::copy_n(from, count, data->begin());
            data->dirty();
        }
        return true;
    }

    // What a view of this size needs. One level of depth suffices.
    void make(const gloam_settings& settings) {
        settings_ = settings;
        const bool full = settings_.preset.resolution == gloam_full, deep = settings_.preset.deep != 0;
        const bool tiles = settings_.preset.resolution == gloam_tiles;
        using Image = osg::ref_ptr<osg::Texture2D>;
        const GLint texel = deep ? GL_RG32UI : GL_R32UI;
        const GLenum channels = deep ? GL_RG_INTEGER : GL_RED_INTEGER;
        const Image texels = image(texel, channels, GL_UNSIGNED_INT, full ? 1 : 2);
        const Image full_texels = tiles ? image(texel, channels, GL_UNSIGNED_INT) : texels.get();
        const Image marks = image(GL_R8, GL_RED, GL_UNSIGNED_BYTE, 8);
        Image levels[2], history[2];
        for (Image& made : levels) made = image(deep ? GL_R32F : GL_R16F, GL_RED, GL_FLOAT);
        for (Image& made : history) made = image(GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV);
        color = image(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
        depth = image(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
        shown = image(GL_R8, GL_RED, GL_UNSIGNED_BYTE);
        draw_to(*this, {color});
        attach(DEPTH_BUFFER, depth);
        dirtyAttachmentMap();
        data_.clear();
        for (int i = 0; i < 2; ++i) {  // frames in turn, which exchange what is of the frame before
            states_[i] = state(program(new osg::Shader(osg::Shader::FRAGMENT, R"(#version 330 core
                uniform sampler2D color, stored_image, shown;
                in vec2 at;
                out vec4 result;
                void main() {
                    gl_FragDepth = texture(stored_image, at).x;
                    result = texture(color, at) * vec4(vec3(1.0 - texture(shown, at).x), 1.0);
                })")));
            int unit = 0;
            const auto read = [&](const char* sampler, osg::Texture2D* texture) {
                states_[i]->setTextureAttribute(unit, texture, osg::StateAttribute::PROTECTED);
                states_[i]->addUniform(new osg::Uniform(sampler, unit++));
            };
            read("texel_image", texels), read("full_texels", full_texels), read("mark_image", marks);
            read("color", color), read("stored_image", depth), read("normal_image", depth),
                read("shown", shown);
            read("depth_image", levels[i]), read("depth_before_image", levels[1 - i]);
            read("before_image", history[1 - i]);
            passes_[i].clear();
            pass(i, "prepare", frame_.prepare, {levels[i]});
            pass(i, "sweep", frame_.sweep, {texels});
            if (tiles) pass(i, "mark", frame_.mark, {marks});
            if (tiles) pass(i, "refine", frame_.sweep, {full_texels});
            if (tiles) pass(i, "halve", frame_.sweep, {texels}, 1);
            if (tiles) pass(i, "join", frame_.join, {shown, history[i], full_texels});
            if (!tiles && !full) pass(i, "join", frame_.join, {shown, history[i]});
            if (tiles || full) pass(i, "filter", frame_.filter, {shown, history[i]}, 1);
        }
    }

    // texels: the unit of those that it reads.
    template <class Parameters>
    void pass(int turn, const std::string& name, const Parameters& parameters,
              std::initializer_list<osg::Texture2D*> written, int texels = 0) {
        osg::Camera* const made = new osg::Camera;
        draw_to(*made, written);
        made->setReferenceFrame(ABSOLUTE_RF);
        made->setClearMask(0);
        made->addChild(triangle_);
        const std::string file =
            effect_ + (settings_.preset.orthographic ? "/orthographic/" : "/") + name + ".frag";
        if (!programs_[file])
            programs_[file] = program(osg::Shader::readShaderFile(osg::Shader::FRAGMENT, file));
        made->setStateSet(state(programs_[file]));
        osg::FloatArray* const data = new osg::FloatArray(32);
        data->setBufferObject(new osg::UniformBufferObject);
        data_.emplace_back(reinterpret_cast<const float*>(&parameters), sizeof parameters / 4, data);
        made->getStateSet()->setAttribute(new osg::UniformBufferBinding(0, data, 0, 128));
        made->getStateSet()->addUniform(new osg::Uniform("texel_image", texels));
        passes_[turn].push_back(made);
    }

    osg::Texture2D* image(GLint format, GLenum channels, GLenum type, int divisor = 1) const {
        osg::Texture2D* const made = new osg::Texture2D;
        const int* const size = settings_.size;
        made->setTextureSize((size[0] + divisor - 1) / divisor, (size[1] + divisor - 1) / divisor);
        made->setInternalFormat(format);
        made->setSourceFormat(channels);
        made->setSourceType(type);
        const auto filter = format == GL_RGB10_A2 ? osg::Texture::LINEAR : osg::Texture::NEAREST;
        made->setFilter(osg::Texture::MIN_FILTER, filter);
        made->setFilter(osg::Texture::MAG_FILTER, filter);
        made->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
        made->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
        return made;
    }

    static osg::Program* program(osg::Shader* fragment) {
        osg::Program* const made = new osg::Program;
        made->addShader(new osg::Shader(osg::Shader::VERTEX, R"(#version 330 core
            layout(location = 0) in vec2 corner;
            out vec2 at;
            void main() { at = 0.5 * corner + 0.5; gl_Position = vec4(corner, 0.0, 1.0); })"));
        made->addShader(fragment);
        made->addBindUniformBlock("Parameters", 0);
        return made;
    }

    static osg::StateSet* state(osg::Program* program) {
        osg::StateSet* const made = new osg::StateSet;
        made->setDataVariance(DYNAMIC);
        made->setAttribute(program, osg::StateAttribute::PROTECTED);
        made->setAttribute(new osg::PolygonMode, osg::StateAttribute::PROTECTED);  // no wireframe
        made->setMode(GL_DEPTH_TEST, osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
        for (const GLenum mode : {GL_BLEND, GL_CULL_FACE, GL_ALPHA_TEST, GL_SCISSOR_TEST})
            made->setMode(mode, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
        return made;
    }

    static void draw_to(osg::Camera& camera, std::initializer_list<osg::Texture2D*> written) {
        camera.setRenderOrder(PRE_RENDER);
        camera.setRenderTargetImplementation(FRAME_BUFFER_OBJECT);
        camera.setImplicitBufferAttachmentMask(0, 0);
        camera.setCullingActive(false);
        camera.setViewport(0, 0, (*written.begin())->getTextureWidth(),
                           (*written.begin())->getTextureHeight());
        int place = COLOR_BUFFER0;
        for (osg::Texture2D* texture : written) camera.attach(BufferComponent(place++), texture);
    }

    using Block = std::tuple<const float*, std::size_t, osg::ref_ptr<osg::FloatArray>>;
    std::string effect_;
    gloam_settings settings_;
    int deep_, turn_ = 0;
    gloam_frame frame_ = {};
    osg::Matrixd before_;
    osg::ref_ptr<osg::Geometry> triangle_ = new osg::Geometry;
    osg::ref_ptr<osg::StateSet> states_[2];
    std::vector<osg::ref_ptr<osg::Camera>> passes_[2];
    std::vector<Block> data_;
    std::map<std::string, osg::ref_ptr<osg::Program>> programs_;
};
