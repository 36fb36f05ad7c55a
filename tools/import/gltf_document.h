#pragma once

// Reading a glTF document that somebody else wrote, beside what assimp reads of it.

#include "base/json.h"
#include "import/source_model.h"

#include <Eigen/Core>
#include <fmt/format.h>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coif {

/// What is wrong, as a sentence without the file's name.
template <class... Args>
[[nodiscard]] tl::unexpected<std::string> fault(fmt::format_string<Args...> text, Args&&... args) {
  return tl::unexpected(fmt::format(text, std::forward<Args>(args)...));
}

/// Three finite numbers as a list [x, y, z] or as an object with members x, y and z.
[[nodiscard]] std::optional<Eigen::Vector3d> vector_of(const nlohmann::json& value);

/// Members of a glTF document (.gltf, or the JSON chunk of a .glb or .vrm), those of `members`. The rest, which may hold
/// whole buffers as text, is skipped unstored; so is what is nested deeper than any extension needs, so that nothing
/// that walks the result can exhaust the stack. Null where the document is no object. The error is a sentence without
/// the file's name.
[[nodiscard]] tl::expected<nlohmann::json, std::string> read_gltf_json(const std::filesystem::path& path,
                                                                       std::span<const std::string_view> members);

/// The buffers of a glTF document, read when somebody asks for them: the binary chunk of a .glb, base64 in the document,
/// or a file beside it. Source: Khronos, "glTF 2.0 Specification", chapters 3.6 and 4.4.
class GltfBuffers {
 public:
  /// Both must outlive the object; `document` needs the member `buffers`. Files beside the document must really lie in one of
  /// `folders`, as folders_of_source() gives them; where there are none, links may lead anywhere.
  GltfBuffers(const std::filesystem::path& path, const nlohmann::json& document, std::vector<std::filesystem::path> folders = {})
      : path_(path), document_(document), folders_(std::move(folders)) {}

  /// Exactly as many bytes as the document promises; valid as long as the object. The error is a sentence without the
  /// file's name. Files outside the document's folder, or above 1 GiB, are refused.
  [[nodiscard]] tl::expected<std::span<const std::byte>, std::string> bytes(std::size_t buffer);

 private:
  const std::filesystem::path& path_;
  const nlohmann::json& document_;
  std::vector<std::filesystem::path> folders_;
  std::map<std::size_t, std::vector<std::byte>> read_;
};

/// What an accessor has to be.
struct NumbersWanted {
  const char* type = "SCALAR";    ///< "SCALAR", "VEC3" or "VEC4".
  std::size_t width = 1;          ///< Numbers per element of that type.
  std::size_t most_elements = 1;  ///< More are refused.
};

/// All numbers of an accessor, element by element: floats, or normalized integers as the fractions that they mean. All
/// are finite. The error is a sentence without the file's name; sparse accessors are refused.
/// `document` needs the members `accessors` and `bufferViews`; `accessor` is an index in it, by somebody's word.
[[nodiscard]] tl::expected<std::vector<float>, std::string> read_gltf_numbers(const nlohmann::json& document,
                                                                              GltfBuffers& buffers,
                                                                              const nlohmann::json& accessor,
                                                                              const NumbersWanted& wanted);

/// All numbers of an accessor of unsigned integers, such as indices; at most so many. As read_gltf_numbers() otherwise.
[[nodiscard]] tl::expected<std::vector<std::uint32_t>, std::string> read_gltf_indices(const nlohmann::json& document,
                                                                                      GltfBuffers& buffers,
                                                                                      const nlohmann::json& accessor,
                                                                                      std::size_t most);

/// Who is whose parent among a glTF document's nodes. `document` needs the member `nodes` and must outlive the object.
class GltfTree {
 public:
  explicit GltfTree(const nlohmann::json& document);

  [[nodiscard]] std::size_t size() const { return parents_.size(); }
  [[nodiscard]] const nlohmann::json& node(std::uint32_t index) const;
  /// Printable, for messages; "node 3" for one without a name.
  [[nodiscard]] std::string label(std::uint32_t index) const;
  /// All of that name, as the file writes it.
  [[nodiscard]] std::vector<std::uint32_t> named(std::string_view name) const;
  /// The node and all that it hangs on, the root last. The error is a sentence: too many levels, or a loop.
  [[nodiscard]] tl::expected<std::vector<std::uint32_t>, std::string> with_parents(std::uint32_t index) const;

 private:
  const nlohmann::json& nodes_;
  std::vector<std::uint32_t> parents_;
};

/// Which of `nodes` each node of the glTF document became; kNoIndex for those outside the scene and those that cannot
/// be told. assimp 5.2 builds its tree by walking the document's from the scene's roots, children in their order, under
/// a root of its own unless the scene has exactly one; it keeps names and makes up missing ones. So nodes are told by
/// their place in the tree, and their names, where they have any, must agree. Below a disagreement a node is found by
/// its name where that is the only one of its kind on both sides.
[[nodiscard]] std::vector<std::uint32_t> match_gltf_nodes(const nlohmann::json& document,
                                                          const std::vector<SourceNode>& nodes);

}  // namespace coif
