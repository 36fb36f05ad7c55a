#pragma once

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

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

}  // namespace coif
