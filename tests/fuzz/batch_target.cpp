// The index of a batch: batch.json, episodes.jsonl, layouts.jsonl and failed.jsonl, with form feeds between them.
#include <sstream>

#include "core/run/batch/batch_index.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

BatchTexts texts_of(const std::string& input) {
  std::istringstream parts(input);
  BatchTexts texts;
  for (std::string* text : {&texts.batch, &texts.episodes, &texts.layouts, &texts.failed})
    std::getline(parts, *text, '\f');
  return texts;
}

void run(const std::string& input) {
  const auto index = read_or_refuse([&] { return parse_batch_index(texts_of(input), "folder"); });
  if (!index) return;
  require(index->bits == 32 || index->bits == 64, "numbers have 32 or 64 bits");
  for (const EpisodeEntry& entry : index->episodes) {
    require(entry.layout < index->layouts.size(), "an episode has a layout");
    for (const JobChange& change : entry.changes) number_of_json(change.value);
  }
}

const Registered kTarget("batch", run);

}  // namespace
}  // namespace taxel::fuzz
