// The exported face of the loadable module. [render/scene/front_end.h]
#include "parser/parser.h"

extern "C" {

int firstlight_front_end_abi() { return firstlight::render::kFrontEndAbi; }

const firstlight::render::FrontEnd* firstlight_front_end() {
  static const firstlight::parser::PovFrontEnd front_end;
  return &front_end;
}
}
