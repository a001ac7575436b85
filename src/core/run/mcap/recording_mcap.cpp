#include "core/run/mcap/recording_mcap.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/run/mcap/mcap_writer.h"
#include "core/run/mcap/ros_messages.h"

namespace taxel {
namespace {

constexpr const char* kWorldFrame = "world";
constexpr const char* kMocapFrame = "mocap";
constexpr const char* kJsonType = "application/json";
constexpr const char* kShareUnit = "1";  // a share from 0 to 1

/// Channels of one sensor. A channel that the sensor does not have is not set.
struct SensorChannels {
  std::string frame;  ///< name of the sensor in topics, and of its frame
  TaxelNames taxels, calibrated_taxels, slip_taxels;
  std::optional<std::uint16_t> readings, errors, calibrated, slip, uncovered;
  std::optional<std::uint16_t> shear[2];  ///< along e1 and e2
  std::uint16_t force = 0, contact = 0, pose = 0;
};

/// True if a run moves a mocap body; a recording of any other run has the identity in each step.
bool has_mocap(const Recording& recording) {
  const Pose still;
  return std::ranges::any_of(recording.mocap, [&](const Pose& pose) { return pose.p != still.p || pose.q != still.q; });
}

TaxelNames taxel_names_of(const RecordedSensor& sensor, const std::string& unit) {
  TaxelNames taxels{utf8_or_marks(sensor.geom), utf8_or_marks(unit), {}, {}};
  for (std::size_t k = 0; k < sensor.taxel_ids.size(); ++k) {
    const int id = sensor.taxel_ids[k];
    const std::string& name = sensor.taxel_names[k];
    taxels.ids.push_back(id);
    taxels.names.push_back(name.empty() ? fmt::format("taxel_{}", id) : utf8_or_marks(name));
  }
  return taxels;
}

/// Writes the parts of one recording in their order.
class RecordingExport {
 public:
  RecordingExport(const Recording& recording, const RunNotes& notes)
      : recording_(recording),
        notes_(notes),
        writer_("ros2", utf8_or_marks(notes.program.empty() ? "taxel" : notes.program),
                [this](std::string_view bytes) { bytes_ += bytes; }) {}

  std::string bytes() {
    name_frames();
    write_notes();
    for (std::size_t i = 0; i < recording_.sensors.size(); ++i) add_channels(recording_.sensors[i], sensors_[i]);
    transforms_ = add_channel(RosType::transforms, "/tf", {{"translation.unit", "m"}, {"rotation.unit", "1"}});
    for (const RecordedRow& row : recording_.rows) add_row(row);
    writer_.finish();
    return std::move(bytes_);
  }

 private:
  void name_frames() {
    RosNames names;
    names.add(kWorldFrame);
    names.add(kMocapFrame);
    for (const RecordedSensor& sensor : recording_.sensors) sensors_.emplace_back().frame = names.add(sensor.geom);
    for (const std::string& object : recording_.objects) objects_.push_back(names.add(object));
    has_mocap_ = has_mocap(recording_);
  }

  /// Writes the metadata and attachments, which come first so that a reader of a stream knows them.
  void write_notes() {
    McapMap run{{"program", utf8_or_marks(notes_.program)},
                {"timestep", fmt::format("{}", recording_.timestep)},
                {"timestep.unit", "s"},
                {"time", "since the start of the run"}};
    writer_.add_metadata("taxel", run);
    for (std::size_t i = 0; i < recording_.sensors.size(); ++i) {
      const RecordedSensor& sensor = recording_.sensors[i];
      const std::string layout = sensors_[i].frame + ".taxels.json";
      McapMap facts{{"geom", utf8_or_marks(sensor.geom)},
                    {"layout", layout},
                    {"readings.unit", sensor.reading_unit},
                    {"seed", fmt::format("{}", sensor.seed)}};
      if (sensor.calibrated_unit) facts.emplace_back("calibrated.unit", utf8_or_marks(*sensor.calibrated_unit));
      writer_.add_metadata("taxel/" + sensors_[i].frame, facts);
      writer_.add_attachment(layout, kJsonType, sensor.layout_json);
    }
    if (!notes_.file_name.empty()) writer_.add_attachment(notes_.file_name, kJsonType, notes_.file_text);
  }

  std::uint16_t add_channel(RosType type, const std::string& topic, McapMap units) {
    const auto [at, is_new] = schemas_.try_emplace(type, std::uint16_t{0});
    if (is_new) at->second = writer_.add_schema(ros_type_name(type), "ros2msg", ros_type_definition(type));
    units.emplace_back("offered_qos_profiles", "");  // required by the profile; a recording has no quality of service
    return writer_.add_channel({at->second, topic, "cdr", std::move(units)});
  }

  void add_channels(const RecordedSensor& sensor, SensorChannels& channels) {
    const std::string begin = "/taxel/" + channels.frame + "/";
    const auto add_values = [&](const char* name, const std::string& unit) {
      return add_channel(RosType::tactile_readings, begin + name, {{"values.unit", utf8_or_marks(unit)}});
    };
    channels.taxels = taxel_names_of(sensor, sensor.reading_unit);
    if (!sensor.taxel_ids.empty()) channels.readings = add_values("readings", sensor.reading_unit);
    if (sensor.errors) channels.errors = add_values("readings_error", sensor.reading_unit);
    if (sensor.calibrated_unit) {
      channels.calibrated_taxels = taxel_names_of(sensor, *sensor.calibrated_unit);
      channels.calibrated = add_values("calibrated", *sensor.calibrated_unit);
    }
    if (sensor.shear) {
      channels.shear[0] = add_values("shear_e1", sensor.reading_unit);
      channels.shear[1] = add_values("shear_e2", sensor.reading_unit);
    }
    if (sensor.slip) {
      channels.slip_taxels = taxel_names_of(sensor, kShareUnit);
      channels.slip = add_values("slip", kShareUnit);
    }
    channels.force = add_channel(RosType::vector_stamped, begin + "force", {{"vector.unit", "N"}});
    if (sensor.force)
      channels.uncovered = add_channel(RosType::vector_stamped, begin + "uncovered_force", {{"vector.unit", "N"}});
    channels.contact =
        add_channel(RosType::tactile_contact, begin + "contact",
                    {{"time.unit", "s"}, {"travel.unit", "m"}, {"area.unit", "m^2"}, {"polygons.unit", "1"}});
    channels.pose = add_channel(RosType::pose_stamped, begin + "pose",
                                {{"pose.position.unit", "m"}, {"pose.orientation.unit", "1"}});
  }

  void add_row(const RecordedRow& row) {
    const RosStamp stamp = ros_stamp(row.time);
    for (std::size_t i = 0; i < row.sensors.size(); ++i) add_sensor(row, row.sensors[i], sensors_[i], stamp);
    std::vector<FramePose> frames;
    for (std::size_t i = 0; i < row.sensors.size(); ++i) frames.push_back({sensors_[i].frame, row.sensors[i].X_WM});
    for (std::size_t i = 0; i < row.objects.size(); ++i) frames.push_back({objects_[i], row.objects[i]});
    if (has_mocap_) frames.push_back({kMocapFrame, recording_.mocap.at(static_cast<std::size_t>(row.step))});
    writer_.add_message(transforms_, stamp.nanoseconds(), transforms_message({stamp, kWorldFrame}, frames));
  }

  void add_sensor(const RecordedRow& row, const SensorRecord& record, const SensorChannels& channels, RosStamp stamp) {
    const RosHeader on_sensor{stamp, channels.frame}, in_world{stamp, kWorldFrame};
    const auto add = [&](std::optional<std::uint16_t> channel, const auto& make_message) {
      if (channel) writer_.add_message(*channel, stamp.nanoseconds(), make_message());
    };
    add(channels.readings, [&] { return readings_message(on_sensor, channels.taxels, record.readings); });
    add(channels.errors, [&] { return readings_message(on_sensor, channels.taxels, record.errors); });
    add(channels.calibrated,
        [&] { return readings_message(on_sensor, channels.calibrated_taxels, record.calibrated); });
    for (int axis = 0; axis < 2; ++axis)
      add(channels.shear[axis], [&] {
        std::vector<double> values;
        for (const dvec2& value : record.shear) values.push_back(value[axis]);
        return readings_message(on_sensor, channels.taxels, values);
      });
    add(channels.slip, [&] { return readings_message(on_sensor, channels.slip_taxels, record.slip); });
    add(channels.force, [&] { return vector_message(in_world, record.force_W); });
    add(channels.uncovered, [&] { return vector_message(in_world, record.uncovered_W); });
    add(channels.contact, [&] {
      return contact_message(on_sensor,
                             {row.time, row.travel, record.area, static_cast<std::uint32_t>(record.polygons)});
    });
    add(channels.pose, [&] { return pose_message(in_world, record.X_WM); });
  }

  const Recording& recording_;
  const RunNotes& notes_;
  std::string bytes_;
  McapWriter writer_;
  std::vector<SensorChannels> sensors_;
  std::vector<std::string> objects_;  // names of the frames
  std::map<RosType, std::uint16_t> schemas_;
  std::uint16_t transforms_ = 0;
  bool has_mocap_ = false;
};

}  // namespace

std::string recording_to_mcap(const Recording& recording, const RunNotes& notes) {
  return RecordingExport(recording, notes).bytes();
}

void write_mcap(const std::filesystem::path& path, const Recording& recording, const RunNotes& notes) {
  std::string bytes;
  try {
    bytes = recording_to_mcap(recording, notes);
  } catch (const Error& error) {
    throw Error(path.string(), error.where(), error.message());
  }
  write_file_atomically(path, bytes);
}

}  // namespace taxel
