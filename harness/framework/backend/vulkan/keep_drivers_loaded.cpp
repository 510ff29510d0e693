// SPDX-License-Identifier: MIT
// In sanitizer builds only: libraries are never unloaded. The loader unloads drivers and layers with each
// instance. A report of their leaks would then lack the library's name, and the leaks could not be suppressed
// by name.
extern "C" int dlclose(void*) {
    return 0;
}
