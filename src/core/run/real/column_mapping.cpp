#include "core/run/real/column_mapping.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "core/base/error.h"

namespace taxel {
namespace {

void check_gain(double gain, const std::string& file, const std::string& pointer) {
  if (!std::isfinite(gain) || gain == 0) throw Error(file, pointer, fmt::format("must not be 0, is {}", gain));
}

void check_columns(const ColumnMapping& mapping, const std::string& file) {
  std::set<int> taxels;
  std::set<std::string> columns{mapping.time};
  for (std::size_t i = 0; i < mapping.taxels.size(); ++i) {
    const TaxelColumn& one = mapping.taxels[i];
    const std::string pointer = fmt::format("/taxels/{}", i);
    if (!taxels.insert(one.taxel).second)
      throw Error(file, pointer + "/taxel", fmt::format("taxel {} has a column already", one.taxel));
    if (one.column.empty()) throw Error(file, pointer + "/column", "must name a column");
    if (!columns.insert(one.column).second)
      throw Error(file, pointer + "/column", fmt::format("column \"{}\" is used already", one.column));
    if (one.gain) check_gain(*one.gain, file, pointer + "/gain");
  }
}

}  // namespace

void check_mapping(const ColumnMapping& mapping, const std::string& file) {
  const auto one_of = [](const std::string& text, const char* all) {
    return text.size() == 1 && std::string(all).find(text) != std::string::npos;
  };
  if (!one_of(mapping.separator, ",;\t "))
    throw Error(file, "/separator", "must be a comma, a semicolon, a tab or a blank");
  if (!one_of(mapping.decimal, ".,")) throw Error(file, "/decimal", "must be a point or a comma");
  if (mapping.decimal == mapping.separator) throw Error(file, "/decimal", "is the separator as well");
  if (mapping.header_lines < 0)
    throw Error(file, "/header_lines", fmt::format("must be 0 or more, is {}", mapping.header_lines));
  if (mapping.taxels.empty()) throw Error(file, "/taxels", "no column is a taxel");
  if (mapping.time.empty() && !(mapping.rate > 0 && std::isfinite(mapping.rate)))
    throw Error(file, "/rate",
                "must be greater than 0 where no column is the time: name that column in \"time\", or give the rows "
                "per second");
  check_gain(mapping.gain, file, "/gain");
  check_columns(mapping, file);
}

}  // namespace taxel
