#pragma once
// What the files of the C interface share: an asset behind coif_asset, hair behind coif_hair, a world behind
// coif_world, and lists of records as C sees them.

#include <coif.h>
#include <coif/asset.h>
#include <coif/bit_cast.h>
#include <coif/hair.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

// Lies at the start of the caller's memory; the memory of coif::Hair follows.
struct coif_hair {
  coif::Asset asset;
  coif::Hair hair;
};

// The same for coif::HairWorld. The member has the name of coif_hair's, for functions that take either.
struct coif_world {
  coif::HairWorld hair;
};

namespace coif::c {

static_assert(sizeof(coif::Asset) <= sizeof(coif_asset) && alignof(coif::Asset) <= alignof(coif_asset));
static_assert(std::is_trivially_copyable_v<coif::Asset>, "C copies it with its bytes");
static_assert(int(COIF_NOT_ASKED) == int(coif::Status::kNotAsked));

inline coif_status code(coif::Status status) { return static_cast<coif_status>(status); }

/// The asset behind coif_asset; one that is not open for null.
inline const coif::Asset& view_of(const coif_asset* asset) {
  static constexpr coif::Asset kNone;
  return asset == nullptr ? kNone : *reinterpret_cast<const coif::Asset*>(asset->inside);
}

/// Empty for null.
inline std::span<const std::byte> bytes_of(const void* data, std::size_t bytes) {
  return {static_cast<const std::byte*>(data), data == nullptr ? 0 : bytes};
}

/// Records in C's type of the same layout. Null and a count of 0 where there are none.
template <typename InC, typename Record>
const InC* list(std::span<const Record> records, std::uint32_t* count) {
  static_assert(sizeof(InC) == sizeof(Record) && alignof(InC) == alignof(Record));
  if (count != nullptr) *count = static_cast<std::uint32_t>(records.size());
  return records.empty() ? nullptr : reinterpret_cast<const InC*>(records.data());
}

/// A list in C's type of the same layout; empty for null.
template <typename T, typename InC>
std::span<const T> span_of(const InC* list, std::uint32_t count) {
  static_assert(sizeof(InC) == sizeof(T) && alignof(InC) == alignof(T));
  return {reinterpret_cast<const T*>(list), list == nullptr ? 0 : count};
}

/// Copies the bytes into the other language's type of the same layout.
template <typename To, typename From>
To copied(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return bit_cast<To>(from);
}

inline coif::Vec3 vector_of(const coif_vec3& from) { return {from.x, from.y, from.z}; }
inline coif::Vec3 of_three(const float (&from)[3]) { return {from[0], from[1], from[2]}; }

inline coif::WorldAsset in_cpp(coif_world_asset asset) { return {asset.index, asset.generation}; }
inline coif::WorldHead in_cpp(coif_world_head head) { return {head.index, head.generation}; }

inline coif::HeadPose pose_of(const coif_head_pose& from) { return copied<coif::HeadPose>(from); }

}  // namespace coif::c

/// A member of a C struct lies where the record has it, and is as large.
#define COIF_SAME(InC, in_c, Record, member)                       \
  static_assert(offsetof(InC, in_c) == offsetof(Record, member) && \
                sizeof(static_cast<InC*>(nullptr)->in_c) == sizeof(static_cast<Record*>(nullptr)->member))
