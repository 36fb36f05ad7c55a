#pragma once

// The bytes of a glTF document: buffers, and the views of them, which may be compressed.
// Source: Khronos, "glTF 2.0 Specification", chapters 3.6 and 4.4; "EXT_meshopt_compression".

#include "base/json.h"
#include "base/side_file.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif::gltf {

inline constexpr std::size_t kMostBufferBytes = std::size_t{1} << 30;

/// A bufferView's bytes, and the stride of its elements; 0: tightly packed.
struct GltfView {
  std::span<const std::byte> bytes;
  std::size_t stride = 0;
};

/// The buffers of a document, read at the first use: the binary chunk of a .glb, base64 in the document, or a file in
/// its folder or in one of the `roots`.
class GltfBuffers {
 public:
  /// All arguments must outlive the object; `document` needs the members `buffers` and `bufferViews`.
  GltfBuffers(const std::filesystem::path& path, const nlohmann::json& document,
              std::span<const std::filesystem::path> roots = {})
      : path_(path), document_(document), roots_(roots) {}

  /// Exactly as many bytes as the document promises; valid as long as the object. The error is a sentence without the
  /// file's name. Files elsewhere, or above 1 GiB, are refused.
  [[nodiscard]] tl::expected<std::span<const std::byte>, std::string> bytes(std::size_t buffer);

  /// A bufferView, decompressed; valid as long as the object. The error is a sentence.
  [[nodiscard]] tl::expected<GltfView, std::string> view(const nlohmann::json& index);

  /// Paths of the files beside the document that were looked for, found or not.
  [[nodiscard]] const std::set<std::string>& side_files() const { return side_files_; }

  /// Files that lie there under other names than the document has.
  [[nodiscard]] std::span<const Respelled> respelled() const { return respelled_; }

 private:
  using Bytes = tl::expected<std::vector<std::byte>, std::string>;
  [[nodiscard]] Bytes read(const nlohmann::json& buffer, std::size_t wanted);
  [[nodiscard]] Bytes read_side_file(const std::string& uri, std::size_t wanted);
  [[nodiscard]] tl::expected<std::span<const std::byte>, std::string> part(const nlohmann::json& place);
  [[nodiscard]] tl::expected<GltfView, std::string> decompressed(std::size_t view, const nlohmann::json& compression);

  const std::filesystem::path& path_;
  const nlohmann::json& document_;
  std::span<const std::filesystem::path> roots_;
  std::map<std::size_t, std::vector<std::byte>> read_;
  std::map<std::size_t, std::vector<std::byte>> decompressed_;
  std::set<std::string> side_files_;
  std::vector<Respelled> respelled_;
};

/// The content of a "data:" URI (RFC 2397), in base64 or with %XX for bytes; none where it is damaged.
[[nodiscard]] std::optional<std::vector<std::byte>> bytes_of_data_uri(std::string_view uri);

/// Decompresses a bufferView with EXT_meshopt_compression. `compression` is the extension's object. The error is a
/// sentence.
[[nodiscard]] tl::expected<std::vector<std::byte>, std::string> decompress_meshopt(const nlohmann::json& compression,
                                                                                   std::span<const std::byte> bytes);

}  // namespace coif::gltf
