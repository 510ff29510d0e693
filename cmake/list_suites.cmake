# SPDX-License-Identifier: MIT
# cmake -D PROGRAM=file -D PREFIX=name -D OUTPUT=file -D ENVIRONMENT=list -D SEEN=folder -P list_suites.cmake
# Writes one ctest test for each suite of a GoogleTest program: the tests of a suite share a process and its device. A
# suite of many tests becomes several ctest tests, so that every core has work. SEEN gets a file for each ctest test,
# which lists the shaders that it reads (tools/test-readers; a / in a name is a comma there).
set(most_tests 48)
# The groups that take longest, in seconds. ctest starts these first, before it has measured any of them. It measures
# the others itself: it would not where they had a COST.
set(long_groups cli.Stories_drivers 40 cli.Stories_hostile 40 cli.All/PoisonOf/1of2 20 cli.All/PoisonOf/2of2 20
  closed_form.All/ClosedForm/2of2 30
  effect.All/Prepared 15 closed_form.All/ClosedForm/1of2 20
  experiment.TemporalQuality 20 catalogue.CatalogueCoverage 20 cli.Stories_pack 20 effect.Pictures 35)

execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listing RESULT_VARIABLE status)
if(status)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: exit status ${status}, expected 0")
endif()
string(REPLACE ";" "," listing "${listing}")
string(REPLACE "\n" ";" lines "${listing}")
set(script)

function(add_group NAME FILTER SHARDS INDEX)
  string(REPLACE "/" "," seen "${NAME}")
  set(variables "${ENVIRONMENT}" "GLOAM_DEPENDENCIES_OUTPUT=${SEEN}/${seen}")
  if(SHARDS GREATER 1)
    list(APPEND variables GTEST_TOTAL_SHARDS=${SHARDS} GTEST_SHARD_INDEX=${INDEX})
  endif()
  set(cost)
  list(FIND long_groups "${NAME}" place)
  if(NOT place EQUAL -1)
    math(EXPR place "${place} + 1")
    list(GET long_groups ${place} seconds)
    set(cost "COST ${seconds} ")
  endif()
  string(APPEND script "add_test([==[${NAME}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${FILTER}]==])\n"
    "set_tests_properties([==[${NAME}]==] PROPERTIES TIMEOUT 900 ${cost}ENVIRONMENT [==[${variables}]==])\n")
  set(script "${script}" PARENT_SCOPE)
endfunction()

function(add_suite NAME COUNT)
  if(COUNT EQUAL 0)
    return()
  endif()
  math(EXPR shards "(${COUNT} + ${most_tests} - 1) / ${most_tests}")
  foreach(number RANGE 1 ${shards})
    math(EXPR index "${number} - 1")
    set(name "${PREFIX}.${NAME}")
    if(shards GREATER 1)
      string(APPEND name "/${number}of${shards}")
    endif()
    add_group("${name}" "${NAME}.*" ${shards} ${index})
  endforeach()
  set(script "${script}" PARENT_SCOPE)
endfunction()

set(suite)
set(count 0)
foreach(line IN LISTS lines)
  string(REGEX REPLACE " *#.*" "" line "${line}")
  if(line MATCHES "^([^ ].*)\\.$")
    set(next "${CMAKE_MATCH_1}")
    add_suite("${suite}" ${count})
    set(suite "${next}")
    set(count 0)
  elseif(line MATCHES "^  [^ ]" AND NOT line MATCHES "^  DISABLED_")
    math(EXPR count "${count} + 1")
  endif()
endforeach()
add_suite("${suite}" ${count})
file(WRITE "${OUTPUT}" "${script}")
