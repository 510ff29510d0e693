// SPDX-License-Identifier: MIT
// gloam_osg MODEL RADIUS shows a model; with SHOTS RESULT behind it draws what compare.py asks.
#include "GloamAO.h"

#include <osgDB/ReadFile>
#include <osgViewer/Viewer>

#include "../shots.hpp"

// Keeps the red of what is drawn.
struct Kept : osg::Camera::DrawCallback {
    void operator()(osg::RenderInfo& info) const override {
        const osg::Viewport& size = *info.getCurrentCamera()->getViewport();
        picture->readPixels(0, 0, int(size.width()), int(size.height()), GL_RED, GL_UNSIGNED_BYTE);
        if (glGetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL reports an error");
    }
    osg::ref_ptr<osg::Image> picture = new osg::Image;
};

int main(int count, char** arguments) try {
    if (count != 3 && count != 5) throw std::runtime_error("expected MODEL RADIUS [SHOTS RESULT]");
    const osg::ref_ptr<osgDB::Options> turned = new osgDB::Options(count == 5 ? "noRotation" : "");
    const osg::ref_ptr<osg::Node> model = osgDB::readRefNodeFile(arguments[1], turned);
    if (!model) throw std::runtime_error(arguments[1] + std::string(": cannot read the model"));
    const osg::ref_ptr<GloamAO> occluded = new GloamAO(EFFECT, PRESET, std::stof(arguments[2]));
    occluded->addChild(model);
    osgViewer::Viewer viewer;
    viewer.setSceneData(occluded);
    if (count == 3) return viewer.run();

    osg::Camera& camera = *viewer.getCamera();
    const osg::ref_ptr<Kept> kept = new Kept;
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    viewer.setUpViewInWindow(0, 0, 640, 480);
    if (camera.getGraphicsContext() == nullptr) throw std::runtime_error("no display: see xvfb-run");
    camera.getGraphicsContext()->getState()->setCheckForGLErrors(osg::State::NEVER_CHECK_GL_ERRORS);
    camera.setFinalDrawCallback(kept);
    model->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);  // white
    const auto look = [&](std::size_t pass, const Shot& shot) {
        viewer.setSceneData(pass == 0 ? model : osg::ref_ptr<osg::Node>(occluded));
        occluded->restart();
        const double aspect = shot.width / shot.height, half = shot.tall / 2;
        camera.setViewport(0, 0, int(shot.width), int(shot.height));
        camera.setProjectionMatrixAsPerspective(shot.fovy, aspect, 1, 10);
        if (half > 0) camera.setProjectionMatrixAsOrtho(-half * aspect, half * aspect, -half, half, 1, 10);
    };
    const auto frame = [&](const Shot& shot) {
        const auto& [x, y, z] = shot.eye;
        const auto& [u, v, w] = shot.target;
        camera.setViewMatrixAsLookAt({x, y, z}, {u, v, w}, {0, 1, 0});
        viewer.frame();
        const char* const red = reinterpret_cast<const char*>(kept->picture->data());
        return std::string(red, kept->picture->getTotalSizeInBytes());
    };
    each_shot(arguments + 3, {"none", "gloam"}, look, frame);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "gloam_osg: %s\n", error.what());
    return 2;
}
