#include "gl/passes.h"

namespace coif {
namespace {

PassList plan(const MaterialRecord& material, const AlphaRange& texture) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), solid_pass(material));
  return drawn;
}

}  // namespace

const TransparencyMode kOpaqueMode = {"opaque", plan};

}  // namespace coif
