#include "app/studio/nouns/view/scene_info.h"

#include <fmt/format.h>

#include <algorithm>

#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

std::string counted(std::size_t count, const char* one, const char* more) {
  return fmt::format("{} {}", grouped(static_cast<long long>(count)), count == 1 ? one : more);
}

void add_solver(const SimFrame& frame, std::vector<InfoRow>& rows) {
  const StepFacts& facts = frame.facts;
  const SceneMarks& marks = frame.scene->marks;
  const auto number = [](std::int32_t count) { return static_cast<std::size_t>(std::max(count, 0)); };
  const std::string islands = facts.islands > 0 ? " in " + counted(number(facts.islands), "island", "islands") : "";
  rows.push_back({"Contacts", fmt::format("{} of MuJoCo, {}{}", grouped(facts.contacts),
                                          counted(number(facts.constraints), "constraint", "constraints"), islands)});
  rows.push_back(
      {"Solver", fmt::format("{}, {}", marks.solver, counted(number(facts.iterations), "iteration", "iterations"))});
  rows.push_back({"Energy", facts.energy ? fmt::format("potential {:.4g} J, kinetic {:.4g} J", facts.energy->potential,
                                                       facts.energy->kinetic)
                                         : "off: <flag energy=\"enable\"/>"});
  const double used = static_cast<double>(facts.arena),
               all = static_cast<double>(std::max<std::uint64_t>(marks.arena, 1));
  rows.push_back({"Memory", fmt::format("{} of {}, {:.1f} %", bytes_text(used), bytes_text(all), 100 * used / all)});
}

void add_sensors(const SimFrame& frame, std::vector<InfoRow>& rows) {
  if (frame.sensors.empty()) return;
  std::size_t polygons = 0, rays = 0, hits = 0;
  for (const SensorStep& sensor : frame.sensors) {
    for (const ContactSurface& surface : sensor.surfaces) polygons += surface.polygons.size();
    rays += sensor.hits.size();
    hits += static_cast<std::size_t>(
        std::count_if(sensor.hits.begin(), sensor.hits.end(), [](const RayHit& hit) { return hit.hit(); }));
  }
  rows.push_back(
      {"Sensors", fmt::format("{}: {}, {} of {} hit", frame.sensors.size(), counted(polygons, "polygon", "polygons"),
                              grouped(static_cast<long long>(hits)), counted(rays, "ray", "rays"))});
}

std::string size_text(const SimFrame& frame) {
  const SimScene& scene = *frame.scene;
  std::string text = counted(scene.geoms.size(), "geom", "geoms");
  if (frame.mark_poses.bodies.empty()) return text;  // a saved step has no poses
  const auto dofs = static_cast<std::size_t>(scene.marks.dofs);
  return fmt::format("{}, {}, {}", counted(frame.mark_poses.bodies.size() - 1, "body", "bodies"), text,
                     counted(dofs, "DOF", "DOFs"));
}

}  // namespace

std::vector<InfoRow> scene_info(const RunView& run) {
  std::vector<InfoRow> rows;
  if (!run.frame || !run.frame->scene) return rows;
  const SimFrame& frame = *run.frame;
  rows.push_back(
      {"Time", fmt::format("{:.4f} s, step {} of {:.4g} ms", frame.time, frame.step, 1e3 * frame.scene->timestep)});
  const Performance& p = run.performance;
  if (p.is_real_time && p.step_seconds > 0) {
    const std::string speed = run.playing ? fmt::format(", {:.2f} x real time", p.simulation_speed) : "";
    rows.push_back({"Pace", duration_text(p.step_seconds) + " a step" + speed});
  }
  rows.push_back({"Size", size_text(frame)});
  if (!frame.mark_poses.bodies.empty()) add_solver(frame, rows);
  add_sensors(frame, rows);
  rows.push_back({"History", fmt::format("{}, {}", counted(frame.history.steps, "step", "steps"),
                                         bytes_text(static_cast<double>(frame.history.bytes)))});
  return rows;
}

}  // namespace taxel::ui
