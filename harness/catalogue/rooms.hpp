// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"

// One function for each folder of the shader library; each appends the folder's equations.
namespace gloam::catalogue {

void append_numeric(Entries& entries);
void append_sampling(Entries& entries);
void append_geometry(Entries& entries);
void append_occlusion(Entries& entries);
void append_temporal(Entries& entries);
void append_filter(Entries& entries);
void append_shading(Entries& entries);
void append_builtins(Entries& entries);

}  // namespace gloam::catalogue
