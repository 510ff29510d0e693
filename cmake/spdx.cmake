# SPDX-License-Identifier: MIT
# Writes gloam.spdx.json, an SPDX 2.3 document of what is installed and what is compiled into it, with the licences.
# spdx_document is its path. Libraries that the program loads, shared ones, are not part of it.
set(spdx_document ${PROJECT_BINARY_DIR}/gloam.spdx.json)
set(spdx_packages)
set(spdx_relations)

# gloam_spdx_package(NAME VERSION LICENCE COPYRIGHT PURL): a package of the document; VERSION and PURL may be empty.
function(gloam_spdx_package NAME VERSION LICENCE COPYRIGHT PURL)
  string(REPLACE "_" "-" id ${NAME})
  string(CONCAT text "{\"SPDXID\": \"SPDXRef-${id}\", \"name\": \"${NAME}\", "
    "\"downloadLocation\": \"NOASSERTION\", \"filesAnalyzed\": false, \"licenseConcluded\": \"${LICENCE}\", "
    "\"licenseDeclared\": \"${LICENCE}\", \"copyrightText\": \"${COPYRIGHT}\"")
  if(VERSION)
    string(APPEND text ", \"versionInfo\": \"${VERSION}\"")
  endif()
  if(PURL)
    string(APPEND text ", \"externalRefs\": [{\"referenceCategory\": \"PACKAGE-MANAGER\", \"referenceType\": \"purl\", "
      "\"referenceLocator\": \"${PURL}\"}]")
  endif()
  set(spdx_packages ${spdx_packages} "${text}}" PARENT_SCOPE)
endfunction()

# gloam_spdx_relation(FROM TYPE TO), as in "SPDXRef-gloam STATIC_LINK SPDXRef-glslang".
function(gloam_spdx_relation FROM TYPE TO)
  string(REPLACE "_" "-" TO ${TO})
  string(CONCAT text "{\"spdxElementId\": \"SPDXRef-${FROM}\", \"relationshipType\": \"${TYPE}\", "
    "\"relatedSpdxElement\": \"SPDXRef-${TO}\"}")
  set(spdx_relations ${spdx_relations} "${text}" PARENT_SCOPE)
endfunction()

file(STRINGS LICENSE spdx_copyright REGEX "^Copyright")
set(spdx_parts gloam-shader-test gloam-glsl)
if(NOT GLOAM_FRAMEWORK_ONLY)
  list(APPEND spdx_parts gloam)
endif()
foreach(part ${spdx_parts})
  gloam_spdx_package(${part} ${PROJECT_VERSION} MIT "${spdx_copyright}" "")
  gloam_spdx_relation(DOCUMENT DESCRIBES ${part})
endforeach()

# Headers and static libraries that are compiled in: who has it, name, version, licence.
set(spdx_libraries
  "gloam-shader-test|stb||MIT OR Unlicense"
  "gloam-shader-test|xxHash||BSD-2-Clause"
  "gloam-shader-test|Vulkan-Hpp|${Vulkan_VERSION}|Apache-2.0 OR MIT"
  "gloam-shader-test|glm|${glm_VERSION}|MIT"
  "gloam-shader-test|nlohmann_json|${nlohmann_json_VERSION}|MIT")
if(NOT GLOAM_FRAMEWORK_ONLY)
  set(of_glslang "BSD-3-Clause AND BSD-2-Clause AND MIT AND Apache-2.0 AND AML AND (GPL-3.0-or-later WITH ")
  string(APPEND of_glslang "Bison-exception-2.2)")
  list(APPEND spdx_libraries
    "gloam|glslang|${glslang_VERSION}|${of_glslang}"
    "gloam|SPIRV-Tools|${SPIRV-Tools_VERSION}|Apache-2.0"
    "gloam|CLI11|${CLI11_VERSION}|BSD-3-Clause")
  if(spirv_cross_target STREQUAL "spirv-cross-c")
    list(APPEND spdx_libraries "gloam|SPIRV-Cross||Apache-2.0 OR MIT")
  endif()
  gloam_spdx_relation(gloam STATIC_LINK gloam-shader-test)
  gloam_spdx_relation(gloam DEPENDS_ON gloam-glsl)
endif()
foreach(row ${spdx_libraries})
  string(REPLACE "|" ";" row "${row}")
  list(GET row 0 part)
  list(GET row 1 name)
  list(GET row 2 version)
  list(GET row 3 licence)
  gloam_spdx_package(${name} "${version}" "${licence}" NOASSERTION "")
  gloam_spdx_relation(${part} STATIC_LINK ${name})
endforeach()

string(TIMESTAMP spdx_time UTC)
string(SHA256 spdx_key "${PROJECT_VERSION} ${spdx_packages}")
string(JOIN ",\n    " spdx_packages ${spdx_packages})
string(JOIN ",\n    " spdx_relations ${spdx_relations})
file(WRITE ${spdx_document} "{
  \"spdxVersion\": \"SPDX-2.3\",
  \"dataLicense\": \"CC0-1.0\",
  \"SPDXID\": \"SPDXRef-DOCUMENT\",
  \"name\": \"gloam-${PROJECT_VERSION}\",
  \"documentNamespace\": \"https://spdx.org/spdxdocs/gloam-${PROJECT_VERSION}-${spdx_key}\",
  \"creationInfo\": {\"created\": \"${spdx_time}\", \"creators\": [\"Tool: gloam-${PROJECT_VERSION}\"]},
  \"packages\": [
    ${spdx_packages}
  ],
  \"relationships\": [
    ${spdx_relations}
  ]
}
")
