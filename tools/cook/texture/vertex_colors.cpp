#include "cook/texture/vertex_colors.h"

#include "cook/recipe/drawn_recipe.h"
#include "cook/select/mesh_topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Array4f;
using Eigen::Vector2f;
using Eigen::Vector4f;

constexpr float kNearlyNothing = 1.5f / 255;
constexpr std::uint32_t kCells = 128;      ///< Cells on each side of the unit square in which strips are compared.
constexpr std::uint32_t kMostSheets = 48;  ///< For one look.
constexpr float kSameColor = 0.03f;  ///< In square roots of linear numbers: differences that the eye does not see.
constexpr std::uint32_t kUnpaintedSide = 64;  ///< Side of the white image for a look without one.
constexpr double kManyCells = 4.0 * kCells * kCells;

float difference(const Vector4f& a, const Vector4f& b) {
  return (a.array().max(0.0f).sqrt() - b.array().max(0.0f).sqrt()).abs().maxCoeff();
}

/// The colours of islands that share the texels of one image.
struct ColorSheet {
  std::vector<Vector4f> color = std::vector<Vector4f>(std::size_t(kCells) * kCells);
  std::vector<bool> is_used = std::vector<bool>(std::size_t(kCells) * kCells, false);
};

struct ColoredCell {
  std::uint32_t cell;
  Vector4f color;
};

std::uint32_t wrapped_cell(std::int64_t at) { return std::uint32_t((at % kCells + kCells) % kCells); }

/// The cells whose middle a triangle covers, and the cell of its own middle.
void add_cells(const HairMesh& hair, std::size_t t, std::vector<ColoredCell>& out) {
  const std::uint32_t* const v = &hair.triangles[3 * t];
  const Vector2f a = hair.uvs[v[0]] * kCells, b = hair.uvs[v[1]] * kCells, c = hair.uvs[v[2]] * kCells;
  const auto color_at = [&](float wa, float wb, float wc) -> Vector4f {
    return wa * hair.colors[v[0]] + wb * hair.colors[v[1]] + wc * hair.colors[v[2]];
  };
  const auto add = [&](std::int64_t x, std::int64_t y, const Vector4f& color) {
    out.push_back({wrapped_cell(y) * kCells + wrapped_cell(x), color});
  };
  const Vector2f middle = (a + b + c) / 3;
  add(std::int64_t(std::floor(middle.x())), std::int64_t(std::floor(middle.y())),
      color_at(1.0f / 3, 1.0f / 3, 1.0f / 3));
  const float area = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
  const Vector2f low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const double cells = double(high.x() - low.x()) * double(high.y() - low.y());
  if (area == 0 || !(cells < kManyCells)) return;
  for (auto y = std::int64_t(std::floor(low.y())); float(y) <= high.y(); ++y) {
    for (auto x = std::int64_t(std::floor(low.x())); float(x) <= high.x(); ++x) {
      const Vector2f p(float(x) + 0.5f, float(y) + 0.5f);
      const float wb = ((p - a).x() * (c - a).y() - (p - a).y() * (c - a).x()) / area;
      const float wc = ((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x()) / area;
      if (wb >= 0 && wc >= 0 && wb + wc <= 1) add(x, y, color_at(1 - wb - wc, wb, wc));
    }
  }
}

float worst_difference(const ColorSheet& sheet, std::span<const ColoredCell> cells) {
  float worst = 0;
  for (const ColoredCell& at : cells) {
    if (sheet.is_used[at.cell]) worst = std::max(worst, difference(sheet.color[at.cell], at.color));
  }
  return worst;
}

/// The sheet of each island of one look: the first one in which no earlier island has other colours there.
std::vector<std::uint32_t> sheets_of(const HairMesh& hair, std::span<const std::vector<std::size_t>> islands) {
  std::vector<ColorSheet> sheets;
  std::vector<std::uint32_t> sheet_of;
  std::vector<ColoredCell> cells;
  for (const std::vector<std::size_t>& island : islands) {
    cells.clear();
    for (const std::size_t t : island) add_cells(hair, t, cells);
    std::uint32_t best = 0;
    float least = INFINITY;
    for (std::uint32_t s = 0; s < sheets.size() && least > kSameColor; ++s) {
      const float worst = worst_difference(sheets[s], cells);
      if (worst < least) {
        least = worst;
        best = s;
      }
    }
    if (least > kSameColor && sheets.size() < kMostSheets) {
      best = std::uint32_t(sheets.size());
      sheets.emplace_back();
    }
    for (const ColoredCell& at : cells) {
      if (sheets[best].is_used[at.cell]) continue;
      sheets[best].is_used[at.cell] = true;
      sheets[best].color[at.cell] = at.color;
    }
    sheet_of.push_back(best);
  }
  return sheet_of;
}

/// The common colour of all triangles of a look; none where they differ.
std::optional<Vector4f> only_color(const SurfaceLooks& looks, std::uint32_t look, const HairMesh& hair) {
  std::optional<Vector4f> only;
  for (std::size_t i = 0; i < hair.triangles.size(); ++i) {
    if (looks.of_triangle[i / 3] != look) continue;
    const Vector4f& color = hair.colors[hair.triangles[i]];
    if (!only) only = color;
    if ((color - *only).cwiseAbs().maxCoeff() > 1.0e-3f) return std::nullopt;
  }
  return only;
}

/// A look of one colour needs no texels for it.
void paint_looks_of_one_color(SurfaceLooks& looks, HairMesh& hair) {
  for (std::uint32_t i = 0; i < looks.looks.size(); ++i) {
    const std::optional<Vector4f> only = only_color(looks, i, hair);
    if (!only) continue;
    SurfaceLook& look = looks.looks[i];
    look.factor = look.factor.cwiseProduct(*only).cwiseMin(1.0f);
    for (std::size_t k = 0; k < hair.triangles.size(); ++k) {
      if (looks.of_triangle[k / 3] == i) hair.colors[hair.triangles[k]].setOnes();
    }
  }
}

bool is_plain(const HairMesh& hair) {
  return std::ranges::all_of(hair.triangles, [&](std::uint32_t v) { return hair.colors[v] == Vector4f::Ones(); });
}

}  // namespace

void judge_vertex_colors(const DrawnRecipe& recipe, HairMesh& hair, Findings& findings) {
  if (hair.colors.empty()) return;
  float brightest = 0, solidest = 0;
  for (const std::uint32_t v : hair.triangles) {
    brightest = std::max(brightest, hair.colors[v].head<3>().maxCoeff());
    solidest = std::max(solidest, hair.colors[v].w());
  }
  const char* const nothing = brightest < kNearlyNothing ? "black" : solidest < kNearlyNothing ? "clear" : nullptr;
  if (recipe.vertex_colors == VertexColors::kAuto && nothing != nullptr) {
    findings.warn(
        "C152",
        fmt::format(
            "the hair's vertex colours are all {}: they are taken for numbers of another program and not used; to use "
            "them, set \"textures.vertex_colors\" to \"multiply\"",
            nothing));
  }
  const bool is_used = recipe.vertex_colors == VertexColors::kMultiply ||
                       (recipe.vertex_colors == VertexColors::kAuto && nothing == nullptr);
  if (!is_used || is_plain(hair)) return hair.colors.clear();
  findings.note(
      "vertex colours multiply colour and alpha of the hair; \"textures.vertex_colors\": \"ignore\" does without");
}

namespace {

/// Without coordinates images show nothing, and factors are colours like those of vertices.
void paint_vertices(SurfaceLooks& looks, HairMesh& hair) {
  std::vector<bool> is_painted(hair.colors.size(), false);
  for (std::size_t i = 0; i < hair.triangles.size(); ++i) {
    const std::uint32_t v = hair.triangles[i];
    if (is_painted[v]) continue;
    hair.colors[v] = hair.colors[v].cwiseProduct(looks.looks[looks.of_triangle[i / 3]].factor);
    is_painted[v] = true;
  }
  const JointAlpha alpha = join_alpha(looks.looks);
  SurfaceLook joint = looks.looks[looks.main];
  joint.image = joint.normals = joint.strands = nullptr;
  joint.factor.setOnes();
  joint.alpha_use = alpha.use;
  joint.alpha_cutoff = alpha.cutoff;
  looks.looks = {joint};
  looks.main = 0;
  std::ranges::fill(looks.of_triangle, 0u);
}

/// Copies cost detail where they do not fit the size that the cooked image may have.
void tell_of_copies(const SurfaceLook& look, std::uint32_t copies, std::uint32_t max_size, Findings& findings) {
  if (look.image == nullptr || copies < 2) return;
  std::string text = fmt::format(
      "material '{}': strips show the same part of its texture in different vertex colours, so that it is stored "
      "{} times",
      look.name, copies);
  const double wanted = double(copies) * double(look.image->texel_count()), most = double(max_size) * max_size;
  if (wanted <= most) return findings.note(std::move(text));
  findings.warn(
      "C152",
      fmt::format(
          "{}, at {:.0f} % of its size: paint the colours into the texture, raise \"textures.max_size\", or set "
          "\"textures.vertex_colors\" to \"ignore\"",
          text, 100 * std::sqrt(most / wanted)));
}

}  // namespace

void split_by_vertex_colors(SurfaceLooks& looks, HairMesh& hair, std::uint32_t max_size, Findings& findings) {
  if (hair.colors.empty()) return;
  if (hair.uvs.empty()) {
    paint_vertices(looks, hair);
    paint_looks_of_one_color(looks, hair);
    if (is_plain(hair)) hair.colors.clear();
    return;
  }
  paint_looks_of_one_color(looks, hair);
  const auto before = std::uint32_t(looks.looks.size());
  for (std::uint32_t i = 0; i < before; ++i) {
    if (only_color(looks, i, hair)) continue;
    const auto islands = color_islands(hair, [&](std::size_t t) { return looks.of_triangle[t] == i; });
    const std::vector<std::uint32_t> sheet_of = sheets_of(hair, islands);
    const std::uint32_t sheets = *std::ranges::max_element(sheet_of) + 1, first = std::uint32_t(looks.looks.size()) - 1;
    for (std::uint32_t s = 1; s < sheets; ++s) looks.looks.push_back(SurfaceLook(looks.looks[i]));
    for (std::size_t k = 0; k < islands.size(); ++k) {
      for (const std::size_t t : islands[k]) looks.of_triangle[t] = sheet_of[k] == 0 ? i : first + sheet_of[k];
    }
    tell_of_copies(looks.looks[i], sheets, max_size, findings);
  }
  paint_looks_of_one_color(looks, hair);
  if (is_plain(hair)) return hair.colors.clear();
  for (std::uint32_t i = 0; i < looks.looks.size(); ++i) {
    SurfaceLook& look = looks.looks[i];
    if (look.image != nullptr || only_color(looks, i, hair)) continue;
    const std::size_t texels = std::size_t(kUnpaintedSide) * kUnpaintedSide;
    look.image =
        &looks.made.emplace_back(Image{kUnpaintedSide, kUnpaintedSide, 4, std::vector<std::uint8_t>(4 * texels, 255)});
  }
}

std::vector<std::vector<std::size_t>> color_islands(const HairMesh& hair,
                                                    const std::function<bool(std::size_t)>& takes) {
  DisjointSets sets(hair.positions.size());
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    if (!takes(t)) continue;
    sets.unite(hair.triangles[3 * t], hair.triangles[3 * t + 1]);
    sets.unite(hair.triangles[3 * t], hair.triangles[3 * t + 2]);
  }
  std::vector<std::uint32_t> number(hair.positions.size(), importer::kNoIndex);
  std::vector<std::vector<std::size_t>> islands;
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    if (!takes(t)) continue;
    std::uint32_t& island = number[sets.find(hair.triangles[3 * t])];
    if (island == importer::kNoIndex) {
      island = std::uint32_t(islands.size());
      islands.emplace_back();
    }
    islands[island].push_back(t);
  }
  return islands;
}

}  // namespace coif::cook
