# SPDX-License-Identifier: MIT
# examples/fragment: packed for OpenGL 3.3 and OpenGL ES 3.0, compiled by glslang's own program for both, and drawn by
# Mesa where EGL is installed.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
find_program(GLSLANG NAMES glslangValidator glslang REQUIRED)
foreach(version 330 300es)
  foreach(name blur occlusion method)
    set(shader "${WORK}/${name}-${version}.frag")
    run("pack" "${GLOAM}" pack "${EXAMPLES}/fragment/${name}.frag" --version ${version} --out "${shader}")
    run("glslang" "${GLSLANG}" "${shader}")
  endforeach()
endforeach()

if(NOT DRAWS)
  message("skipped: the shaders compile; without libegl-dev and libgles-dev they are not drawn")
  return()
endif()
build(fragment)
set(ENV{LIBGL_ALWAYS_SOFTWARE} 1)
run("OpenGL 3.3" "${WORK}/build/packed_fragment" gl "${WORK}/occlusion-330.frag" "${WORK}/gl.pgm")
run("OpenGL ES 3.0" "${WORK}/build/packed_fragment" es "${WORK}/occlusion-300es.frag" "${WORK}/es.pgm")

# A whole method is what `gloam render` makes of the same frame; with another radius it is not.
run("render" "${GLOAM}" render room --size 161x99 --frames 1 --preset tssao-paper --method sweep --samples 32
  --set steps=4 --radius 0.5 --no-filter --write-gbuffer "${WORK}/gbuffers" --out "${WORK}/rendered")
set(programs gl es)
set(versions 330 300es)
foreach(case IN ZIP_LISTS programs versions)
  set(command "${WORK}/build/packed_fragment" ${case_0} --method "${WORK}/method-${case_1}.frag"
    "${WORK}/gbuffers/f0000")
  run("method, ${case_0}" ${command} 0.5 "${WORK}/rendered/f0000_ao.pfm")
  execute_process(COMMAND ${command} 0.4 "${WORK}/rendered/f0000_ao.pfm" RESULT_VARIABLE status ERROR_VARIABLE error
    OUTPUT_QUIET)
  if(NOT status EQUAL 2 OR NOT error MATCHES "not what gloam has rendered")
    message(FATAL_ERROR "method, ${case_0}: another radius is not noticed: ${status} ${error}")
  endif()
endforeach()

# The whole library: Mesa keeps words for itself that glslang lets pass as names.
set(glsl "${EXAMPLES}/../glsl")
file(GLOB_RECURSE files RELATIVE "${glsl}" "${glsl}/gloam/*.glsl")
run("pack" "${GLOAM}" pack ${files} --version 330 --out "${WORK}/library-330.frag")
run("Mesa, OpenGL 3.3" "${WORK}/build/packed_fragment" gl --compile "${WORK}/library-330.frag")
run("pack" "${GLOAM}" pack ${files} --version 300es --out "${WORK}/library-300es.frag")
run("Mesa, OpenGL ES 3.0" "${WORK}/build/packed_fragment" es --compile "${WORK}/library-300es.frag")
