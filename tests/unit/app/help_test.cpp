// Manual pages and completion scripts of a small program.
#include <gtest/gtest.h>

#include "app/help/program_help.h"

namespace taxel {
namespace {

ProgramHelp small_program() {
  const OptionHelp shape{{"-s", "--shape"}, "WORD", "Shape of the body [a word: one]", {"box", "sphere"}, true};
  const OptionHelp file{{}, "FILE", "The file", {}, true};
  const OptionHelp quiet{{"--quiet"}, "", "No user's messages", {}, false};
  return {{"press", "Presses a body", ".first line\nback\\slash", {quiet}},
          {{"down", "Moves down", "", {shape, file}}, {"up", "Moves up", "", {}}},
          "1.2"};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ManPage, ListsOptionsAndCommands) {
  const std::string page = man_page(small_program());
  EXPECT_TRUE(page.starts_with(".TH PRESS 1 \"\" \"Taxel Studio 1.2\"")) << page;
  EXPECT_TRUE(has(page, ".SH NAME\npress \\- Presses a body\n")) << page;
  EXPECT_TRUE(has(page, ".SS press down\nMoves down.\n")) << page;
  EXPECT_TRUE(has(page, "\\fB\\-s, \\-\\-shape\\fR WORD\nShape of the body")) << page;
  EXPECT_TRUE(has(page, "\\fIFILE\\fR\nThe file\n")) << page;
}

TEST(ManPage, EscapesWhatTroffWouldObey) {
  EXPECT_TRUE(has(man_page(small_program()), "\\&.first line\n.br\nback\\eslash\n"));
}

TEST(Completion, QuotesApostrophesForEachShell) {
  EXPECT_TRUE(has(completion_script(small_program(), "fish"), "-d 'No user'\\''s messages'"));
  EXPECT_TRUE(has(completion_script(small_program(), "zsh"), "'*--quiet[No user'\\''s messages]'"));
}

TEST(Completion, OffersTheWordsOfAnOption) {
  EXPECT_TRUE(has(completion_script(small_program(), "bash"), "\"down --shape\") words='box sphere' ;;"));
  EXPECT_TRUE(has(completion_script(small_program(), "fish"), "-s s -l shape -x -a 'box sphere'"));
  EXPECT_TRUE(has(completion_script(small_program(), "zsh"),
                  "'*--shape[Shape of the body \\[a word\\: one\\]]:value:(box sphere)'"));
}

TEST(Completion, HasNoConditionWithoutCommands) {
  ProgramHelp help = small_program();
  help.commands.clear();
  EXPECT_TRUE(has(completion_script(help, "fish"), "complete -c press -l quiet -d"));
  EXPECT_FALSE(has(completion_script(help, "bash"), "command=\"$word\""));
}

}  // namespace
}  // namespace taxel
