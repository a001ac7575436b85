// `taxel contact` with every pair of shapes, rigid and soft: both orders give the same contact, and B pushes A away.
#include <cmath>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// A shape as JSON, and its half height above its origin [m].
struct PairShape {
  const char* name;
  Json shape;
  double height;
};

const PairShape kBounded[] = {{"sphere", {{"type", "sphere"}, {"size", {0.02}}}, 0.02},
                              {"capsule", {{"type", "capsule"}, {"size", {0.015, 0.01}}}, 0.025},
                              {"ellipsoid", {{"type", "ellipsoid"}, {"size", {0.02, 0.025, 0.018}}}, 0.018},
                              {"cylinder", {{"type", "cylinder"}, {"size", {0.02, 0.022}}}, 0.022},
                              {"box", {{"type", "box"}, {"size", {0.02, 0.015, 0.017}}}, 0.017},
                              {"mesh", {{"type", "mesh"}, {"file", "box.obj"}}, 0.016}};
const PairShape kPlane{"plane", {{"type", "plane"}}, 0};

/// Returns a body with a modulus if it is soft. A soft plane also needs a thickness.
Json body(const PairShape& shape, bool soft, const Json& pos, const Json& quat) {
  Json json = {{"shape", shape.shape}, {"pos", pos}, {"quat", quat}};
  if (std::string(shape.name) != "plane" && std::string(shape.name) != "mesh") json["resolution"] = 0.006;
  if (soft) json["material"] = {{"modulus", 5e4}};
  if (soft && std::string(shape.name) == "plane") json["material"]["thickness"] = 0.01;
  return json;
}

/// Expects a contact of two bodies, one of which is 2 mm deep in the other, slightly shifted and rotated.
void expect_contact(const PairShape& below, bool below_soft, const PairShape& above, bool above_soft) {
  SCOPED_TRACE(testing::Message() << (above_soft ? "soft " : "rigid ") << above.name << " on "
                                  << (below_soft ? "soft " : "rigid ") << below.name);
  const fs::path folder = test_folder();
  write_text(folder / "box.obj", box_obj(0.016));
  const Json a = body(below, below_soft, {0, 0, 0}, {1, 0, 0, 0});
  const Json b = body(above, above_soft, {0.002, 0.001, below.height + above.height - 0.002}, {0.98, 0, 0, 0.199});
  const auto run = [&](const Json& first, const Json& second) {
    write_text(folder / "case.json",
               Json{{"format", "contact-case"}, {"version", 1}, {"a", first}, {"b", second}}.dump());
    return taxel_json({"contact", "case.json"}, folder);
  };
  const Json on_a = run(a, b), on_b = run(b, a);
  const double area = on_a["area"];
  ASSERT_GT(on_a["polygons"], 0);
  EXPECT_EQ(on_a["polygons"], on_b["polygons"]);
  EXPECT_NEAR(area, on_b["area"].get<double>(), 1e-10 * area);
  const auto force_a = on_a["force"].get<std::vector<double>>(), force_b = on_b["force"].get<std::vector<double>>();
  EXPECT_LT(force_a[2], 0);  // pressed down
  const double size = std::hypot(force_a[0], force_a[1], force_a[2]);
  EXPECT_LT(std::hypot(force_a[0], force_a[1]), 0.2 * size);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(force_a[i], -force_b[i], 1e-10 * size);
  EXPECT_GT(on_a["max_pressure"], 0);
  EXPECT_LE(on_a["max_pressure"], 5e4);
  EXPECT_LE(size, on_a["max_pressure"].get<double>() * area);
}

TEST(ShapePairs, TouchInBothOrders) {
  for (const PairShape& above : kBounded) {
    expect_contact(kPlane, false, above, true);
    expect_contact(kPlane, true, above, false);
    expect_contact(kPlane, true, above, true);
    for (const PairShape& below : kBounded) {
      expect_contact(below, false, above, true);
      if (std::string(below.name) <= above.name) expect_contact(below, true, above, true);
    }
  }
}

}  // namespace
}  // namespace taxel::test
