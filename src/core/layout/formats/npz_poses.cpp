#include "core/layout/formats/layout_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/archive/npz.h"
#include "core/base/error.h"

namespace taxel {
namespace {

constexpr HeldValues kHeldByNpz{true, true, true, true, false, false, false, false};
constexpr std::size_t kMaxPoses = 100'000;

/// Throws Error unless the first three columns of a pose are a rotation: of length 1, at right angles to each other and
/// right-handed.
void check_rotation(const double* pose, const std::string& file, const std::string& where) {
  constexpr double kMaxError = 2.5e-3;  // of numbers of three decimals
  const auto column = [&](int c) { return dvec3(pose[c], pose[4 + c], pose[8 + c]); };
  double error = std::abs(glm::determinant(dmat3(column(0), column(1), column(2))) - 1);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b <= a; ++b) error = std::max(error, std::abs(glm::dot(column(a), column(b)) - (a == b ? 1 : 0)));
  if (!(error <= kMaxError))
    throw Error(file, where,
                fmt::format("columns 0 to 2 must be a rotation: they are off by {:.3g}; is the matrix transposed or "
                            "scaled?",
                            error));
}

/// Throws Error unless the last row of a pose of four rows is 0 0 0 1.
void check_last_row(const double* pose, const std::string& file, const std::string& where) {
  const double* const row = pose + 12;
  if (row[0] == 0 && row[1] == 0 && row[2] == 0 && row[3] == 1) return;
  throw Error(file, where,
              fmt::format("the last row must be 0 0 0 1, is {} {} {} {}: is the matrix transposed?", row[0], row[1],
                          row[2], row[3]));
}

/// Reads the pose of one taxel from its rows of four numbers.
Taxel taxel_of_pose(const double* pose, std::size_t rows, std::size_t index, const std::string& file) {
  Taxel taxel;
  taxel.id = static_cast<int>(index);
  taxel.center = {pose[3], pose[7], pose[11]};
  taxel.normal = {pose[2], pose[6], pose[10]};
  const std::string where = fmt::format("poses[{}]", index);
  if (!is_finite(taxel.center)) throw Error(file, where, "the centre (column 3) must be finite");
  if (!is_finite(taxel.normal)) throw Error(file, where, "the normal (column 2) must be finite");
  if (!(glm::dot(taxel.normal, taxel.normal) > 0))
    throw Error(file, where, "the normal (column 2) must be a direction, is 0 0 0");
  if (rows == 4) check_last_row(pose, file, where);
  check_rotation(pose, file, where);
  return taxel;
}

void read_ids(const NpzReader& npz, std::vector<Taxel>& taxels) {
  const std::vector<std::int64_t> ids = npz.integers("ids", {taxels.size()});
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] < 0 || ids[i] > std::numeric_limits<int>::max())
      throw Error(npz.file(), fmt::format("ids[{}]", i),
                  fmt::format("must be 0 or more and of 31 bits, is {}", ids[i]));
    taxels[i].id = static_cast<int>(ids[i]);
  }
}

void read_radii(const NpzReader& npz, std::vector<Taxel>& taxels) {
  const std::vector<double> radii = npz.doubles("radii", {taxels.size()});
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (!(radii[i] > 0) || !std::isfinite(radii[i]))
      throw Error(npz.file(), fmt::format("radii[{}]", i), fmt::format("must be greater than 0, is {}", radii[i]));
    taxels[i].radius = radii[i];
  }
}

void read_names(const NpzReader& npz, std::vector<Taxel>& taxels) {
  const std::vector<std::string> names = npz.texts("names");
  if (names.size() != taxels.size())
    throw Error(npz.file(), "names",
                fmt::format("must be as many as the {} poses, are {}", taxels.size(), names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) taxels[i].name = names[i];
}

std::vector<ImportedLayout> parse_npz(const std::string& bytes, const std::string& file) {
  return {layout_of_poses(NpzReader(ZipArchive(file, bytes)))};
}

/// Appends a pose whose third column is the normal: as it is if its length is near 1, otherwise with length
/// 1. The other columns complete a right-handed frame.
void append_pose(std::vector<double>& poses, const Taxel& taxel, bool& is_normalised) {
  const dvec3 scaled =
      taxel.normal / std::max({std::abs(taxel.normal.x), std::abs(taxel.normal.y), std::abs(taxel.normal.z)});
  const double length = glm::length(taxel.normal);
  const bool is_unit = std::abs(length - 1) < 1e-3;
  is_normalised = is_normalised || !is_unit;
  const dvec3 n = is_unit ? taxel.normal : glm::normalize(scaled);
  const dvec3 unit = glm::normalize(n);
  const dvec3 along = std::abs(unit.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 x = glm::normalize(along - glm::dot(along, unit) * unit), y = glm::cross(unit, x);
  for (int row = 0; row < 3; ++row) poses.insert(poses.end(), {x[row], y[row], n[row], taxel.center[row]});
}

WrittenLayouts write_npz(const std::vector<ImportedLayout>& layouts) {
  check_taxels_to_write(layouts);
  require_normals(layouts, "a pose");
  const ImportedLayout& one = layouts.front();
  std::vector<double> poses, radii;
  std::vector<std::int64_t> ids;
  std::vector<std::string> names;
  bool is_normalised = false;
  for (const Taxel& taxel : one.layout.taxels) {
    append_pose(poses, taxel, is_normalised);
    radii.push_back(taxel.radius);
    ids.push_back(taxel.id);
    names.push_back(taxel.name);
  }
  NpzWriter npz;
  npz.add("poses", {ids.size(), 3, 4}, poses);
  npz.add("ids", {ids.size()}, ids);
  if (one.has_radii()) npz.add("radii", {ids.size()}, radii);
  if (std::any_of(names.begin(), names.end(), [](const std::string& name) { return !name.empty(); }))
    npz.add("names", names);
  WrittenLayouts written{npz.bytes(), losses_in(layouts, kHeldByNpz, "an archive of poses")};
  if (is_normalised) written.notes.emplace_back("normals are written with length 1");
  return written;
}

}  // namespace

ImportedLayout layout_of_poses(const NpzReader& npz) {
  const std::string& file = npz.file();
  if (!npz.has("poses"))
    throw Error(
        file, "poses",
        "is missing: an archive of taxels has the array poses (taxels, 3, 4) with the normal in the third and the "
        "centre in the fourth column");
  const NpzReader::Shape shape = npz.shape("poses");
  const bool has_last_row = shape.size() == 3 && shape[1] == 4;
  const std::size_t rows = has_last_row ? 4 : 3;
  const std::vector<double> poses = npz.doubles("poses", {NpzReader::kAny, rows, 4});
  const std::size_t count = poses.size() / (4 * rows);
  if (count == 0) throw Error(file, "poses", "holds no taxel");
  if (count > kMaxPoses) throw Error(file, "poses", fmt::format("has {} poses, at most {} are read", count, kMaxPoses));
  ImportedLayout imported;
  imported.has_density = imported.has_material = imported.has_frame = false;
  for (std::size_t i = 0; i < count; ++i)
    imported.layout.taxels.push_back(taxel_of_pose(poses.data() + i * 4 * rows, rows, i, file));
  if (npz.has("ids")) read_ids(npz, imported.layout.taxels);
  if (npz.has("names")) read_names(npz, imported.layout.taxels);
  if (npz.has("radii")) {
    read_radii(npz, imported.layout.taxels);
  } else {
    imported.set_all_radii_missing();
    imported.notes.push_back(fmt::format("the archive has no radii: they are {} m", Taxel().radius));
  }
  return imported;
}

namespace {

bool has_poses(std::string_view bytes) {
  return bytes.find("poses.npy") != std::string_view::npos;
}

}  // namespace

LayoutFormat npz_format() {
  LayoutFormat format{"npz", "NumPy poses of taxels", {".npz"}};
  format.holds = kHeldByNpz;
  format.is_start = has_poses;
  format.parse = parse_npz;
  format.write = write_npz;
  return format;
}

}  // namespace taxel
