#include "app/studio/frame/message_list.h"

#include <utility>

#include "core/base/text/message.h"

namespace taxel::ui {

void add_message(Messages& messages, Severity severity, std::string text, double now, Holds holds, bool is_shown) {
  const std::string line{taxel::shown_part(text, kMostShownLine)};
  const bool repeats = !messages.empty() && messages.back().severity == severity && messages.back().text == line &&
                       messages.back().holds == holds;
  const int number = messages.empty() ? 1 : messages.back().number + 1;
  if (repeats) messages.pop_back();
  Message message;
  message.severity = severity;
  message.text = line;
  message.number = number;
  message.shown_at = now;
  message.holds = holds;
  message.toast = is_shown;
  messages.push_back(std::move(message));
}

void end_messages(Messages& messages, Holds holds) {
  if (holds == Holds::for_run) {
    std::erase_if(messages, [](const Message& message) { return message.holds == Holds::for_run; });
    return;
  }
  for (Message& message : messages)
    if (message.holds == holds) message.toast = false;
}

}  // namespace taxel::ui
