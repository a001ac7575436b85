// The states of the window itself.
#pragma once

#include <string>
#include <vector>

#include "app/studio/app/values/arrangement.h"
#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/window_place.h"
#include "app/studio/features/demo/demo_state.h"
#include "app/studio/features/files/file_dialog_state.h"
#include "app/studio/features/files/files_state.h"
#include "app/studio/features/menus/help_state.h"
#include "app/studio/features/menus/menu_keys_state.h"
#include "app/studio/features/menus/palette_state.h"
#include "app/studio/features/menus/tour_state.h"
#include "app/studio/features/messages/message_list.h"
#include "app/studio/features/profiler/profile_state.h"
#include "app/studio/features/view/view_state.h"

namespace taxel::ui {

/// States of the window itself.
struct WindowFeatures {
  Appearance appearance;
  Arrangement arrangement;
  PanelsShown panels;
  MenuKeys menu_keys;
  PaletteState palette;
  HelpState help;
  TourState tour;
  DemoState demo;
  ProfileState profile;
  ViewShown view;
  Messages messages;
  FileDialog dialog;
  std::vector<FileNotice> notices;  ///< oldest first
  Recovery recovery;
  std::vector<ExampleTile> examples;  ///< examples with a picture, for the start card
  std::vector<std::string> recent;    ///< recently opened files, newest first; kept in the settings file
  WindowPlace place;                  ///< place on the screen; kept in the settings file
  std::string title;                  ///< title of the window
  bool full_screen = false;           ///< whether the window has no frame
  bool asks_unsaved = false;          ///< whether it asks to save before the document is left
};

/// Calls visit(state) for each state.
template <class Visit>
void visit_features(WindowFeatures& of, const Visit& visit) {
  visit(of.appearance);
  visit(of.arrangement);
  visit(of.panels);
  visit(of.menu_keys);
  visit(of.palette);
  visit(of.help);
  visit(of.tour);
  visit(of.demo);
  visit(of.profile);
  visit(of.view);
  visit(of.messages);
  visit(of.dialog);
  visit(of.notices);
  visit(of.recovery);
  visit(of.recent);
  visit(of.place);
  visit(of.title);
  visit(of.full_screen);
  visit(of.asks_unsaved);
}

}  // namespace taxel::ui
