#include "app/studio/host/run/handover.h"

#include <algorithm>
#include <utility>

namespace taxel::studio {
namespace {

bool same_taxels(const Layout& a, const Layout& b) {
  return std::equal(a.taxels.begin(), a.taxels.end(), b.taxels.begin(), b.taxels.end(),
                    [](const Taxel& x, const Taxel& y) { return x.id == y.id; });
}

bool same_mesh(const TriMeshPtr& a, const TriMeshPtr& b) {
  return a == b || (a->faces() == b->faces() && a->vertices() == b->vertices());
}

/// Returns true if both layouts have friction with the same state.
bool same_bristles(const Layout& a, const Layout& b) {
  return a.material.tangential_stiffness == b.material.tangential_stiffness &&
         a.material.bristles == b.material.bristles;
}

bool reads_by(const SimFrame& frame, const SensorModelPtr& model) {
  const auto& sensors = frame.simulated->sensors;
  return std::find(sensors.begin(), sensors.end(), model) != sensors.end();
}

}  // namespace

void Handover::update(HostEvents& events) {
  send_newest();
  send_replacement(events);
}

/// With the same taxels the run continues with new readings. Otherwise the rows of the run would not fit, and another
/// run begins.
void Handover::send_newest() {
  const SensorModelPtr model = document_.model();
  if (!is_wanted_ || !model || document_.edits().building() || replacement_ || run_.pending()) return;
  is_wanted_ = false;
  const SimFramePtr& frame = run_.frame();
  if (!run_.scene().is_of_document || !frame || frame->simulated->sensors.empty()) return;
  const SensorModelPtr& simulated = frame->simulated->sensors.front();
  if (simulated == model) return;
  if (same_taxels(simulated->layout, model->layout) && same_bristles(simulated->layout, model->layout) &&
      same_mesh(simulated->mesh, model->mesh)) {
    begin({simulated, model});
  } else if (model->taxel_count() > 0 && document_.edits().problem().empty()) {
    run_.build({.document = *document_.opened(),
                .is_scenario = true,
                .scenario = run_.scene().scenario,
                .plays = run_.playback().plays,
                .turns_cameras = false,
                .is_shown = false});
  }
}

/// Sends samples to the simulation, or displays them if no simulation reads by their preview.
void Handover::send_replacement(HostEvents& events) {
  if (!replacement_ || replacement_->command > 0 || run_.pending()) return;
  const Polished& models = replacement_->models;
  if (!run_.scene().is_of_document || !run_.frame() || !reads_by(*run_.frame(), models.preview)) {
    document_.accept_polished(std::exchange(replacement_, std::nullopt)->models, events);
  } else {
    replacement_->command = run_.send(ReplaceModelCommand{models.preview, models.model});
  }
}

void Handover::accept(const SimEvent& event, HostEvents& events) {
  if (!replacement_ || replacement_->command == 0 || event.reply_to != replacement_->command) return;
  if (std::holds_alternative<ModelReplaced>(event.what)) {
    document_.accept_polished(std::exchange(replacement_, std::nullopt)->models, events);
  } else if (std::holds_alternative<Refused>(event.what) || std::holds_alternative<Done>(event.what)) {
    document_.retain_preview(std::exchange(replacement_, std::nullopt)->models.preview);
  }
}

bool Handover::will_change_samples() const {
  const SimFramePtr& frame = run_.frame();
  if (!run_.scene().is_of_document || !frame || !frame->simulated) return false;
  const auto is_preview = [](const SensorModelPtr& model) { return model && model->quality == SampleQuality::preview; };
  const std::vector<SensorModelPtr>& sensors = frame->simulated->sensors;
  if (std::none_of(sensors.begin(), sensors.end(), is_preview)) return false;
  return document_.loader().busy() || run_.pending() || replacement_ || document_.edits().building() || is_wanted_;
}

}  // namespace taxel::studio
