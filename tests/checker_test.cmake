# check(NAME RESULT TEXT): runs CHECKER over SCRATCH; it has to end as RESULT says, `passes` or `fails`, and to print TEXT.
# Included by the tests of the checkers.

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
