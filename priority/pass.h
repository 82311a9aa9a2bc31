#pragma once

#include "priority/root_source.h"
#include "priority/sink.h"

namespace firstlight::priority {

/// Something that is traced: the trees from the source's roots, whose light goes to the sink. A pass begins when those
/// before it are complete, so its source may read their sinks; several may share one.
struct Pass {
  RootSource* source;
  Sink* sink;
};

}  // namespace firstlight::priority
