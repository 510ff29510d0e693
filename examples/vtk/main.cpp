// SPDX-License-Identifier: MIT
// gloam_vtk --compare: a bunny's occlusion by vtkSSAOPass and by vtkGloamPass, beside what is true. gloam_vtk
// --check: vtkGloamPass after another size and with a parallel camera.
#include <vtkActor.h>
#include <vtkPNGWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include "../compare.hpp"
#include "vtkGloamPass.h"

int main(int count, char** arguments) try {
    const std::string what = count == 2 ? arguments[1] : "";
    if (what != "--compare" && what != "--check") throw std::runtime_error("expected --compare or --check");
    const Comparison of(GLOAM);
    vtkNew<vtkPolyData> mesh;
    vtkNew<vtkPoints> points;
    mesh->SetPoints(points);
    mesh->AllocateEstimate(vtkIdType(of.points.size() / 3), 3);
    for (const auto& [x, y, z] : of.points) {
        const vtkIdType i = points->InsertNextPoint(x, y, z), triangle[] = {i - 2, i - 1, i};
        if (i % 3 == 2) mesh->InsertNextCell(VTK_TRIANGLE, 3, triangle);
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
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
    window->SetSize(of.width, of.height);
    vtkNew<vtkTransform> to_world;
    double rows[16];
    for (int i = 0; i < 16; ++i) rows[i] = of.view[i % 4 * 4 + i / 4];
    to_world->SetMatrix(rows);
    to_world->Inverse();
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0, 0, 0);
    camera->SetFocalPoint(0, 0, -1);
    camera->ApplyTransform(to_world);
    camera->SetViewAngle(of.angle);
    camera->SetClippingRange(0.5, 300);

    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkGloamPass> gloam;
    gloam->SetDelegatePass(steps);
    gloam->SetRadius(of.radius);
    renderer->SetPass(gloam);
    vtkNew<vtkSSAOPass> own;
    own->SetDelegatePass(steps);
    own->SetRadius(of.radius);
    own->BlurOn();
    const auto time = [&](int frames) {
        return of.least_time(frames, [&] { window->Render(), window->WaitForCompletion(); });
    };
    const auto error = [&](const Picture& occlusion) {
        vtkNew<vtkUnsignedCharArray> picture;
        window->GetPixelData(0, 0, of.width - 1, of.height - 1, 0, picture);
        return of.error(picture->GetPointer(0), occlusion);
    };
    const auto row = [&](const std::string& pass) {
        const double least = time(8);
        of.print_row(pass, error(of.truth), least);
        vtkNew<vtkWindowToImageFilter> picture;
        picture->SetInput(window);
        vtkNew<vtkPNGWriter> writer;
        writer->SetInputConnection(picture->GetOutputPort());
        writer->SetFileName(("compared/" + pass + ".png").c_str());
        writer->Write();
    };

    if (what == "--compare") {
        of.print_head();
        renderer->SetPass(nullptr);
        row("none");
        renderer->SetPass(own);
        row("vtkSSAOPass");
        renderer->SetPass(gloam);
        for (const auto& [preset, numbers] : gloam_presets) {
            gloam->SetPreset(preset);
            row("vtkGloamPass " + preset);
        }
    } else {
        window->SetSize(300, 200);
        time(2);
        window->SetSize(of.width, of.height);
        time(8);
        const double resized = error(of.truth);
        camera->ParallelProjectionOn();
        renderer->ResetCamera(-1, 1, 0, 2, -1, 1);  // about the bunny
        renderer->ResetCameraClippingRange();
        time(1);
        std::vector<float> depth(of.truth.values.size());
        window->GetZbufferData(0, 0, of.width - 1, of.height - 1, depth.data());
        vtkNew<vtkMatrix4x4> columns;
        columns->Transpose(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1),
                           columns);
        const double parallel = error(of.rendered(depth.data(), columns->GetData()));
        std::printf("error after another size %.4f, of a parallel camera beside gloam render %.4f\n", resized,
                    parallel);
        if (resized > 0.012 || parallel > 0.012) throw std::runtime_error("expected at most 0.012");
    }
    if (const GLenum wrong = glGetError()) throw std::runtime_error("OpenGL error " + std::to_string(wrong));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "gloam_vtk: %s\n", error.what());
    return 2;
}
