// Layout files of version 0 are read as those of version 1, and nothing of them is lost.
#include "core/layout/file/layout_keys.h"

#include <gtest/gtest.h>

#include "core/layout/file/layout_json.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

constexpr const char* kVersion0 = R"({
  "format": "taxel-layout", "version": 0, "name": "draft", "mesh": "tip.stl", "scale": 0.001,
  "density": 2e6, "seed": 7, "radius": 0.004, "by": {"lab": "x"},
  "sampling": {"weights": "voronoi", "made": 1},
  "taxels": [{"position": [0, 0, 1], "direction": [0, 0, 2], "note": "a"},
             {"id": 5, "position": [1, 0, 0], "normal": [1, 0, 0], "radius": 0.002}]
})";
constexpr const char* kVersion1 = R"({
  "format": "taxel-layout", "version": 1, "name": "draft", "mesh": {"file": "tip.stl", "scale": [0.001, 0.001, 0.001]},
  "by": {"lab": "x"}, "sampling": {"weights": "voronoi", "made": 1, "density": 2e6, "seed": 7},
  "taxels": [{"center": [0, 0, 1], "normal": [0, 0, 2], "radius": 0.004, "note": "a"},
             {"id": 5, "center": [1, 0, 0], "normal": [1, 0, 0], "radius": 0.002}]
})";

/// Returns the text of version 0 with one part replaced.
std::string changed(const std::string& part, const std::string& by) {
  std::string text = kVersion0;
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), by);
}

TEST(LayoutMigration, GivesTheSameLayoutAsVersion1) {
  const LayoutOfFile old = parse_layout_of_file(kVersion0, "f"), current = parse_layout_of_file(kVersion1, "f");
  EXPECT_EQ(old.layout, current.layout);
  EXPECT_EQ(layout_to_json(old.layout), layout_to_json(current.layout));
  EXPECT_FALSE(old.has_frame);
  EXPECT_EQ(old.layout.unknown.at("/by"), R"({"lab":"x"})");
  EXPECT_EQ(old.layout.unknown.at("/sampling/made"), "1");
  EXPECT_EQ(old.layout.unknown.at("/taxels/0/note"), R"("a")");
}

TEST(LayoutMigration, NotesEachChange) {
  const std::vector<std::string> expected = {"is of version 0: it is read as version 1, and will be saved as that",
                                             R"("mesh" is an object, and the file is "mesh/file")",
                                             R"("scale" is "mesh/scale")",
                                             R"("density" is "sampling/density")",
                                             R"("seed" is "sampling/seed")",
                                             R"("position" and "direction" of 2 taxels are "center" and "normal")",
                                             R"("radius" of the file is that of each of the 1 taxels without one)"};
  EXPECT_EQ(parse_layout_of_file(kVersion0).notes, expected);
  EXPECT_TRUE(parse_layout_of_file(kVersion1).notes.empty());
}

TEST(LayoutMigration, NotesNoChangeThatIsNotMade) {
  const std::string text =
      R"({"format": "taxel-layout", "version": 0, "mesh": {"file": "m", "scale": [1, 2, 3]}, "taxels": []})";
  const LayoutOfFile read = parse_layout_of_file(text);
  EXPECT_EQ(read.notes.size(), 1U);
  EXPECT_EQ(read.layout.mesh.scale, dvec3(1, 2, 3));
}

TEST(LayoutMigration, RefusesAValueAtBothPlaces) {
  const auto error = [](const std::string& text) { return test::complaint_of([&] { parse_layout(text, "f"); }); };
  EXPECT_EQ(error(changed("\"seed\": 7", "\"density\": 3")), "f: has the key \"density\" twice in one object");
  EXPECT_EQ(error(changed("\"made\": 1", "\"seed\": 1")),
            "f: /seed: is also in \"sampling\" (version 1): remove one of them");
  EXPECT_EQ(error(changed("\"note\": \"a\"", "\"center\": [0, 0, 0]")),
            "f: /taxels/0: has both \"position\" (version 0) and \"center\" (version 1): remove one");
  EXPECT_EQ(error(changed("{\"weights\": \"voronoi\", \"made\": 1}", "3")), "f: /sampling: must be an object");
}

TEST(LayoutMigration, NamesThePlaceOfVersion1ForAWrongValue) {
  const auto error = [](const std::string& text) { return test::complaint_of([&] { parse_layout(text, "f"); }); };
  EXPECT_EQ(error(changed("[0, 0, 1]", "\"up\"")),
            "f: /taxels/0/center: must be an array of 3 numbers, is \"up\" (place and key are those of version 1)");
  EXPECT_EQ(error(changed("\"radius\": 0.004", "\"radius\": null")),
            "f: /taxels/0/radius: must be a number, is null (place and key are those of version 1)");
  EXPECT_EQ(error(changed("\"taxels\": [", "\"taxels\": 3, \"rest\": [")),
            "f: /taxels: must be an array, is 3 (place and key are those of version 1)");
}

}  // namespace
}  // namespace taxel
