#pragma once

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// The buffers of a glTF document, read when somebody asks for them: the binary chunk of a .glb, base64 in the document,
/// or a file beside it. Source: Khronos, "glTF 2.0 Specification", chapters 3.6 and 4.4.
class GltfBuffers {
 public:
  /// Both must outlive the object; `document` needs the member `buffers`.
  GltfBuffers(const std::filesystem::path& path, const nlohmann::json& document) : path_(path), document_(document) {}

  /// Exactly as many bytes as the document promises; valid as long as the object. The error is a sentence without the
  /// file's name. Files outside the document's folder, or above 1 GiB, are refused.
  [[nodiscard]] tl::expected<std::span<const std::byte>, std::string> bytes(std::size_t buffer);

 private:
  const std::filesystem::path& path_;
  const nlohmann::json& document_;
  std::map<std::size_t, std::vector<std::byte>> read_;
};

}  // namespace coif
