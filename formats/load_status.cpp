#include <coif/load_status.h>

namespace coif {
namespace {

/// Appends to a buffer of fixed size; snprintf would bring in the locale and a format parser.
class TextBuffer {
 public:
  TextBuffer(char* text, std::size_t capacity) : text_(text), capacity_(capacity) {}

  void add(char c) {
    if (length_ + 1 < capacity_) text_[length_++] = c;
  }
  void add(const char* s) {
    while (*s != 0) add(*s++);
  }
  void add(std::uint64_t number) {
    char digits[20];
    int count = 0;
    do {
      digits[count++] = char('0' + number % 10);
      number /= 10;
    } while (number != 0);
    while (count > 0) add(digits[--count]);
  }
  std::size_t finish() {
    if (capacity_ > 0) text_[length_] = 0;
    return length_;
  }

 private:
  char* text_;
  std::size_t capacity_;
  std::size_t length_ = 0;
};

void add_chunk_name(TextBuffer& out, std::uint32_t id) {
  for (int i = 0; i < 4; ++i) {
    const char c = char(id >> (8 * i) & 0xFF);
    out.add(c >= 0x20 && c < 0x7F ? c : '?');
  }
}

}  // namespace

const char* describe(LoadCode code) {
  switch (code) {
    case LoadCode::kOk: return "no error";
    case LoadCode::kTooSmall: return "too short to be a cooked hair asset";
    case LoadCode::kMisaligned: return "the memory given is not aligned to 64 bytes";
    case LoadCode::kMagic: return "not a cooked hair asset";
    case LoadCode::kMajorVersion: return "cooked for another major version of the format; cook it again";
    case LoadCode::kSize: return "size differs from the header's: the file is truncated or has bytes added";
    case LoadCode::kChunkCount: return "more chunks than the format allows or the file can hold";
    case LoadCode::kHash: return "the bytes were changed after cooking (hash differs)";
    case LoadCode::kChunkRange: return "chunk outside the file, overlapping, out of order or not aligned";
    case LoadCode::kChunkDuplicate: return "chunk occurs twice";
    case LoadCode::kChunkUnknown: return "chunk must be understood but is not known to this version";
    case LoadCode::kChunkMissing: return "chunk is absent but needed";
    case LoadCode::kChunkSize: return "chunk size does not fit its records or the declared count";
    case LoadCode::kReserved: return "reserved bits are not zero";
    case LoadCode::kNotFinite: return "number is not finite or outside its range";
    case LoadCode::kEnumerator: return "value is not known to this version";
    case LoadCode::kReference: return "index points outside the array it refers to";
    case LoadCode::kBoneOrder: return "bones are not sorted head, scalp, simulated with parents first";
    case LoadCode::kBoneJoint: return "bone does not start where its simulated parent ends";
    case LoadCode::kColliderSet: return "bone's set names colliders that do not exist, or the bone is rigid";
    case LoadCode::kChainCover: return "chains do not cover the simulated bones exactly once";
    case LoadCode::kLinkOrder: return "links are not trees between bones of equal depth in different chains, by depth";
    case LoadCode::kOpenBones: return "too many bones of the chain wait for their children; store it depth first";
    case LoadCode::kPatchCover: return "patches do not cover the index list exactly once in order";
    case LoadCode::kLodCover: return "levels of detail do not cover the patches exactly once in order";
    case LoadCode::kLodOrder: return "screen sizes do not fall to 0 or errors do not grow from 0, level by level";
    case LoadCode::kOrderCover: return "draw order does not draw every triangle of a level of detail exactly once";
    case LoadCode::kLodBones: return "bone is simulated in levels of detail where it cannot be, or not in the finest";
    case LoadCode::kWeightSum: return "skin weights do not add up to one";
    case LoadCode::kName: return "names do not end with a zero byte";
  }
  return "unknown error";
}

std::size_t describe(const LoadStatus& status, char* text, std::size_t capacity) {
  TextBuffer out(text, capacity);
  if (status.chunk != 0) {
    out.add("chunk ");
    add_chunk_name(out, status.chunk);
    if (status.code != LoadCode::kHash) {
      out.add(", record ");
      out.add(status.item);
    }
    out.add(": ");
  }
  out.add(describe(status.code));
  // A reference is refused for reaching the array's size or more, so both numbers are printed even when equal.
  const bool reference = status.code == LoadCode::kReference && status.expected != 0;
  if (reference || status.expected != status.found) {
    out.add(reference ? " (size " : " (expected ");
    out.add(status.expected);
    out.add(reference ? ", index " : ", found ");
    out.add(status.found);
    out.add(")");
  }
  return out.finish();
}

}  // namespace coif
