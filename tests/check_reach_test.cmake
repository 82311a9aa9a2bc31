# The checker of what folders compile without catches what is planted, however far away, and lets a clean tree pass.
# Run: cmake -DCHECKER=<check_reach.cmake> -DSCRATCH=<folder> -P check_reach_test.cmake

cmake_minimum_required(VERSION 3.25)

function(check name expected_result expected_text)
  execute_process(COMMAND "${CMAKE_COMMAND}" "-DROOT=${SCRATCH}" -P "${CHECKER}"
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0)
    set(result passes)
  else()
    set(result fails)
  endif()
  string(FIND "${output}" "${expected_text}" at)
  if(NOT result STREQUAL expected_result OR at EQUAL -1)
    message(FATAL_ERROR "${name}: expected that it ${expected_result} with '${expected_text}', it ${result} with:\n${output}")
  endif()
  message(STATUS "${name}: ${result}, as it should")
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
file(WRITE "${SCRATCH}/render/shape/shape.h" "#pragma once\n")
file(WRITE "${SCRATCH}/render/texture/pigment.h" "#pragma once\n")
file(WRITE "${SCRATCH}/render/scene/solid.h" "#pragma once\n#include \"render/shape/shape.h\"\n")
file(WRITE "${SCRATCH}/render/scene/scene.h" "#pragma once\n#include \"render/scene/solid.h\"\n")
file(WRITE "${SCRATCH}/render/trace/step.h" "#pragma once\n  #  include <render/texture/pigment.h>\n")
file(WRITE "${SCRATCH}/render/trace/task.h" "#pragma once\n#include \"priority/round.h\"\n#include <vector>\n")
file(WRITE "${SCRATCH}/priority/round.h" "#pragma once\n#include \"render/trace/task.h\"\n")
file(WRITE "${SCRATCH}/parser/parser.cpp" "#include \"render/scene/scene.h\"\n")
check("a clean tree, with a circle" passes "compile without")

file(WRITE "${SCRATCH}/priority/far.cpp" "#include \"priority/round.h\"\n#include \"render/scene/scene.h\"\n")
check("a shape behind two headers" fails "render/scene/scene.h -> render/scene/solid.h -> render/shape/shape.h")
file(REMOVE "${SCRATCH}/priority/far.cpp")

file(WRITE "${SCRATCH}/priority/near.h" "#pragma once\n#include \"render/trace/step.h\"\n")
check("a texture behind one" fails "priority/near.h -> render/trace/step.h -> render/texture/pigment.h")
file(REMOVE "${SCRATCH}/priority/near.h")
