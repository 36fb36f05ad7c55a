#include "motion/head_path.h"

#include <array>
#include <bit>
#include <cstring>

namespace coif::motion {
namespace {

static_assert(std::endian::native == std::endian::little);
using Row = std::array<double, 8>;

}  // namespace

std::vector<std::byte> clip_bytes(std::span<const ClipKey> keys) {
  std::vector<std::byte> bytes(keys.size() * sizeof(Row));
  std::byte* to = bytes.data();
  for (const ClipKey& key : keys) {
    const Eigen::Vector3d& p = key.position;
    const Eigen::Quaterniond& q = key.rotation;
    const Row row{key.seconds, p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
    std::memcpy(to, row.data(), sizeof row);
    to += sizeof row;
  }
  return bytes;
}

std::vector<ClipKey> clip_keys(std::span<const std::byte> bytes) {
  std::vector<ClipKey> keys;
  if (bytes.size() % sizeof(Row) != 0) return keys;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(Row)) {
    Row row;
    std::memcpy(row.data(), bytes.data() + at, sizeof row);
    keys.push_back({row[0], {row[1], row[2], row[3]}, Eigen::Quaterniond(row[7], row[4], row[5], row[6])});
  }
  if (path_of(keys) == nullptr) keys.clear();
  return keys;
}

}  // namespace coif::motion
