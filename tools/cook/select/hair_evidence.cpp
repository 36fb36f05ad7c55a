#include "cook/select/hair_evidence.h"

#include "cook/select/called.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace coif::cook {
namespace {

std::vector<bool> nodes_below(const importer::SourceModel& source, std::uint32_t top) {
  std::vector<bool> below(source.nodes.size(), top == importer::kNoIndex);
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    const std::uint32_t parent = source.nodes[n].parent;
    if (n == top || (parent != importer::kNoIndex && below[parent])) below[n] = true;
  }
  return below;
}

std::vector<bool> nodes_of_meshes(const importer::SourceModel& source) {
  std::vector<bool> carries_mesh(source.nodes.size(), false);
  for (const importer::SourceMesh& mesh : source.meshes) carries_mesh[mesh.node] = true;
  return carries_mesh;
}

/// The kinds of nodes.
struct NodeKinds {
  const std::vector<bool>& hair_bones;
  std::vector<bool> of_eyes, of_head;
};

std::vector<bool> nodes_of_eyes(const importer::SourceModel& source) {
  std::vector<bool> of_eyes;
  for (const importer::SourceNode& node : source.nodes) of_eyes.push_back(is_called_eye(node.name));
  return of_eyes;
}

/// Adds one vertex of the piece to its evidence; shares are sums until they are divided.
/// Returns the vertex's share of hair bones.
double add_vertex(const importer::SourceMesh& mesh, std::uint32_t v, const NodeKinds& kinds, PieceEvidence& piece) {
  double hair = 0;
  const auto add = [&](std::uint32_t node, double weight) {
    if (kinds.hair_bones[node]) hair += weight;
    if (kinds.of_eyes[node]) piece.eye_bone_share += weight;
    if (kinds.of_head[node]) piece.head_share += weight;
  };
  if (mesh.influence_begin.empty()) {
    add(mesh.node, 1);
  } else {
    for (std::uint32_t k = mesh.influence_begin[v]; k < mesh.influence_begin[v + 1]; ++k) {
      add(mesh.influences[k].node, double(mesh.influences[k].weight));
    }
  }
  piece.hair_bone_share += hair;
  piece.largest_hair_bone = std::max(piece.largest_hair_bone, hair);
  piece.height = std::max(piece.height, double(mesh.positions[v].y()));
  return hair;
}

/// Where nothing is called head: the lowest bone of a spine above all bones called hair.
std::uint32_t node_above_hair(const importer::SourceModel& source, const std::vector<bool>& carries_mesh) {
  std::vector<std::size_t> below(source.nodes.size(), 0);
  std::size_t all = 0;
  for (std::size_t n = source.nodes.size(); n-- > 0;) {
    if (!carries_mesh[n] && is_called_hair(source.nodes[n].name)) {
      ++below[n];
      ++all;
    }
    if (source.nodes[n].parent != importer::kNoIndex) below[source.nodes[n].parent] += below[n];
  }
  std::uint32_t lowest = importer::kNoIndex;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n)
    if (all > 1 && below[n] == all && is_called_trunk(source.nodes[n].name)) lowest = n;
  return lowest;
}

}  // namespace

bool either_is_called(const importer::SourceModel& source, const importer::SourceMesh& mesh, NameQuestion is_called) {
  return is_called(mesh.name) || is_called(importer::material_name(source, mesh));
}

bool hair_is_called(const importer::SourceModel& source, const HairMesh& hair, NameQuestion is_called,
                    NameQuestion is_file_called) {
  const auto says_so = [&](std::uint32_t m) { return either_is_called(source, source.meshes[m], is_called); };
  if (!hair.source_meshes.empty() && std::ranges::all_of(hair.source_meshes, says_so)) return true;
  return source.meshes.size() == hair.source_meshes.size() &&
         is_file_called(std::filesystem::path(source.path).stem().string());
}

bool is_beard(const importer::SourceModel& source, const HairMesh& hair) {
  constexpr double kMiddle = 0.35, kHardlyAny = 0.02;  // of half the box's sides; of the hair's surface
  if (!hair_is_called(source, hair, is_called_beard, is_called_beard)) return false;
  const Eigen::AlignedBox3d box = hair.box();
  double above = 0, all = 0;
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    const Eigen::Vector3f a = hair.corner(t, 0), b = hair.corner(t, 1), c = hair.corner(t, 2);
    const auto area = double((b - a).cross(c - a).norm());
    const Eigen::Vector3d at = ((a + b + c) / 3).cast<double>() - box.center();
    const Eigen::Vector3d reach = kMiddle * box.sizes() / 2;
    all += area;
    if (at.y() > 0 && std::abs(at.x()) < reach.x() && std::abs(at.z()) < reach.z()) above += area;
  }
  return above <= kHardlyAny * all;
}

float weight_on(const importer::SourceMesh& mesh, std::size_t v, const std::vector<bool>& counts) {
  if (mesh.influence_begin.empty()) return counts[mesh.node] ? 1.0f : 0.0f;
  float sum = 0;
  for (std::uint32_t k = mesh.influence_begin[v]; k < mesh.influence_begin[v + 1]; ++k) {
    if (counts[mesh.influences[k].node]) sum += mesh.influences[k].weight;
  }
  return sum;
}

bool moves_limbs(const importer::SourceModel& source) {
  constexpr double kGoodPart = 0.02;  // share of all vertices: feet have few
  std::vector<bool> is_limb;
  for (const importer::SourceNode& node : source.nodes) is_limb.push_back(is_called_limb(node.name));
  std::size_t moved = 0, all = 0;
  for (const importer::SourceMesh& mesh : source.meshes) {
    all += mesh.positions.size();
    for (std::size_t v = 0; v + 1 < mesh.influence_begin.size(); ++v)
      moved += weight_on(mesh, v, is_limb) > 0.5f ? 1 : 0;
  }
  return double(moved) > kGoodPart * double(all);
}

std::uint32_t guess_head_node(const importer::SourceModel& source) {
  if (source.head_node != importer::kNoIndex) return source.head_node;
  std::vector<std::size_t> below(source.nodes.size(), 1);
  for (std::size_t n = source.nodes.size(); n-- > 0;) {
    if (source.nodes[n].parent != importer::kNoIndex) below[source.nodes[n].parent] += below[n];
  }
  const std::vector<bool> carries_mesh = nodes_of_meshes(source);
  std::uint32_t head = importer::kNoIndex;
  // A mesh called head is not a bone, unless the skeleton goes on below it.
  for (const bool meshes_too : {false, true}) {
    for (std::uint32_t n = 0; n < source.nodes.size() && (head == importer::kNoIndex || !meshes_too); ++n) {
      const bool is_bone = !carries_mesh[n] || (meshes_too && below[n] > 1);
      if (!is_bone || !is_called_head(source.nodes[n].name)) continue;
      if (head == importer::kNoIndex || below[n] > below[head]) head = n;
    }
  }
  return head != importer::kNoIndex ? head : node_above_hair(source, carries_mesh);
}

std::vector<bool> find_hair_bones(const importer::SourceModel& source) {
  const std::vector<bool> below_head = nodes_below(source, guess_head_node(source));
  const std::vector<bool> carries_mesh = nodes_of_meshes(source);
  std::vector<bool> hair(source.nodes.size(), false);
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    hair[n] = below_head[n] && !carries_mesh[n] && is_called_hair(source.nodes[n].name);
  }
  for (const importer::SourceSpring& spring : source.springs) {
    for (const importer::SourceSpringJoint& joint : spring.joints) {
      if (below_head[joint.node]) hair[joint.node] = true;
    }
  }
  return hair;
}

std::vector<bool> find_carriers(const importer::SourceModel& source) {
  const std::vector<bool> hair = find_hair_bones(source);
  const bool has_hair_bones = std::ranges::count(hair, true) > 0;
  std::vector<bool> carries = hair;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    const std::uint32_t parent = source.nodes[n].parent;
    if (parent != importer::kNoIndex && hair[n] == false && carries[parent] && has_hair_bones) carries[n] = true;
    if (!has_hair_bones) carries[n] = !is_called_face_part(source.nodes[n].name);
  }
  for (std::size_t n = source.nodes.size(); n-- > 0;) {
    if (carries[n] && has_hair_bones && source.nodes[n].parent != importer::kNoIndex)
      carries[source.nodes[n].parent] = true;
  }
  return carries;
}

std::vector<PieceEvidence> weigh_pieces(const importer::SourceModel& source, const importer::SourceMesh& mesh,
                                        const MeshPieces& pieces, const std::vector<bool>& hair_bones,
                                        std::uint32_t head_node) {
  std::vector<PieceEvidence> evidence(pieces.count);
  for (PieceEvidence& piece : evidence) piece.height = -1.0e30;
  const NodeKinds kinds{hair_bones, nodes_of_eyes(source), nodes_below(source, head_node)};
  for (std::size_t t = 0; t < pieces.piece_of.size(); ++t) {
    PieceEvidence& piece = evidence[pieces.piece_of[t]];
    ++piece.triangles;
    double hair = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      hair += add_vertex(mesh, mesh.triangles[3 * t + k], kinds, piece);
    }
    piece.largest_triangle_share = std::max(piece.largest_triangle_share, hair / 3);
  }
  for (PieceEvidence& piece : evidence) {
    const double corners = 3 * double(piece.triangles);
    piece.hair_bone_share /= corners;
    piece.eye_bone_share /= corners;
    piece.head_share /= corners;
  }
  return evidence;
}

}  // namespace coif::cook
