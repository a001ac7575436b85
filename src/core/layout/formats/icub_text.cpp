// iCub's text files of taxel positions: header lines, a line [calibration], then one row `x y z nx ny nz` for each
// taxel [m]. The row number, from 0, is the taxel's id. A row of zeros is a place in the readings without a taxel.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/layout/formats/layout_format.h"
#include "core/layout/formats/text.h"

namespace taxel {
namespace {

constexpr HeldValues kHeldByIcub{true, false, true, false, false, false, false, false};
constexpr int kMaxRows = 100'000;  ///< an iCub has 4000 taxels
constexpr std::size_t kNumbers = 6;

class IcubReader {
 public:
  IcubReader(const std::string& text, const std::string& file) : text_(text), file_(file) {
    imported_.has_density = imported_.has_material = imported_.has_frame = false;
  }

  ImportedLayout read() {
    for (std::string_view rest = text_; !rest.empty();) {
      const std::size_t end = rest.find('\n');
      ++line_;
      read_line(rest.substr(0, end));
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    if (!in_rows_) throw Error(file_, "has no line [calibration]: it is no file of taxel positions of an iCub");
    if (imported_.layout.taxels.empty()) throw Error(file_, "holds no taxel: all rows are zero, or there are none");
    imported_.set_all_radii_missing();
    add_notes();
    return std::move(imported_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(file_, in_rows_ ? fmt::format("line {} (row {})", line_, row_) : fmt::format("line {}", line_),
                message);
  }

  void read_line(std::string_view line) {
    if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    const std::vector<std::string_view> words = split_words(line);
    if (words.empty() || words[0].starts_with('#') || words[0].starts_with("//")) return;
    if (words[0].starts_with('[')) return read_section(std::string(words[0]));
    if (in_rows_) return read_row(words);
    if (words[0] == "name" && words.size() > 1) {
      imported_.layout.name = words[1];
    } else {
      headers_.emplace_back(words[0]);
    }
  }
  void read_section(const std::string& name) {
    if (name != "[calibration]") fail(fmt::format("section {} is not known, only [calibration]", name));
    if (in_rows_) fail("[calibration] is in the file twice");
    in_rows_ = true;
  }
  void read_row(const std::vector<std::string_view>& words) {
    std::array<double, kNumbers> v{};
    if (words.size() < kNumbers) fail(fmt::format("must have 6 numbers, x y z nx ny nz, has {}", words.size()));
    for (std::size_t i = 0; i < kNumbers; ++i) {
      const std::optional<double> number = number_of_word(words[i]);
      if (!number) fail(fmt::format("must have 6 numbers, x y z nx ny nz, but \"{}\" is none", words[i].substr(0, 60)));
      v[i] = *number;
    }
    has_more_columns_ = has_more_columns_ || words.size() > kNumbers;
    if (row_ >= kMaxRows) fail(fmt::format("is beyond the {} rows that are read", kMaxRows));
    Taxel taxel;
    taxel.id = row_;
    taxel.center = {v[0], v[1], v[2]};
    taxel.normal = {v[3], v[4], v[5]};
    const bool has_place = taxel.center != dvec3(0), has_normal = glm::dot(taxel.normal, taxel.normal) > 0;
    if (has_place || has_normal)
      imported_.layout.taxels.push_back(taxel);
    else
      ++zero_rows_;
    if (has_place && !has_normal) without_normal_.push_back(row_);
    ++row_;
  }

  void note(const std::string& text) { imported_.notes.push_back(text); }
  void add_notes() {
    note(fmt::format("the file has no radii: they are {} m", Taxel().radius));
    if (zero_rows_ > 0)
      note(fmt::format("{} of {} rows are zero: no taxels; the others keep their row number as id", zero_rows_, row_));
    if (!without_normal_.empty())
      note(fmt::format("{} rows have a place but no normal, which the skin gives: {}", without_normal_.size(),
                       some_rows()));
    imported_.has_normals = without_normal_.empty();
    std::set<std::array<double, 3>> places;
    for (const Taxel& taxel : imported_.layout.taxels) places.insert({taxel.center.x, taxel.center.y, taxel.center.z});
    if (places.size() < imported_.layout.taxels.size())
      note(fmt::format("{} taxels are at {} places: the taxels of a triangle share one", imported_.layout.taxels.size(),
                       places.size()));
    if (has_more_columns_) note("columns after the sixth are not carried over");
    std::string left;
    for (const std::string& word : headers_) left += (left.empty() ? "" : ", ") + word.substr(0, 60);
    if (headers_.size() <= 20 && !left.empty()) note("not carried over: " + left);
    if (headers_.size() > 20) note(fmt::format("not carried over: {} header lines", headers_.size()));
  }
  [[nodiscard]] std::string some_rows() const {
    constexpr std::size_t kShown = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(kShown, without_normal_.size()); ++i)
      text += fmt::format("{}{}", i == 0 ? "" : ", ", without_normal_[i]);
    return text + (without_normal_.size() > kShown ? " and others" : "");
  }

  const std::string& text_;
  const std::string& file_;
  ImportedLayout imported_;
  std::vector<std::string> headers_;  ///< first words of header lines that are not carried over
  std::vector<int> without_normal_;   ///< rows with a place but no normal
  int line_ = 0, row_ = 0, zero_rows_ = 0;
  bool in_rows_ = false, has_more_columns_ = false;
};

std::vector<ImportedLayout> parse_icub(const std::string& text, const std::string& file) {
  return {IcubReader(text, file).read()};
}

/// Returns the taxels by row. Throws Error for ids that are no row numbers.
std::map<int, const Taxel*> rows_of(const std::vector<Taxel>& taxels) {
  std::map<int, const Taxel*> rows;
  for (const Taxel& taxel : taxels) {
    if (taxel.id < 0 || taxel.id >= kMaxRows)
      throw Error("", fmt::format("taxel {}", taxel.id),
                  fmt::format("has an id that is no row number from 0 to {}", kMaxRows - 1));
    if (!rows.try_emplace(taxel.id, &taxel).second)
      throw Error("", fmt::format("taxel {}", taxel.id), "is there twice: a row holds one taxel, give them other ids");
  }
  return rows;
}

WrittenLayouts write_icub(const std::vector<ImportedLayout>& layouts) {
  check_taxels_to_write(layouts);
  require_normals(layouts, "a file of an iCub");
  const Layout& layout = layouts.front().layout;
  WrittenLayouts written{"", losses_in(layouts, kHeldByIcub, "a file of an iCub")};
  std::string name = layout.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return split_words(std::string_view(&c, 1)).empty(); }, '_');
  if (!name.empty()) written.bytes += fmt::format("name {}\n", name);
  if (name != layout.name) written.notes.push_back(fmt::format("the name is written without blanks: {}", name));
  written.bytes += "spatial_sampling taxel\n[calibration]\n";
  const auto out = std::back_inserter(written.bytes);
  int row = 0;
  const std::map<int, const Taxel*> rows = rows_of(layout.taxels);
  for (const auto& [id, taxel] : rows) {
    for (; row < id; ++row) written.bytes += "0 0 0 0 0 0\n";
    const dvec3 &c = taxel->center, &n = taxel->normal;
    fmt::format_to(out, "{} {} {} {} {} {}\n", c.x, c.y, c.z, n.x, n.y, n.z);
    ++row;
  }
  if (!std::is_sorted(layout.taxels.begin(), layout.taxels.end(),
                      [](const Taxel& a, const Taxel& b) { return a.id < b.id; }))
    written.notes.emplace_back("taxels are in the order of their ids");
  return written;
}

bool has_calibration(std::string_view bytes) {
  return bytes.find("[calibration]") != std::string_view::npos;
}

}  // namespace

LayoutFormat icub_format() {
  LayoutFormat format{"icub", "Taxel positions of an iCub", {".txt"}};
  format.holds = kHeldByIcub;
  format.is_start = has_calibration;
  format.parse = parse_icub;
  format.write = write_icub;
  return format;
}

}  // namespace taxel
