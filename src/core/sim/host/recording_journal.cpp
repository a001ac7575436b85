#include "core/sim/host/recording_journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/output.h"
#include "core/run/recording/recording_files.h"
#include "core/sim/host/write_recording.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// The first line of BASE.rows.
constexpr const char* kFormat = "taxel recording rows 2";
constexpr const char* kFormatWithoutElastic =
    "taxel recording rows 1";  // of versions without SensorRecord::elastic_force_W

/// The first number of an entry.
enum class Entry { step = 1, row = 2, cut = 3 };

constexpr std::size_t kPoseNumbers = 7;

/// Adds the extension to the whole name, which may have dots.
fs::path with_extension(const fs::path& base, const char* extension) {
  return base.string() + extension;
}

/// FNV-1a, 64 bit (Fowler, Noll, Vo): detects an entry that was written in part.
std::uint64_t checksum(const double* numbers, std::size_t count) {
  constexpr std::uint64_t kBasis = 0xcbf29ce484222325, kPrime = 0x100000001b3;
  std::uint64_t hash = kBasis;
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::uint64_t>(numbers[i]);
    for (unsigned shift = 0; shift < 64; shift += 8) hash = (hash ^ ((bits >> shift) & 0xffU)) * kPrime;
  }
  return hash;
}

/// Writes numbers one after the other; Take reads them in the same order.
struct Put {
  std::vector<double>& out;
  void operator()(double value) { out.push_back(value); }
};
struct Take {
  const double* at;
  void operator()(double& value) { value = *at++; }
};

template <class Io, class Vector>
void each(Io& io, Vector& v) {
  for (int i = 0; i < v.length(); ++i) io(v[i]);
}

template <class Io, class AnyPose>
void pose(Io& io, AnyPose& X) {
  for (int i = 0; i < 3; ++i) io(X.p[i]);
  io(X.q.w), io(X.q.x), io(X.q.y), io(X.q.z);
}

/// All numbers of a row but its step, which follows from its place.
template <class Io, class Row>
void row_numbers(Io& io, Row& row) {
  io(row.time), io(row.travel);
  for (auto& sensor : row.sensors) {
    each(io, sensor.force_W);
    if (sensor.elastic_force_W) each(io, *sensor.elastic_force_W);
    io(sensor.area);
    for (auto& reading : sensor.readings) io(reading);
    for (auto& error : sensor.errors) io(error);
    for (auto& value : sensor.calibrated) io(value);
    for (auto& shear : sensor.shear) each(io, shear);
    for (auto& value : sensor.slip) io(value);
    each(io, sensor.uncovered_W);
    pose(io, sensor.X_WM);
  }
  for (auto& object : row.objects) pose(io, object);
}

std::vector<double> entry_of(Entry kind) {
  return {static_cast<double>(kind)};
}

/// A row as large as those of the recording, all numbers 0.
RecordedRow empty_row(const Recording& recording, bool has_elastic) {
  RecordedRow row;
  for (const RecordedSensor& sensor : recording.sensors) {
    SensorRecord& record = row.sensors.emplace_back();
    record.readings.resize(sensor.taxel_ids.size());
    if (has_elastic) record.elastic_force_W.emplace(0);
    if (sensor.errors) record.errors.resize(sensor.taxel_ids.size());
    if (sensor.calibrated_unit) record.calibrated.resize(sensor.taxel_ids.size());
    if (sensor.shear) record.shear.resize(sensor.taxel_ids.size());
    if (sensor.slip) record.slip.resize(sensor.taxel_ids.size());
  }
  row.objects.resize(recording.objects.size());
  return row;
}

void cut(Recording& recording, std::size_t steps) {
  std::erase_if(recording.rows, [&](const RecordedRow& row) { return row.step >= static_cast<std::int64_t>(steps); });
  if (recording.mocap.size() > steps) recording.mocap.resize(steps);
}

/// Reads the entries after the head of BASE.rows until the end, or the first that is not complete.
void read_entries(std::string_view bytes, bool has_elastic, Recording& recording) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (numbers.empty()) return;
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  const RecordedRow shape = empty_row(recording, has_elastic);
  std::vector<double> one_row;
  Put put{one_row};
  row_numbers(put, shape);
  for (std::size_t at = 0; at < numbers.size();) {
    const double kind = numbers[at];
    std::size_t size = 1 + kPoseNumbers;                                                         // without the checksum
    if (kind == static_cast<double>(Entry::row)) size += one_row.size() + shape.sensors.size();  // numbers of polygons
    if (kind == static_cast<double>(Entry::cut)) size = 2;
    if (at + size >= numbers.size()) return;
    const double* begin = &numbers[at];
    if (std::bit_cast<std::uint64_t>(begin[size]) != checksum(begin, size)) return;
    at += size + 1;
    if (kind == static_cast<double>(Entry::cut)) {
      cut(recording, static_cast<std::size_t>(begin[1]));
      continue;
    }
    Take take{begin + 1};
    if (kind == static_cast<double>(Entry::row)) {
      RecordedRow row = shape;
      row.step = static_cast<std::int64_t>(recording.mocap.size());
      row_numbers(take, row);
      for (SensorRecord& sensor : row.sensors) sensor.polygons = static_cast<int>(*take.at++);
      recording.rows.push_back(std::move(row));
    }
    pose(take, recording.mocap.emplace_back());
  }
}

/// Returns true if another process has locked the file, or it cannot be opened.
bool is_in_use(const fs::path& path) {
  const os::File file(path, os::Open::check);
  return !file.is_open() || !file.try_lock();
}

/// Returns true if a path cannot take a recording: a file, or a folder that holds more than temporary files of killed
/// processes.
bool is_taken(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return fs::exists(path, ignored);
  const fs::directory_iterator entries(path, ignored);
  return std::any_of(begin(entries), end(entries),
                     [](const fs::directory_entry& entry) { return entry.path().extension() != ".part"; });
}

}  // namespace

RecordingJournal::RecordingJournal(fs::path base, const std::string& target) : base_(std::move(base)) {
  const fs::path rows = with_extension(base_, ".rows");
  file_ = os::File(rows, os::Open::append);
  if (!file_.is_open()) throw Error(rows.string(), fmt::format("cannot be created: {}", os::error_text(file_.error())));
  if (!file_.try_lock()) throw Error(rows.string(), "cannot be created: another process has locked it");
  const std::string head = fmt::format("{}\n{}\n", kFormat, target);
  std::error_code ignored;
  fs::remove(with_extension(base_, ".npz"), ignored);
  int why = file_.cut(0);
  if (why == 0) why = file_.write_at_once(head);
  bytes_ = head.size();
  if (why == 0) return;
  remove();
  throw Error(rows.string(), "writing failed: " + os::error_text(why));
}

void RecordingJournal::write(std::vector<double> entry) {
  entry.push_back(std::bit_cast<double>(checksum(entry.data(), entry.size())));
  const std::string_view bytes(reinterpret_cast<const char*>(entry.data()), entry.size() * sizeof(double));
  if (const int why = file_.write_at_once(bytes); why != 0) {
    static_cast<void>(file_.cut(bytes_));  // entries after a part of one would not be read
    throw Error(with_extension(base_, ".rows").string(), "writing failed: " + os::error_text(why));
  }
  bytes_ += bytes.size();
}

/// Writes BASE.npz. A recording may have more rows than the first by now, because an earlier call has failed.
void RecordingJournal::write_head(const Recording& recording) {
  write_file_atomically(with_extension(base_, ".npz"), recording_to_npz(recording));
  has_head_ = true;
  steps_ = recording.mocap.size();
  rows_ = recording.rows.size();
}

void RecordingJournal::follow(const Recording& recording) {
  if (recording.rows.empty()) return;
  if (!has_head_) write_head(recording);
  write_cut();
  for (; steps_ < recording.mocap.size(); ++steps_) {
    const bool has_row =
        rows_ < recording.rows.size() && recording.rows[rows_].step == static_cast<std::int64_t>(steps_);
    std::vector<double> entry = entry_of(has_row ? Entry::row : Entry::step);
    Put put{entry};
    if (has_row) {
      row_numbers(put, recording.rows[rows_]);
      for (const SensorRecord& sensor : recording.rows[rows_].sensors) put(sensor.polygons);
    }
    pose(put, recording.mocap[steps_]);
    write(std::move(entry));
    rows_ += has_row ? 1 : 0;
  }
}

void RecordingJournal::cut_to(const Recording& recording) {
  if (!has_head_ || recording.mocap.size() >= steps_) return;
  steps_ = recording.mocap.size();
  rows_ = recording.rows.size();
  cut_ = steps_;
  write_cut();
}

/// Writes a cut that is due. Steps after it must not follow without it.
void RecordingJournal::write_cut() {
  if (!cut_) return;
  std::vector<double> entry = entry_of(Entry::cut);
  entry.push_back(static_cast<double>(*cut_));
  write(std::move(entry));
  cut_.reset();
}

void RecordingJournal::remove() {
  remove_recording_journal(base_);
}

void remove_recording_journal(const fs::path& base) {
  std::error_code ignored;
  fs::remove(with_extension(base, ".rows"), ignored);
  fs::remove(with_extension(base, ".npz"), ignored);
}

std::optional<LeftRecording> read_recording_journal(const fs::path& base) {
  const fs::path rows = with_extension(base, ".rows"), head = with_extension(base, ".npz");
  std::error_code ignored;
  if (!fs::is_regular_file(rows, ignored) || !fs::is_regular_file(head, ignored)) return std::nullopt;
  if (is_in_use(rows)) return std::nullopt;  // its process lives
  const std::string bytes = read_file(rows);
  const std::size_t first = bytes.find('\n');
  const std::size_t second = first == std::string::npos ? first : bytes.find('\n', first + 1);
  const std::string format = second == std::string::npos ? "" : bytes.substr(0, first);
  if (format != kFormat && format != kFormatWithoutElastic)
    throw Error(rows.string(), fmt::format("does not begin with \"{}\" and a path", kFormat));
  LeftRecording left{base, bytes.substr(first + 1, second - first - 1), read_recording(head)};
  read_entries(std::string_view(bytes).substr(second + 1), format == kFormat, left.recording);
  if (left.recording.rows.empty()) return std::nullopt;
  return left;
}

std::vector<LeftRecording> left_recordings(const fs::path& folder) {
  std::vector<fs::path> bases;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".rows" && entry.is_regular_file(error))
      bases.push_back(fs::path(entry.path()).replace_extension());
  std::sort(bases.begin(), bases.end());
  std::vector<LeftRecording> all;
  for (const fs::path& base : bases) {
    if (is_in_use(with_extension(base, ".rows"))) continue;  // its process lives
    try {
      if (std::optional<LeftRecording> left = read_recording_journal(base)) {
        all.push_back(std::move(*left));
        continue;
      }
    } catch (const Error&) {  // nothing in it can be read
    }
    remove_recording_journal(base);
  }
  return all;
}

namespace {
/// Removes the temporary folder of a process that has ended while it put its files into `folder`.
void remove_parts_in(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return;
  try {
    const OutputFolder cleared(folder);
  } catch (const Error&) {  // nothing can be removed in it
  }
}
}  // namespace

void discard_left_recording(const LeftRecording& left) {
  remove_recording_journal(left.base);
  remove_parts_in(left.target);
  std::error_code ignored;
  if (fs::is_directory(left.target, ignored)) fs::remove(left.target, ignored);  // fails unless it is empty
}

fs::path write_left_recording(const LeftRecording& left) {
  fs::path target = left.target;
  const std::string stem = (target.parent_path() / target.stem()).string(), extension = target.extension().string();
  for (int number = 1; is_taken(target); ++number)
    target = number == 1 ? fmt::format("{}-recovered{}", stem, extension)
                         : fmt::format("{}-recovered-{}{}", stem, number, extension);
  write_recording(target, left.recording, nullptr);
  remove_recording_journal(left.base);
  remove_parts_in(left.target);
  return target;
}

}  // namespace taxel
