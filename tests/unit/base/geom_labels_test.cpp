// Labels of geoms without a name, names of sensors on such geoms, and short names of sensors.
#include "core/base/text/geom_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/base/text/sensor_names.h"

namespace taxel {
namespace {

using Texts = std::vector<std::string>;

TEST(GeomLabels, CallUnnamedGeomsByBodyAndClass) {
  EXPECT_EQ(geom_labels({{"", "rh_ffdistal", "plastic_visual", "f_distal_pst", "mesh"},
                         {"", "rh_ffdistal", "plastic_collision", "f_distal_pst", "mesh"},
                         {"floor", "world", "", "", "plane"},
                         {"", "object", "", "", "ellipsoid"}}),
            (Texts{"rh_ffdistal, plastic_visual", "rh_ffdistal, plastic_collision", "floor", "object, ellipsoid"}));
}

TEST(GeomLabels, AddMeshesAndNumbersWhereClassesRepeat) {
  EXPECT_EQ(geom_labels({{"", "rh_forearm", "plastic_visual", "forearm_0", "mesh"},
                         {"", "rh_forearm", "plastic_visual", "forearm_1", "mesh"},
                         {"", "rh_forearm", "plastic_collision", "", "box"},
                         {"", "rh_palm", "plastic_collision", "", "box"},
                         {"", "rh_palm", "plastic_collision", "", "box"},
                         {"", "rh_palm", "plastic_collision", "", "capsule"}}),
            (Texts{"rh_forearm, plastic_visual, forearm_0", "rh_forearm, plastic_visual, forearm_1",
                   "rh_forearm, plastic_collision", "rh_palm, plastic_collision, box 1",
                   "rh_palm, plastic_collision, box 2", "rh_palm, plastic_collision, capsule"}));
}

TEST(GeomLabels, UseMeshOrTypeWithoutClasses) {
  EXPECT_EQ(geom_labels({{"", "ff_tip", "", "link_3.0_tip", "mesh"}, {"", "ff_tip", "", "", "capsule"}}),
            (Texts{"ff_tip, link_3.0_tip", "ff_tip, capsule"}));
  EXPECT_EQ(geom_labels({{"", "tip", "", "skin", "mesh"}, {"", "tip", "", "skin", "mesh"}}),
            (Texts{"tip, skin 1", "tip, skin 2"}));
}

TEST(GeomLabels, RemainWhenAnotherGeomOfTheBodyGetsAName) {
  std::vector<GeomParts> geoms = {{"", "tip", "", "skin", "mesh"}, {"", "tip", "", "skin", "mesh"}};
  geoms[0].name = "tip";
  EXPECT_EQ(geom_labels(geoms), (Texts{"tip", "tip, skin 2"}));
}

TEST(GeomLabels, DifferInAnyModel) {
  std::mt19937 random(7);
  const Texts words = {"", "a", "b", "a, b", "a, b 1", "a, b 1 (2)", "b 1", "b, box"};
  const auto word = [&](std::size_t from) { return words[from + random() % (words.size() - from)]; };
  for (int round = 0; round < 2000; ++round) {
    std::vector<GeomParts> geoms;
    Texts names;
    for (std::size_t i = 0; i < 1 + random() % 12; ++i) {
      std::string name = word(0);
      if (std::ranges::find(names, name) != names.end()) name.clear();
      names.push_back(name);
      geoms.push_back({name, word(1), word(0), word(0), random() % 2 == 0 ? "box" : "mesh"});
    }
    Texts labels = geom_labels(geoms), sensors = geom_sensor_names(geoms);
    std::ranges::sort(sensors);
    ASSERT_EQ(std::ranges::adjacent_find(sensors), sensors.end()) << "in round " << round;
    for (std::size_t i = 0; i < geoms.size(); ++i) {
      EXPECT_FALSE(labels[i].empty());
      EXPECT_TRUE(geoms[i].name.empty() || labels[i] == geoms[i].name) << labels[i];
    }
    std::ranges::sort(labels);
    ASSERT_EQ(std::ranges::adjacent_find(labels), labels.end()) << "in round " << round;
  }
}

TEST(GeomSensorNames, AreThoseOfBodiesWhereTheyAreClear) {
  EXPECT_EQ(geom_sensor_names({{"", "rh_ffdistal", "plastic_visual", "f_distal_pst", "mesh"},
                               {"", "rh_ffdistal", "plastic_collision", "f_distal_pst", "mesh"},
                               {"", "ff_tip", "", "", "capsule"},
                               {"", "ff_tip", "", "link_3.0_tip", "mesh"},
                               {"floor", "world", "", "", "plane"},
                               {"", "object", "", "", "ellipsoid"}}),
            (Texts{"rh_ffdistal", "rh_ffdistal_2", "ff_tip_1", "ff_tip", "floor", "object"}));
  EXPECT_EQ(
      geom_sensor_names({{"", "forearm", "", "upper half", "mesh"},
                         {"", "forearm", "", "lower", "mesh"},
                         {"", "forearm", "", "lower", "mesh"},
                         {"", "palm", "", "", "box"},
                         {"", "palm", "", "", "box"},
                         {"forearm_lower", "body 3", "", "", "box"},
                         {"", "body 3", "", "", "box"}}),
      (Texts{"forearm_upper_half", "forearm_lower_2", "forearm_3", "palm_1", "palm_2", "forearm_lower", "body_3_2"}));
}

TEST(GeomSensorNames, GiveTheBodysNameToItsDrawnMesh) {
  const std::vector<GeomParts> geoms = {{"", "tip", "", "hull", "mesh", true},
                                        {"", "tip", "", "skin", "mesh", false},
                                        {"", "tip", "", "skin", "mesh", false},
                                        {"", "tip", "", "", "box", true}};
  EXPECT_EQ(geom_sensor_names(geoms), (Texts{"tip_hull", "tip", "tip_3", "tip_4"}));
  EXPECT_EQ(mesh_geom(geoms, "tip"), 1U);
  EXPECT_EQ(mesh_geom(geoms, "palm"), std::nullopt);
}

TEST(GeomLabels, ReadTheNumberOfAFormerLabel) {
  EXPECT_EQ(number_in_label("geom 27"), 27);
  for (const char* text : {"geom", "geom ", "geom -1", "geom 7 ", "geom seven", "my geom 7", "geom 123456789", "geom7"})
    EXPECT_EQ(number_in_label(text), -1) << text;
}

TEST(SensorName, IsThatOfTheBodyOrTheNextFreeOne) {
  EXPECT_EQ(sensor_name("rh_ffdistal", {}), "rh_ffdistal");
  EXPECT_EQ(sensor_name("rh_ffdistal", {"rh_ffdistal"}), "rh_ffdistal_2");
  EXPECT_EQ(sensor_name("rh_ffdistal", {"rh_ffdistal", "rh_ffdistal_2", "rh_ffdistal_4"}), "rh_ffdistal_3");
  EXPECT_EQ(sensor_name("body 5", {}), "body_5");
  EXPECT_EQ(sensor_name("left, upper pad", {}), "left__upper_pad");
}

TEST(ShortSensorNames, AreTheFingersOfAHand) {
  EXPECT_EQ(short_sensor_names({"rh_ffdistal", "rh_mfdistal", "rh_rfdistal", "rh_lfdistal", "rh_thdistal", "rh_palm"}),
            (Texts{"index", "middle", "ring", "little", "thumb", "palm"}));
  EXPECT_EQ(short_sensor_names({"ff_tip", "mf_tip", "rf_tip", "th_tip"}), (Texts{"index", "middle", "ring", "thumb"}));
  EXPECT_EQ(short_sensor_names({"left_index_pad", "Thumb", "pinky_tip"}), (Texts{"index", "thumb", "little"}));
}

TEST(ShortSensorNames, HaveLinksAndSidesWhereFingersRepeat) {
  EXPECT_EQ(short_sensor_names({"rh_ffdistal", "rh_ffmiddle", "rh_mfdistal"}),
            (Texts{"index distal", "index middle", "middle"}));
  EXPECT_EQ(short_sensor_names({"if_ds", "if_px", "mf_ds"}), (Texts{"index ds", "index px", "middle"}));
  EXPECT_EQ(short_sensor_names({"rh_ffdistal", "lh_ffdistal", "lh_mfdistal"}),
            (Texts{"right index distal", "left index distal", "middle"}));
}

TEST(ShortSensorNames, DropSharedWordsOfOtherNames) {
  EXPECT_EQ(short_sensor_names({"link_3.0_tip", "link_7.0_tip", "link_15.0_tip"}), (Texts{"3.0", "7.0", "15.0"}));
  EXPECT_EQ(short_sensor_names({"left_finger_pad", "right_finger_pad"}), (Texts{"left", "right"}));
  EXPECT_EQ(short_sensor_names({"fingertip", "fingertip_2"}), (Texts{"fingertip", "fingertip_2"}));
}

TEST(ShortSensorNames, KeepOneNameAndUnknownWords) {
  EXPECT_EQ(short_sensor_names({"rh_ffdistal"}), (Texts{"rh_ffdistal"}));
  EXPECT_EQ(short_sensor_names({}), Texts{});
  EXPECT_EQ(short_sensor_names({"bumper", "wheel"}), (Texts{"bumper", "wheel"}));
}

TEST(ShortSensorNames, DifferIfNamesDiffer) {
  std::mt19937 random(3);
  const Texts words = {"rh", "lh", "ff", "index", "ffdistal", "distal", "middle", "mf", "palm", "link", "3.0", "tip"};
  for (int round = 0; round < 3000; ++round) {
    Texts names;
    for (std::size_t i = 0; i < 2 + random() % 8; ++i) {
      std::string name = words[random() % words.size()];
      for (std::size_t k = random() % 3; k > 0; --k)
        name += (random() % 4 == 0 ? " " : "_") + words[random() % words.size()];
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    Texts shortened = short_sensor_names(names);
    for (const std::string& name : shortened) EXPECT_FALSE(name.empty());
    std::ranges::sort(shortened);
    ASSERT_EQ(std::ranges::adjacent_find(shortened), shortened.end()) << "in round " << round;
  }
}

}  // namespace
}  // namespace taxel
