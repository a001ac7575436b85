// Every rule of a layout: broken once, reported once, at its place.
#include "core/layout/check/layout_check.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/layout/file/layout_json.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Returns two valid taxels on the upper face of a box of 20 x 16 x 10 mm.
Layout good_layout() {
  Layout layout;
  layout.mesh.file = "box.obj";
  layout.taxels = {{0, "a", dvec3(0.004, 0, 0.005), dvec3(0, 0, 1), 0.003, {}},
                   {1, "b", dvec3(-0.004, 0, 0.005), dvec3(0, 0, 1), 0.003, {}}};
  return layout;
}
MeshIndex box() {
  return MeshIndex(std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.008, 0.005))));
}

/// Returns problems as "severity pointer code".
std::vector<std::string> listed(const Problems& problems) {
  std::vector<std::string> list;
  for (const Problem& p : problems) {
    EXPECT_EQ(p.file, "f.json");
    EXPECT_FALSE(p.message.empty());
    list.push_back(fmt::format("{} {} {}", to_string(p.severity), p.pointer, p.code));
  }
  return list;
}
using List = std::vector<std::string>;

template <class Change>
List values_after(const Change& change) {
  Layout layout = good_layout();
  change(layout);
  return listed(check_layout_values(layout, "f.json"));
}
template <class Change>
List on_mesh_after(const Change& change) {
  Layout layout = good_layout();
  change(layout);
  return listed(check_layout_on_mesh(layout, box(), "cafe", "f.json"));
}

TEST(LayoutCheck, FindsNoProblemInAValidLayout) {
  EXPECT_EQ(values_after([](Layout&) {}), List{});
  EXPECT_EQ(on_mesh_after([](Layout&) {}), List{});
}

TEST(LayoutCheck, NamesTheValueInTheMessageOfARadius) {
  Layout layout = good_layout();
  layout.taxels[1].radius = -0.006;
  const Problems problems = check_layout_values(layout, "f.json");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].pointer, "/taxels/1/radius");
  EXPECT_EQ(problems[0].message, "must be greater than 0, is -0.006 (taxel 1)");
  try {
    throw_first_error(problems);
    FAIL();
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "f.json: /taxels/1/radius: must be greater than 0, is -0.006 (taxel 1)");
  }
}

TEST(LayoutCheck, NamesEachRepairValueOutOfItsRange) {
  const auto edge = [](double v) { return [v](Layout& l) { l.mesh.repair.edge = v; }; };
  EXPECT_EQ(values_after(edge(-3e-4)), List{"error /mesh/repair/edge repair_out_of_range"});
  EXPECT_EQ(values_after(edge(0)), List{"error /mesh/repair/edge repair_out_of_range"});
  EXPECT_EQ(values_after(edge(kNaN)), List{"error /mesh/repair/edge repair_out_of_range"});
  EXPECT_EQ(values_after(edge(3e-4)), List{});
  EXPECT_EQ(values_after([](Layout& l) { l.mesh.repair = {RepairLevel::wrap, 0.0, kInf, -1.0, 0.0, 0.0}; }),
            (List{"error /mesh/repair/join repair_out_of_range", "error /mesh/repair/fill repair_out_of_range",
                  "error /mesh/repair/edge repair_out_of_range", "error /mesh/repair/tolerance repair_out_of_range",
                  "error /mesh/repair/refine repair_out_of_range"}));
  Layout layout = good_layout();
  layout.mesh.repair.edge = -3e-4;
  EXPECT_EQ(check_layout_values(layout, "f.json")[0].message, "must be greater than 0, is -0.0003");
}

TEST(LayoutCheck, NamesTheIdInProblemsOfTaxels) {
  Layout layout = good_layout();
  layout.taxels[0].id = 70;
  layout.taxels[1].id = 4;
  layout.taxels[1].radius = 0.0;
  layout.taxels[0].subtaxels = {{layout.taxels[0].center, dvec3(0), 0.001}};
  for (const Problem& p : check_layout_values(layout, "f.json"))
    EXPECT_TRUE(p.message.ends_with(p.pointer.starts_with("/taxels/0") ? " (taxel 70)" : " (taxel 4)")) << p.message;
  layout = good_layout();
  layout.taxels[1].id = 815;
  layout.taxels[1].center.z = 0.02;
  const Problems on_mesh = check_layout_on_mesh(layout, box(), "", "f.json");
  ASSERT_EQ(on_mesh.size(), 2U);
  for (const Problem& p : on_mesh) EXPECT_TRUE(p.message.ends_with(" (taxel 815)")) << p.message;
}

TEST(LayoutCheck, CentresAGeodesicFieldAtTheNearestPoint) {
  // The taxel is 2.9 mm above the box. Around the point below, the top of the box is reached by a path of 3 mm, the
  // side only by straight distance.
  const auto sideways = [](Metric metric) {
    return [metric](Layout& l) {
      l.receptive_field = {metric, 45.0};
      l.taxels[0] = {0, "", dvec3(0.0075, 0, 0.0079), dvec3(1, 0, 0.2), 0.003, {}};
    };
  };
  const List off = {"warning /taxels/0/center center_off_surface", "warning /taxels/0/normal normal_off_surface"};
  EXPECT_EQ(on_mesh_after(sideways(Metric::geodesic)), off);
  List empty = off;
  empty.push_back("warning /taxels/0 field_empty");
  EXPECT_EQ(on_mesh_after(sideways(Metric::euclidean)), empty);
}

TEST(LayoutCheck, DoesNotThrowForWarnings) {
  EXPECT_NO_THROW(
      throw_first_error({{"f", "/x", Severity::warning, "c", "m", ""}, {"f", "", Severity::note, "c", "m", ""}}));
}

TEST(LayoutCheck, ReportsInvalidValuesOfTaxels) {
  const auto first = [](auto change) { return values_after([&](Layout& l) { change(l.taxels[0]); }); };
  for (const double r : {0.0, -1.0, kNaN, kInf})
    EXPECT_EQ(first([&](Taxel& t) { t.radius = r; }), List{"error /taxels/0/radius radius_not_positive"}) << r;
  EXPECT_EQ(first([](Taxel& t) { t.radius = 1.1e6; }), List{"error /taxels/0/radius too_far"});
  EXPECT_EQ(first([](Taxel& t) { t.center.y = kNaN; }), List{"error /taxels/0/center not_finite"});
  EXPECT_EQ(first([](Taxel& t) { t.normal = dvec3(0); }), List{"error /taxels/0/normal zero_normal"});
  EXPECT_EQ(first([](Taxel& t) { t.normal.x = kInf; }), List{"error /taxels/0/normal not_finite"});
  EXPECT_EQ(first([](Taxel& t) { t.id = 1; }), List{"error /taxels/1/id duplicate_id"});
  EXPECT_EQ(first([](Taxel& t) { t.id = -3; }), List{"error /taxels/0/id id_negative"});
  EXPECT_EQ(first([](Taxel& t) { t.center = dvec3(-0.004, 1e-10, 0.005); }),
            List{"warning /taxels/1/center duplicate_place"});
  EXPECT_EQ(first([](Taxel& t) {
              t.subtaxels = {{t.center, dvec3(0), -1.0}};
            }),
            (List{"error /taxels/0/subtaxels/0/normal zero_normal",
                  "error /taxels/0/subtaxels/0/radius radius_not_positive"}));
  EXPECT_EQ(first([](Taxel& t) {
              t.subtaxels = {{t.center, t.normal, 0.004}};
            }),
            List{"warning /taxels/0/subtaxels/0/radius subtaxel_larger"});
  EXPECT_EQ(first([](Taxel& t) {
              t.subtaxels = {{t.center + dvec3(0.0029, 0, 0), t.normal, 0.001},
                             {t.center + dvec3(0, 0.0031, 0), t.normal, 0.001}};
            }),
            List{"warning /taxels/0/subtaxels/1/center subtaxel_outside"});
}

TEST(LayoutCheck, ReportsDensitiesOfTaxels) {
  for (const double d : {-1.0, kNaN, kInf})
    EXPECT_EQ(values_after([&](Layout& l) { l.taxels[0].density = d; }),
              List{"error /taxels/0/density density_negative"});
  EXPECT_EQ(values_after([](Layout& l) { l.taxels[0].density = 0.5 * l.sampling.density; }),
            List{"warning /taxels/0/density density_unused"});
  EXPECT_EQ(values_after([](Layout& l) { l.taxels[0].density = 2 * l.sampling.density; }), List{});
  EXPECT_EQ(values_after([](Layout& l) { l.taxels[0].density = 1e15; }),
            List{"error /taxels/0/density density_too_high"});
}

TEST(LayoutCheck, ReportsInvalidSettings) {
  EXPECT_EQ(values_after([](Layout& l) { l.mesh.file.clear(); }), List{"error /mesh/file mesh_file_empty"});
  EXPECT_EQ(values_after([](Layout& l) { l.mesh.scale.y = 0; }), List{"error /mesh/scale/1 scale_zero"});
  EXPECT_EQ(values_after([](Layout& l) { l.frame.pad = dvec3(0); }), List{"error /frame/pad zero_normal"});
  EXPECT_EQ(values_after([](Layout& l) { l.frame.pad = dvec3(0, 0, -2); }), List{"error /frame/pad frame_parallel"});
  EXPECT_EQ(values_after([](Layout& l) { l.frame.pad = dvec3(0, -1, 0.5); }), List{"warning /frame/pad frame_skew"});
  for (const double d : {0.0, -1e7, kNaN, kInf})
    EXPECT_EQ(values_after([&](Layout& l) { l.sampling.density = d; }),
              List{"error /sampling/density density_not_positive"});
  EXPECT_EQ(values_after([](Layout& l) { l.receptive_field.metric = Metric::geodesic; }), List{});
  for (const double a : {0.0, -45.0, 180.1, kNaN})
    EXPECT_EQ(values_after([&](Layout& l) { l.receptive_field.max_angle_deg = a; }),
              List{"error /receptive_field/max_angle_deg angle_out_of_range"});
  EXPECT_EQ(values_after([](Layout& l) { l.readout.max_depth = -1; }), List{"error /readout/max_depth depth_negative"});
  EXPECT_EQ(values_after([](Layout& l) { l.material.modulus = kNaN; }),
            List{"error /material/modulus modulus_negative"});
  EXPECT_EQ(values_after([](Layout& l) { l.material.thickness = -1; }),
            List{"error /material/thickness thickness_negative"});
  EXPECT_EQ(values_after([](Layout& l) { l.material.dissipation = -1; }),
            List{"error /material/dissipation dissipation_negative"});
  EXPECT_EQ(values_after([](Layout& l) { l.material.friction = kInf; }),
            List{"error /material/friction friction_negative"});
  EXPECT_EQ(values_after([](Layout& l) { l.material.field = FieldKind::tets; }),
            List{"error /material/field not_available"});
  EXPECT_EQ(values_after([](Layout& l) { l.taxels.clear(); }), List{"warning /taxels no_taxels"});
}

TEST(LayoutCheck, ChecksFrictionThatSticks) {
  const auto after = [](double stiffness, int bristles, double modulus) {
    return values_after([=](Layout& l) {
      l.material.tangential_stiffness = stiffness;
      l.material.bristles = bristles;
      l.material.modulus = modulus;
    });
  };
  EXPECT_EQ(after(1e8, 1, 1e5), List{});
  EXPECT_EQ(after(0, kMostBristles, 0), List{});
  for (const double stiffness : {-1.0, kNaN, kInf})
    EXPECT_EQ(after(stiffness, 500, 1e5), List{"error /material/tangential_stiffness stiffness_negative"});
  EXPECT_EQ(after(1e8, 500, 0), List{"error /material/tangential_stiffness stiffness_of_rigid"});
  for (const int bristles : {-1, 0, kMostBristles + 1})
    EXPECT_EQ(after(1e8, bristles, 1e5), List{"error /material/bristles bristles_out_of_range"});
}

TEST(LayoutCheck, LimitsTheRollOffByTheLargestAngle) {
  const auto after = [](double angle, double falloff) {
    return values_after([=](Layout& l) {
      l.receptive_field.max_angle_deg = angle;
      l.receptive_field.angle_falloff_deg = falloff;
    });
  };
  for (const double f : {0.0, 10.0, 45.0}) EXPECT_EQ(after(45, f), List{});
  for (const double f : {-1.0, 45.5, kNaN, kInf})
    EXPECT_EQ(after(45, f), List{"error /receptive_field/angle_falloff_deg falloff_out_of_range"});
  EXPECT_EQ(after(0, 10), List{"error /receptive_field/max_angle_deg angle_out_of_range"});
}

TEST(LayoutCheck, RefusesExactReadingsWhereThereAreNone) {
  const auto after = [](Aggregate aggregate, RayDirection ray) {
    return values_after([=](Layout& l) {
      l.readout.aggregate = aggregate;
      l.readout.method = ReadingMethod::exact;
      l.readout.ray = ray;
    });
  };
  for (const Aggregate a : {Aggregate::weighted_mean, Aggregate::mean}) {
    EXPECT_EQ(after(a, RayDirection::surface_normal), List{});
    EXPECT_EQ(after(a, RayDirection::taxel_normal), List{"error /readout/method method_needs_surface_rays"});
  }
  EXPECT_EQ(after(Aggregate::force, RayDirection::surface_normal), List{});
  EXPECT_EQ(after(Aggregate::force, RayDirection::taxel_normal), List{"warning /readout/ray ray_unused"});
  for (const Aggregate a : {Aggregate::weighted_sum, Aggregate::nearest, Aggregate::max})
    for (const RayDirection ray : {RayDirection::surface_normal, RayDirection::taxel_normal})
      EXPECT_EQ(after(a, ray), List{"error /readout/method method_not_available"});
}

TEST(LayoutCheck, ReportsInvalidCalibrations) {
  const auto broken = [](auto change) {
    Layout layout = good_layout();
    change(layout.calibration.emplace());
    return listed(check_layout_values(layout, "f.json"));
  };
  using C = Calibration;
  EXPECT_EQ(broken([](C&) {}), List{});
  EXPECT_EQ(broken([](C& c) {
              c.hysteresis = {-1, 2, {}};
            }),
            (List{"error /calibration/hysteresis/width width_negative",
                  "error /calibration/hysteresis/fraction fraction_out_of_range"}));
  EXPECT_EQ(broken([](C& c) {
              c.crosstalk = {kNaN, 0};
            }),
            (List{"error /calibration/crosstalk/fraction fraction_out_of_range",
                  "error /calibration/crosstalk/reach reach_not_positive"}));
  EXPECT_EQ(broken([](C& c) { c.tare = {false, kInf}; }), List{"error /calibration/tare not_finite"});
  EXPECT_EQ(broken([](C& c) { c.tare_deviation = -1; }), List{"error /calibration/tare_deviation deviation_negative"});
  EXPECT_EQ(broken([](C& c) { c.gain_deviation = kNaN; }), List{"error /calibration/gain_deviation not_finite"});
  EXPECT_EQ(broken([](C& c) { c.noise = -1; }), List{"error /calibration/noise deviation_negative"});
  EXPECT_EQ(broken([](C& c) { c.gain = 0; }), List{"error /calibration/gain gain_zero"});
  EXPECT_EQ(broken([](C& c) {
              c.gain = 1, c.curve = {{0, 0}};
            }),
            (List{"error /calibration/curve gain_and_curve", "error /calibration/curve curve_too_short"}));
  EXPECT_EQ(broken([](C& c) {
              c.curve = {{0, 0}, {0, 1}, {1, kInf}};
            }),
            (List{"error /calibration/curve/1/0 curve_not_ascending", "error /calibration/curve/2/1 not_finite"}));
  EXPECT_EQ(broken([](C& c) { c.range = {1, 1}; }), List{"error /calibration/range range_empty"});
  EXPECT_EQ(broken([](C& c) { c.range = {kNaN, 1}; }), List{"error /calibration/range/0 not_finite"});
  EXPECT_EQ(broken([](C& c) { c.quantisation = Quantisation{}; }),
            List{"error /calibration/quantisation step_or_bits"});
  EXPECT_EQ(broken([](C& c) {
              c.quantisation = {0.0, {}};
            }),
            List{"error /calibration/quantisation/step step_not_positive"});
  EXPECT_EQ(broken([](C& c) {
              c.quantisation = {{}, 33};
            }),
            (List{"error /calibration/quantisation/bits bits_out_of_range",
                  "error /calibration/quantisation/bits bits_without_range"}));
  EXPECT_EQ(broken([](C& c) { c.rate = 0; }), List{"error /calibration/rate rate_not_positive"});
  EXPECT_EQ(
      broken([](C& c) {
        c.dead = {1.5, kNaN};
      }),
      (List{"error /calibration/dead/fraction fraction_out_of_range", "error /calibration/dead/value not_finite"}));
}

TEST(LayoutCheck, ReportsInvalidStagesOfTheChain) {
  const auto broken = [](const Calibration& calibration) {
    Layout layout = good_layout();
    layout.calibration = calibration;
    return listed(check_layout_values(layout, "f.json"));
  };
  Calibration c;
  const auto response = [&](const Response& r) {
    c.response = r;
    return broken(c);
  };
  EXPECT_EQ(response({{1, -2e-5}, 2e4, {}}), List{});
  EXPECT_EQ(response({{1, -2e-5}, 3e4, {}}), List{"error /calibration/response/polynomial response_not_ascending"});
  // Slopes with a minimum between the ends: 3 x^2 - 6 x + 3.1 and 4 x^3 - 12 x^2 + 9 x + 0.2 at x = 1 and 1.5.
  EXPECT_EQ(response({{3.1, -3, 1}, 3, {}}), List{});
  EXPECT_EQ(response({{2.9, -3, 1}, 3, {}}), List{"error /calibration/response/polynomial response_not_ascending"});
  EXPECT_EQ(response({{0.2, 4.5, -4, 1}, 3, {}}), List{});
  EXPECT_EQ(response({{-0.2, 4.5, -4, 1}, 3, {}}),
            List{"error /calibration/response/polynomial response_not_ascending"});
  EXPECT_EQ(response({{0.2, 4.5, -4.1, 1}, 3, {}}),
            List{"error /calibration/response/polynomial response_not_ascending"});
  EXPECT_EQ(response({{1, 0, 0, 0, 1}, kNaN, {}}), (List{"error /calibration/response/polynomial polynomial_too_long",
                                                         "error /calibration/response/up_to not_finite"}));
  EXPECT_EQ(response({{kInf}, 0, {{0, 0}, {1, 1}}}), (List{"error /calibration/response polynomial_or_points",
                                                           "error /calibration/response/polynomial/0 not_finite",
                                                           "error /calibration/response/up_to up_to_not_positive"}));
  EXPECT_EQ(response({}), List{"error /calibration/response polynomial_or_points"});
  EXPECT_EQ(response({{}, 1, {{0, 0}}}), (List{"error /calibration/response/up_to up_to_without_polynomial",
                                               "error /calibration/response/points curve_too_short"}));
  EXPECT_EQ(response({{}, 0, {{0, 0}, {1, 2}, {1, 1}, {2, kNaN}}}),
            (List{"error /calibration/response/points/2/0 curve_not_ascending",
                  "error /calibration/response/points/2/1 response_not_ascending",
                  "error /calibration/response/points/3/1 not_finite"}));
  c = {};
  c.relaxation = {{0.5, 1}, {0.6, -1}, {-0.1, kNaN}};
  EXPECT_EQ(broken(c), (List{"error /calibration/relaxation/1/time time_not_positive",
                             "error /calibration/relaxation/2/amplitude fraction_out_of_range",
                             "error /calibration/relaxation/2/time not_finite"}));
  c.relaxation = {{0.5, 1}, {0.6, 2}};
  EXPECT_EQ(broken(c), List{"error /calibration/relaxation relaxation_too_large"});
  c.relaxation = {{0.7, 1}, {0.2, 2}, {0.1, 3}};  // the sum is 1 up to rounding
  EXPECT_EQ(broken(c), List{});
  c = {};
  c.hysteresis = {1, 1, {{-1, 0.1}}};
  EXPECT_EQ(broken(c), (List{"error /calibration/hysteresis/plays/0/width width_negative",
                             "error /calibration/hysteresis hysteresis_too_large"}));
  c = {};
  c.low_pass = {1, 1};
  EXPECT_EQ(broken(c), List{"error /calibration/low_pass time_or_cutoff"});
  c.low_pass = {{}, 0};
  EXPECT_EQ(broken(c), List{"error /calibration/low_pass/cutoff cutoff_not_positive"});
  c.low_pass = LowPass{};
  EXPECT_EQ(broken(c), List{"error /calibration/low_pass time_or_cutoff"});
  c = {};
  c.crosstalk_matrix = {{1, 2, 3}};  // there are two taxels
  c.crosstalk = {0.1, 0.01};
  c.latency = -1;
  EXPECT_EQ(
      broken(c),
      (List{"error /calibration/crosstalk_matrix matrix_size", "error /calibration/crosstalk_matrix/0 matrix_size",
            "error /calibration/crosstalk_matrix crosstalk_twice", "error /calibration/latency latency_negative"}));
  c = {};
  c.crosstalk_matrix = {{1, 0}, {kNaN, 1}};
  EXPECT_EQ(broken(c), List{"error /calibration/crosstalk_matrix/1/0 not_finite"});
}

TEST(LayoutCheck, NamesTheTaxelOfAnInvalidCalibration) {
  Layout layout = good_layout();
  layout.calibration.emplace().taxels = {{.id = 1, .tare = kNaN, .gain = 0, .curve = {}, .dead = kInf},
                                         {.id = 1, .tare = {}, .gain = {}, .curve = {}, .dead = {}},
                                         {.id = 8, .tare = {}, .gain = {}, .curve = {}, .dead = {}}};
  const Problems problems = check_layout_values(layout, "f.json");
  EXPECT_EQ(listed(problems),
            (List{"error /calibration/taxels/0/tare not_finite", "error /calibration/taxels/0/gain gain_zero",
                  "error /calibration/taxels/0/dead not_finite", "error /calibration/taxels/1/id duplicate_id",
                  "warning /calibration/taxels/2/id calibration_unused"}));
  EXPECT_EQ(problems[1].message, "must not be 0, is 0 (taxel 1)");
}

TEST(LayoutCheck, ReportsACentreFarFromTheMesh) {
  Layout layout = good_layout();
  layout.taxels[0].center.z = 0.0065;
  const Problems problems = check_layout_on_mesh(layout, box(), "", "f.json");
  ASSERT_EQ(listed(problems), List{"warning /taxels/0/center center_off_surface"});
  EXPECT_EQ(problems[0].message, "is 1.5 mm from the surface, the radius is 3 mm (taxel 0)");
  EXPECT_EQ(problems[0].fix, "nearest point of the surface: [0.004, 0, 0.005]");
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.taxels[0].center.z = 0.020; }),
            (List{"error /taxels/0/center center_off_surface", "warning /taxels/0 field_empty"}));
}

TEST(LayoutCheck, AsksWhetherCentresAreInMillimetres) {
  const auto in_mm = [](Layout& l) {
    for (Taxel& taxel : l.taxels) taxel.center *= 1000.0;
  };
  EXPECT_EQ(on_mesh_after(in_mm), List{"error /taxels centers_in_mm"}) << "instead of a problem of each taxel";
  EXPECT_EQ(on_mesh_after([](Layout& l) {
              for (Taxel& taxel : l.taxels) taxel.center *= 500.0;
            }).front(),
            "error /taxels/0/center center_off_surface")
      << "they are not on the mesh in mm";
}

TEST(LayoutCheck, ReportsANormalAgainstTheSurface) {
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.taxels[0].normal = dvec3(0, 0.9, 1); }), List{});  // 42 degrees
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.taxels[0].normal = dvec3(0, 1.7, 1); }),           // 59.5 degrees
            List{"warning /taxels/0 field_empty"});
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.taxels[0].normal = dvec3(0, 2, 1); }),
            (List{"warning /taxels/0/normal normal_off_surface", "warning /taxels/0 field_empty"}));
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.taxels[0].normal = dvec3(0, 0, -1); }),
            (List{"warning /taxels/0/normal normal_points_inward", "warning /taxels/0 field_empty"}));
}

TEST(LayoutCheck, ReportsASizeThatDoesNotFitTheMesh) {
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.taxels[0].radius = 3.0; }),
            List{"warning /taxels/0/radius radius_exceeds_body"});
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.sampling.density = 1e12; }),
            List{"error /sampling/density density_too_high"});
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.sampling.density = 1.0; }),
            List{"warning /sampling/density density_too_low"});
}

TEST(LayoutCheck, ReportsADifferentHashOfTheMesh) {
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.mesh.sha256 = "beef"; }), List{"warning /mesh/sha256 mesh_changed"});
  EXPECT_EQ(on_mesh_after([](Layout& l) { l.mesh.sha256 = "cafe"; }), List{});
}

TEST(LayoutCheck, ReportsASoftMaterialOnAnOpenMesh) {
  const TriMesh closed = make_box(dvec3(0.010, 0.008, 0.005));
  std::vector<ivec3> faces = closed.faces();
  faces.pop_back();
  const MeshIndex open(std::make_shared<TriMesh>(closed.vertices(), faces));
  Layout layout = good_layout();
  layout.taxels.clear();
  EXPECT_EQ(listed(check_layout_on_mesh(layout, open, "", "f.json")), List{"error /mesh/file mesh_open"});
  layout.material.modulus = 0.0;
  EXPECT_EQ(listed(check_layout_on_mesh(layout, open, "", "f.json")), List{});
}

TEST(LayoutCheck, ReportsCavitiesThatAreNotSensed) {
  TriMesh outer = make_box(dvec3(0.010, 0.008, 0.005));
  const TriMesh inner = make_box(dvec3(0.003));
  std::vector<dvec3> vertices = outer.vertices();
  std::vector<ivec3> faces = outer.faces();
  for (const ivec3& f : inner.faces()) faces.push_back(ivec3(f.x, f.z, f.y) + outer.vertex_count());
  vertices.insert(vertices.end(), inner.vertices().begin(), inner.vertices().end());
  const MeshIndex index(std::make_shared<TriMesh>(vertices, faces));
  Layout layout = good_layout();
  layout.taxels[0].center = dvec3(0, 0, 0.003);  // on the cavity's wall, 2 mm below the skin
  EXPECT_EQ(listed(check_layout_on_mesh(layout, index, "", "f.json")),
            (List{"note /mesh/file mesh_has_cavity", "warning /taxels/0/center center_off_surface"}));
  layout.sampling.shells = Shells::all;
  EXPECT_EQ(listed(check_layout_on_mesh(layout, index, "", "f.json")).at(0), "note /mesh/file mesh_has_cavity");
  EXPECT_EQ(check_layout_on_mesh(layout, index, "", "f.json")[0].message,
            "has enclosed shells (12 of 24 faces): they are sampled as well, but only the outer ones can be touched");
}

TEST(LayoutCheck, FindsNoErrorsInTheRealLayout) {
  const std::filesystem::path file = std::filesystem::path(TAXEL_REAL_DATA) / "shadow_fingertip.taxels.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "absent: " << file;
  const Layout layout = read_layout(file);
  EXPECT_EQ(check_layout_values(layout, "f.json").size(), 0U);
  const LoadedMesh loaded = load_mesh(mesh_path(layout, file), layout.mesh.scale);
  EXPECT_EQ(listed(check_layout_on_mesh(layout, MeshIndex(loaded.mesh), loaded.sha256, "f.json")),
            List{"note /mesh/file mesh_has_cavity"});
}

/// Intersections that a repair found are reported unchanged. Without a repair, the mesh is searched for intersections.
TEST(LayoutCheck, ReportsIntersectionsThatTheRepairFound) {
  const MeshIndex index = box();
  RepairedMesh repaired = *as_loaded(index.mesh_ptr());
  EXPECT_TRUE(check_layout_mesh(repaired, "f.json").empty());
  repaired.crossings = SelfIntersections{5, 1, 3, dvec3(0.001, 0, 0)};
  const Problems problems = check_layout_mesh(repaired, "f.json");
  EXPECT_EQ(listed(problems), List{"warning /mesh/file mesh_self_intersection"});
  EXPECT_EQ(problems.at(0).message,
            "5 pairs of faces cut through each other, the first at (1, 0, 0) mm (faces 1 and 3)");
}

}  // namespace
}  // namespace taxel
