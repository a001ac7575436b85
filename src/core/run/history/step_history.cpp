// The latest steps of a run, packed into a ring of memory, and their rows.
//
// A step is packed (packed_step.cpp) behind the one before it, in blocks of a huge page. The oldest steps are forgotten
// first, or the newest, when the run continues from an earlier one: both only move the ends. Empty blocks are used
// again, so a full ring allocates nothing. While it grows, another thread prepares the next block and touches its
// pages, because the first access to new memory costs the simulation more than filling it.
//
// Rows have the numbers that timelines draw, and grow in columns. An edition counts changes other than at the ends, so
// that a reader copies new rows only. Rows that are forgotten leave their largest readings and counts, by which
// breakpoints still measure. After a cut the detector continues as if the newest remaining step had just been made: the
// histories are computed again from the rows.
#include "core/run/history/step_history.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

#include "core/base/os/process.h"
#include "core/run/history/packed_step.h"
#include "core/sensor/error_bars.h"
#include "core/sensor/explain/explanation.h"

namespace taxel {

RingMemory::Block RingMemory::make_block(std::size_t size) {
  const std::size_t whole = (size + kBlock - 1) / kBlock * kBlock;
  Block block{std::unique_ptr<std::byte[], Free>(static_cast<std::byte*>(std::aligned_alloc(kBlock, whole))), whole};
  if (block.data == nullptr) throw std::bad_alloc();
  os::prefer_huge_pages(block.data.get(), whole);
  std::memset(block.data.get(), 0, whole);
  return block;
}

RingMemory::Block RingMemory::take_block(std::size_t size) {
  if (spare_.size >= size) return std::exchange(spare_, {});
  if (size > kBlock) return make_block(size);
  Block block = next_.valid() ? next_.get() : make_block(kBlock);
  next_ = std::async(std::launch::async, make_block, kBlock);
  return block;
}

void RingMemory::clear() {
  blocks_.clear();
  spare_ = {};
  if (next_.valid()) next_.get();
}

std::byte* RingMemory::push(std::size_t size) {
  if (blocks_.empty() || blocks_.back().used + size > blocks_.back().size) {
    blocks_.push_back(take_block(size));
  }
  Block& block = blocks_.back();
  std::byte* piece = block.data.get() + block.used;
  block.used += size;
  ++block.pieces;
  return piece;
}

void RingMemory::retire(Block block) {
  block.used = block.pieces = 0;
  spare_ = std::move(block);
}

void RingMemory::pop_front() {
  if (--blocks_.front().pieces > 0) return;
  retire(std::move(blocks_.front()));
  blocks_.pop_front();
}

void RingMemory::pop_back(std::size_t size) {
  Block& block = blocks_.back();
  block.used -= size;
  if (--block.pieces > 0) return;
  retire(std::move(block));
  blocks_.pop_back();
}

std::size_t RingMemory::bytes() const {
  std::size_t sum = spare_.size + (next_.valid() ? kBlock : 0);
  for (const Block& block : blocks_) sum += block.size;
  return sum;
}

namespace {

void gather_signals(const StepView& view, std::vector<SensorSignal>& signals) {
  signals.clear();
  for (std::size_t s = 0; s < view.sensors.size(); ++s) {
    const SensorView& sensor = view.sensors[s];
    const SensorModelPtr& model = view.scene->sensors[s];
    signals.push_back({sensor.readings, glm::length(sensor.force_W), model ? reading_floor(*model) : 0.0});
  }
}

SensorSummary summarize(const SensorView& sensor, double force) {
  SensorSummary row;
  row.force = force;
  double smallest = std::numeric_limits<double>::infinity();
  for (const ContactSurface* surface : sensor.surfaces) {
    row.polygons += static_cast<int>(surface->polygons.size());
    for (const ContactPolygon& polygon : surface->polygons) {
      row.area += polygon.area;
      smallest = std::min(smallest, polygon.area);
    }
  }
  row.smallest_polygon = row.polygons > 0 ? smallest : 0.0;
  return row;
}

constexpr std::uint8_t bit(StepEvent event) {
  return static_cast<std::uint8_t>(event);
}

/// Appends the last `count` values of a column to another column.
template <class T>
void append_last(const Column<T>& values, std::size_t count, Column<T>& to) {
  to.append(values.end() - count, values.end());
}

}  // namespace

std::size_t HistoryRows::bytes() const {
  return rows_.steps.capacity() * sizeof(StepMark) + rows_.sensors.capacity() * sizeof(SensorSummary) +
         rows_.readings.capacity() * sizeof(double);
}

void HistoryRows::clear() {
  rows_.forget_back(rows_.rows());
  ++rows_.edition;
  rows_.forgotten_largest.clear();
  rows_.forgotten_touched.clear();
  jumps_.clear();
  detector_.restart();
}

void HistoryRows::remember_jumps(RecordedJumps jumps) {
  const std::span<const double> before = rows_.readings_of(rows_.rows() - 2), now = rows_.readings_of(rows_.rows() - 1);
  const std::vector<double> scales =
      detector_.scales(jumps.sensor, jumps.least, jumps.limits.jump, jumps.limits.of_sensor);
  const std::size_t first = std::accumulate(
      reading_counts_.begin(), reading_counts_.begin() + static_cast<std::ptrdiff_t>(jumps.sensor), std::size_t{0});
  for (std::size_t k = 0; k < reading_counts_[jumps.sensor]; ++k) {
    const double change = std::abs(now[first + k] - before[first + k]);
    if (change > jumps.limits.jump * scales[k]) jumps.changes.emplace_back(static_cast<int>(k), change);
  }
  mark_jump(jumps);
  jumps_.push_back(std::move(jumps));
}

bool HistoryRows::mark_jump(const RecordedJumps& jumps) {
  const std::size_t row = rows_.row_of(jumps.step);
  SensorSummary& summary = rows_.sensors[row * rows_.sensor_count + jumps.sensor];
  int taxel = -1;
  double largest = jumps.limits.jump;
  for (const auto& [k, change] : jumps.changes) {
    const double part = change / detector_.scale(jumps.sensor, k, jumps.least, jumps.limits.of_sensor);
    if (part > largest) largest = part, taxel = k;
  }
  const SensorSummary was = summary;
  summary.is_jump = taxel >= 0;
  if (taxel >= 0) summary.jumped_taxel = taxel;
  if (taxel >= 0)
    rows_.steps[row].events |= bit(jumps.at_equal_force ? StepEvent::jump_at_equal_force : StepEvent::jump);
  return was.is_jump != summary.is_jump || was.jumped_taxel != summary.jumped_taxel;
}

bool HistoryRows::mark_jumps() {
  constexpr unsigned kJumps = bit(StepEvent::jump) | bit(StepEvent::jump_at_equal_force);
  for (const RecordedJumps& jumps : jumps_) {
    std::uint8_t& events = rows_.steps[rows_.row_of(jumps.step)].events;
    events = static_cast<std::uint8_t>(events & ~kJumps);
  }
  bool any_changed = false;
  for (const RecordedJumps& jumps : jumps_) any_changed = mark_jump(jumps) || any_changed;
  return any_changed;
}

std::optional<Stop> HistoryRows::add(const StepView& view, bool other_layout, const Breakpoints& breakpoints) {
  const bool first_row = rows_.rows() == 0;
  rows_.sensor_count = view.sensors.size();
  rows_.reading_count = 0;
  reading_counts_.clear();
  gather_signals(view, signals_);
  const std::vector<std::optional<Jump>>& jumps = detector_.compare(view.step, view.time, signals_, breakpoints);
  StepMark mark{view.step, view.time, view.travel, 0};
  if (other_layout) mark.events |= bit(StepEvent::other_layout);
  std::optional<Stop> stop;
  if (mark_jumps()) ++rows_.edition;
  std::vector<RecordedJumps> jumped;
  for (std::size_t s = 0; s < view.sensors.size(); ++s) {
    SensorSummary row = summarize(view.sensors[s], signals_[s].force);
    row.largest_reading = detector_.largest(s);
    const int before = first_row ? 0 : rows_.sensors[rows_.sensors.size() - rows_.sensor_count].polygons;
    if (row.polygons > 0 && before == 0 && !first_row) mark.events |= bit(StepEvent::contact_begins);
    if (row.polygons == 0 && before > 0) mark.events |= bit(StepEvent::contact_ends);
    if (jumps[s]) {
      row.largest_jump = jumps[s]->largest_change;
      row.jumped_taxel = row.largest_jump > 0 ? jumps[s]->taxel : -1;
      if (is_jump(*jumps[s], breakpoints))
        jumped.push_back({view.step, s, jumps[s]->at_equal_force, breakpoints, signals_[s].least, {}});
      if (!other_layout && !stop && stops(*jumps[s], breakpoints)) stop = *jumps[s];
    }
    rows_.sensors.push_back(row);
    const std::span<const double> readings = view.sensors[s].readings;
    rows_.readings.append(readings.data(), readings.data() + readings.size());
    reading_counts_.push_back(view.sensors[s].readings.size());
    rows_.reading_count += reading_counts_.back();
  }
  if (const std::optional<Disagreement> found = disagreement(view, breakpoints)) {
    mark.events |= bit(StepEvent::disagreement);
    if (!stop) stop = *found;
  }
  rows_.steps.push_back(mark);
  for (const RecordedJumps& each : jumped) remember_jumps(each);
  return stop;
}

std::optional<Disagreement> HistoryRows::disagreement(const StepView& view, const Breakpoints& breakpoints) const {
  if (!breakpoints.on_disagreement) return std::nullopt;
  std::optional<Disagreement> worst;
  for (std::size_t s = 0; s < view.sensors.size(); ++s) {
    const SensorModelPtr& model = view.scene->sensors[s];
    if (!model) continue;
    const SensorView& sensor = view.sensors[s];
    const std::vector<double> scales =
        detector_.scales(s, signals_[s].least, breakpoints.disagreement, breakpoints.of_sensor);
    const std::optional<SampleGap> gap = largest_sample_gap(*model, sensor.surfaces, sensor.readings, scales);
    if (!gap) continue;
    const double part = gap->gap / scales[static_cast<std::size_t>(gap->taxel)];
    if (!(part > breakpoints.disagreement) || (worst && part <= worst->part)) continue;
    worst = Disagreement{view.step, view.time, static_cast<int>(s), gap->taxel, gap->sampled, gap->exact, part};
  }
  return worst;
}

void HistoryRows::trim_to(std::size_t retained) {
  const std::size_t count = rows_.rows() - retained;
  if (count > 0 && rows_.forgotten_largest.size() != rows_.reading_count) {
    rows_.forgotten_largest.assign(rows_.reading_count, 0.0);
    rows_.forgotten_touched.assign(rows_.reading_count, 0);
  }
  for (std::size_t row = 0; row < count; ++row) {
    const std::span<const double> readings = rows_.readings_of(row);
    for (std::size_t i = 0; i < readings.size(); ++i) {
      rows_.forgotten_largest[i] = std::max(rows_.forgotten_largest[i], std::abs(readings[i]));
      rows_.forgotten_touched[i] += readings[i] != 0 ? 1 : 0;
    }
  }
  rows_.forget_front(count);
  while (!jumps_.empty() && (rows_.rows() == 0 || jumps_.front().step < rows_.steps.front().step)) jumps_.pop_front();
}

/// Returns the history of one sensor, whose first reading has the index `first` in each row.
ReadingHistory HistoryRows::history_of(std::size_t first, std::size_t count) const {
  ReadingHistory history{std::vector<double>(count, 0.0), std::vector<int>(count, 0)};
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t reading = first + k;
    history.largest[k] = largest_reading(rows_, reading);
    if (reading < rows_.forgotten_touched.size()) history.touched[k] = rows_.forgotten_touched[reading];
    for (std::size_t row = 0; row < rows_.rows(); ++row)
      history.touched[k] += rows_.readings[row * rows_.reading_count + reading] != 0 ? 1 : 0;
  }
  return history;
}

void HistoryRows::replace_newest(const StepView& view) {
  gather_signals(view, signals_);
  detector_.continue_from(signals_, {});
  double* readings = rows_.readings.data() + rows_.readings.size() - rows_.reading_count;
  for (const SensorView& sensor : view.sensors)
    readings = std::copy(sensor.readings.begin(), sensor.readings.end(), readings);
  ++rows_.edition;
  if (rows_.rows() > 1) rows_.steps.back().events |= bit(StepEvent::other_layout);  // the first has no earlier layout
}

void HistoryRows::cut(std::size_t count) {
  rows_.forget_back(count);
  ++rows_.edition;
  signals_.clear();
  std::vector<ReadingHistory> histories;
  std::size_t reading = 0;
  const double* readings = rows_.readings.data() + rows_.readings.size() - rows_.reading_count;
  for (std::size_t s = 0; s < rows_.sensor_count; ++s) {
    const SensorSummary& row = rows_.sensors[rows_.sensors.size() - rows_.sensor_count + s];
    signals_.push_back({{readings, reading_counts_[s]}, row.force});
    readings += reading_counts_[s];
    histories.push_back(history_of(reading, reading_counts_[s]));
    reading += reading_counts_[s];
  }
  detector_.continue_from(signals_, histories);
  while (!jumps_.empty() && jumps_.back().step > rows_.steps.back().step) jumps_.pop_back();
  mark_jumps();
}

void StepHistory::set_limits(const StepHistoryLimits& limits) {
  limits_ = limits;
  limits_.steps = std::max<std::size_t>(1, limits_.steps);
  while (size() > limits_.steps || (bytes() > limits_.bytes && size() > 1)) forget_oldest();
  rows_.trim_to(size());
}

void StepHistory::clear() {
  steps_.clear();
  memory_.clear();
  rows_.clear();
}

void StepHistory::forget_oldest() {
  memory_.pop_front();
  steps_.pop_front();
}

void StepHistory::pack(const StepView& view, Entry& entry) {
  entry.scene = view.scene;
  entry.finished = view.finished;
  const std::size_t room = largest_packed_size(view);
  std::byte* to = memory_.push(room);
  entry.packed_bytes = pack_step(view, to);
  memory_.shrink_back(room, entry.packed_bytes);
  entry.packed = to;
}

std::optional<Stop> StepHistory::record(const StepView& view, const SimState& state) {
  if (!empty() && view.step != last() + 1) clear();
  const bool other_layout = !empty() && steps_.back().scene != view.scene;
  Entry entry;
  if (size() >= limits_.steps) {
    entry = std::move(steps_.front());  // reuses the memory of its vector
    forget_oldest();
  }
  pack(view, entry);
  entry.state = state;
  state_bytes_ = sizeof(Entry) + entry.state.integration.capacity() * sizeof(double);
  steps_.push_back(std::move(entry));
  while (bytes() > limits_.bytes && size() > 1) forget_oldest();
  std::optional<Stop> stop = rows_.add(view, other_layout, breakpoints_);
  rows_.trim_to(size());
  return stop;
}

void StepHistory::fill_step(std::uint64_t number, Step& step) const {
  const Entry& from = at(number);
  step.scene = from.scene;
  step.step = from.state.step;
  step.time = from.state.time;
  step.travel = from.state.travel;
  step.finished = from.finished;
  unpack_step(from.packed, step);
}

StepPtr StepHistory::step(std::uint64_t number) const {
  auto step = std::make_shared<Step>();
  fill_step(number, *step);
  return step;
}

void StepHistory::replace_newest(const StepView& view) {
  if (empty() || view.step != last()) return;
  memory_.pop_back(steps_.back().packed_bytes);
  pack(view, steps_.back());
  rows_.replace_newest(view);
}

void StepHistory::cut_after(std::uint64_t step) {
  std::size_t cut = 0;
  for (; last() > step; ++cut) {
    memory_.pop_back(steps_.back().packed_bytes);
    steps_.pop_back();
  }
  if (cut > 0) rows_.cut(cut);
}

std::size_t StepHistory::bytes() const {
  return memory_.bytes() + size() * state_bytes_ + rows_.bytes();
}

std::shared_ptr<const HistoryLanes> StepHistory::lanes() const {
  const auto lanes = std::make_shared<HistoryLanes>();
  copy_lanes(*lanes);
  return lanes;
}

void StepHistory::copy_lanes(HistoryLanes& lanes) const {
  const HistoryLanes& rows = rows_.lanes();
  const bool another = lanes.edition != rows.edition || empty() || lanes.rows() == 0 ||
                       lanes.steps.back().step < rows.steps.front().step;
  lanes.forget_front(another ? lanes.rows() : rows.steps.front().step - lanes.steps.front().step);
  lanes.edition = rows.edition;
  lanes.sensor_count = rows.sensor_count;
  lanes.reading_count = rows.reading_count;
  lanes.forgotten_largest = rows.forgotten_largest;
  lanes.forgotten_touched = rows.forgotten_touched;
  const std::size_t more = rows.rows() - lanes.rows();
  append_last(rows.steps, more, lanes.steps);
  append_last(rows.sensors, more * rows.sensor_count, lanes.sensors);
  append_last(rows.readings, more * rows.reading_count, lanes.readings);
}

}  // namespace taxel
