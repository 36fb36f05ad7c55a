#include "gl/draw_orders.h"

#include <cstdint>

namespace coif {
namespace {

template <typename Index>
class IndexWriter {
 public:
  explicit IndexWriter(std::byte* out) : next_(reinterpret_cast<Index*>(out)) {}

  void write(std::span<const std::uint32_t> indices) {
    for (const std::uint32_t index : indices) *next_++ = static_cast<Index>(index);
  }

 private:
  Index* next_;
};

template <typename Index>
void write_orders(const Asset& asset, std::byte* out) {
  IndexWriter<Index> writer(out);
  writer.write(asset.indices());
  for (const std::uint32_t triangle : asset.orders())
    writer.write(asset.indices().subspan(3 * std::size_t{triangle}, 3));
}

}  // namespace

void write_draw_orders(const Asset& asset, std::span<std::byte> out) {
  const std::size_t count = asset.indices().size() * asset.order_count();
  if (out.size() == count * sizeof(std::uint16_t)) {
    write_orders<std::uint16_t>(asset, out.data());
  } else {
    write_orders<std::uint32_t>(asset, out.data());
  }
}

}  // namespace coif
