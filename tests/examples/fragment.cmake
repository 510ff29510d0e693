# SPDX-License-Identifier: MIT
# examples/fragment: packed for OpenGL 3.3 and OpenGL ES 3.0, compiled by glslang's own program for both, and drawn by
# Mesa where EGL is installed.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
find_program(GLSLANG NAMES glslangValidator glslang REQUIRED)
foreach(version 330 300es)
  set(shader "${WORK}/occlusion-${version}.frag")
  run("pack" "${GLOAM}" pack "${EXAMPLES}/fragment/occlusion.frag" --version ${version} --out "${shader}")
  run("glslang" "${GLSLANG}" "${shader}")
endforeach()

if(NOT DRAWS)
  message("skipped: the shaders compile; without libegl-dev and libgles-dev they are not drawn")
  return()
endif()
build(fragment)
set(ENV{LIBGL_ALWAYS_SOFTWARE} 1)
run("OpenGL 3.3" "${WORK}/build/packed_fragment" gl "${WORK}/occlusion-330.frag" "${WORK}/gl.pgm")
run("OpenGL ES 3.0" "${WORK}/build/packed_fragment" es "${WORK}/occlusion-300es.frag" "${WORK}/es.pgm")

# The whole library: Mesa keeps words for itself that glslang lets pass as names.
set(glsl "${EXAMPLES}/../glsl")
file(GLOB_RECURSE files RELATIVE "${glsl}" "${glsl}/gloam/*.glsl")
run("pack" "${GLOAM}" pack ${files} --version 330 --out "${WORK}/library-330.frag")
run("Mesa, OpenGL 3.3" "${WORK}/build/packed_fragment" gl --compile "${WORK}/library-330.frag")
run("pack" "${GLOAM}" pack ${files} --version 300es --out "${WORK}/library-300es.frag")
run("Mesa, OpenGL ES 3.0" "${WORK}/build/packed_fragment" es --compile "${WORK}/library-300es.frag")
