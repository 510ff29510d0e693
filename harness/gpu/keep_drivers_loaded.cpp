// SPDX-License-Identifier: MIT
// In sanitizer builds only: libraries are never unloaded. The loader unloads drivers and layers with each
// instance, and what they leak then has no library's name any more in a report, so that nothing could be
// suppressed by name.
extern "C" int dlclose(void*) {
    return 0;
}
