// Genesis' probes: a JSON list of {link_name, kind, probes}. A probe has `pos` [m], `normal` and `radius` [m], in the
// frame of its link. The probes of a grid are nested rows; the place in the grid is kept in the taxel's name.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/base/text/json.h"
#include "core/layout/formats/layout_format.h"

namespace taxel {
namespace {

using ProbesJson = nlohmann::ordered_json;
using ProbesValue = JsonNode<ProbesJson>;
using ProbesObject = JsonObject<ProbesJson>;

constexpr HeldValues kHeldByGenesis{false, false, true, true, false, false, false, true};
constexpr std::string_view kCanvasKey = "\"canvas_hw\"";
constexpr std::size_t kMaxProbes = 100'000;

/// The place of a probe in its grid.
struct GridPlace {
  std::size_t row = 0, column = 0;
};

std::string name_of_place(const GridPlace& place) {
  return fmt::format("row {} column {}", place.row, place.column);
}

/// Returns the place that name_of_place() wrote.
std::optional<GridPlace> place_of_name(const std::string& name) {
  GridPlace place;
  const std::string row = "row ", column = " column ";
  const std::size_t middle = name.find(column);
  if (!name.starts_with(row) || middle == std::string::npos) return std::nullopt;
  std::from_chars(name.data() + row.size(), name.data() + middle, place.row);
  std::from_chars(name.data() + middle + column.size(), name.data() + name.size(), place.column);
  if (name != name_of_place(place)) return std::nullopt;
  return place;
}

class SensorOfProbes {
 public:
  SensorOfProbes(const ProbesValue& value, std::size_t& probes) : count_(probes) {
    ProbesObject object(value);
    const std::string link = object.required("link_name").text();
    std::string kind = "list";
    object.text("kind", kind);
    imported_.layout.name = imported_.geom = link;
    imported_.geom_place = value.pointer() + "/link_name";
    imported_.has_density = imported_.has_material = imported_.has_frame = false;
    imported_.notes.emplace_back("positions are in the frame of the link, which is taken to be that of the mesh");
    read_probes(object.required("probes"));
    if (padding_ > 0)
      imported_.notes.push_back(fmt::format("{} probes of radius 0 fill up the grid and are left out", padding_));
    object.keep_unknown();
    if (!has_rows_ && kind == "grid") imported_.notes.push_back("the kind is grid, but the probes are not in rows");
    if (has_rows_) imported_.notes.emplace_back("row and column of the grid are in the names of the taxels");
  }
  [[nodiscard]] ImportedLayout take() { return std::move(imported_); }

 private:
  void read_probes(const ProbesValue& probes) {
    for (std::size_t i = 0; i < probes.length(); ++i) {
      const ProbesValue item = probes.item(i);
      if (item.json().is_array()) {
        has_rows_ = true;
        for (std::size_t j = 0; j < item.length(); ++j) read_probe(item.item(j), name_of_place({i, j}));
      } else {
        read_probe(item, "");
      }
    }
    if (imported_.layout.taxels.empty()) probes.fail(padding_ > 0 ? "holds only probes of radius 0" : "holds no probe");
  }
  void read_probe(const ProbesValue& value, const std::string& name) {
    if (++count_ > kMaxProbes) value.fail(fmt::format("is beyond the {} probes that are read", kMaxProbes));
    ProbesObject object(value);
    Taxel taxel;
    taxel.id = static_cast<int>(imported_.layout.taxels.size());
    taxel.name = name;
    taxel.center = object.required("pos").vector3();
    const ProbesValue normal = object.required("normal");
    taxel.normal = normal.vector3();
    const ProbesValue radius = object.required("radius");
    taxel.radius = radius.number();
    object.keep_unknown();
    if (taxel.radius == 0) {
      ++padding_;
      return;
    }
    must_be_positive(radius, taxel.radius);
    if (!(glm::dot(taxel.normal, taxel.normal) > 0)) normal.fail("must be a direction, is [0, 0, 0]");
    imported_.layout.taxels.push_back(std::move(taxel));
  }

  ImportedLayout imported_;
  std::size_t& count_;
  bool has_rows_ = false;
  int padding_ = 0;  ///< number of probes of radius 0
};

std::vector<ImportedLayout> parse_genesis(const std::string& text, const std::string& file) {
  const ProbesJson json = parse_json<ProbesJson>(text, file);
  UnknownJson unknown;
  const ProbesValue root(json, file, &unknown);
  if (json.is_object() && json.contains("canvas_hw"))
    root.fail(
        "is the canvas of a hand, which places grids in a picture and has no positions: the probes are in another "
        "file");
  if (!json.is_array()) root.fail("must be a list of sensors with link_name and probes");
  std::vector<ImportedLayout> layouts;
  std::size_t probes = 0;
  for (std::size_t i = 0; i < root.length(); ++i) {
    unknown.clear();
    layouts.push_back(SensorOfProbes(root.item(i), probes).take());
    std::string left;
    for (const auto& [pointer, value] : unknown)
      if (left.size() < 200) left += (left.empty() ? "" : ", ") + pointer;
    if (!left.empty()) layouts.back().notes.push_back("not carried over: " + short_quote(left));
  }
  if (layouts.empty()) throw Error(file, "holds no sensor");
  return layouts;
}

ProbesJson probe_json(const Taxel& taxel) {
  const std::string pointer = fmt::format("taxel {}", taxel.id);
  return {{"radius", json_number<ProbesJson>(taxel.radius, pointer)},
          {"pos", json_vector<ProbesJson>(taxel.center, pointer)},
          {"normal", json_vector<ProbesJson>(taxel.normal, pointer)}};
}

/// Returns nested rows if the names of the taxels are places that follow each other; otherwise nothing.
std::optional<ProbesJson> rows_json(const std::vector<Taxel>& taxels) {
  ProbesJson rows = ProbesJson::array();
  for (const Taxel& taxel : taxels) {
    const std::optional<GridPlace> place = place_of_name(taxel.name);
    if (!place) return std::nullopt;
    if (place->row == rows.size() && place->column == 0) rows.push_back(ProbesJson::array());
    if (place->row + 1 != rows.size() || place->column != rows.back().size()) return std::nullopt;
    rows.back().push_back(probe_json(taxel));
  }
  return rows;
}

WrittenLayouts write_genesis(const std::vector<ImportedLayout>& layouts) {
  check_taxels_to_write(layouts);
  require_normals(layouts, "a probe");
  ProbesJson json = ProbesJson::array();
  std::vector<ImportedLayout> flat;
  for (const ImportedLayout& one : layouts) {
    std::optional<ProbesJson> rows = rows_json(one.layout.taxels);
    ProbesJson probes = ProbesJson::array();
    if (!rows)
      for (const Taxel& taxel : one.layout.taxels) probes.push_back(probe_json(taxel));
    if (!rows) flat.push_back(one);
    json.push_back({{"link_name", one.geom.empty() ? one.layout.name : one.geom},
                    {"kind", rows ? "grid" : "list"},
                    {"probes", rows ? std::move(*rows) : std::move(probes)}});
  }
  HeldValues holds = kHeldByGenesis;
  holds.names = flat.empty();
  WrittenLayouts written{json_text(json), losses_in(layouts, holds, "a list of probes")};
  if (!std::all_of(layouts.begin(), layouts.end(), [](const ImportedLayout& one) { return !one.geom.empty(); }))
    written.notes.emplace_back("link_name is the layout's name: no link is known");
  return written;
}

/// Returns true for the beginning of a JSON list, and for the canvas of a hand, which parse_genesis() refuses.
bool is_list(std::string_view bytes) {
  if (bytes.find(kCanvasKey) != std::string_view::npos) return true;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '[';
}

}  // namespace

LayoutFormat genesis_format() {
  LayoutFormat format{"genesis", "Probes of Genesis", {".probes.json", ".json"}};
  format.holds = kHeldByGenesis;
  format.reads_several = format.writes_several = true;
  format.is_start = is_list;
  format.parse = parse_genesis;
  format.write = write_genesis;
  return format;
}

}  // namespace taxel
