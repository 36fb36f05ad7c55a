#include "gltf/buffers.h"

#include "base/encodings.h"
#include "base/files.h"
#include "base/text.h"
#include "gltf/document.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace coif::gltf {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Bytes = tl::expected<std::vector<std::byte>, std::string>;

Bytes read_part(std::ifstream& file, std::size_t size) {
  std::vector<std::byte> bytes(size);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (std::size_t(file.gcount()) != size) return fault("cut off: {} of {} bytes", file.gcount(), size);
  return bytes;
}

bool read_word(std::ifstream& file, std::uint32_t& word) {
  return bool(file.read(reinterpret_cast<char*>(&word), sizeof word));
}

/// The chunk after the JSON one. Sizes are checked against the file's, so that none makes the reader allocate more.
Bytes read_binary_chunk(const fs::path& path, std::size_t wanted) {
  constexpr std::streamoff kHeader = 12, kChunkHeader = 8;
  std::ifstream file(path, std::ios::binary);
  char magic[4] = {};
  std::uint32_t json_bytes = 0, size = 0, type = 0;
  file.read(magic, sizeof magic);
  if (!file || std::memcmp(magic, "glTF", sizeof magic) != 0) return fault("without a uri, and the file is no .glb");
  file.seekg(kHeader);
  if (!read_word(file, json_bytes)) return fault("cut off");
  file.seekg(kHeader + kChunkHeader + std::streamoff{json_bytes});
  if (!read_word(file, size) || !read_word(file, type) || std::memcmp(&type, "BIN", 4) != 0) {
    return fault("without a uri, and the .glb has no binary chunk");
  }
  std::error_code code;
  const std::uintmax_t whole = fs::file_size(path, code);
  const auto left = code ? 0 : whole - std::uintmax_t(file.tellg());
  if (wanted > size || wanted > left) {
    return fault("cut off: {} of {} bytes", std::min<std::uintmax_t>(size, left), wanted);
  }
  return read_part(file, wanted);
}

Bytes read_data_uri(const std::string& text, std::size_t wanted) {
  auto bytes = bytes_of_data_uri(text);
  if (!bytes) return fault("a damaged data: URI");
  if (bytes->size() < wanted) return fault("cut off: {} of {} bytes", bytes->size(), wanted);
  bytes->resize(wanted);
  return std::move(*bytes);
}

/// Some writers do not encode names: "50%20.bin" may be one.
SideFile side_file_of(const std::string& uri, const fs::path& name, const fs::path& folder) {
  std::error_code error;
  SideFile decoded = find_side_file(folder, name);
  const bool is_plain = !fs::exists(decoded.path, error) && fs::is_regular_file(folder / uri, error);
  return is_plain ? SideFile{folder / uri} : decoded;
}

}  // namespace

std::optional<std::vector<std::byte>> bytes_of_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::string_view data = uri.substr(comma + 1);
  const bool is_escaped = data.find('%') != std::string_view::npos;
  const std::string plain = is_escaped ? decoded_uri(data) : std::string();
  const std::string_view text = is_escaped ? std::string_view(plain) : data;
  if (uri.substr(0, comma).ends_with(";base64")) return from_base64(text);
  const auto bytes = std::as_bytes(std::span(text));
  return std::vector<std::byte>(bytes.begin(), bytes.end());
}

Bytes GltfBuffers::read_side_file(const std::string& uri, std::size_t wanted) {
  const fs::path name = decoded_uri(uri);
  const std::string shown = printable_text(uri, 100);
  const bool is_path = !name.empty() && name.is_relative() && name.native().find('\0') == std::string::npos &&
                       uri.find("://") == std::string::npos;
  if (!is_path) return fault("in '{}', which is not in this file's folder; put it there or export as .glb", shown);
  std::error_code code;
  const SideFile found = side_file_of(uri, name, path_.parent_path());
  const fs::path& path = found.path;
  const auto status = fs::status(path, code);
  const bool is_inside =
      fs::exists(status) ? lies_in(path, folders_of_source(path_, roots_)) : *name.lexically_normal().begin() != "..";
  if (!is_inside) {
    return fault(
        "in '{}', which is not in this file's folder; put it there or export as .glb; where it lies in another folder "
        "or is a link, "
        "allow that folder with --root",
        shown);
  }
  side_files_.insert(path.string());
  if (found.is_respelled) respelled_.push_back({shown, shown_from(path_.parent_path(), path)});
  if (!fs::exists(status))
    return fault("in '{}', and there is no such file; put it beside this one or export as .glb", shown);
  std::ifstream file(path, std::ios::binary);
  if (!fs::is_regular_file(status) || !file) return fault("in '{}', which cannot be opened", shown);
  const std::uintmax_t size = fs::file_size(path, code);
  if (code || size < wanted) return fault("cut off: '{}' has {} of {} bytes", shown, code ? 0 : size, wanted);
  return read_part(file, wanted);
}

Bytes GltfBuffers::read(const json& buffer, std::size_t wanted) {
  const json& uri = member(buffer, "uri");
  if (!uri.is_string()) return read_binary_chunk(path_, wanted);
  const auto& text = uri.get_ref<const std::string&>();
  return text.starts_with("data:") ? read_data_uri(text, wanted) : read_side_file(text, wanted);
}

tl::expected<std::span<const std::byte>, std::string> GltfBuffers::bytes(std::size_t buffer) {
  if (const auto found = read_.find(buffer); found != read_.end()) return found->second;
  const json& entries = list_of(member(document_, "buffers"));
  if (buffer >= entries.size()) return fault("buffer {} is not one of {}", buffer, entries.size());
  const auto wanted = index_of(member(entries[buffer], "byteLength"), kMostBufferBytes + 1);
  if (!wanted) return fault("buffer {} has no byteLength of 0 to 1 GiB", buffer);
  Bytes bytes = read(entries[buffer], *wanted);
  if (!bytes) return fault("buffer {} is {}", buffer, bytes.error());
  return read_.emplace(buffer, std::move(*bytes)).first->second;
}

/// The bytes of a bufferView, or of an extension that replaces it.
tl::expected<std::span<const std::byte>, std::string> GltfBuffers::part(const json& place) {
  const json& offset = member(place, "byteOffset");
  const auto buffer = index_of(member(place, "buffer"), kMostBufferBytes);
  const auto begin = offset.is_null() ? std::optional<std::uint32_t>(0) : index_of(offset, kMostBufferBytes + 1);
  const auto size = index_of(member(place, "byteLength"), kMostBufferBytes + 1);
  if (!buffer || !begin || !size) return fault("has offsets or sizes that are no such numbers");
  const auto whole = bytes(*buffer);
  if (!whole) return fault("needs a buffer that cannot be read: {}", whole.error());
  if (*begin > whole->size() || *size > whole->size() - *begin) {
    return fault("ends at byte {} of a buffer of {}", std::size_t{*begin} + *size, whole->size());
  }
  return whole->subspan(*begin, *size);
}

tl::expected<GltfView, std::string> GltfBuffers::decompressed(std::size_t view, const json& compression) {
  const auto known = decompressed_.find(view);
  const auto stride = index_of(member(compression, "byteStride"), kMostBufferBytes).value_or(0);
  if (known != decompressed_.end()) return GltfView{known->second, stride};
  const auto packed = part(compression);
  if (!packed) return tl::unexpected(packed.error());
  auto bytes = decompress_meshopt(compression, *packed);
  if (!bytes) return tl::unexpected(bytes.error());
  return GltfView{decompressed_.emplace(view, std::move(*bytes)).first->second, stride};
}

tl::expected<GltfView, std::string> GltfBuffers::view(const json& index) {
  const json& views = list_of(member(document_, "bufferViews"));
  const auto number = index_of(index, views.size());
  if (!number) return fault("is in no bufferView of the {} that there are", views.size());
  const json& entry = views[*number];
  const auto about = [&](const std::string& what) {
    return tl::unexpected(fmt::format("is in bufferView {}, which {}", *number, what));
  };
  for (const char* const name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    if (const json& compression = extension(entry, name); compression.is_object()) {
      auto view = decompressed(*number, compression);
      return view ? view : about(view.error());
    }
  }
  const json& stride = member(entry, "byteStride");
  const auto step = stride.is_null() ? std::optional<std::uint32_t>(0) : index_of(stride, kMostBufferBytes);
  const auto bytes = part(entry);
  if (!bytes) return about(bytes.error());
  if (!step) return about("has a byteStride that is no such number");
  return GltfView{*bytes, *step};
}

}  // namespace coif::gltf
