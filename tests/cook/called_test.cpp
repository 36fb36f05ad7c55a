#include "cook/select/called.h"

#include <gtest/gtest.h>

namespace coif::cook::called_test {

TEST(HairNames, HairIsFoundInSeveralWordsAndLanguages) {
  for (const char* name : {"Hair", "hair_back", "HAIR.001", "Fringe_L", "ponytail01", "PonyTail", "braid", "Hair_Black",
                           "newhair", "J_Sec_Hair1_04", "twintail_R", "髪の毛", "HairCap", "Hair_Brown", "basic_hair",
                           "Basic_Hair_Light", "capelli", "Pelo01", "CurlyHair"}) {
    EXPECT_TRUE(is_called_hair(name)) << name;
  }
}

TEST(HairNames, WhatIsWornInHairOrSpeltLikeItIsNot) {
  for (const char* name :
       {"Chair", "hairband", "Hair_Clip", "HairRibbon", "armchair", "body", "face", "Wear", "head", "hair-tie.L",
        "HairAccessory", "hair_accce", "Wiggle", "Camilla", "Stress", "Harmony", "pelota"}) {
    EXPECT_FALSE(is_called_hair(name)) << name;
  }
}

TEST(HairNames, PartsOfWordsSayNothing) {
  for (const char* name : {"Hair_Brown", "brown_long", "solid", "Eyelet", "Splash", "browser"}) {
    EXPECT_FALSE(is_called_brow(name)) << name;
  }
  for (const char* name : {"solid", "Slide", "Invalid", "Hair_Brown"}) EXPECT_FALSE(is_called_eye(name)) << name;
  for (const char* name : {"Eyebrow_L", "LeftEyelash", "brows", "BrowL", "eye_lash", "Lashes.001"}) {
    EXPECT_TRUE(is_called_brow(name)) << name;
  }
  for (const char* name : {"Beard", "facial-hair_beard-full", "ZZ_Moustache"})
    EXPECT_TRUE(is_called_beard(name)) << name;
  for (const char* name : {"Bip01 LEye", "mixamorig:LeftEye", "eye.R", "righteye", "Eyeball_L"}) {
    EXPECT_TRUE(is_called_eyeball(name)) << name;
  }
  for (const char* name : {"LEyeBlinkTop", "LeftEyelid", "EyeTarget", "eyebrow", "eye_end"}) {
    EXPECT_FALSE(is_called_eyeball(name)) << name;
  }
  for (const char* name : {"Head", "mixamorig:Head", "J_Bip_C_Head", "Bip01 Head", "UnityChan_Head", "headBone"}) {
    EXPECT_TRUE(is_called_head(name)) << name;
  }
  for (const char* name : {"HeadTop_End", "Headband", "HeadNub", "headphones", "Headlight", "HairHead", "forehead"}) {
    EXPECT_FALSE(is_called_head(name)) << name;
  }
}

}  // namespace coif::cook::called_test
