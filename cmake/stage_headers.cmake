# SPDX-License-Identifier: MIT
# Copies the headers of `rooms` from `source` to stage/gloam/ROOM, each #include "ROOM/FILE" turned into
# #include "gloam/ROOM/FILE": rooms have short names, and an installed header must not meet another project's "base/".
file(REMOVE_RECURSE "${stage}")
list(JOIN rooms "|" any_room)
foreach(room ${rooms})
  file(GLOB_RECURSE headers RELATIVE "${source}" "${source}/${room}/*.hpp")
  list(FILTER headers EXCLUDE REGEX "/internal/")
  foreach(header ${headers})
    file(READ "${source}/${header}" text)
    string(REGEX REPLACE "#include \"((${any_room})/[^\"]+)\"" "#include \"gloam/\\1\"" text "${text}")
    file(WRITE "${stage}/gloam/${header}" "${text}")
  endforeach()
endforeach()
file(COPY "${CMAKE_CURRENT_LIST_DIR}/shader_test.hpp" DESTINATION "${stage}/gloam")
