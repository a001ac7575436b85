// The results of a simulator: steps, contacts at given poses, scene files. Nothing here changes its state.
#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/hydro/intersect.h"
#include "core/mesh/repair/repair.h"
#include "core/sim/model/geometry.h"
#include "core/sim/model/scene_view.h"
#include "core/sim/plugin/pairs/body_contacts.h"
#include "core/sim/scene/scene_patch.h"
#include "core/sim/simulator_impl.h"

namespace taxel {

bool Simulator::finished() const {
  return impl_->scenario && impl_->steps > impl_->scenario->motion.last_step;
}
bool Simulator::row_due() const {
  return impl_->row_due;
}
const std::shared_ptr<const SimScene>& Simulator::scene() const {
  return impl_->shown;
}

namespace {

/// A text about a sensor or another body of a scene, whose title ends in ": ".
struct TitledText {
  std::string title, text;
};

/// Returns each different text once, behind the title of the first body that has it and the number of the others.
std::vector<std::string> merged(const std::vector<TitledText>& all) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto has_text = [&](const TitledText& one) { return one.text == all[i].text; };
    const auto begin = all.begin(), present = begin + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(begin, present, has_text)) continue;
    std::string title = all[i].title;
    const auto others = std::count_if(present + 1, all.end(), has_text);
    if (others > 0 && title.ends_with(": ")) title.replace(title.size() - 2, 2, fmt::format(" and {} more: ", others));
    texts.push_back(title + all[i].text);
  }
  return texts;
}

}  // namespace

std::vector<std::string> Simulator::warnings() const {
  std::vector<TitledText> of_bodies;
  for (std::size_t i = 0; i < impl_->bodies.size(); ++i) {
    const std::string title = impl_->title_of(i);
    for (const std::string& text : impl_->contacts(i).warnings) of_bodies.push_back({title, text});
    // The caller has the model of a built-in scenario and knows its report.
    const SensorModelPtr model = i < impl_->sensor_count() && !impl_->scenario ? impl_->model(i) : nullptr;
    if (model != nullptr && model->mesh != model->loaded)
      of_bodies.push_back({title, "mesh of the layout: " + repair_summary(model->repaired->report)});
  }
  std::vector<std::string> all = impl_->compiled.notes;
  for (std::string& text : merged(of_bodies)) all.push_back(std::move(text));
  return all;
}

std::vector<std::string> Simulator::repairs() const {
  std::vector<TitledText> of_bodies;
  for (std::size_t i = 0; i < impl_->bodies.size(); ++i)
    for (const TouchedGeom& touched : impl_->contacts(i).touched())
      if (!touched.repair.empty()) of_bodies.push_back({impl_->title_of(i), touched.repair});
  std::vector<std::string> all;
  if (impl_->scenario) all = impl_->scenario->repairs;
  for (std::string& text : merged(of_bodies)) all.push_back(std::move(text));
  return all;
}

SensorTimes Simulator::sensor_times() const {
  SensorTimes sum;
  for (std::size_t i = 0; i < impl_->bodies.size(); ++i) {
    const SensorTimes& times = impl_->contacts(i).times;
    sum.surfaces += times.surfaces;
    sum.forces += times.forces;
    sum.readings += times.readings;
  }
  return sum;
}

StepView Simulator::view() const {
  StepView now;
  view(now);
  return now;
}

void Simulator::Impl::read_sensors() {
  unread.clear();
  for (std::size_t i = 0; i < sensor_count(); ++i)
    if (sensor(i)->is_unread()) unread.push_back(sensor(i));
  taxel::read_sensors(m(), d(), unread);
}

void Simulator::view(StepView& view) const {
  Impl& s = *impl_;
  view.scene = scene();
  view.step = s.steps;
  view.time = s.time;
  view.travel = s.travel;
  view.finished = finished();
  view.geom_poses.clear();
  for (const int g : s.drawn) view.geom_poses.push_back(geom_pose(s.m(), s.d(), g));
  view.sensors.resize(s.bodies.size());
  s.read_sensors();
  static const SensorReading without_taxels;
  for (std::size_t i = 0; i < s.bodies.size(); ++i) {
    const BodyContacts& body = s.contacts(i);
    const SensorReading& reading = i < s.sensor_count() ? s.sensor(i)->reading() : without_taxels;
    const Evaluation& e = body.sensed();
    SensorView& one = view.sensors[i];
    one.X_WM = e.X_WM;
    one.readings = reading.values;
    one.shear = reading.shear;
    one.slip = i < s.sensor_count() ? std::span<const double>(s.sensor(i)->slip()) : std::span<const double>();
    one.uncovered_W = e.X_WM.rotate(reading.force.uncovered_normal);
    one.force_W = one.torque_W = dvec3(0);
    one.surfaces.clear();
    one.motions.clear();
    for (const std::size_t k : e.near) {
      one.force_W += e.X_WM.rotate(e.pairs[k].wrench.force);
      one.torque_W += e.X_WM.rotate(e.pairs[k].wrench.torque);
      one.surfaces.push_back(&e.pairs[k].surface);  // in the order of the surface indices of the hits
      one.motions.push_back({body.touched()[k].properties, e.pairs[k].V_rub});
    }
    one.sticking.clear();
    // The motions do not give the friction of bristles, which follows their deflections.
    if (std::any_of(e.near.begin(), e.near.end(), [&](std::size_t k) { return !e.pairs[k].sticking.roots.empty(); }))
      for (const std::size_t k : e.near) one.sticking.push_back(&e.pairs[k].sticking);
    one.hits = reading.hits.all();
    one.hit_rays = reading.hits.hit_rays();
  }
  view.constraint_points = constraint_points(s.m(), s.d());
  pose_marks(s.m(), s.d(), view.mark_poses);
  view.facts = step_facts(s.m(), s.d());
}

void Simulator::fill_frame(SimFrame& frame, FilledHits& hits) const {
  fill_step(view(), frame, hits);
  frame.controls = control_values(impl_->m(), impl_->d());
  frame.perturbed = impl_->perturbation.shown(impl_->m(), impl_->d());
}

SensorStep Simulator::contact_at(std::size_t sensor, std::span<const Pose> sensors, std::span<const Pose> X_WG) const {
  const Impl& s = *impl_;
  SensorStep out;
  out.model = s.model(sensor);
  out.X_WM = sensors[sensor];
  IntersectWorkspace workspace;
  const BodyContacts& self = s.contacts(sensor);
  for (const TouchedGeom& touched : self.touched()) {
    ContactSurface& surface = out.surfaces.emplace_back();
    if (touched.body == nullptr) continue;
    if (const int partner = s.place_of(touched.role.partner); partner >= 0) {
      const auto o = static_cast<std::size_t>(partner);
      intersect_bodies(self, s.contacts(o), touched.role.mirrored, sensors[sensor], sensors[o], surface, workspace);
      continue;
    }
    const auto drawn = std::find(s.drawn.begin(), s.drawn.end(), touched.geom);
    if (drawn == s.drawn.end() && s.m().body_weldid[s.m().geom_bodyid[touched.geom]] != 0)
      throw Error(s.title, fmt::format("geom \"{}\" moves and is not recorded: it is invisible",
                                       geom_name(s.m(), touched.geom)));
    const Pose pose = drawn == s.drawn.end() ? geom_pose(s.m(), s.d(), touched.geom)
                                             : X_WG[static_cast<std::size_t>(drawn - s.drawn.begin())];
    intersect(*self.body(), *touched.body, sensors[sensor], pose, surface, workspace);
  }
  if (sensor >= s.sensor_count()) return out;
  SensorReading reading;
  read_sensor(*out.model, surface_pointers(out), reading);
  out.hits = reading.hits.all();
  out.readings = std::move(reading.values);
  out.uncovered_W = out.X_WM.rotate(reading.force.uncovered_normal);
  return out;
}

SceneFiles Simulator::files(const std::string& folder) const {
  return impl_->scenario ? impl_->scenario->files : portable_scene(impl_->compiled, impl_->d(), folder);
}

Pose Simulator::mocap_pose() const {
  const Impl& s = *impl_;
  if (s.mocap < 0) return {};
  const mjtNum *p = s.d().mocap_pos + 3 * s.mocap, *q = s.d().mocap_quat + 4 * s.mocap;
  return {{q[0], q[1], q[2], q[3]}, {p[0], p[1], p[2]}};
}

void export_scene(const Simulator& simulator, const std::filesystem::path& folder) {
  write_scene(folder / "scene.xml", simulator.files());
}

SceneFiles patched_files(const Simulator& simulator, const std::filesystem::path& output) {
  const Simulator::Impl& s = *simulator.impl_;
  if (s.scenario) throw Error(s.title, "is a scenario, which has no file");
  return patched_scene(s.title, s.attachments, s.compiled, output).scene;
}

std::string save_scene(const Simulator& simulator, const std::filesystem::path& file) {
  SceneFiles files;
  std::string reason;
  try {
    files = patched_files(simulator, file);
  } catch (const Error& error) {
    reason = error.what();
    files = simulator.files(file.stem().string() + "_files");
  }
  write_scene(file, files);
  if (reason.empty()) return "";
  return "a new print of the whole scene with copies of its files, because the scene cannot be patched: " + reason;
}

}  // namespace taxel
