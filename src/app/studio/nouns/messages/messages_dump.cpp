// The messages in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/nouns/messages/messages.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_messages(const App& app, nlohmann::ordered_json& state) {
  Json json = Json::array();
  for (const Message& m : app.get<Messages>()) {
    json.push_back({{"number", m.number}, {"severity", to_string(m.severity)}, {"text", m.text}, {"shown", m.toast}});
  }
  state["messages"] = std::move(json);
}

}  // namespace taxel::ui
