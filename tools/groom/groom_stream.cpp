#include "groom/read_groom.h"

#include "import/stream_parts.h"

namespace coif::groom {
namespace {

constexpr std::uint32_t kMagic = 0x31524847u;

constexpr auto transfer_group = [](auto& archive, auto& group) {
  return archive.sequence(group.name) && archive.plain(group.first_strand) && archive.plain(group.strand_count);
};

constexpr auto transfer_groom = [](auto& archive, auto& groom) {
  constexpr std::size_t kCount = sizeof(std::uint64_t);
  return archive.sequence(groom.path) && archive.sequence(groom.format) && archive.sequence(groom.points) &&
         archive.sequence(groom.begin) && archive.sequence(groom.widths) && archive.sequence(groom.colors) &&
         archive.sequence(groom.opacities) && archive.list(groom.groups, kCount + 8, transfer_group) &&
         archive.plain(groom.follow_hairs) && importer::transfer_flag(archive, groom.root_first) &&
         importer::transfer_space(archive, groom.space) &&
         archive.list(groom.warnings, 2 * kCount, importer::transfer_warning);
};

}  // namespace

std::vector<std::uint8_t> encode_groom(const GroomOutcome& outcome) {
  return importer::encode_framed(kMagic, outcome, transfer_groom);
}

bool decode_groom(std::span<const std::uint8_t> bytes, GroomOutcome& outcome) {
  return importer::decode_framed(kMagic, bytes, outcome, transfer_groom, find_groom_fault);
}

}  // namespace coif::groom
