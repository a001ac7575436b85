// Scenes for MuJoCo 2.x load: attributes that MuJoCo has dropped are removed with a note, and errors remain errors.
#include "core/sim/scene/current_mjcf.h"

#include <gtest/gtest.h>

#include "core/base/files.h"
#include "core/sim/simulator.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel::test {
namespace {

namespace fs = std::filesystem;

struct Result {
  std::string xml;
  std::vector<std::string> notes;
};
Result search(const std::string& xml) {
  Result result;
  result.xml = without_dropped_attributes(xml, "s.xml", result.notes);
  return result;
}

TEST(DroppedAttributes, AreRemovedAndLinesKeepTheirNumbers) {
  const Result r = search("<mujoco>\n  <option collision=\"all\"\n timestep='0.001'/>\n</mujoco>");
  EXPECT_EQ(r.xml, "<mujoco>\n  <option                \n timestep='0.001'/>\n</mujoco>");
  ASSERT_EQ(r.notes.size(), 1U);
  EXPECT_EQ(r.notes[0],
            "s.xml: line 2: option collision=\"all\" is no longer known to MuJoCo; it is left out: all pairs are "
            "tested, dynamic and predefined ones");
}

TEST(DroppedAttributes, KeepTheirValueIfRenamed) {
  EXPECT_EQ(search("<mujoco><option mpr_tolerance='1e-5'/></mujoco>").xml,
            "<mujoco><option ccd_tolerance='1e-5'/></mujoco>");
  EXPECT_EQ(search("<mujoco><option><flag passive = \"disable\"/></option></mujoco>").xml,
            "<mujoco><option><flag spring = \"disable\" damper = \"disable\"/></option></mujoco>");
  // If both names are given, the new name has priority.
  EXPECT_EQ(search("<mujoco><option mpr_iterations='9' ccd_iterations='7'/></mujoco>").xml,
            "<mujoco><option                    ccd_iterations='7'/></mujoco>");
}

TEST(DroppedAttributes, AreRecognizedByTheirElementAndItsParent) {
  for (const char* kept : {"<mujoco><custom><text name='collision' data='apirate=\"1\"'/></custom></mujoco>",
                           "<mujoco><!-- <option collision='all'/> --><contact internal='false'/></mujoco>",
                           "<mujoco><![CDATA[<option collision='all'/>]]></mujoco>"}) {
    const Result r = search(kept);
    EXPECT_EQ(r.xml, kept);
    EXPECT_TRUE(r.notes.empty());
  }
  EXPECT_EQ(search("<mujoco><deformable><flex><contact internal='false'/></flex></deformable></mujoco>").notes.size(),
            1U);
}

TEST(DroppedAttributes, LeaveTextUnchangedThatIsNotWellFormed) {
  for (const char* broken :
       {"<mujoco><option collision='all'", "<mujoco><option collision=all/></mujoco>",
        "<mujoco><option collision='all'/><!-- ", "<mujoco><option collision='all' x/>", "", "<"}) {
    const Result r = search(broken);
    EXPECT_EQ(r.xml, broken);
    EXPECT_TRUE(r.notes.empty()) << broken;
  }
}

/// Each attribute of the table, in a scene that MuJoCo refuses unless the attribute is removed.
TEST(DroppedAttributes, AreRemovedFromScenesThatThenLoad) {
  const TempFolder temp;
  for (const char* part :
       {"<option collision='predefined'/>", "<option apirate='100'/>", "<option mpr_iterations='50'/>",
        "<option mpr_tolerance='1e-6'/>", "<option><flag sensornoise='enable'/></option>",
        "<option><flag passive='enable'/></option>", "<compiler convexhull='true'/>",
        "<compiler exactmeshinertia='true'/>", "<compiler><lengthrange inteval='2'/></compiler>",
        "<default><joint actuatorforcelimited='true' actuatorforcerange='-1 1'/></default>",
        "<default><camera orthographic='true'/></default>",
        "<worldbody><body><joint actuatorforcerange='-1 1'/><geom size='1'/></body></worldbody>"}) {
    write_file_atomically(temp.path() / "scene.xml", "<mujoco>" + std::string(part) + "</mujoco>");
    const auto simulator = Simulator::load(temp.path() / "scene.xml");
    EXPECT_GE(simulator->warnings().size(), 1U) << part;
    EXPECT_NE(simulator->warnings()[0].find("no longer known to MuJoCo"), std::string::npos) << part;
  }
}

TEST(DroppedAttributes, AreRemovedInIncludedFilesWithoutChangingFiles) {
  const TempFolder temp;
  const std::string scene = "<mujoco><include file='parts/a.xml'/><worldbody><geom size='1'/></worldbody></mujoco>";
  const std::string part = "<mujoco>\n<option collision='all' timestep='0.0005'/></mujoco>";
  fs::create_directories(temp.path() / "parts");
  write_file_atomically(temp.path() / "scene.xml", scene);
  write_file_atomically(temp.path() / "parts/a.xml", part);
  const auto simulator = Simulator::load(temp.path() / "scene.xml");
  EXPECT_EQ(simulator->scene()->timestep, 0.0005);
  ASSERT_EQ(simulator->warnings().size(), 1U);
  EXPECT_NE(simulator->warnings()[0].find("a.xml: line 2: option collision"), std::string::npos)
      << simulator->warnings()[0];
  EXPECT_EQ(read_file(temp.path() / "scene.xml"), scene);
  EXPECT_EQ(read_file(temp.path() / "parts/a.xml"), part);
}

TEST(DroppedAttributes, KeepThePlaceOfErrorsOfMujoco) {
  const TempFolder temp;
  const auto complaint = [&](const std::string& xml) {
    write_file_atomically(temp.path() / "scene.xml", xml);
    return complaint_of([&] { Simulator::load(temp.path() / "scene.xml"); });
  };
  const std::string file = (temp.path() / "scene.xml").string();
  EXPECT_EQ(complaint("<mujoco>\n<option collision='all'\n/>\n<option colision='all'/></mujoco>"),
            file + ": XML Error: Schema violation: unrecognized attribute: 'colision'; Element 'option', line 4");
  EXPECT_NE(complaint("<mujoco><compiler coordinate='global'/></mujoco>").find("global coordinates"),
            std::string::npos);
  EXPECT_NE(complaint("<mujoco><option collision='all'/><worldbody>\n<composite type='grid' count='2 2 1' "
                      "spacing='1'/></worldbody></mujoco>")
                .find("Element 'composite', line 2"),
            std::string::npos);
}

}  // namespace
}  // namespace taxel::test
