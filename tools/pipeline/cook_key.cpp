#include "pipeline/cook_key.h"

#include "payload_hash.h"

#include <fmt/format.h>

namespace coif {

std::string content_digits(std::span<const std::byte> bytes) {
  return fmt::format("{:016x}{:016x}", xxh64(bytes, 0), xxh64(bytes, 1));
}

std::string cook_key(const CookIdentity& identity) {
  constexpr const char* kLayout = "coif cache 1";  // of the entries, too: another layout never meets this one's
  std::string text;
  // Lengths in front, so that no two different lists of parts read the same.
  for (const std::string& part :
       {std::string(kLayout), identity.tool, identity.importer, identity.source.filename().string(),
        content_digits(identity.source_bytes), identity.recipe}) {
    text += fmt::format("{}:{}", part.size(), part);
  }
  return content_digits(std::as_bytes(std::span(text)));
}

}  // namespace coif
