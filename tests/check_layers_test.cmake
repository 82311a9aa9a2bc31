# The checker of the layers catches what is planted, names its line, and lets a clean tree pass.
# Run: cmake -DCHECKER=<check_layers.cmake> -DSCRATCH=<folder> -P check_layers_test.cmake

cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/checker_test.cmake")

# plant(FILE TEXT EXPECTED): a clean tree and one file more.
function(plant file text expected)
  file(WRITE "${SCRATCH}/${file}" "${text}")
  check("${file}" fails "${expected}")
  file(REMOVE "${SCRATCH}/${file}")
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
file(WRITE "${SCRATCH}/render/math/vec.h" "#pragma once\n#include <array>\n")
file(WRITE "${SCRATCH}/render/shape/sphere.h" "#pragma once\n#include \"render/math/vec.h\"\n")
file(WRITE "${SCRATCH}/render/image/write.cpp" "#include <OpenImageIO/imageio.h>\n")
file(WRITE "${SCRATCH}/parser/parser.cpp" "#include \"render/scene/scene.h\"\n#include \"render/shape/sphere.h\"\n")
file(WRITE "${SCRATCH}/priority/driver.cpp" "#include \"priority/queue.h\"\n  #  include \"render/trace/step.h\"\n")
file(WRITE "${SCRATCH}/app/main.cpp" "#include \"parser/parser.h\"\n#include \"priority/driver.h\"\n")
check("a clean tree" passes "keep the layers")

plant(parser/accel.cpp "#include <vector>\n\n#include \"render/accel/bvh.h\"\n"
  "parser/accel.cpp:3: error: parser must not include 'render/accel/bvh.h'")
plant(parser/trace.cpp "#include \"render/trace/step.h\"\n" "parser must not include 'render/trace/step.h'")
plant(parser/film.h "#pragma once\n#include \"render/film/film.h\"\n" "parser/film.h:2: error: parser must not")
plant(parser/queue.cpp "#include \"priority/ray_queue.h\"\n" "parser must not include 'priority/ray_queue.h'")
plant(priority/shape.cpp "#include \"render/shape/sphere.h\"\n" "priority must not include 'render/shape/sphere.h'")
plant(priority/texture.cpp "  #  include <render/texture/pigment.h>\n" "priority must not include")
plant(priority/text.cpp "#include \"parser/text/lexer.h\"\n" "priority must not include 'parser/text/lexer.h'")
plant(parser/directive/up.cpp "#include \"parser/statement/statements.h\"\n"
  "parser/directive must not include 'parser/statement/statements.h'")
plant(parser/expression/up.cpp "#include \"parser/directive/interpreter.h\"\n"
  "parser/expression must not include 'parser/directive/interpreter.h'")
plant(app/inside.cpp "#include \"parser/text/lexer.h\"\n" "app must not include 'parser/text/lexer.h'")
plant(render/trace/up.cpp "#include \"priority/driver.h\"\n" "render/trace must not include 'priority/driver.h'")
plant(render/math/up.h "#include \"render/shape/sphere.h\"\n" "render/math must not include")
plant(render/scene/up.h "#include \"render/film/film.h\"\n" "render/scene must not include")
plant(render/shape/app.cpp "#include \"app/options.h\"\n" "render/shape must not include 'app/options.h'")
plant(render/shape/near.cpp "#include \"sphere.h\"\n" "must be written from the root")
plant(render/film/oiio.cpp "#include <OpenImageIO/imageio.h>\n" "only render/image may include")
plant(render/gadget/new.h "#pragma once\n" "the folder 'render/gadget' has no row")
