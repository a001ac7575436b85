// The probe tool through the real executable: raw events in; position, depth and reading out.
#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kWheelUp = R"({"event": "wheel", "y": 1})", kWheelDown = R"({"event": "wheel", "y": -1})";

std::string move_to(const std::string& at) {
  return R"({"event": "mouse_move", "at": )" + at + "}";
}

const Lines kTakeUp{kLayoutMode, kIdle, key("x"), kIdle, move_to(taxel(3)), kIdle};

double force_of(const Json& state) {
  return state["probe"]["reading"]["force"];
}

TEST(ProbeTool, FollowsThePointerOverTheSkinAndReads) {
  const StudioProgram studio;
  studio.play(joined({kTakeUp,
                      {dump("on.json"), move_to(in_view(0.544, 0.507)), kIdle, dump("moved.json"),
                       move_to(in_view(0.297, 0.126)), kIdle, dump("off.json")}}),
              {kLayoutFile});
  const Json on = studio.state("on.json"), moved = studio.state("moved.json"), off = studio.state("off.json");
  EXPECT_TRUE(on["probe"]["held"]);
  EXPECT_EQ(on["probe"]["problem"], "");
  const dvec3 center = vector_of(taxel_of(on["document"]["layout"], 3)["center"]);
  EXPECT_LT(glm::distance(vector_of(on["probe"]["at"]), center), 5e-4);
  EXPECT_GT(force_of(on), 0.05);
  EXPECT_GT(on["probe"]["reading"]["values"][3], 1000) << on["probe"].dump();
  EXPECT_FALSE(on["polygons"].empty()) << "the contact surface is drawn";
  EXPECT_EQ(on["bars"].size(), on["document"]["layout"]["taxels"].size());
  bool has_bar = false;
  for (const Json& bar : on["bars"]) {
    if (bar["taxel"] == 3) {
      has_bar = true;
      EXPECT_EQ(bar["value"], on["probe"]["reading"]["values"][3]);
    }
  }
  EXPECT_TRUE(has_bar);
  const MeshIndex skin(load_mesh(kMeshFile).mesh);
  const dvec3 at = vector_of(moved["probe"]["at"]);
  EXPECT_GT(glm::distance(at, center), 5e-4);
  EXPECT_LT(skin.closest_point(at).distance, 1e-9);
  EXPECT_EQ(off["probe"]["at"], moved["probe"]["at"]) << "outside the sensor the probe stays";
  EXPECT_EQ(on["camera"], off["camera"]);
  EXPECT_EQ(on["history"], off["history"]);
  EXPECT_EQ(on["document"], off["document"]);
}

TEST(ProbeTool, SetsTheDepthByWheelAndDragAndPutsItDownByAClick) {
  const StudioProgram studio;
  studio.play(joined({kTakeUp,
                      {dump("first.json"), kWheelUp, kWheelUp, kIdle, dump("deeper.json"), kWheelDown, kWheelDown,
                       kIdle, dump("back.json"),
                       // A drag downwards.
                       R"({"event": "mouse_down"})", kIdle, move_to(in_view(0.471, 0.602)), kIdle,
                       move_to(in_view(0.471, 0.678)), kIdle, R"({"event": "mouse_up"})", kIdle, dump("dragged.json"),
                       // A probe that is put down does not follow the pointer, and edits change its reading.
                       move_to(in_view(0.529, 0.450)), kIdle, dump("left.json"), click(taxel(9)), kIdle,
                       dump("selected.json")}}),
              {kLayoutFile});
  const Json first = studio.state("first.json"), deeper = studio.state("deeper.json"), back = studio.state("back.json");
  EXPECT_GT(deeper["probe"]["depth"], first["probe"]["depth"]);
  EXPECT_GT(force_of(deeper), force_of(first));
  EXPECT_EQ(deeper["probe"]["at"], first["probe"]["at"]);
  EXPECT_EQ(back["probe"]["depth"], first["probe"]["depth"]);
  EXPECT_EQ(back["probe"]["reading"], first["probe"]["reading"]);
  EXPECT_EQ(back["camera"], first["camera"]) << "the wheel does not zoom on the sensor";
  const Json dragged = studio.state("dragged.json"), left = studio.state("left.json");
  EXPECT_GT(dragged["probe"]["depth"], first["probe"]["depth"]);
  EXPECT_FALSE(dragged["probe"]["held"]);
  EXPECT_EQ(dragged["camera"], first["camera"]);
  EXPECT_EQ(left["probe"], dragged["probe"]);
  EXPECT_EQ(studio.state("selected.json")["selection"]["taxel"], 9);
}

TEST(ProbeTool, ReadsEveryEditAtOnceAndItsUndo) {
  const StudioProgram studio;
  studio.play(joined({kTakeUp,
                      {click(taxel(3)), kIdle, key("a"), kIdle, dump("before.json"),
                       R"({"event": "wheel", "y": 10, "at": {"view": [0.471, 0.639]}, "mods": ["ctrl"]})", kIdle,
                       dump("edited.json"), key("z", kCtrl), kIdle, dump("undone.json")}}),
              {kLayoutFile});
  const Json before = studio.state("before.json"), edited = studio.state("edited.json");
  EXPECT_EQ(edited["history"]["depth"], 1);
  EXPECT_LT(edited["probe"]["reading"]["values"][3], before["probe"]["reading"]["values"][3])
      << "the mean over a larger field";
  EXPECT_EQ(force_of(edited), force_of(before)) << "the contact is the same";
  EXPECT_TRUE(edited["probe"]["latency"].is_number());
  EXPECT_EQ(studio.state("undone.json")["probe"]["reading"], before["probe"]["reading"]);
}

TEST(ProbeTool, MovesByItsHandleAndIsPickedUpByAClick) {
  const StudioProgram studio;
  studio.play(
      joined({kTakeUp,
              {click(taxel(3)), kIdle, dump("down.json"), R"({"event": "mouse_down", "at": {"taxel": 3}})", kIdle,
               move_to(in_view(0.529, 0.507)), kIdle, move_to(in_view(0.544, 0.488)), kIdle, R"({"event": "mouse_up"})",
               kIdle, dump("led.json"), click(in_view(0.544, 0.488)), kIdle, dump("up.json")}}),
      {kLayoutFile});
  const Json down = studio.state("down.json"), led = studio.state("led.json");
  EXPECT_FALSE(down["probe"]["held"]);
  EXPECT_FALSE(led["probe"]["held"]);
  EXPECT_NE(led["probe"]["at"], down["probe"]["at"]);
  EXPECT_EQ(led["probe"]["depth"], down["probe"]["depth"]);
  EXPECT_EQ(led["camera"], down["camera"]);
  EXPECT_EQ(led["document"], down["document"]);
  EXPECT_TRUE(studio.state("up.json")["probe"]["held"]);
}

TEST(ProbeTool, EndsByEscAndXAndIsHiddenInSimulate) {
  const StudioProgram studio;
  studio.play(joined({kTakeUp,
                      {key("Esc"),
                       kIdle,
                       dump("escaped.json"),
                       key("x"),
                       kIdle,
                       move_to(in_view(0.471, 0.507)),
                       kIdle,
                       dump("again.json"),
                       key("x"),
                       kIdle,
                       dump("left.json"),
                       key("x"),
                       kIdle,
                       move_to(in_view(0.471, 0.507)),
                       kIdle,
                       key("2", kCtrl),
                       kIdle,
                       dump("simulate.json"),
                       kLayoutMode,
                       kIdle,
                       dump("layout.json")}}),
              {kLayoutFile});
  EXPECT_TRUE(studio.state("escaped.json")["probe"].is_null());
  EXPECT_TRUE(studio.state("again.json")["probe"]["reading"].is_object());
  EXPECT_TRUE(studio.state("left.json")["probe"].is_null());
  EXPECT_TRUE(studio.state("left.json")["polygons"].empty());
  EXPECT_TRUE(studio.state("simulate.json")["probe"]["reading"].is_null());
  EXPECT_TRUE(studio.state("layout.json")["probe"]["reading"].is_object());
}

TEST(ProbeTool, HasShapeAndMaterialInItsPanel) {
  const StudioProgram studio;
  studio.play(joined({kTakeUp,
                      {click(taxel(3)),
                       kIdle,
                       dump("ball.json"),
                       press("Probe/Shape"),
                       kIdle,
                       press("Edge"),
                       kIdle,
                       dump("edge.json"),
                       press("Probe/Shape"),
                       kIdle,
                       press("Mesh file"),
                       kIdle,
                       dump("none.json"),
                       press("Probe file"),
                       kIdle,
                       type(kMeshFile),
                       key("Enter"),
                       kIdle,
                       dump("mesh.json"),
                       press("Probe/Material"),
                       kIdle,
                       press("Soft"),
                       kIdle,
                       dump("soft.json")}}),
              {kLayoutFile});
  const Json ball = studio.state("ball.json");
  EXPECT_EQ(studio.state("edge.json")["probe"]["shape"], "edge");
  EXPECT_NE(force_of(studio.state("edge.json")), force_of(ball));
  EXPECT_NE(studio.state("none.json")["probe"]["problem"].get<std::string>().find("choose a mesh file"),
            std::string::npos);
  EXPECT_TRUE(studio.state("none.json")["probe"]["reading"].is_null());
  EXPECT_EQ(studio.state("mesh.json")["probe"]["problem"], "");
  EXPECT_GT(force_of(studio.state("mesh.json")), 0);
  EXPECT_GT(studio.state("soft.json")["probe"]["modulus"], 0);
  EXPECT_LT(force_of(studio.state("soft.json")), force_of(studio.state("mesh.json"))) << "it yields as well";
}

}  // namespace
}  // namespace taxel::test
