// SPDX-License-Identifier: MIT
#pragma once

namespace gloam::reference {

// Layers of depth that the references of the gathers see: what the eye sees, as the shaders do where
// GLOAM_LAYERS is not defined.
inline constexpr int gloam_layers = 1;

}  // namespace gloam::reference
