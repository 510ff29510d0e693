# SPDX-License-Identifier: MIT
# run(WHAT command...): stops the test when the command fails, or Vulkan's validation layers report something.
function(run WHAT)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0 OR output MATCHES "Validation (Error|Warning)")
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${WHAT}: exit status ${status}\n${command}\n${output}")
  endif()
endfunction()

# build(NAME option...): configures and builds the example of that name in ${WORK}/build.
function(build NAME)
  run("configure" "${CMAKE_COMMAND}" -G Ninja -S "${EXAMPLES}/${NAME}" -B "${WORK}/build"
    "-DCMAKE_CXX_COMPILER=${COMPILER}"
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-Wall\ -Wextra\ -Werror ${ARGN})
  run("build" "${CMAKE_COMMAND}" --build "${WORK}/build")
endfunction()

# sequence(FOLDER option...): G-buffers of 40 frames of a moving view, as `gloam render` writes them with these options,
# and in FOLDER/../rendered what it makes of them. The camera cuts at frame 10, and from frame 20 on the view is smaller.
function(sequence FOLDER)
  file(REMOVE_RECURSE "${FOLDER}" "${WORK}/second")
  run("render" "${GLOAM}" render moving --size 161x99 --frames 20 ${ARGN} --write-gbuffer "${FOLDER}" --out "${WORK}/first")
  run("render" "${GLOAM}" render moving --size 96x54 --frame 20 --frames 20 ${ARGN} --write-gbuffer "${WORK}/second"
    --out "${WORK}/first")
  foreach(kind .json _depth.pfm _normal.pfm)
    foreach(frame RANGE 19)
      string(REGEX MATCH "..$" from "0${frame}")
      math(EXPR to "${frame} + 20")
      file(RENAME "${WORK}/second/f00${from}${kind}" "${FOLDER}/f00${to}${kind}")
    endforeach()
  endforeach()
  file(GLOB others "${FOLDER}/*_motion.pfm" "${FOLDER}/*_previous_depth.pfm" "${FOLDER}/*_color.pfm")
  file(REMOVE ${others})
  file(READ "${FOLDER}/f0010.json" json)
  string(REGEX REPLACE "\"(prev_view|previous_from_current)\"" "\"no_\\1\"" json "${json}")
  file(WRITE "${FOLDER}/f0010.json" "${json}")
  run("render" "${GLOAM}" render --gbuffer "${FOLDER}" ${ARGN} --out "${WORK}/rendered")
endfunction()
