// Shards of batches: the input is a list of members (members.h), so that checksums never stop a fuzzer.
#include "core/run/batch/shard.h"

#include "fuzz/members.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const auto shard = read_or_refuse([&] { return Shard(archive_bytes_of(input), "input.npz"); });
  if (!shard) return;
  std::int64_t rows = 0;
  for (const JobOutcome& outcome : shard->head().outcomes) rows += outcome.rows;
  for (const ShardColumn& column : shard->head().columns) {
    const auto all = read_or_refuse([&] { return shard->rows(column.name, 0, rows); });
    if (!all) continue;
    require(all->values.size() == static_cast<std::size_t>(rows) * all->width, "a column has a row of values for each");
    if (rows == 0) continue;
    const auto last = read_or_refuse([&] { return shard->rows(column.name, rows - 1, 1); });
    require(last && last->values.size() == all->width, "each row of a column can be read");
  }
}

const Registered kTarget("shard", run);

}  // namespace
}  // namespace taxel::fuzz
