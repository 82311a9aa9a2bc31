# The checker of what folders compile without catches what is planted, however far away, and lets a clean tree pass.
# Run: cmake -DCHECKER=<check_reach.cmake> -DSCRATCH=<folder> -P check_reach_test.cmake

cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/checker_test.cmake")

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
