#include "view/page/hair_views.h"

#include "render/patch_color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace coif::view {
namespace {

constexpr std::array<ScreenColor, 5> kOrderColors{
    {{0x42, 0x12, 0x5a}, {0x3a, 0x58, 0x96}, {0x20, 0x95, 0x8c}, {0x66, 0xbe, 0x58}, {0xe0, 0xd8, 0x32}}};

/// IEC 61966-2-1.
double encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

std::uint8_t byte_of(double share) { return std::uint8_t(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

void add_color(std::string& json, const ScreenColor& color, const std::string& text) {
  char number[16];
  std::snprintf(number, sizeof number, "#%02x%02x%02x", color[0], color[1], color[2]);
  json.append(json.back() == '[' ? "" : ",").append("{\"color\":\"").append(number);
  json.append("\",\"text\":\"").append(text).append("\"}");
}

void add_layers(std::string& json) {
  for (std::size_t i = 0; i < kLayerColors.size(); ++i) {
    const int least = i < 2 ? int(i) + 1 : (1 << (i - 1)) + 1, most = 1 << i;
    std::string text = std::to_string(least);
    if (i + 1 == kLayerColors.size())
      text += " and more";
    else if (most > least)
      text += " to " + std::to_string(most);
    add_color(json, kLayerColors[i], text);
  }
}

void add_order(std::string& json) {
  constexpr const char* kTexts[] = {"first", "a quarter", "half", "three quarters", "last"};
  for (std::size_t i = 0; i < kOrderColors.size(); ++i) add_color(json, kOrderColors[i], kTexts[i]);
}

}  // namespace

HairView hair_view_of(float choice) {
  return choice >= 1 && choice < 4 ? HairView(std::uint8_t(choice)) : HairView::kHair;
}

ScreenColor order_color(double share) {
  constexpr std::size_t kPieces = kOrderColors.size() - 1;
  const double place = std::clamp(share, 0.0, 1.0) * kPieces;
  const std::size_t piece = std::min(std::size_t(place), kPieces - 1);
  ScreenColor color;
  for (std::size_t k = 0; k < 3; ++k) {
    const double from = kOrderColors[piece][k], to = kOrderColors[piece + 1][k];
    color[k] = std::uint8_t(std::lround(from + (place - double(piece)) * (to - from)));
  }
  return color;
}

ScreenColor screen_color_of_patch(std::size_t patch) {
  const Eigen::Vector3f linear = render::patch_color(patch);
  ScreenColor color;
  for (int k = 0; k < 3; ++k) color[std::size_t(k)] = byte_of(encoded(double(linear[k])));
  return color;
}

std::string legend_json(const Asset& asset, HairView view, std::uint32_t lod) {
  std::string title;
  if (view == HairView::kPatches) {
    title = std::to_string(asset.lod_patches(lod).size()) +
            " patches, each in the colour that coif render --component patches gives it";
  }
  if (view == HairView::kOverdraw) title = "Layers of hair in a pixel";
  if (view == HairView::kOrder) title = "When a triangle is drawn";
  std::string json = "{\"title\":\"" + title + "\",\"colors\":[";
  if (view == HairView::kOverdraw) add_layers(json);
  if (view == HairView::kOrder) add_order(json);
  return json + "]}";
}

}  // namespace coif::view
