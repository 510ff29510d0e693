// SPDX-License-Identifier: MIT
// gloam_vtk MODEL RADIUS SHOTS RESULT: an OBJ file by vtkSSAOPass and by vtkGloamPass, as compare.py asks.
#include <vtkActor.h>
#include <vtkOBJReader.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkUnsignedCharArray.h>

#include "../shots.hpp"
#include "vtkGloamPass.h"

int main(int count, char** arguments) try {
    if (count != 5) throw std::runtime_error("expected MODEL RADIUS SHOTS RESULT");
    vtkNew<vtkOBJReader> model;
    model->SetFileName(arguments[1]);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(model->GetOutputPort());
    vtkNew<vtkActor> actor;  // white in ambient light alone: its color is the visibility
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(1);
    actor->GetProperty()->SetDiffuse(0);
    vtkNew<vtkRenderer> renderer;
    renderer->AddActor(actor);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->AddRenderer(renderer);

    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkGloamPass> gloam;
    vtkNew<vtkSSAOPass> own;
    own->BlurOn();
    for (vtkSSAOPass* pass : {own.Get(), static_cast<vtkSSAOPass*>(gloam)}) {
        pass->SetDelegatePass(steps);
        pass->SetRadius(std::stod(arguments[2]));
    }
    std::vector<std::string> passes{"none", "vtkSSAOPass"};
    for (const auto& [preset, numbers] : gloam_presets) passes.push_back("gloam, " + preset);

    const auto look = [&](std::size_t pass, const Shot& shot) {
        renderer->SetPass(pass == 0 ? nullptr : pass == 1 ? own.Get() : static_cast<vtkSSAOPass*>(gloam));
        if (pass > 1) gloam->SetPreset(passes[pass].substr(7));
        gloam->Cut();
        window->SetSize(int(shot.width), int(shot.height));
        vtkCamera* camera = renderer->GetActiveCamera();
        camera->SetViewAngle(shot.fovy);
        camera->SetParallelProjection(shot.tall > 0);
        camera->SetParallelScale(shot.tall / 2);
        camera->SetFocalPoint(shot.target);
    };
    const auto frame = [&](const Shot& shot) {
        renderer->GetActiveCamera()->SetPosition(shot.eye);
        renderer->GetActiveCamera()->SetClippingRange(0.02 * renderer->GetActiveCamera()->GetDistance(), 300);
        window->Render();
        vtkNew<vtkUnsignedCharArray> picture;
        window->GetPixelData(0, 0, int(shot.width) - 1, int(shot.height) - 1, 0, picture);
        std::string red(picture->GetNumberOfTuples(), 0);
        for (std::size_t i = 0; i < red.size(); ++i) red[i] = char(picture->GetValue(3 * vtkIdType(i)));
        return red;
    };
    each_shot(arguments + 3, passes, look, frame);
    if (const GLenum wrong = glGetError()) throw std::runtime_error("OpenGL error " + std::to_string(wrong));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "gloam_vtk: %s\n", error.what());
    return 2;
}
