# SPDX-License-Identifier: MIT
# examples/vulkan from nothing but the folder that `gloam pack --effect` writes: what it shades is what `gloam render`
# shades, to the bit, frame by frame under a moving camera; and its check would see a difference.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
set(radius 0.3)
set(frames 4)
if(NOT SIZE)
  set(SIZE 161x99)
endif()
set(effect "${WORK}/effect")

separate_arguments(OPTIONS)  # of the pack alone
separate_arguments(INPUTS)   # of both: how depth and normals are stored, and the output

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
run("pack" "${GLOAM}" pack --effect --preset ${PRESET} --radius ${radius} ${OPTIONS} ${INPUTS} --out "${effect}")
build(vulkan "-DEFFECT=${effect}")
run("render" "${GLOAM}" render room --size ${SIZE} --frames ${frames} --preset ${PRESET} --radius ${radius} ${INPUTS}
  --write-gbuffer "${WORK}/gbuffers" --out "${WORK}/rendered")
run("example" "${WORK}/build/packed_effect" "${WORK}/gbuffers" "${WORK}/packed")

math(EXPR last "${frames} - 1")
foreach(frame RANGE ${last})
  set(name "f000${frame}_ao.pfm")
  file(SHA256 "${WORK}/rendered/${name}" rendered)
  file(SHA256 "${WORK}/packed/${name}" packed)
  if(NOT rendered STREQUAL packed)
    message(FATAL_ERROR "${PRESET}: ${name} is not what gloam render has written")
  endif()
  list(APPEND pictures ${rendered})
endforeach()
list(REMOVE_DUPLICATES pictures)
list(LENGTH pictures count)
if(NOT count EQUAL frames)
  message(FATAL_ERROR "of ${frames} frames some are the same: ${pictures}")
endif()
