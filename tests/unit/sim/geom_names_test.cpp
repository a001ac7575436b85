// The names of geoms in a configuration after MjSpec.attach(), which renames geoms and instances but not these names.
#include <gtest/gtest.h>

#include "fixtures/sensor_scene.h"

namespace taxel::test {
namespace {

constexpr const char* kPrefixedWorld = R"(<asset><mesh name='L_ball' file='ball.obj'/></asset><worldbody>
    <geom name='floor' type='plane' size='1 1 1' contype='0' conaffinity='0'/>
    <body pos='0 0 0.019'><freejoint/><geom name='L_ball' type='mesh' mesh='L_ball' contype='0' conaffinity='0'/>
      <geom name='L_nail' type='box' size='.001 .001 .001' contype='0' conaffinity='0'/></body>
    <body pos='1 0 0'><freejoint/><geom name='L_box' type='box' size='.01 .01 .01' contype='0' conaffinity='0'/></body>
    <body pos='2 0 0'><freejoint/><geom name='box' type='box' size='.01 .01 .01' contype='0' conaffinity='0'/></body>
    <body pos='4 0 0'><freejoint/><geom name='peg_l' type='box' size='.01 .01 .01' contype='0' conaffinity='0'/></body>
    <body pos='5 0 0'><freejoint/><geom name='a/cap_l' type='box' size='.01 .01 .01' contype='0' conaffinity='0'/></body>
    <body pos='3 0 0'><freejoint/><geom name='L_R_pad' type='box' size='.01 .01 .01' contype='0' conaffinity='0'/></body>
  </worldbody></mujoco>)";

class AttachedNames : public testing::Test {
 protected:
  void SetUp() override { s.add_sensor("ball", make_sphere(0.02, 0.008), {FieldKind::star, 5e4, 0, 5, 0.5}); }

  void compile_instance(const std::string& name, const std::string& keys, const std::string& reference = "") {
    s.compile("<mujoco><extension><plugin plugin='taxel.sensor'><instance name='" + name + "'>" +
              key("layout", "ball.taxels.json") + keys + "</instance></plugin></extension><sensor><plugin name='" +
              (name.ends_with("_l") ? "t_l" : "t") + "' plugin='taxel.sensor' instance='" + name + "' " + reference +
              "/></sensor>" + kPrefixedWorld);
  }
  /// Returns the names of the touched geoms, separated by spaces.
  [[nodiscard]] std::string touched_names() const {
    std::string names;
    for (const TouchedGeom& touched : s.sensor().touched())
      names += (names.empty() ? "" : " ") + std::string(mj_id2name(s.model.get(), mjOBJ_GEOM, touched.geom));
    return names;
  }
  void expect_refusal(const std::vector<std::string>& words) const {
    EXPECT_EQ(s.model, nullptr);
    for (const std::string& word : words)
      EXPECT_NE(s.error.find(word), std::string::npos) << word << " in: " << s.error;
  }

  SensorScene s;
};

TEST_F(AttachedNames, HaveThePrefixOfTheInstance) {
  compile_instance("L_tip",
                   key("geom", "ball") + key("others", "nail") + key("materials", "{\"nail\": {\"friction\": 2}}"));
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(s.sensor().config().geom_name, "L_ball");
  EXPECT_EQ(touched_names(), "L_nail");
  EXPECT_DOUBLE_EQ(s.sensor().touched()[0].properties.friction, 2 * 0.5 * 2 / 2.5);
}

TEST_F(AttachedNames, AreFirstSearchedAsWritten) {
  compile_instance("L_tip", key("geom", "ball") + key("others", "box floor"));
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(touched_names(), "floor box");
}

TEST_F(AttachedNames, MayHaveSeveralPrefixes) {
  compile_instance("L_R_tip", key("geom", "ball") + key("others", "pad nail"));
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(touched_names(), "L_nail L_R_pad");
}

TEST_F(AttachedNames, MayHaveASuffixOrBoth) {
  compile_instance("tip_l", key("geom", "L_ball") + key("others", "peg floor"));
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(touched_names(), "floor peg_l");
  compile_instance("a/tip_l", key("geom", "L_ball") + key("others", "cap peg"));
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(touched_names(), "peg_l a/cap_l");
  compile_instance("pad", key("geom", "L_ball") + key("others", "L_R_pa"));
  expect_refusal({"no geom named \"L_R_pa\""});
  compile_instance("tip", key("geom", "L_b") + key("others", "peg"), "objtype='geom' objname='L_ball'");
  expect_refusal({"no geom named \"peg\" or \"pegall\""});
}

TEST_F(AttachedNames, FollowTheGeomToWhichTheSensorRefers) {
  const std::string reference = "objtype='geom' objname='L_ball'";
  for (const std::string& geom : {std::string(), key("geom", "ball"), key("geom", "L_ball")}) {
    compile_instance("tip", geom + key("others", "L_nail"), reference);
    ASSERT_NE(s.model, nullptr) << s.error;
    EXPECT_EQ(s.sensor().config().geom_name, "L_ball");
    EXPECT_EQ(s.model->nsensordata, 1);
  }
  compile_instance("tip", key("geom", "ball") + key("others", "nail"), reference);
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(touched_names(), "L_nail");
}

TEST_F(AttachedNames, AreNamedInErrors) {
  compile_instance("tip", key("others", "floor"));
  expect_refusal({"geom", "required", "objname"});
  compile_instance("tip", key("geom", "ball") + key("others", "nose"), "objtype='geom' objname='L_ball'");
  expect_refusal({"others", "\"nose\"", "\"L_nose\""});
  compile_instance("tip", key("geom", "thumb"), "objtype='geom' objname='L_ball'");
  expect_refusal({"geom", "\"thumb\"", "\"L_ball\""});
  compile_instance("L_tip", key("geom", "ball") + key("materials", "{\"nail\": {}, \"L_nail\": {}}"));
  expect_refusal({"materials", "\"L_nail\"", "twice"});
}

TEST_F(AttachedNames, MayMeanAllGeomsOfOtherBodies) {
  compile_instance("L_tip", key("geom", "ball") + key("others", "*") +
                                key("materials", "{\"*\": {\"friction\": 2}, \"floor\": {\"friction\": 0.5}}"));
  ASSERT_NE(s.model, nullptr) << s.error;
  EXPECT_EQ(touched_names(), "floor L_box box peg_l a/cap_l L_R_pad");
  EXPECT_DOUBLE_EQ(s.sensor().touched()[0].properties.friction, 0.5);
  EXPECT_DOUBLE_EQ(s.sensor().touched()[1].properties.friction, 2 * 0.5 * 2 / 2.5);
  compile_instance("L_tip", key("geom", "ball") + key("others", "floor *"));
  expect_refusal({"others", "\"*\""});
}

TEST_F(AttachedNames, WorkInSoftContacts) {
  const auto compile_contact = [&](const std::string& material) {
    s.compile("<mujoco><extension><plugin plugin='taxel.contact'><instance name='L_soft'>" +
              key("materials", "{\"" + material + "\": {\"modulus\": 1e5}}") + key("pairs", "nail floor, nail box") +
              "</instance></plugin></extension>" + kPrefixedWorld);
  };
  compile_contact("nail");
  ASSERT_NE(s.model, nullptr) << s.error;
  const BodyContacts& nail = *find_body(*s.data, {0, 0});
  EXPECT_EQ(nail.settings().geom_name, "L_nail");
  EXPECT_EQ(nail.touched().size(), 2U);
  compile_contact("*");
  expect_refusal({"materials", "\"*\"", "only for sensors"});
}

}  // namespace
}  // namespace taxel::test
