// The tool in use in the state of the window.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of_tool(Tool tool) {
  switch (tool) {
    case Tool::none:
      return "none";
    case Tool::place:
      return "place";
    case Tool::slide:
      return "slide";
    case Tool::move:
      return "move";
    case Tool::turn:
      return "turn";
    case Tool::resize:
      return "resize";
    case Tool::way_point:
      return "way_point";
    case Tool::box:
      return "box";
    case Tool::lasso:
      return "lasso";
    case Tool::brush:
      return "brush";
  }
  return "none";
}

}  // namespace

void dump_tool(const App& app, nlohmann::ordered_json& state) {
  const ToolState& tool = app.get<ToolState>();
  state["tool"] = {{"name", name_of_tool(tool.tool)}, {"value", tool.value}, {"problem", tool.problem}};
}

}  // namespace taxel::ui
