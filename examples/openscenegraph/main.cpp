// SPDX-License-Identifier: MIT
// gloam_osg --compare: a bunny's ambient occlusion beside what is traced. gloam_osg --check: whether it is
// right while the camera moves, after another size and for an orthographic camera. gloam_osg MODEL RADIUS
// shows a model.
#include "GloamAO.h"

#include <osg/Geode>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>
#include <osgUtil/SmoothingVisitor>
#include <osgViewer/Viewer>

#include "../compare.hpp"

// Keeps what is drawn, and its depth: rows from the bottom up.
struct Kept : osg::Camera::DrawCallback {
    void operator()(osg::RenderInfo& info) const override {
        const osg::Viewport& size = *info.getCurrentCamera()->getViewport();
        picture->readPixels(0, 0, int(size.width()), int(size.height()), GL_RGB, GL_UNSIGNED_BYTE);
        if (depth_of != nullptr) info.getState()->applyTextureAttribute(0, depth_of->depth);
        if (depth_of != nullptr) depth->readImageFromCurrentTexture(info.getContextID(), false, GL_FLOAT);
        if (glGetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL reports an error");
    }
    osg::ref_ptr<osg::Image> picture = new osg::Image, depth = new osg::Image;
    const GloamAO* depth_of = nullptr;
};

struct View {
    explicit View(const Comparison& of) : of(of) {
        const osg::ref_ptr<osg::Geometry> mesh = new osg::Geometry;
        osg::Vec3Array* const points = new osg::Vec3Array;
        for (const auto& [x, y, z] : of.points) points->push_back({x, y, z});
        mesh->setVertexArray(points);
        const osg::Vec4 white(1, 1, 1, 1);
        mesh->setColorArray(new osg::Vec4Array(1, &white), osg::Array::BIND_OVERALL);
        mesh->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, GLsizei(points->size())));
        osgUtil::SmoothingVisitor::smooth(*mesh);
        occluded->addChild(mesh);
        viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
        viewer.setUpViewInWindow(0, 0, of.width, of.height);
        if (camera.getGraphicsContext() == nullptr) throw std::runtime_error("no display: see xvfb-run");
        camera.getGraphicsContext()->getState()->setCheckForGLErrors(osg::State::NEVER_CHECK_GL_ERRORS);
        camera.setFinalDrawCallback(kept);
    }
    // The least time of eight frames, ms, of a camera that turns.
    double draw(osg::Node* scene, bool lit, bool orthographic = false, double turn = 0) {
        const double aspect = double(of.width) / of.height;
        double angle = 0;
        scene->getOrCreateStateSet()->setMode(GL_LIGHTING, lit);
        viewer.setSceneData(scene);
        camera.setViewport(0, 0, of.width, of.height);
        camera.setProjectionMatrixAsPerspective(of.angle, aspect, 1, 10);
        if (orthographic) camera.setProjectionMatrixAsOrtho(-2 * aspect, 2 * aspect, -2, 2, 1, 10);
        return of.least_time(8, [&] {
            camera.setViewMatrix(osg::Matrixf(of.view.data()) * osg::Matrix::rotate(angle += turn, 1, 2, 0));
            viewer.frame();
        });
    }
    double error(const Picture& occlusion) {
        return of.error(std::as_const(*kept->picture).data(), occlusion);
    }
    Comparison of;
    osgViewer::Viewer viewer;
    osg::Camera& camera = *viewer.getCamera();
    const osg::ref_ptr<GloamAO> occluded = new GloamAO(EFFECT, PRESET, of.radius);
    const osg::ref_ptr<Kept> kept = new Kept;
};

void compare(View view) {
    view.draw(view.occluded, true);
    osgDB::writeImageFile(*view.kept->picture, "compared/openscenegraph.png");
    view.of.print_head();
    for (osg::Node* scene : {view.occluded->getChild(0), static_cast<osg::Node*>(view.occluded)}) {
        const double time = view.draw(scene, false);
        view.of.print_row(scene == view.occluded ? "GloamAO" : "none", view.error(view.of.truth), time);
    }
}

// Whether pictures are near to what is traced, or what `gloam render` makes of their depth.
bool check(View view) {
    view.draw(view.occluded, false);
    const double traced = view.error(view.of.truth);
    double worst = 0;
    std::printf("beside what is traced: %.4f\n", traced);
    for (const char* const kind : {"moving", "resized", "orthographic"}) {
        if (*kind == 'r') view.of.width = 500, view.of.height = 333;
        view.kept->depth_of = view.occluded;
        view.draw(view.occluded, false, *kind == 'o', 0.01);
        const auto* const depth = reinterpret_cast<const float*>(view.kept->depth->data());
        const double apart = view.error(view.of.rendered(depth, view.occluded->projection->ptr()));
        std::printf("%s, beside gloam render: %.4f\n", kind, apart);
        worst = std::max(worst, apart);
    }
    return traced < 0.0114 && worst < 0.0065;  // where the history lags: 0.007
}

int main(int count, char** arguments) {
    const std::string first = count > 1 ? arguments[1] : "--compare";
    if (first == "--compare") return compare(View(Comparison(GLOAM))), 0;
    if (first == "--check") return check(View(Comparison(GLOAM))) ? 0 : 1;
    const float radius = count > 2 ? std::strtof(arguments[2], nullptr) : 1;
    const osg::ref_ptr<GloamAO> occluded = new GloamAO(EFFECT, PRESET, radius);
    occluded->addChild(osgDB::readNodeFile(first));
    osgViewer::Viewer viewer;
    viewer.setSceneData(occluded);
    return viewer.run();
}
