// taxel read: the readings of a layout in one contact.
#include <memory>

#include "app/cli/command.h"
#include "app/cli/default_layout.h"
#include "app/cli/read_report.h"
#include "core/layout/words.h"

namespace taxel::cli {
namespace {

struct Options {
  std::string layout;
  std::string file;
  LayoutOptions over;
  bool convergence = false;
};

/// The case as seen by the layout: the layout is body a, what it touches body b.
ContactCase case_of_layout(const Options& options) {
  ContactCase contact_case = read_contact_case(options.file);
  const auto free_for_layout = [](const CaseBody& body) { return !body.shape; };
  if (!free_for_layout(contact_case.a) && !contact_case.b.layout.empty()) std::swap(contact_case.a, contact_case.b);
  if (!free_for_layout(contact_case.a)) {
    throw Error(options.file, "/a", "must be the layout (pos, quat and no shape), is a shape");
  }
  if (!contact_case.b.layout.empty()) {
    throw Error(options.file, "/b", "must be a shape: two layouts against each other cannot be read");
  }
  return contact_case;
}

int run(const Options& options, Console& console) {
  const ContactCase contact_case = case_of_layout(options);
  SensorCache cache;
  const SensorModelPtr model = load_model(options.layout, options.over, console, nullptr, &cache);
  const MadeBody other = make_case_body(contact_case, contact_case.b, "b");
  if (!model->body->soft() && !other.body->soft())
    throw Error(options.file, "/b/material/modulus", "must be greater than 0: the layout is rigid");
  for (const std::string& warning : other.warnings) console.warn(options.file + ": " + warning);

  ReadReport report{*model, contact_case.a.X_WB, {}, {}, {}, {}, {}, {}, {}};
  IntersectWorkspace workspace;
  evaluate_contact(contact_case, *model->body, *other.body, report.result, workspace);
  const ContactSurface* const surfaces[] = {&report.result.surface};
  SensorReading reading;
  const SurfaceMotion motions[] = {
      {combine(model->body->material, other.body->material), relative_twist(contact_case.a, contact_case.b)}};
  read_sensor(*model, surfaces, reading, RayPath::fastest, motions);
  read_shear(*model, surfaces, motions, reading);
  report.shear = reading.shear;
  report.hits = reading.hits;
  const FieldWeights weights(model->layout, *model->skin);
  reading.integral.integrate(*model, weights, surfaces, {}, report.force);
  for (const Word<Aggregate>& how : kAggregateWords) {
    report.readings.emplace_back(how.value, report.force.values);
    if (how.value != Aggregate::force) aggregate(*model, report.hits, how.value, report.readings.back().second);
  }
  for (int k = 0; k < model->taxel_count(); ++k) report.behind.push_back(samples_behind(*model, report.hits.all(), k));
  if (options.convergence) report.convergence = read_convergence(make_convergence_models(model, cache), surfaces);
  console.result(console.json() ? read_json(report) : read_text(report));
  return kDone;
}

}  // namespace

Command add_read(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(parent, common, "read",
                              "The readings of a layout in one contact, with every aggregate and its samples",
                              "taxel read finger.taxels.json finger_on_box.json --json");
  app->add_option("LAYOUT", options->layout, "Layout file (*.taxels.json)")->required()->option_text("(required)");
  app->add_option("CASE", options->file,
                  "Contact case (JSON); its `a` holds the pose of the layout's mesh-file frame, `b` what it touches")
      ->required()
      ->option_text("(required)");
  add_skin(*app, options->over.skin);
  add_sampling(*app, options->over);
  add_aggregate(*app, options->over.aggregate);
  app->add_flag("--convergence", options->convergence,
                "Read the same contact with a quarter of the samples and with four times as many, too");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
