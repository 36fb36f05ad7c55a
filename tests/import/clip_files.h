#pragma once
// Animated glTF documents that tests write for themselves.

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace coif::test {

/// One node, and an animation of it; what tests vary is in `document` until text() is asked for.
class ClipDocument {
 public:
  ClipDocument();

  /// Adds a channel to the first animation that moves `node` ("translation", "rotation" or "scale").
  ClipDocument& animate(std::size_t node, const std::string& path, const std::vector<float>& seconds,
                        const std::vector<float>& values, const char* interpolation = "LINEAR");

  /// As .gltf with its buffer inside.
  [[nodiscard]] std::string text() const;
  /// As .gltf with its buffer in the file `uri`, whose content is buffer().
  [[nodiscard]] std::string text_beside(const std::string& uri) const;
  [[nodiscard]] std::string glb() const;
  [[nodiscard]] const std::string& buffer() const { return buffer_; }

  nlohmann::json document;  ///< Nodes: 0, "head".

 private:
  std::size_t add(const std::vector<float>& values, const char* type, std::size_t width);

  std::string buffer_;
};

/// Quaternions (x, y, z, w) of a nod about X, one for each time.
[[nodiscard]] std::vector<float> turns_about_x(const std::vector<float>& seconds,
                                               const std::function<double(double)>& radians);

}  // namespace coif::test
