#include "app/studio/nouns/generate/pattern_job.h"
#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/brush/brush.h"
#include "app/studio/nouns/generate/generate_state.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace taxel::studio {

std::string displayed_problem(const PatternFieldError& error) {
  if (!error.value) return fmt::format("{}: {}", error.field.label, error.rule);
  const DisplayUnit unit = display_unit(error.field.quantity);
  if (error.field.quantity == FieldQuantity::number)
    return fmt::format("{}: {}, is {}", error.field.label, error.rule, *error.value);
  return fmt::format("{}: {}, is {:g} {}", error.field.label, error.rule, *error.value / std::pow(10.0, unit.decimal),
                     unit.typed);
}

PatternJob::PatternJob(JobExecutor& executor)
    : NewestWins(executor, Priority::normal, [](const PatternRequest& request, PatternResult& out, Progress& progress) {
        out.number = request.number;
        try {
          out.made = make_pattern(request.pattern, request.source, *request.skin, &progress);
        } catch (const PatternFieldError& error) {
          out.problem = displayed_problem(error);
        }
      }) {}

namespace {

/// Returns the request for the preview that the panel waits for.
PatternRequest pattern_request(const ui::GenerateState& generate, const SensorModel& model) {
  const ui::PatternInputs& asked = generate.asked;
  PatternRequest request{generate.number, asked.pattern, {}, asked.skin};
  PatternSource& source = request.source;
  source.frame = asked.frame;
  source.sensor = asked.sensor;
  source.painted = !asked.region->empty();
  source.faces = ui::skin_faces(model, *asked.region);
  if (asked.table) source.table = *asked.table;
  source.table_file = asked.table_file;
  source.image = asked.image;
  return request;
}

class PatternOfFeature final : public FeatureJob {
 public:
  explicit PatternOfFeature(JobExecutor& executor) : patterns_(executor) {}

  void request_about_run(const ui::App& app, const SensorModelPtr& /*model*/,
                         const SendToSimulation& /*send*/) override {
    const ui::GenerateState& generate = app.get<ui::GenerateState>();
    const SensorModelPtr& model = app.shown->document.model;
    if (!generate.open || !generate.asked.skin || !model) return patterns_.post(std::nullopt, Superseded::cancel);
    if (std::exchange(number_, generate.number) != generate.number)
      patterns_.post(pattern_request(generate, *model), Superseded::cancel);
  }
  bool take_about_layout(const SensorModelPtr& /*model*/, bool /*is_compiled*/) override {
    return store(made_, patterns_.newest());
  }
  void fill(ui::App& app) const override {
    ui::GenerateState& g = app.get<ui::GenerateState>();
    if (!made_ || !g.open || !g.waiting() || made_->number != g.number) return;
    g.shown = made_->number;
    g.problem = made_->problem;
    g.left_out = made_->made.left_out;
    g.least_distance = made_->made.least_distance;
    g.ghosts = made_->problem.empty() ? std::make_shared<const std::vector<Taxel>>(made_->made.taxels) : nullptr;
  }
  [[nodiscard]] bool busy() const override { return patterns_.busy() || patterns_.newest() != made_; }

 private:
  PatternJob patterns_;
  std::uint64_t number_ = 0;  // of the newest request
  PatternResultPtr made_;
};

}  // namespace

std::unique_ptr<FeatureJob> make_pattern_job(JobExecutor& executor) {
  return std::make_unique<PatternOfFeature>(executor);
}

}  // namespace taxel::studio
