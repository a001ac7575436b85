// taxel read: reads a layout in one contact, or at many poses of the touched shape.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <ranges>

#include "app/cli/command_layout.h"
#include "app/cli/report_writer.h"
#include "core/base/files.h"
#include "core/base/output.h"
#include "core/hydro/intersect.h"
#include "core/layout/sensor_frame.h"
#include "core/layout/words.h"
#include "core/sensor/calibration.h"
#include "core/sensor/contact_case/contact_case.h"
#include "core/sensor/contact_case/pose_readings.h"
#include "core/sensor/error_bars.h"
#include "core/sensor/explain/explanation.h"
#include "core/sensor/readout/aggregate.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/compare/error_bars.h"

namespace taxel::cli {
namespace {

/// The files of `taxel read --poses`.
struct PoseFiles {
  std::string poses;  ///< table of poses, or empty for the one pose of the case
  std::string out;    ///< table of readings
};

struct ReadOptions {
  std::string layout;
  std::string file;
  LayoutOptions over;
  bool convergence = false, error_bars = false, ideal = false;
  PoseFiles files;
};

/// The readings of a layout in one contact, and the samples that each of them comes from. Lists are in layout order.
struct ReadReport {
  SensorModelPtr model;
  Pose X_WM;                                                        ///< pose of the mesh file's frame
  ContactResult result;                                             ///< contact of the layout's body, frame M
  ForceReading force;                                               ///< frame M
  std::vector<dvec2> shear;                                         ///< by the layout's aggregate
  std::vector<std::pair<Aggregate, std::vector<double>>> readings;  ///< by every aggregate of samples, and the force
  std::vector<std::vector<TaxelSampleReading>> behind;              ///< contributing samples of each taxel
  std::optional<Convergence> convergence;                           ///< empty if not requested
  std::vector<double> by_layout;                                    ///< by the layout's aggregate and method
  std::optional<ModelReadings> errors;                              ///< `by_layout`, better readings and their bars
  std::vector<double> calibrated;  ///< values that a device reports for `by_layout`; empty without a calibration

  [[nodiscard]] const Layout& layout() const { return model->layout; }
  /// Returns the model that `errors` compare with: the exact integral of samples, or finer bodies.
  [[nodiscard]] ReadingModel better() const { return errors->models.back().model; }
  void visit(ReportWriter& w) const;
  void visit_taxel(ReportWriter& w, std::size_t k) const;
  void visit_convergence(ReportWriter& w) const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string convergence_text() const;
  [[nodiscard]] std::string errors_text() const;
  [[nodiscard]] std::string calibrated_text() const;
  [[nodiscard]] std::string calibrated_unit() const;
};

/// Returns the fraction of a taxel's samples whose rays hit a contact surface; 0 without samples.
double covered(const std::vector<TaxelSampleReading>& samples) {
  if (samples.empty()) return 0;
  const auto hits = std::count_if(samples.begin(), samples.end(), [](const TaxelSampleReading& s) { return s.hit; });
  return static_cast<double>(hits) / static_cast<double>(samples.size());
}

void ReadReport::visit_taxel(ReportWriter& w, std::size_t k) const {
  const Taxel& taxel = layout().taxels[k];
  const TangentFrame frame = tangent_frame(layout().frame, taxel.normal);
  w("id", taxel.id);
  w("name", taxel.name);
  w("covered", covered(behind[k]));
  w("tangents", std::array{X_WM.rotate(frame.e1), X_WM.rotate(frame.e2)});
  w("normal_force", X_WM.rotate(force.normal[k]));
  w.list("samples", behind[k], [](ReportWriter& one, const TaxelSampleReading& sample) {
    one("sample", sample.sample);
    one("hit", sample.hit);
    one("depth", sample.depth);
    one("pressure", sample.pressure);
    one("weight", sample.weight);
    one("share", sample.share);
  });
}

void ReadReport::visit_convergence(ReportWriter& w) const {
  w("aggregate", to_word(convergence->aggregate));
  w("factors", Convergence::kFactors);
  w("samples", convergence->samples);
  w.list("taxels", std::views::iota(std::size_t{0}, layout().taxels.size()), [&](ReportWriter& one, std::size_t k) {
    std::vector<double> values;
    for (const std::vector<double>& of_taxels : convergence->values) values.push_back(of_taxels[k]);
    one("id", layout().taxels[k].id);
    one("values", values);
    one("difference", convergence->difference(k));
  });
}

void ReadReport::visit(ReportWriter& w) const {
  w("force", result.wrench_W.force);
  w("torque", result.wrench_W.torque);
  w("area", result.surface.area());
  w("polygons", result.surface.polygons.size());
  w("aggregate", to_word(layout().readout.aggregate));
  w("method", to_word(layout().readout.method));
  w("reading", by_layout);
  w.object("readings", [&](ReportWriter& by_aggregate) {
    for (const auto& [how, values] : readings) by_aggregate(to_word(how), values);
  });
  if (!calibrated.empty())
    w.object("calibrated", [&](ReportWriter& object) {
      object("unit", calibrated_unit());
      object("values", calibrated);
    });
  w("shear", shear);
  w.object("uncovered", [&](ReportWriter& uncovered) {
    uncovered("force", force.uncovered);
    uncovered("normal_force", X_WM.rotate(force.uncovered_normal));
  });
  w.list("taxels", std::views::iota(std::size_t{0}, behind.size()),
         [&](ReportWriter& taxel, std::size_t k) { visit_taxel(taxel, k); });
  if (errors)
    w.object("error_bars", [&](ReportWriter& object) {
      object("compared_with", better() == ReadingModel::exact ? "exact" : "finer_bodies");
      object("readings", by_layout);
      object("better", (*errors)[better()].values);
      object("bars", errors->bars);
    });
  if (convergence) w.object("convergence", [&](ReportWriter& object) { visit_convergence(object); });
}

std::string ReadReport::convergence_text() const {
  std::string text = fmt::format("\n{} with 1/4, 1 and 4 times the samples: {} on the skin\n",
                                 to_word(convergence->aggregate), fmt::join(convergence->samples, ", "));
  text += fmt::format("{:>6} {:<16} {:>14} {:>14} {:>14} {:>14}\n", "taxel", "name", "1/4", "1", "4", "4 less 1");
  for (std::size_t k = 0; k < layout().taxels.size(); ++k) {
    const Taxel& taxel = layout().taxels[k];
    text += fmt::format("{:>6} {:<16}", taxel.id, taxel.name);
    for (const std::vector<double>& values : convergence->values) text += fmt::format(" {:>14.6g}", values[k]);
    text += fmt::format(" {:>14.3g}\n", convergence->difference(k));
  }
  return text;
}

std::string ReadReport::errors_text() const {
  const char* unit = reading_unit(layout().readout.aggregate);
  const bool is_exact = better() == ReadingModel::exact;
  std::string text = fmt::format("\nerror bars of {} [{}], compared with {}\n", to_word(layout().readout.aggregate),
                                 unit, is_exact ? "the exact integral" : "bodies whose edges are half as long");
  text += fmt::format("{:>6} {:<16} {:>14} {:>14} {:>14}\n", "taxel", "name", "reading", is_exact ? "exact" : "finer",
                      "bar");
  for (std::size_t k = 0; k < by_layout.size(); ++k)
    text += fmt::format("{:>6} {:<16} {:>14.6g} {:>14.6g} {:>14.3g}\n", layout().taxels[k].id, layout().taxels[k].name,
                        by_layout[k], (*errors)[better()].values[k], errors->bars[k]);
  return text;
}

std::string ReadReport::calibrated_unit() const {
  const std::string& unit = layout().calibration.value().unit;
  return unit.empty() ? reading_unit(layout().readout.aggregate) : unit;
}

std::string ReadReport::calibrated_text() const {
  std::string text =
      fmt::format("\nvalues that a device with the layout's calibration reports at rest [{}]\n", calibrated_unit());
  text += fmt::format("{:>6} {:<16} {:>14} {:>14}\n", "taxel", "name", "reading", "calibrated");
  for (std::size_t k = 0; k < calibrated.size(); ++k)
    text += fmt::format("{:>6} {:<16} {:>14.6g} {:>14.6g}\n", layout().taxels[k].id, layout().taxels[k].name,
                        by_layout[k], calibrated[k]);
  return text;
}

std::string ReadReport::text() const {
  const dvec3& total = result.wrench_W.force;
  std::string text = fmt::format("force {} {} {} N on the layout, area {} m^2, {} polygons\n", total.x, total.y,
                                 total.z, result.surface.area(), result.surface.polygons.size());
  text += fmt::format("{:>6} {:<16} {:>8} {:>8}", "taxel", "name", "samples", "covered");
  for (const auto& [how, values] : readings) text += fmt::format(" {:>14}", to_word(how));
  const bool is_exact = layout().readout.method == ReadingMethod::exact;
  if (is_exact) text += fmt::format(" {:>20}", fmt::format("exact {}", to_word(layout().readout.aggregate)));
  text += '\n';
  for (std::size_t k = 0; k < behind.size(); ++k) {
    const Taxel& taxel = layout().taxels[k];
    text +=
        fmt::format("{:>6} {:<16} {:>8} {:>6.1f} %", taxel.id, taxel.name, behind[k].size(), 100 * covered(behind[k]));
    for (const auto& [how, values] : readings) text += fmt::format(" {:>14.6g}", values[k]);
    if (is_exact) text += fmt::format(" {:>20.6g}", by_layout[k]);
    text += '\n';
  }
  text += fmt::format("force that no taxel reaches: {:.6g} N of {:.6g} N\n", force.uncovered,
                      force.covered + force.uncovered);
  text += "weighted_sum in Pa m^2, force in N, the others in Pa\n";
  if (!calibrated.empty()) text += calibrated_text();
  if (errors) text += errors_text();
  return convergence ? text + convergence_text() : text;
}

/// Returns the contact case with the layout as body a and the touched shape as body b. Throws Error naming the file.
ContactCase case_of_layout(const ReadOptions& options) {
  ContactCase contact_case = read_contact_case(options.file);
  const auto is_free = [](const CaseBody& body) { return !body.shape; };
  if (!is_free(contact_case.a) && !contact_case.b.layout.empty()) std::swap(contact_case.a, contact_case.b);
  if (!is_free(contact_case.a)) {
    throw Error(options.file, "/a", "must be the layout (pos and quat, without a shape), is a shape");
  }
  if (!contact_case.b.layout.empty()) {
    throw Error(options.file, "/b", "must be a shape: a contact of two layouts is not supported");
  }
  return contact_case;
}

/// Measures the error bars of `reading`, which the model read from `surfaces` of a case. Throws Error if the layout's
/// readings have none.
ModelReadings measure_errors(const ContactCase& contact_case, const SensorModelPtr& model, const MadeBody& other,
                             const SensorReading& reading, std::span<const ContactSurface* const> surfaces) {
  TouchedBody touched;
  touched.body = other.body;
  touched.X_WB = contact_case.b.X_WB;
  touched.name = "b";
  if (other.shape) touched.shape = std::make_shared<const Shape>(*other.shape);
  auto scene = std::make_shared<SimScene>();
  scene->sensors = {model};
  scene->touched = {{touched}};
  StepView step;
  step.scene = scene;
  SensorView& sensor = step.sensors.emplace_back();
  sensor.X_WM = contact_case.a.X_WB;
  sensor.readings = reading.values;
  sensor.surfaces.assign(surfaces.begin(), surfaces.end());
  sensor.hits = reading.hits.all();
  return SensorErrors(*scene, 0).read(step);
}

/// The summary of the written table.
struct PosesReport {
  std::string file;
  std::size_t poses = 0, touching = 0;
  int taxels = 0;
  std::string aggregate, method, unit;
  double largest = 0;  ///< largest reading of all poses

  void visit(ReportWriter& w) const {
    w("file", file);
    w("poses", poses);
    w("touching", touching);
    w("taxels", taxels);
    w("aggregate", aggregate);
    w("method", method);
    w("unit", unit);
    w("largest", largest);
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("{} poses, {} with contact, {} taxels, {} by {}, at most {:.6g} {}: {}\n", poses, touching,
                       taxels, aggregate, method, largest, unit, file);
  }
};

/// Throws Error if a body of the case moves: a row of the table is a contact at rest.
void check_at_rest(const ContactCase& contact_case) {
  const auto check = [&](const CaseBody& body, const char* name) {
    for (const auto& [velocity, key] :
         {std::pair{body.V_WB.linear, "linear_velocity"}, std::pair{body.V_WB.angular, "angular_velocity"}})
      if (velocity != dvec3(0))
        throw Error(contact_case.file, fmt::format("/{}/{}", name, key),
                    "must be 0 with --poses, whose contacts are at rest: leave it out");
  };
  check(contact_case.a, "a");
  check(contact_case.b, "b");
}

bool is_moved(const CaseBody& body) {
  return body.X_WB.p != dvec3(0) || body.X_WB.q != dquat(1, 0, 0, 0);
}

/// Reads `model` at the poses of the shape `object`, body b of the case, and writes the table of readings. Throws Error
/// naming the file of a wrong pose, or the case if its bodies move.
void read_at_poses(const PoseFiles& files, const ContactCase& contact_case, const SensorModel& model,
                   const HydroBody& object, Console& console) {
  check_at_rest(contact_case);
  const TargetFile target(files.out);
  std::vector<std::string> unread;
  const std::vector<Pose> poses = parse_poses_csv(read_file(files.poses), files.poses, &unread);
  if (!unread.empty())
    console.note(fmt::format("{}: columns that are not read: {}", files.poses, fmt::join(unread, ", ")));
  if (is_moved(contact_case.a) || is_moved(contact_case.b))
    console.note(
        fmt::format("{}: pos and quat have no effect: {} has the poses of the shape in the frame of the "
                    "layout's mesh",
                    contact_case.file, files.poses));
  const PoseReadings readings = read_poses(model, object, poses);
  target.write(pose_readings_to_csv(model.layout, poses, readings));

  PosesReport report;
  report.file = files.out;
  report.poses = poses.size();
  report.touching = poses.size() - at(static_cast<int>(std::count(readings.areas.begin(), readings.areas.end(), 0.0)));
  report.taxels = readings.taxels;
  report.aggregate = to_word(model.layout.readout.aggregate);
  report.method = to_word(model.layout.readout.method);
  report.unit = reading_unit(model.layout.readout.aggregate);
  for (const double reading : readings.readings) report.largest = std::max(report.largest, reading);
  print_report(console, report);
}

int run_read_command(const ReadOptions& options, Console& console) {
  const ContactCase contact_case = case_of_layout(options);
  SensorCache cache;
  const SensorModelPtr model = load_model(options.layout, options.over, console, nullptr, &cache);
  const MadeBody other = make_case_body(contact_case, contact_case.b, "b");
  if (!model->body->soft() && !other.body->soft())
    throw Error(options.file, "/b/material/modulus", "must be greater than 0: the layout is rigid");
  for (const std::string& warning : other.warnings) console.warn(options.file + ": " + warning);

  if (!options.files.poses.empty()) {
    read_at_poses(options.files, contact_case, *model, *other.body, console);
    return kDone;
  }
  ReadReport report{model, contact_case.a.X_WB, {}, {}, {}, {}, {}, {}, {}, {}, {}};
  IntersectWorkspace workspace;
  evaluate_contact(contact_case, *model->body, *other.body, report.result, workspace);
  const ContactSurface* const surfaces[] = {&report.result.surface};
  SensorReading reading;
  const SurfaceMotion motions[] = {
      {combine(model->body->material, other.body->material), relative_twist(contact_case.a, contact_case.b)}};
  read_sensor(*model, surfaces, reading, RayPath::fastest, motions);
  read_shear(*model, surfaces, motions, reading);
  report.shear = reading.shear;
  report.by_layout = reading.values;
  if (model->layout.calibration && !options.ideal)
    report.calibrated = calibrated_at_rest(model->layout, reading.values);
  if (options.error_bars) report.errors = measure_errors(contact_case, model, other, reading, surfaces);
  const RayHits hits = reading.hits;
  reading.integral.integrate(*model, *skin_fields_for(*model, IntegralKind::force), surfaces, {}, report.force);
  for (const AggregateRow& how : kAggregates) {
    report.readings.emplace_back(how.value, report.force.values);
    if (aggregate_spec(how.value).fold != nullptr) aggregate(*model, hits, how.value, report.readings.back().second);
  }
  for (int k = 0; k < model->taxel_count(); ++k) report.behind.push_back(samples_behind(*model, hits.all(), k));
  if (options.convergence) report.convergence = read_convergence(make_convergence_models(model, cache), surfaces);
  print_report(console, report);
  return kDone;
}

}  // namespace

Run add_read(OptionList& list) {
  const auto options = std::make_shared<ReadOptions>();
  list.add("LAYOUT", &options->layout, "Layout file (*.taxels.json)", required());
  list.add("CASE", &options->file,
           "Contact case (JSON); `a` has the pose of the layout's mesh-file frame, `b` is the touched shape",
           required());
  add_skin(list, options->over.skin);
  add_sampling(list, options->over);
  add_readout(list, options->over.readout);
  list.add("--convergence", &options->convergence,
           "Read the same contact with a quarter of the samples and with four times as many, too");
  list.add(
      "--error-bars", &options->error_bars,
      "Also compare each reading by the layout's aggregate with its exact integral, or an exact reading with that of "
      "bodies whose edges are half as long");
  list.add("--ideal", &options->ideal,
           "Only the readings, before the layout's calibration. Without this option its values are printed too, of the "
           "contact at rest: relaxation, low pass, rate and latency have no effect, since one contact has no time");
  list.add("--out", &options->files.out, "With --poses: the table (CSV) of readings, wrenches and areas to write",
           {.unit = "FILE"});
  list.add("--poses", &options->files.poses,
           "Read every pose of a table (columns x, y, z, qw, qx, qy, qz; metres, or \"x [mm]\") of the shape in the "
           "frame of the layout's mesh, at rest, before the layout's calibration",
           {.unit = "FILE", .needs = {"--out"}, .excludes = {"--convergence", "--error-bars"}});
  return [options](Console& console) { return run_read_command(*options, console); };
}

}  // namespace taxel::cli
