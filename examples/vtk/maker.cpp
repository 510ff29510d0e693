// SPDX-License-Identifier: MIT
// The pass for Python: the text by which vtkmodules takes an object, or what is wrong. version: the VTK of
// the caller, whose classes have to be those that this library was built for.
#include <vtkVersionMacros.h>

#include "vtkGloamPass.h"

extern "C" const char* gloam_pass(const char* version, const char* preset) {
    static std::string text;
    text = std::string("gloam was built for VTK " VTK_VERSION ", not ") + version;
    if (version != std::string(VTK_VERSION)) return text.c_str();
    text = std::string("expected fast, balanced, quality or reference, found ") + preset;
    if (gloam_presets.count(preset) == 0) return text.c_str();
    vtkGloamPass* pass = vtkGloamPass::New();
    pass->SetPreset(preset);
    std::ostringstream address;
    address << "_" << std::hex << reinterpret_cast<std::size_t>(static_cast<vtkObjectBase*>(pass))
            << "_p_void";
    return (text = address.str()).c_str();
}
