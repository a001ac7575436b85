// The list of messages: numbers, and notes that leave the view.
#include <gtest/gtest.h>

#include "app/studio/frame/message_list.h"
#include "app/studio/nouns/messages/messages.h"

namespace taxel::ui {
namespace {

TEST(AddMessage, NumbersMessagesInOrderOfArrival) {
  Messages messages;
  add_message(messages, Severity::note, "first", 1.5);
  add_message(messages, Severity::error, "second", 2.5);
  messages.erase(messages.begin());
  add_message(messages, Severity::warning, "third", 3.5);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].number, 2);
  EXPECT_EQ(messages[1].number, 3) << "a number is not used twice";
  EXPECT_EQ(messages[1].text, "third");
  EXPECT_EQ(messages[1].shown_at, 3.5);
}

TEST(AddMessage, OnlyListsAMessageThatIsNotShown) {
  Messages messages;
  add_message(messages, Severity::note, "welded 4 duplicate vertices", 1, Holds::always, false);
  add_message(messages, Severity::note, "Saved", 1);
  EXPECT_FALSE(messages[0].toast);
  EXPECT_TRUE(messages[1].toast);
  EXPECT_TRUE(toasts_will_change(messages));
  messages.pop_back();
  EXPECT_FALSE(toasts_will_change(messages));
}

TEST(ToastsWillChange, CountsNotesInTheViewOnly) {
  Messages messages;
  EXPECT_FALSE(toasts_will_change(messages));
  add_message(messages, Severity::error, "An error remains until it is closed.", 0);
  EXPECT_FALSE(toasts_will_change(messages));
  add_message(messages, Severity::note, "A note leaves the view after a while.", 0);
  EXPECT_TRUE(toasts_will_change(messages));
  messages[1].toast = false;
  EXPECT_FALSE(toasts_will_change(messages));
}

TEST(EndMessages, TakesTheMessagesOfOneCircumstanceFromTheLine) {
  Messages messages;
  add_message(messages, Severity::warning, "Paused: taxel 3 jumped", 0, Holds::while_paused);
  add_message(messages, Severity::note, "a.csv will be written as soon as the samples are polished.", 0,
              Holds::while_export_waits);
  add_message(messages, Severity::error, "It could not be read.", 0);
  EXPECT_FALSE(toasts_will_change(messages)) << "a note that waits does not leave by itself";
  end_messages(messages, Holds::while_paused);
  EXPECT_FALSE(messages[0].toast);
  EXPECT_TRUE(messages[1].toast);
  end_messages(messages, Holds::while_export_waits);
  EXPECT_FALSE(messages[1].toast);
  EXPECT_TRUE(messages[2].toast);
  EXPECT_EQ(messages.size(), 3U) << "all stay in the list";
}

TEST(Messages, ReplaceTheNewestOneThatTheyRepeat) {
  Messages messages;
  add_message(messages, Severity::note, "There is no edit to undo", 1);
  add_message(messages, Severity::note, "There is no edit to undo", 2);
  add_message(messages, Severity::note, "There is no edit to undo", 3);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].shown_at, 3);
  EXPECT_EQ(messages[0].number, 3);
  add_message(messages, Severity::warning, "There is no edit to undo", 4);
  EXPECT_EQ(messages.size(), 2U) << "a warning is another message";
}

}  // namespace
}  // namespace taxel::ui
