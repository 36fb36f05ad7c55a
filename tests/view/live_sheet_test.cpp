#include "view/sheet/live_sheet.h"

#include "base/json.h"
#include "models/drawn_card.h"
#include "models/skinned_asset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <string>

namespace coif::view::live_sheet_test {

const Asset& wig() {
  static const DrawnAsset asset(made_up_wig({.strips = 12, .texture_size = 32}));
  return *asset;
}

LiveSheet sheet_of(const std::vector<render::Gallery>& galleries) {
  auto sheet = live_sheet(wig(), galleries);
  EXPECT_TRUE(sheet) << sheet.error().message;
  return sheet ? *sheet : LiveSheet();
}

std::vector<render::Gallery> galleries(std::uint32_t only = 0) {
  return render::thesis_galleries(wig(), {.only = only});
}

std::size_t pictures_in(const std::vector<render::Gallery>& all) {
  std::size_t count = 0;
  for (const render::Gallery& gallery : all) count += gallery.pictures.size();
  return count;
}

nlohmann::json json_of(const LiveSheet& sheet) { return nlohmann::json::parse(sheet_json(wig(), sheet, {320, 240})); }

TEST(LiveSheet, EveryPictureHasATileOrAMomentOrIsLeftOut) {
  const auto all = galleries();
  const LiveSheet sheet = sheet_of(all);
  std::size_t shown = 0, tiles = 0;
  for (const LiveGallery& gallery : sheet.galleries) {
    for (const LiveTile& tile : gallery.tiles) {
      shown += std::max<std::size_t>(tile.moments.size(), 1);
      ++tiles;
    }
  }
  EXPECT_EQ(tiles, sheet.tiles);
  EXPECT_EQ(shown + sheet.pictures_left_out, pictures_in(all));
  EXPECT_GT(sheet.pictures_left_out, 0u);
}

TEST(LiveSheet, WhatIsLeftOutIsNamed) {
  const auto all = galleries();
  const LiveSheet sheet = sheet_of(all);
  std::set<std::string> titles;
  for (const LiveGallery& gallery : sheet.galleries) titles.insert(gallery.title);
  for (const render::Gallery& gallery : all) {
    EXPECT_NE(titles.contains(gallery.title), sheet.note.find(gallery.title) != std::string::npos) << gallery.title;
  }
  EXPECT_EQ(sheet_of(galleries(1)).note, "") << "nothing to say";
}

TEST(LiveSheet, CaptionsAreThePicturesOwn) {
  for (const render::Gallery& gallery : galleries(2)) {
    const LiveSheet sheet = sheet_of({gallery});
    ASSERT_EQ(sheet.galleries.at(0).tiles.size(), gallery.pictures.size());
    for (std::size_t i = 0; i < gallery.pictures.size(); ++i) {
      EXPECT_EQ(sheet.galleries[0].tiles[i].caption, gallery.pictures[i].caption);
    }
  }
}

TEST(LiveSheet, StillTilesAreOfTheirPicturesMaterialAndComponentToTheBit) {
  for (const std::uint32_t only : {1u, 2u, 3u, 4u}) {
    const auto all = galleries(only);
    const LiveSheet sheet = sheet_of(all);
    for (std::size_t i = 0; i < all[0].pictures.size(); ++i) {
      const LiveTile& tile = sheet.galleries.at(0).tiles.at(i);
      const render::PictureSettings& picture = all[0].pictures[i].settings;
      EXPECT_EQ(component_of(tile.settings), picture.component) << tile.caption;
      EXPECT_EQ(shadows_of(tile.settings), picture.shadows) << tile.caption;
      EXPECT_TRUE(tile.moments.empty());
      const MaterialRecord seen = material_of(wig(), tile.settings);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(seen.base_color[k], picture.material->base_color[k], 1e-6f * seen.base_color[k]);
      EXPECT_EQ(seen.shading, picture.material->shading);
      EXPECT_EQ(seen.primary_shift, picture.material->primary_shift) << tile.caption;
      EXPECT_EQ(seen.secondary_exponent, picture.material->secondary_exponent) << tile.caption;
      EXPECT_EQ(std::memcmp(seen.ambient, picture.material->ambient, sizeof seen.ambient), 0);
      EXPECT_EQ(seen.opaque_threshold, picture.material->opaque_threshold);
    }
  }
}

TEST(LiveSheet, MotionsPlayByTheirSolversFromWhereTheyAreSeenBestAndStayInThePicture) {
  const auto all = galleries(6);
  const LiveSheet sheet = sheet_of(all);
  ASSERT_EQ(sheet.tiles, all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const LiveTile& tile = sheet.galleries[i].tiles.at(0);
    const render::PictureSettings& picture = all[i].pictures.back().settings;
    EXPECT_EQ(&solver_of(tile.settings.solver), picture.solver);
    EXPECT_EQ(tile.settings.iterations, float(picture.step.iterations));
    EXPECT_EQ(tile.settings.plays, 1);
    EXPECT_EQ(tile.settings.yaw, 75);
    EXPECT_GT(tile.settings.zoom, 0.1f);
    EXPECT_LE(tile.settings.zoom, 1.0f);
    ASSERT_EQ(tile.moments.size(), all[i].pictures.size());
    EXPECT_EQ(tile.moments.back().seconds, picture.time);
    EXPECT_EQ(tile.moments.back().caption, all[i].pictures.back().caption);
  }
}

TEST(LiveSheet, AirBlowsAsInThePictures) {
  const auto all = galleries(7);
  const auto gusts = std::ranges::find_if(
      all, [](const render::Gallery& g) { return g.pictures[0].settings.step.environment.wind.x > 0; });
  ASSERT_NE(gusts, all.end());
  const ViewSettings settings = sheet_of({*gusts}).galleries.at(0).tiles.at(0).settings;
  EXPECT_FLOAT_EQ(settings.wind, 3);
  EXPECT_FLOAT_EQ(settings.wind_from, -90) << "towards +X";
  EXPECT_FLOAT_EQ(settings.gusts, 6);
}

TEST(LiveSheet, JsonSetsOnlyWhatThePageKnows) {
  const auto controls = nlohmann::json::parse(controls_json(wig()));
  std::set<std::string> motions;
  const nlohmann::json sheet = json_of(sheet_of(galleries()));
  for (const auto& gallery : sheet["galleries"]) {
    for (const auto& tile : gallery["tiles"]) {
      for (const auto& [name, value] : tile["settings"].items()) {
        const auto row = std::ranges::find_if(controls, [&](const auto& c) { return c["name"] == name; });
        ASSERT_NE(row, controls.end()) << name;
        if ((*row)["kind"] == "choice") {
          const std::string words = "|" + (*row)["words"].get<std::string>() + "|";
          EXPECT_NE(words.find("|" + value.get<std::string>() + "|"), std::string::npos) << name << ": " << value;
        }
        if (name == "motion") motions.insert(value);
      }
    }
  }
  EXPECT_EQ(motions, (std::set<std::string>{"look-down", "look-aside", "look-up", "charge"}))
      << "still is how pages begin";
}

TEST(LiveSheet, NoTextEndsTheScriptThatItIsIn) {
  LiveSheet sheet;
  sheet.note = "</script><b>";
  const std::string json = sheet_json(wig(), sheet, {64, 64});
  EXPECT_EQ(json.find('<'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(json)["note"], sheet.note);
}

}  // namespace coif::view::live_sheet_test
