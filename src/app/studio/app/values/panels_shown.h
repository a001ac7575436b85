// A switch for each panel that can be open or closed, named after the title of its window.
#pragma once

namespace taxel::ui {

struct PanelsShown {
  bool outliner = true, taxels = true, inspector = true, bars = true, plot = true, section = true, timeline = true;
  bool controls = true;
  bool messages = false, help = false, explain = false, map = false, heat = true, models = false, study = false;
  bool compare = false, history = false, data_set = false;
  bool mesh_report = false, info = false, profiler = false;
};

}  // namespace taxel::ui
