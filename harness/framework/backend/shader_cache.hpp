// SPDX-License-Identifier: MIT
#pragma once

namespace gloam::backend {

// Mesa maps the files of its shader cache into memory, and a process that writes to them where the disk is
// full ends by SIGBUS. Where less than 16 MiB are free, this tells the drivers to keep no cache, by
// MESA_SHADER_CACHE_DISABLE. Call it before a driver is loaded.
void spare_a_full_disk();

}  // namespace gloam::backend
