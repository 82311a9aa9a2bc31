# No source file is over 600 lines: a longer one holds more than one subject.
# Run: cmake -DROOT=<repository> -P check_length.cmake

cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE files RELATIVE "${ROOT}"
  "${ROOT}/render/*" "${ROOT}/parser/*" "${ROOT}/priority/*" "${ROOT}/app/*" "${ROOT}/tests/*" "${ROOT}/testscenes/*")
list(FILTER files INCLUDE REGEX "(\\.(h|hpp|inl|def|cpp|cmake|sh|pov|inc)|CMakeLists\\.txt)$")
list(APPEND files CMakeLists.txt render.sh test.sh)
set(long 0)
foreach(file IN LISTS files)
  file(READ "${ROOT}/${file}" content)
  string(REGEX REPLACE "[^\n]+" "" newlines "${content}")
  string(LENGTH "${newlines}" lines)
  if(lines GREATER 600)
    message(NOTICE "${file}: ${lines} lines")
    math(EXPR long "${long} + 1")
  endif()
endforeach()
list(LENGTH files count)
if(long GREATER 0)
  message(FATAL_ERROR "${long} of ${count} files are over 600 lines")
endif()
message(STATUS "None of ${count} files is over 600 lines")
