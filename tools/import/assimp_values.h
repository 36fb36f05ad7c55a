#pragma once
// assimp's plain values as this project's.

#include "import/printable_text.h"

#include <assimp/matrix4x4.h>
#include <assimp/types.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <string>

namespace coif {

/// As printable text. The length field is not trusted beyond the string's own buffer.
[[nodiscard]] inline std::string text_of(const aiString& text) {
  return printable_text({text.data, std::min<std::size_t>(text.length, sizeof text.data - 1)});
}

/// Both multiply column vectors; the last row is dropped, since node and bind transforms are affine.
[[nodiscard]] inline Eigen::Affine3d affine_of(const aiMatrix4x4& m) {
  Eigen::Affine3d out = Eigen::Affine3d::Identity();
  out.matrix().topRows<3>() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4;
  return out;
}

}  // namespace coif
