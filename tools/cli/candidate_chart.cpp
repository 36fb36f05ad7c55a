#include "cli/asset_summary.h"

#include "base/text.h"
#include "render/patch_color.h"
#include "render/picture.h"
#include "render/picture_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::cli {
namespace {

using cook::HairCandidate, cook::HairCandidates;
using importer::SourceMesh, importer::SourceModel;
using render::PictureColor;

constexpr std::uint32_t kChartSide = 500;          ///< Pixels of one view.
constexpr std::uint32_t kChartLine = 20;           ///< Pixels of one line of the legend.
constexpr std::size_t kChartMostLines = 12;        ///< Parts in the legend.
constexpr float kChartMargin = 0.55f;              ///< Half a view's width over the size of what is in it.
constexpr PictureColor kChartRest{150, 150, 150};  ///< What is no candidate.
constexpr PictureColor kChartBackground{40, 40, 40};
constexpr PictureColor kChartInk{235, 235, 235};

PictureColor color_of_part(std::size_t number) {
  const Eigen::Vector3f linear = render::patch_color(number);
  PictureColor color;
  for (std::size_t c = 0; c < 3; ++c)
    color[c] =
        std::uint8_t(std::lround(255 * std::pow(std::clamp(1.6f * linear[Eigen::Index(c)], 0.0f, 1.0f), 1 / 2.2f)));
  return color;
}

/// One view along an axis, into a square of the picture. Nearer triangles hide others.
class PartView {
 public:
  PartView(render::Picture& picture, std::uint32_t left, const Eigen::AlignedBox3f& box, float turn)
      : picture_(picture), left_(left), middle_(box.center()), depth_(std::size_t(kChartSide) * kChartSide, -1.0e30f) {
    right_ = {std::cos(turn), 0, -std::sin(turn)};
    towards_ = {std::sin(turn), 0, std::cos(turn)};
    scale_ = float(kChartSide) / (2 * kChartMargin * std::max(box.sizes().maxCoeff(), 1.0e-6f));
  }

  void draw(const SourceMesh& mesh, std::size_t t, const PictureColor& color) {
    Eigen::Vector3f at[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3f p = mesh.positions[mesh.triangles[3 * t + k]] - middle_;
      at[k] = {kChartSide / 2 + scale_ * p.dot(right_), kChartSide / 2 - scale_ * p.y(), p.dot(towards_)};
    }
    const Eigen::Vector3f a = at[1] - at[0], b = at[2] - at[0];
    const float area = a.x() * b.y() - a.y() * b.x();
    if (!(std::abs(area) > 1.0e-9f)) return;
    const Eigen::Vector3f p = mesh.positions[mesh.triangles[3 * t]];
    const Eigen::Vector3f normal = (mesh.positions[mesh.triangles[3 * t + 1]] - p)
                                       .cross(mesh.positions[mesh.triangles[3 * t + 2]] - p)
                                       .normalized();
    const float light = 0.45f + 0.55f * std::abs(normal.dot(towards_));
    const auto low = [&](Eigen::Index i) { return std::max(0.0f, std::min({at[0][i], at[1][i], at[2][i]})); };
    const auto high = [&](Eigen::Index i) {
      return std::min(float(kChartSide) - 1, std::max({at[0][i], at[1][i], at[2][i]}));
    };
    for (float y = std::floor(low(1)); y <= high(1); ++y) {
      for (float x = std::floor(low(0)); x <= high(0); ++x) {
        const float dx = x + 0.5f - at[0].x(), dy = y + 0.5f - at[0].y();
        const float u = (dx * b.y() - dy * b.x()) / area, v = (dy * a.x() - dx * a.y()) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        float& depth = depth_[std::size_t(y) * kChartSide + std::size_t(x)];
        const float here = at[0].z() + u * a.z() + v * b.z();
        if (here <= depth) continue;
        depth = here;
        std::uint8_t* pixel = &picture_.rgba[4 * (std::size_t(y) * picture_.width + left_ + std::size_t(x))];
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = std::uint8_t(light * float(color[c]));
      }
    }
  }

 private:
  render::Picture& picture_;
  std::uint32_t left_;
  Eigen::Vector3f middle_;
  std::vector<float> depth_;
  Eigen::Vector3f right_, towards_;
  float scale_ = 1;
};

Eigen::AlignedBox3f box_of(const SourceModel& model, const HairCandidates& candidates) {
  Eigen::AlignedBox3f box;
  for (const HairCandidate& part : candidates.list) {
    const SourceMesh& mesh = model.meshes[part.mesh];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      if (part.taken[i / 3]) box.extend(mesh.positions[mesh.triangles[i]]);
  }
  for (std::size_t m = 0; m < model.meshes.size() && candidates.list.empty(); ++m)
    for (const Eigen::Vector3f& p : model.meshes[m].positions) box.extend(p);
  return box;
}

void draw_legend(const SourceModel& model, const HairCandidates& candidates, render::Picture& picture) {
  std::uint32_t top = kChartSide + kChartLine / 2;
  for (std::size_t k = 0; k < std::min(kChartMostLines, candidates.list.size()); ++k, top += kChartLine) {
    const HairCandidate& part = candidates.list[k];
    const std::string text =
        printable_ascii(fmt::format("{} {}", cook::certainty_text(part.probability), cook::name_of(model, part)));
    render::fill_rectangle(picture, 10, top, 30, top + 14, color_of_part(k));
    render::PictureText(text, 4 * picture.width, 2).draw(picture, 40, top, kChartInk);
  }
}

}  // namespace

render::Picture candidates_chart(const SourceModel& model, const HairCandidates& candidates) {
  constexpr std::array<float, 3> kTurns{0, 1.5707964f, 3.1415927f};
  render::Picture picture;
  picture.width = kChartSide * std::uint32_t(kTurns.size());
  picture.height = kChartSide + kChartLine * std::uint32_t(1 + std::min(kChartMostLines, candidates.list.size()));
  picture.rgba.assign(4 * std::size_t(picture.width) * picture.height, 255);
  render::fill_rectangle(picture, 0, 0, picture.width, picture.height, kChartBackground);
  const Eigen::AlignedBox3f box = box_of(model, candidates);
  if (box.isEmpty()) return picture;
  std::vector<std::vector<PictureColor>> colors;
  for (const SourceMesh& mesh : model.meshes) colors.emplace_back(mesh.triangles.size() / 3, kChartRest);
  for (std::size_t k = 0; k < candidates.list.size(); ++k)
    for (std::size_t t = 0; t < candidates.list[k].taken.size(); ++t)
      if (candidates.list[k].taken[t]) colors[candidates.list[k].mesh][t] = color_of_part(k);
  for (std::uint32_t v = 0; v < kTurns.size(); ++v) {
    PartView view(picture, v * kChartSide, box, kTurns[v]);
    for (std::size_t m = 0; m < model.meshes.size(); ++m)
      for (std::size_t t = 0; t < colors[m].size(); ++t) view.draw(model.meshes[m], t, colors[m][t]);
  }
  draw_legend(model, candidates, picture);
  return picture;
}

}  // namespace coif::cli
