# SPDX-License-Identifier: MIT
# examples/vulkan or examples/opengl from nothing but the folder that `gloam pack --effect` writes: in 40 frames of a
# moving view, with a cut and another size among them, it shows what `gloam render` shows.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
set(ENV{LIBGL_ALWAYS_SOFTWARE} 1)
run("pack" "${GLOAM}" pack --effect --preset ${PRESET} --normals ${NORMALS} --version ${VERSION} --set ${SET} --out "${WORK}/effect")
# With Vulkan's validation layers; newer ones check what shaders access by the last word alone.
set(example ${CMAKE_COMMAND} -E env VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation
  VK_LAYER_ENABLES=VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT
  VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC=true "${WORK}/build/${EXAMPLE}_frame" "${WORK}/gbuffers")
build(${EXAMPLE} "-DEFFECT=${WORK}/effect" -DPRESET=${PRESET})
sequence("${WORK}/gbuffers" --preset ${PRESET} --radius 0.3 --depth ${DEPTH} --normals ${NORMALS} --set ${SET})
run("example" ${example} "${WORK}/shown" 0.3 ${DEPTH})
run("compare" "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/compare.py" "${WORK}/rendered" "${WORK}/shown" ${APART})

# The same by left-handed cameras.
run("mirror" "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/mirror.py" "${WORK}/gbuffers" ${NORMALS})
run("left example" ${example} "${WORK}/left" 0.3 ${DEPTH})
run("left" "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/compare.py" "${WORK}/shown" "${WORK}/left" 0)
run("left render" "${GLOAM}" render --gbuffer "${WORK}/gbuffers" --preset ${PRESET} --radius 0.3 --depth ${DEPTH}
  --normals ${NORMALS} --set ${SET} --out "${WORK}/left_rendered")
run("left" "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/compare.py" "${WORK}/rendered" "${WORK}/left_rendered" 0)
