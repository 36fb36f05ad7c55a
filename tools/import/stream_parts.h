#pragma once

// Shared by the answers of all reading processes. One list of fields serves both directions: `Archive` is ByteEncoder
// with a const object, or ByteDecoder with a mutable one.

#include "base/byte_archive.h"
#include "base/tool_error.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

template <>
inline constexpr bool coif::kIsPlain<coif::importer::SourceInfluence> = true;
template <>
inline constexpr bool coif::kIsPlain<Eigen::Vector3f> = true;
template <>
inline constexpr bool coif::kIsPlain<Eigen::Vector2f> = true;
template <>
inline constexpr bool coif::kIsPlain<Eigen::Vector4f> = true;

namespace coif::importer {

static_assert(sizeof(Eigen::Vector4f) == 16);
static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(Eigen::Vector2f) == 8 && sizeof(SourceInfluence) == 8);

inline constexpr auto transfer_text = [](auto& archive, auto& text) { return archive.sequence(text); };

inline constexpr auto transfer_warning = [](auto& archive, auto& warning) {
  return archive.sequence(warning.code) && archive.sequence(warning.message);
};

inline bool transfer_flag(ByteEncoder& archive, const bool& flag) { return archive.plain(std::uint8_t{flag}); }

// Any byte but 0 and 1 copied into a bool would be undefined.
inline bool transfer_flag(ByteDecoder& archive, bool& flag) {
  std::uint8_t byte = 0;
  if (!archive.plain(byte) || byte > 1) return false;
  flag = byte == 1;
  return true;
}

template <class Choice>
bool transfer_choice(ByteEncoder& archive, const Choice& choice, Choice) {
  return archive.plain(static_cast<std::uint8_t>(choice));
}

// A number beyond the last enumerator is no value of the type that anything after this expects.
template <class Choice>
bool transfer_choice(ByteDecoder& archive, Choice& choice, Choice last) {
  std::uint8_t byte = 0;
  if (!archive.plain(byte) || byte > static_cast<std::uint8_t>(last)) return false;
  choice = static_cast<Choice>(byte);
  return true;
}

inline bool transfer_axis(ByteEncoder& archive, const char& axis) { return archive.plain(axis); }

inline bool transfer_axis(ByteDecoder& archive, char& axis) {
  return archive.plain(axis) && axis >= 'x' && axis <= 'z';
}

inline constexpr auto transfer_space = [](auto& archive, auto& space) {
  return archive.plain(space.metres_per_unit) && transfer_choice(archive, space.unit, Statement::kUnsaid) &&
         transfer_choice(archive, space.up, Statement::kUnsaid) && transfer_axis(archive, space.up_axis) &&
         archive.sequence(space.unit_words) && archive.sequence(space.up_words) && archive.sequence(space.generator);
};

/// The value or the error, after a word by which a stray write into the pipe is recognised.
template <class Value, class Transfer>
[[nodiscard]] std::vector<std::uint8_t> encode_framed(std::uint32_t magic,
                                                      const tl::expected<Value, ToolError>& outcome,
                                                      Transfer transfer) {
  ByteEncoder encoder;
  encoder.plain(magic);
  transfer_flag(encoder, outcome.has_value());
  if (outcome) {
    transfer(encoder, *outcome);
  } else {
    encoder.plain(static_cast<std::uint8_t>(outcome.error().kind));
    encoder.sequence(outcome.error().message);
  }
  return std::move(encoder.bytes);
}

/// False, with `outcome` untouched, unless the bytes are exactly one outcome in whose value `find_fault` finds no
/// fault.
template <class Value, class Transfer>
[[nodiscard]] bool decode_framed(std::uint32_t magic, std::span<const std::uint8_t> bytes,
                                 tl::expected<Value, ToolError>& outcome, Transfer transfer,
                                 std::string (*find_fault)(const Value&)) {
  ByteDecoder decoder(bytes);
  std::uint32_t begin = 0;
  bool has_value = false;
  if (!decoder.plain(begin) || begin != magic || !transfer_flag(decoder, has_value)) return false;
  if (!has_value) {
    ToolError error;
    if (!transfer_choice(decoder, error.kind, ToolError::Kind::kInternal)) return false;
    if (!decoder.sequence(error.message) || !decoder.at_end()) return false;
    outcome = tl::unexpected(std::move(error));
    return true;
  }
  Value value;
  if (!transfer(decoder, value) || !decoder.at_end() || !find_fault(value).empty()) return false;
  outcome = std::move(value);
  return true;
}

}  // namespace coif::importer
