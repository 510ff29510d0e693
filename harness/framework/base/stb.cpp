// SPDX-License-Identifier: MIT
// The implementation of stb's single-header library.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
