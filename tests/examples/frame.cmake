# SPDX-License-Identifier: MIT
# examples/vulkan or examples/opengl from nothing but the folder that `gloam pack --effect` writes: in 40 frames of a
# moving view, with a cut and another size among them, it shows what `gloam render` shows.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
set(ENV{LIBGL_ALWAYS_SOFTWARE} 1)
run("pack" "${GLOAM}" pack --effect --preset ${PRESET} --normals ${NORMALS} --version ${VERSION} --set deep=${DEEP} --out "${WORK}/effect")
build(${EXAMPLE} "-DEFFECT=${WORK}/effect" -DPRESET=${PRESET})
sequence("${WORK}/gbuffers" --preset ${PRESET} --radius 0.3 --depth ${DEPTH} --normals ${NORMALS} --set deep=${DEEP})
run("example" "${WORK}/build/${EXAMPLE}_frame" "${WORK}/gbuffers" "${WORK}/shown" 0.3 ${DEPTH})
run("compare" "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/compare.py" "${WORK}/rendered" "${WORK}/shown" ${APART})

# The same by left-handed cameras.
run("mirror" "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/mirror.py" "${WORK}/gbuffers" ${NORMALS})
run("left example" "${WORK}/build/${EXAMPLE}_frame" "${WORK}/gbuffers" "${WORK}/left" 0.3 ${DEPTH})
run("left" "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/compare.py" "${WORK}/shown" "${WORK}/left" 0)
run("left render" "${GLOAM}" render --gbuffer "${WORK}/gbuffers" --preset ${PRESET} --radius 0.3 --depth ${DEPTH}
  --normals ${NORMALS} --set deep=${DEEP} --out "${WORK}/left_rendered")
run("left" "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/compare.py" "${WORK}/rendered" "${WORK}/left_rendered" 0)
