#include "cook/hair_styles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace coif::cook {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kPi = 3.14159265f;

/// The same numbers with every standard library.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  float between(float low, float high) { return low + (high - low) * float(engine_()) * 0x1p-32f; }
  bool happens(float chance) { return between(0, 1) < chance; }
  std::uint32_t below(std::uint32_t count) { return std::uint32_t(std::uint64_t(engine_()) * count >> 32); }

 private:
  std::mt19937 engine_;
};

/// Half an ellipsoid of skin that hair grows on, and the way that it takes from there.
struct Scalp {
  Vector3f center{0, 1.6f, 0}, radii;

  /// `up` 0: as low as hair grows at the side, 1: the top; `around` 0: the face.
  [[nodiscard]] Vector3f at(float around, float up) const {
    const float lowest = 0.1f + 0.45f * std::max(0.0f, std::cos(around)) - 0.5f * std::max(0.0f, -std::cos(around));
    const float height = lowest + (kPi / 2 - lowest) * up;
    return center + radii.cwiseProduct(Vector3f(std::sin(around) * std::cos(height), std::sin(height),
                                                std::cos(around) * std::cos(height)));
  }
  [[nodiscard]] Vector3f normal(const Vector3f& p) const {
    return (p - center).cwiseQuotient(radii.cwiseAbs2()).normalized();
  }
  /// Moved out until it is `layer` above the skin.
  [[nodiscard]] Vector3f outside(const Vector3f& p, float layer) const {
    const Vector3f grown = radii + Vector3f::Constant(layer), q = (p - center).cwiseQuotient(grown);
    return q.norm() >= 1 ? p : Vector3f(center + grown.cwiseProduct(q.normalized()));
  }
};

struct Strand {
  Vector3f root{0, 0, 0}, towards{0, 0, 0};
  float length = 0.2f;
  float cling = 0.5f;  ///< Share of the length that goes along the skin.
  float lift = 0;      ///< How much it stands off.
  float layer = 0.005f;
  float curl = 0;           ///< Metres.
  bool ends_there = false;  ///< It is tied up at `towards`.
};

std::vector<Vector3f> grow(const Scalp& scalp, const Strand& strand, std::uint32_t rows) {
  constexpr int kSteps = 96;
  std::vector<Vector3f> line{strand.root};
  Vector3f p = strand.root;
  const float step = strand.length / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const float at = float(i) / kSteps;
    const Vector3f normal = scalp.normal(p);
    Vector3f way = strand.towards - p;
    if (!strand.ends_there) way = way.normalized() - normal * normal.dot(way.normalized());
    if (strand.ends_there && way.norm() < 2 * step) break;
    const float falls = strand.ends_there ? 0 : std::clamp((at - strand.cling) / 0.2f, 0.0f, 1.0f);
    Vector3f direction = (1 - falls) * way.normalized() + Vector3f(0, -falls, 0);
    direction += strand.lift * (1 - at) * normal;
    p = p + step * direction.normalized();
    // A root sits in the skin, and the strand comes up from there.
    p = scalp.outside(p, strand.layer * std::min(1.0f, 6 * at));
    line.push_back(p);
  }
  std::vector<Vector3f> rows_of;
  for (std::uint32_t k = 0; k <= rows; ++k) {
    const float at = float(k) / float(rows) * float(line.size() - 1);
    const std::size_t i = std::min(line.size() - 2, std::size_t(at));
    const float turn = 30 * float(k) / float(rows);
    const float out = strand.curl * float(k) / float(rows);
    rows_of.push_back(line[i] + (at - float(i)) * (line[i + 1] - line[i]) +
                      out * Vector3f(std::cos(turn), 0, std::sin(turn)));
  }
  return rows_of;
}

/// Where a strip is in the picture, and which way it lies there.
struct Cell {
  Vector2f low{0, 0}, high{1, 1};
  bool along_u = false, root_high = false;

  [[nodiscard]] Vector2f at(float across, float along) const {
    const float down = root_high ? 1 - along : along;
    return low + Vector2f(along_u ? down : across, along_u ? across : down).cwiseProduct(high - low);
  }
};

struct Look {
  std::vector<Cell> cells;
  bool textured = true;
  float tip_width = 1, root_width = 1, width = 0.02f;
  std::uint32_t columns = 1, rows = 8;
};

std::vector<Cell> make_cells(Dice& dice) {
  const bool along_u = dice.happens(0.2f), root_high = dice.happens(0.5f);
  const std::uint32_t count = dice.happens(0.4f) ? 1 : 2 + dice.below(5);
  // Most artists paint all roots at one side; some pack the pieces as they fit.
  const float turned = dice.happens(0.25f) ? 0.3f : 0, flipped = dice.happens(0.25f) ? 0.4f : 0;
  std::vector<Cell> cells;
  for (std::uint32_t k = 0; k < count; ++k) {
    const float low = float(k) / float(count), high = float(k + 1) / float(count) - (count > 1 ? 0.02f : 0.0f);
    Cell cell{along_u ? Vector2f(0, low) : Vector2f(low, 0), along_u ? Vector2f(1, high) : Vector2f(high, 1), along_u,
              root_high};
    if (dice.happens(flipped)) cell.root_high = !cell.root_high;
    if (dice.happens(turned)) cell.along_u = !cell.along_u;
    cells.push_back(cell);
  }
  return cells;
}

/// Lines of different brightness along the strands; they get thin and far between towards the tip.
Image paint_cells(const std::vector<Cell>& cells, bool fades, Dice& dice) {
  constexpr std::uint32_t kSide = 128;
  Image image{kSide, kSide, 4, {}};
  image.texels.assign(std::size_t(kSide) * kSide * 4, 0);
  for (const Cell& cell : cells) {
    std::array<float, 64> shade{}, length{};
    for (std::size_t k = 0; k < shade.size(); ++k) {
      shade[k] = dice.between(60, 200);
      length[k] = fades ? dice.between(0.6f, 1) : 2;
    }
    const Vector2f size = (cell.high - cell.low) * float(kSide), low = cell.low * float(kSide);
    for (int y = int(low.y()); y < int(low.y() + size.y()); ++y) {
      for (int x = int(low.x()); x < int(low.x() + size.x()); ++x) {
        const float u = (float(x) + 0.5f - low.x()) / size.x(), v = (float(y) + 0.5f - low.y()) / size.y();
        const float across = cell.along_u ? v : u, down = cell.along_u ? u : v;
        const float along = cell.root_high ? 1 - down : down;
        const auto line = std::min<std::size_t>(63, std::size_t(across * 63));
        std::uint8_t* texel = &image.texels[4 * (std::size_t(y) * kSide + std::size_t(x))];
        for (int c = 0; c < 3; ++c)
          texel[c] = std::uint8_t(shade[line] * (1 - 0.15f * float(c)) * (0.8f + 0.2f * along));
        texel[3] = along < length[line] ? 255 : 0;
      }
    }
  }
  return image;
}

void add_strip(const Scalp& scalp, const Strand& strand, const Look& look, Dice& dice, StyledHair& hair) {
  const std::vector<Vector3f> line = grow(scalp, strand, look.rows);
  const Cell& cell = look.cells[dice.below(std::uint32_t(look.cells.size()))];
  importer::SourceMesh& mesh = hair.source.meshes.front();
  const auto first = std::uint32_t(mesh.positions.size());
  const bool mirrored = dice.happens(0.3f);
  for (std::uint32_t k = 0; k <= look.rows; ++k) {
    const float at = float(k) / float(look.rows);
    const Vector3f ahead = line[std::min<std::size_t>(k + 1, look.rows)], behind = line[k > 0 ? k - 1 : 0];
    const Vector3f way = (ahead - behind).normalized(), normal = scalp.normal(line[k]);
    const Vector3f side = way.cross(normal).stableNormalized();
    const float widest =
        at < 0.4f ? look.root_width + (1 - look.root_width) * at / 0.4f : 1 + (look.tip_width - 1) * (at - 0.4f) / 0.6f;
    for (std::uint32_t c = 0; c <= look.columns; ++c) {
      const float across = float(c) / float(look.columns);
      mesh.positions.push_back(line[k] + (across - 0.5f) * look.width * widest * side);
      if (look.textured) mesh.uvs.push_back(cell.at(mirrored ? 1 - across : across, at));
      hair.growth.push_back(way);
    }
  }
  const std::uint32_t wide = look.columns + 1;
  for (std::uint32_t k = 0; k < look.rows; ++k) {
    for (std::uint32_t c = 0; c < look.columns; ++c) {
      const std::uint32_t a = first + k * wide + c, b = a + 1, d = a + wide, e = d + 1;
      mesh.triangles.insert(mesh.triangles.end(), {a, d, b, b, d, e});
    }
  }
}

/// What the families have in common: how long, how dense, how the strands leave the skin.
struct Style {
  Scalp scalp;
  Look look;
  float length = 0.2f, cling = 0.5f, lift = 0, curl = 0;
  std::uint32_t strips = 60;
};

Vector3f random_root(const Scalp& scalp, Dice& dice) {
  return scalp.at(dice.between(-kPi, kPi), 1 - std::sqrt(dice.between(0, 1)));
}

/// From a whorl at the crown, or from a parting.
void hang_loose(const Style& style, bool parted, Dice& dice, StyledHair& hair) {
  const Vector3f crown = style.scalp.at(kPi, dice.between(0.75f, 0.95f));
  const float line = dice.between(-0.03f, 0.03f);
  for (std::uint32_t k = 0; k < style.strips; ++k) {
    Strand strand{random_root(style.scalp, dice)};
    strand.length = style.length * dice.between(0.7f, 1.1f);
    strand.cling = style.cling;
    strand.lift = style.lift;
    strand.curl = style.curl;
    strand.layer = 0.003f + 0.012f * float(k) / float(style.strips);
    Vector3f from = crown;
    if (parted) from = {style.scalp.center.x() + line, strand.root.y(), strand.root.z()};
    strand.towards = strand.root + 10 * (strand.root - from) + Vector3f(0, -1, 0);
    if (!parted && (strand.root - from).norm() < 0.01f) continue;
    add_strip(style.scalp, strand, style.look, dice, hair);
  }
}

void cut_fringe(const Style& style, Dice& dice, StyledHair& hair) {
  for (std::uint32_t k = 0; k < style.strips / 4 + 3; ++k) {
    Strand strand{style.scalp.at(dice.between(-0.5f, 0.5f), dice.between(0.5f, 0.8f))};
    strand.length = dice.between(0.08f, 0.13f);
    strand.cling = 1;
    strand.layer = 0.018f;
    strand.towards = strand.root + Vector3f(0, -0.4f, 1);
    add_strip(style.scalp, strand, style.look, dice, hair);
  }
}

/// Along the skin to where it is tied, and from there down.
void tie_up(const Style& style, float around, float up, float from, float to, Dice& dice, StyledHair& hair) {
  Scalp above = style.scalp;
  above.radii += Vector3f::Constant(0.02f);
  const Vector3f knot = above.at(around, up);
  for (std::uint32_t k = 0; k < style.strips; ++k) {
    Strand strand{style.scalp.at(dice.between(from, to),
                                 dice.between(0, 1) < 0.7f ? dice.between(0, 0.2f) : dice.between(0, 0.8f))};
    strand.towards = knot;
    strand.ends_there = true;
    strand.length = 0.4f;
    strand.layer = 0.004f + 0.01f * float(k) / float(style.strips);
    if ((strand.root - knot).norm() < 0.06f) continue;
    add_strip(style.scalp, strand, style.look, dice, hair);
  }
  for (std::uint32_t k = 0; k < style.strips / 3 + 4; ++k) {
    const Vector3f away = style.scalp.normal(knot);
    Strand strand{knot + 0.01f * Vector3f(dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1))};
    strand.towards = knot + away + Vector3f(dice.between(-0.2f, 0.2f), 0, 0);
    strand.length = style.length * dice.between(0.8f, 1.1f);
    strand.cling = 0.1f;
    strand.lift = 0.5f;
    strand.curl = style.curl;
    add_strip(style.scalp, strand, style.look, dice, hair);
  }
}

void stand_up(const Style& style, Dice& dice, StyledHair& hair) {
  for (std::uint32_t k = 0; k < style.strips; ++k) {
    Strand strand{random_root(style.scalp, dice)};
    strand.length = dice.between(0.05f, 0.14f);
    strand.cling = 1;
    strand.lift = dice.between(2, 5);
    strand.towards =
        strand.root + style.scalp.normal(strand.root) + Vector3f(dice.between(-1, 1), 0.5f, dice.between(-1, 1));
    add_strip(style.scalp, strand, style.look, dice, hair);
  }
}

Style roll_style(Dice& dice) {
  Style style;
  style.scalp.radii = {dice.between(0.072f, 0.085f), dice.between(0.1f, 0.125f), dice.between(0.09f, 0.105f)};
  style.strips = 20 + dice.below(100);
  style.length = dice.between(0.12f, 0.6f);
  style.cling = std::min(0.8f, 0.1f / style.length);
  style.lift = dice.between(0, 0.6f);
  style.look.cells = make_cells(dice);
  style.look.textured = !dice.happens(0.15f);
  style.look.columns = 1 + dice.below(3);
  style.look.rows = 4 + dice.below(10);
  style.look.width = dice.between(0.012f, 0.045f);
  style.look.tip_width = dice.happens(0.4f) ? 1 : dice.between(0.05f, 1);
  style.look.root_width = dice.happens(0.6f) ? 1 : dice.between(0.3f, 1);
  return style;
}

}  // namespace

StyledHair make_style(std::uint32_t seed) {
  Dice dice(seed);
  Style style = roll_style(dice);
  constexpr const char* kFamilies[] = {"loose", "parted", "fringe", "one tail", "two tails", "spikes", "curls"};
  const std::uint32_t family = seed % 7;
  StyledHair hair;
  hair.family = kFamilies[family];
  hair.source.meshes.resize(1);
  hair.source.meshes.front().name = "hair";
  if (family == 6) style.curl = dice.between(0.01f, 0.025f), style.look.rows = 24;
  if (family <= 2 || family == 6) hang_loose(style, family == 1, dice, hair);
  if (family == 2) cut_fringe(style, dice, hair);
  const float height = dice.between(0.15f, 0.8f), side = dice.between(1.7f, 2.4f);
  if (family == 3) tie_up(style, kPi, height, -kPi, kPi, dice, hair);
  if (family == 4) {
    tie_up(style, side, 0.3f, 0.05f, kPi - 0.05f, dice, hair);
    tie_up(style, -side, 0.3f, -kPi + 0.05f, -0.05f, dice, hair);
  }
  if (family == 5) stand_up(style, dice, hair);
  if (style.look.textured && dice.happens(0.7f)) hair.image = paint_cells(style.look.cells, dice.happens(0.7f), dice);
  return hair;
}

}  // namespace coif::cook
