#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::visibility {

/// Lists of many units, one behind the other in one piece of memory.
template <typename Item>
class UnitLists {
 public:
  /// `for_all` is called twice with a function that adds an item to a unit's list, and must call that in the same
  /// order.
  template <typename ForAll>
  UnitLists(std::size_t units, const ForAll& for_all) : begin_(units + 1, 0) {
    for_all([&](std::uint32_t unit, const Item&) { ++begin_[unit + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    items_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for_all([&](std::uint32_t unit, const Item& item) { items_[next[unit]++] = item; });
  }

  [[nodiscard]] std::span<const Item> of(std::uint32_t unit) const {
    return std::span(items_).subspan(begin_[unit], begin_[unit + 1] - begin_[unit]);
  }
  [[nodiscard]] std::size_t size() const { return begin_.size() - 1; }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<Item> items_;
};

}  // namespace coif::visibility
