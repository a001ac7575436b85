// The timeline and the recorded steps in the state of the window.
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/nouns/timeline/timeline.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<StepEvent, const char*>, 6> kEventNames{
    {{StepEvent::contact_begins, "contact_begins"},
     {StepEvent::contact_ends, "contact_ends"},
     {StepEvent::jump, "jump"},
     {StepEvent::jump_at_equal_force, "jump_at_equal_force"},
     {StepEvent::other_layout, "other_layout"},
     {StepEvent::disagreement, "disagreement"}}};

Json breakpoints_json(const Breakpoints& b) {
  return {{"on_jump", b.on_jump},         {"at_equal_force", b.at_equal_force},   {"jump", b.jump},
          {"equal_force", b.equal_force}, {"on_disagreement", b.on_disagreement}, {"disagreement", b.disagreement},
          {"of_sensor", b.of_sensor}};
}

Json stop_json(const SimFrame& frame) {
  if (!frame.stop) return nullptr;
  const auto taxel_id = [&](const auto& at) {
    const Layout& layout = frame.simulated->sensors[static_cast<std::size_t>(at.sensor)]->layout;
    return layout.taxels[static_cast<std::size_t>(at.taxel)].id;
  };
  if (const auto* gap = std::get_if<Disagreement>(&*frame.stop)) {
    return {{"step", gap->step},       {"time", gap->time},   {"taxel", taxel_id(*gap)},
            {"sampled", gap->sampled}, {"exact", gap->exact}, {"part", gap->part}};
  }
  const Jump& jump = std::get<Jump>(*frame.stop);
  return {{"step", jump.step},
          {"time", jump.time},
          {"taxel", taxel_id(jump)},
          {"before", jump.before},
          {"after", jump.after},
          {"part", jump.part},
          {"force_before", jump.force_before},
          {"force_after", jump.force_after},
          {"at_equal_force", jump.at_equal_force}};
}

Json events_json(const HistoryLanes& lanes) {
  Json json = Json::array();
  for (const StepMark& mark : lanes.steps) {
    if (mark.events == 0) continue;
    Json what = Json::array();
    for (const auto& [event, name] : kEventNames) {
      if (mark.has(event)) what.push_back(name);
    }
    json.push_back({{"step", mark.step}, {"what", what}});
  }
  return json;
}

}  // namespace

void dump_timeline(const App& app, nlohmann::ordered_json& state) {
  const Timeline& t = app.get<Timeline>();
  state["timeline"] = {{"lanes", {t.lanes.x0, t.lanes.y0, t.lanes.x1, t.lanes.y1}},
                       {"steps", {t.steps.first, t.steps.last}},
                       {"marks", t.marks},
                       {"unfolded", t.unfolded}};
  if (!app.shown->run.frame) return;
  const HistoryState& history = app.shown->run.frame->history;
  Json json = {{"first", history.first},          {"last", history.last},
               {"steps", history.steps},          {"bytes", history.bytes},
               {"limit", history.limits.steps},   {"recorded", app.shown->run.frame->recorded},
               {"replay", app.shown->run.replay}, {"loop", nullptr}};
  if (app.shown->run.loop) json["loop"] = {app.shown->run.loop->first, app.shown->run.loop->last};
  const RecordingState& recording = app.shown->run.frame->recording;
  json["recording"] = {{"on", recording.on}, {"steps", recording.steps}, {"bytes", recording.bytes}};
  json["breakpoints"] = breakpoints_json(app.shown->run.frame->breakpoints);
  json["stop"] = stop_json(*app.shown->run.frame);
  json["events"] = history.lanes ? events_json(*history.lanes) : Json::array();
  state["simulation"]["history"] = std::move(json);
}

}  // namespace taxel::ui
