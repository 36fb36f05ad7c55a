#include "cook/dynamics/rest_shape.h"

#include "cook/dynamics/bone_motion.h"

#include <fmt/format.h>

namespace coif::cook {

void keep_rest_shape(const std::vector<bool>& takes, AssetContents& contents, Findings& findings) {
  const lab::OpenedAsset opened(contents);
  if (!opened.asset().is_open()) return;
  const lab::Rig rig = lab::rig_of(opened.asset());
  const std::vector<bool> of_rig(takes.begin() + rig.rigid_count, takes.end());
  const std::size_t stiffened = lean_against_weight(rig, std::span(contents.bones).subspan(rig.rigid_count), of_rig,
                                                    std::span(contents.dynamics).subspan(rig.rigid_count));
  if (stiffened > 0) {
    findings.note(fmt::format("{} bones were made stiffer, so that they carry the shape that was modelled", stiffened));
  }
}

}  // namespace coif::cook
