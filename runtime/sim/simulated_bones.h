#pragma once

#include <coif/asset_records.h>

#include <cstddef>
#include <span>

namespace coif {

/// The simulated bones of an asset, which are its last ones, numbered from 0 as the particles are.
class SimulatedBones {
 public:
  /// `count` at most bones.size().
  SimulatedBones(std::span<const BoneRecord> bones, std::size_t count)
      : bones_(bones.last(count)), first_(bones.size() - count) {}

  [[nodiscard]] std::size_t count() const { return bones_.size(); }
  [[nodiscard]] const BoneRecord& operator[](std::size_t i) const { return bones_[i]; }
  [[nodiscard]] bool hangs_from_rigid(std::size_t i) const { return bones_[i].parent < first_; }
  /// Meaningful unless hangs_from_rigid(i).
  [[nodiscard]] std::size_t parent(std::size_t i) const { return bones_[i].parent - first_; }

  /// What every loop from root to tip relies on.
  [[nodiscard]] bool parents_come_first() const {
    for (std::size_t i = 0; i < bones_.size(); ++i) {
      if (bones_[i].parent >= first_ + i) return false;
    }
    return true;
  }

 private:
  std::span<const BoneRecord> bones_;
  std::size_t first_;
};

}  // namespace coif
