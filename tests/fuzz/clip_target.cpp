#include "fuzz/lone_file.h"
#include "fuzz/promise.h"
#include "fuzz/targets.h"

#include "import/clip_file.h"

#include <cmath>

namespace coif::fuzz {
namespace {

void check(const ClipFile& clip) {
  promise(!clip.keys.empty(), "a clip has keys");
  double last = -1;
  for (const NodeKey& key : clip.keys) {
    promise(key.seconds >= 0 && key.seconds > last && std::isfinite(key.seconds), "keys ascend from 0 or later");
    promise(key.position.allFinite(), "positions are finite");
    promise(std::abs(key.rotation.norm() - 1) < 1.0e-6, "rotations have unit length");
    last = key.seconds;
  }
}

}  // namespace

bool try_clip(Input input) {
  static const LoneFile file("clip.glb");
  bool accepted = false;
  for (const char* const node : {"", "head"}) {
    const auto clip = read_clip(file.with(input), node);
    if (clip) check(*clip);
    promise(clip || clip.error().kind == ToolError::Kind::kBadInput, "a refusal is the file's fault");
    accepted = accepted || clip;
  }
  return accepted;
}

}  // namespace coif::fuzz
