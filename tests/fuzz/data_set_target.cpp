// The description of a data set: its two files and the list of failed jobs, with form feeds between them.
#include <sstream>

#include "core/run/batch/data_set_meta.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

DataSetTexts texts_of(const std::string& input) {
  std::istringstream parts(input);
  DataSetTexts texts;
  std::getline(parts, texts.info, '\f');
  std::getline(parts, texts.head, '\f');
  std::getline(parts, texts.failed, '\f');
  return texts;
}

void run(const std::string& input) {
  const auto head = read_or_refuse([&] { return parse_data_set_head(texts_of(input), "folder"); });
  if (head) require(head->bits == 32 || head->bits == 64, "numbers have 32 or 64 bits");
  const auto changes = read_or_refuse([&] { return parse_changes(input, "input", "row 0"); });
  if (!changes) return;
  for (const JobChange& change : *changes) number_of_json(change.value);
}

const Registered kTarget("data_set", run);

}  // namespace
}  // namespace taxel::fuzz
