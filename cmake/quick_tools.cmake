# SPDX-License-Identifier: MIT
# ccache and mold, used where they are installed and needed nowhere. -DGLOAM_QUICK_TOOLS=OFF does without.
option(GLOAM_QUICK_TOOLS "Compile through ccache and link with mold where they are installed" ON)
if(NOT GLOAM_QUICK_TOOLS)
  return()
endif()

find_program(GLOAM_CCACHE ccache)
if(GLOAM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # ccache requires these two kinds of sloppiness for precompiled headers. Checkouts do not share results, because
  # ccache once gave the precompiled header of one checkout to another.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${GLOAM_CCACHE})
endif()

find_program(GLOAM_MOLD mold)
if(GLOAM_MOLD)
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=mold GLOAM_LINKS_WITH_MOLD)
  if(GLOAM_LINKS_WITH_MOLD)
    add_link_options(-fuse-ld=mold)
  endif()
endif()
