#pragma once

// The parts of a model that may be hair, and how likely each is.

#include "cook/select/select_hair.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::cook {

/// What is known of a part, each 0..1 unless it says otherwise. The order is that of kFeatureNames.
enum class Feature : std::uint8_t {
  kCalledHair,   ///< 1: its material, mesh or texture.
  kCalledOther,  ///< 1: headwear, an adornment, skin, an eye, a brow or a part of the face.
  kHairBones,    ///< 1: hair bones move it.
  kEyeBones,     ///< Share of its weight.
  kTransparent,  ///< 1: its material is.
  kHeadShare,    ///< Share of its weight.
  kCrown,        ///< Share of the crown's directions in which it is outermost.
  kFace,         ///< The same of the face.
  kMiddle,       ///< The same of the middle of the face.
  kUnlikeFace,   ///< How far its colour is from that of the middle of the face; 0 where either is unknown.
  kLikeFace,     ///< 1: both are known and nearly the same.
  kHigh,         ///< Height of its middle over the head's centre, in radii, -2..2.
  kLarge,        ///< Diagonal of its box over that of the head, 0..2.
  kOnlyPieces,   ///< 1: it is part of a mesh and told apart by its form alone.
  kBesideMoved,  ///< 1: hair bones move something of its mesh.
  kCount
};

inline constexpr std::size_t kFeatures = std::size_t(Feature::kCount);
/// As in the listing's JSON and in the script that fits the weights.
extern const std::array<const char*, kFeatures> kFeatureNames;

/// One part: a mesh of one material, or pieces of such a mesh that have one colour or hang together.
struct HairCandidate {
  std::uint32_t mesh = 0;
  bool is_whole_mesh = true;
  std::vector<bool> taken;  ///< Per triangle of the mesh.
  std::size_t triangles = 0;
  std::optional<Eigen::Vector3f> color;      ///< As seen, red, green and blue, 0..1; none where it is not known.
  std::array<double, kFeatures> features{};  ///< By Feature.
  double probability = 0;                    ///< That a person would call it hair.

  [[nodiscard]] double at(Feature feature) const { return features[std::size_t(feature)]; }
  /// Share of its triangles that are chosen, 0..1.
  [[nodiscard]] double share_of(const HairChoice& choice) const;
};

struct HairCandidates {
  bool sees_head = false;           ///< A head was found, so that places on it mean something.
  std::vector<HairCandidate> list;  ///< Likeliest first. Every triangle that may be hair is in one of them.
};

/// All parts of a model that are, or reach, on the head; all meshes where no head is found. Images are
/// not looked at: parts of a palette are told apart by their cells.
[[nodiscard]] HairCandidates find_hair_candidates(const importer::SourceModel& source, double weld_distance);

/// That a part with these features is hair, 0..1. The weights are fitted by tests/corpus/fit_candidates.py.
[[nodiscard]] double probability_of_hair(const std::array<double, kFeatures>& features, bool sees_head);

/// What speaks for it and against it, in words: "its material is called 'Hair'; it covers 61 % of the crown".
[[nodiscard]] std::string reason_for(const importer::SourceModel& source, const HairCandidate& candidate);

/// The numbers of the candidates that are nearest to the points (model space, metres), each once. Error (kBadInput): a
/// point is more than 10 cm from all of them.
[[nodiscard]] tl::expected<std::vector<std::size_t>, ToolError> parts_at(const importer::SourceModel& source,
                                                                         const HairCandidates& candidates,
                                                                         std::span<const std::array<double, 3>> points);

/// The recipe's value of "hair" that takes what is chosen and nothing else: {"meshes": ["Head"], "materials": ["Red"]},
/// or, where names do not tell it apart, points on its parts: {"parts": [[0, 1.7, 0.1]]}. What is chosen in no
/// candidate is left out of these.
[[nodiscard]] std::string recipe_line(const importer::SourceModel& source, const HairChoice& choice,
                                      const HairCandidates& candidates);
/// That of one candidate of the list.
[[nodiscard]] std::string recipe_line(const importer::SourceModel& source, const HairCandidate& candidate,
                                      const HairCandidates& candidates);

/// "mesh 'Head' (material 'Red')", "612 triangles of mesh 'Head' (material 'Red')"
[[nodiscard]] std::string name_of(const importer::SourceModel& source, const HairCandidate& candidate);

/// The error for a character on which nothing shows what hair is, with the likeliest parts: a body is never cooked.
[[nodiscard]] tl::unexpected<ToolError> no_hair_on(const importer::SourceModel& source,
                                                   const HairCandidates& candidates);

/// The error for a model with the form of a body. Exporters most often leave curves and particles out of such a file.
[[nodiscard]] tl::unexpected<ToolError> no_hair_in_body(const importer::SourceModel& source);

}  // namespace coif::cook
