// Words by which people look for commands that have other names.
#include "app/studio/frame/keymap.h"

#include <algorithm>
#include <array>

namespace taxel::ui {
namespace {

struct Synonyms {
  std::string_view label, words;
};

constexpr std::array kSynonyms{
    Synonyms{"Export video...", "gif mp4 movie film clip animation render record"},
    Synonyms{"Make a film around the contact", "gif mp4 movie video clip animation orbit turntable talk presentation"},
    Synonyms{"Save screenshot", "picture image snapshot capture photo print screen"},
    Synonyms{"Export picture (PNG)...", "screenshot image snapshot figure transparent paper render"},
    Synonyms{"Export sheet to print (HTML)...", "pdf paper report printout"},
    Synonyms{"Light theme", "dark bright night day mode colour color colours colors scheme appearance skin"},
    Synonyms{"Lock pressure range", "colour color colours colors map scale legend limits auto"},
    Synonyms{"Readings on the skin", "colour color heat map heatmap glow"},
    Synonyms{"Contact surface", "colour color pressure patch"},
    Synonyms{"Larger interface", "zoom font text size bigger scale"},
    Synonyms{"Smaller interface", "zoom font text size scale"},
    Synonyms{"Normal size", "zoom font text scale reset"},
    Synonyms{"Full screen", "fullscreen maximize maximise kiosk"},
    Synonyms{"Run / Pause", "play start stop simulate go"},
    Synonyms{"Reset", "restart rewind begin"},
    Synonyms{"Record", "save log capture"},
    Synonyms{"Export recording...", "csv data log save numpy npz mcap ros2 bag foxglove"},
    Synonyms{"Frame all", "fit zoom home center centre view everything"},
    Synonyms{"Frame selection", "fit zoom focus center centre"},
    Synonyms{"Align camera", "reset view home default"},
    Synonyms{"Orthographic view", "parallel projection perspective isometric cad ortho"},
    Synonyms{"Transparent sensor", "xray see through opacity alpha glass"},
    Synonyms{"Clip plane", "cut section slice cross"},
    Synonyms{"Undo", "revert back"},
    Synonyms{"Undo history", "edits steps log list timeline go back"},
    Synonyms{"Redo", "again forward"},
    Synonyms{"Delete", "remove erase"},
    Synonyms{"Duplicate", "copy clone"},
    Synonyms{"Quit", "exit close end"},
    Synonyms{"New", "create empty blank document layout project"},
    Synonyms{"Open examples...", "sample demo files assets hand fingertip scene tutorial"},
    Synonyms{"Open...", "load import file"},
    Synonyms{"Use the desktop's file dialog", "native system gtk kde gnome zenity kdialog chooser picker"},
    Synonyms{"Keys and mouse", "help shortcuts hotkeys bindings keyboard"},
    Synonyms{"Tour", "help tutorial introduction guide"},
    Synonyms{"Press a probe", "touch poke indent ball finger"},
    Synonyms{"Explain the reading", "why jump artifact artefact"},
    Synonyms{"Compare with a layout...", "second other versus vs difference side by side a/b"},
    Synonyms{"Compare with the paper's released model", "publication article original versus vs difference star"},
    Synonyms{"Compare panel", "second layout versus vs difference side by side a/b"},
    Synonyms{"Profiler panel", "fps speed performance slow timing"},
    Synonyms{"Reset arrangement", "layout windows panels dock default"},
};

}  // namespace

std::string_view synonyms_of(std::string_view label) {
  const auto found =
      std::find_if(kSynonyms.begin(), kSynonyms.end(), [&](const Synonyms& row) { return row.label == label; });
  return found != kSynonyms.end() ? found->words : std::string_view();
}

std::size_t synonym_count() {
  return kSynonyms.size();
}

}  // namespace taxel::ui
