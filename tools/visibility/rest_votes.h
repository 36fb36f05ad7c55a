#pragma once

#include "visibility/order_error.h"

#include <coif/view_cells.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace coif::visibility {

/// The votes of some views of the hair at rest on its triangles, for one rule. Saves looking along the same lines
/// again.
class RestVotes {
 public:
  RestVotes() = default;
  RestVotes(const DrawRule& rule, std::size_t views_per_cell)
      : rule_(rule), views_per_cell_(views_per_cell), votes_(kViewCells * views_per_cell) {}

  /// `view`: its number in its cell, below views_per_cell. Different ones may be kept at the same time.
  void keep(std::size_t cell, std::size_t view, std::vector<Vote> votes) {
    votes_[cell * views_per_cell_ + view] = std::move(votes);
  }
  /// Null where they are not there, or of another rule.
  [[nodiscard]] const std::vector<Vote>* find(const DrawRule& rule, std::size_t cell, std::size_t view) const {
    if (view >= views_per_cell_ || rule != rule_) return nullptr;
    const auto& votes = votes_[cell * views_per_cell_ + view];
    return votes ? &*votes : nullptr;
  }

 private:
  DrawRule rule_;
  std::size_t views_per_cell_ = 0;
  std::vector<std::optional<std::vector<Vote>>> votes_;
};

}  // namespace coif::visibility
