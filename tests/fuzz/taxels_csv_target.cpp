// Tables of taxels.
#include "core/layout/file/layout_json.h"
#include "core/layout/file/taxels_csv.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_or_refuse([&] { return parse_taxels_csv(input, "input.csv"); });
}

const Registered kTarget("taxels_csv", run);

}  // namespace
}  // namespace taxel::fuzz
