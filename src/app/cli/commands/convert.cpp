// taxel convert: reads layouts of any format and writes them in another one, and recorded runs as messages.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/cli/command_layout.h"
#include "app/cli/console.h"
#include "app/cli/report_writer.h"
#include "core/base/files.h"
#include "core/base/output.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/generators/mirror.h"
#include "core/run/recording/recording_files.h"
#include "core/sensor/layout_source.h"
#include "core/sim/host/recording_journal.h"
#include "core/sim/host/write_recording.h"
#include "core/sim/scene/scene_layouts.h"

namespace taxel::cli {
namespace {

namespace fs = std::filesystem;

struct ConvertedRecording {
  std::string in, out, format;
  const Recording& recording;

  void visit(ReportWriter& w) const {
    w("input", in);
    w("file", out);
    w("format", format);
    w("rows", recording.rows.size());
    w.list("sensors", recording.sensors, [](ReportWriter& one, const RecordedSensor& sensor) {
      one("geom", sensor.geom);
      one("taxels", sensor.taxel_ids.size());
      one("unit", sensor.reading_unit);
    });
    w("notes", std::vector<std::string>());  // the report of layouts has notes too
  }
  [[nodiscard]] std::string text() const {
    std::size_t taxels = 0;
    for (const RecordedSensor& sensor : recording.sensors) taxels += sensor.taxel_ids.size();
    return fmt::format("{}: {} rows of {} taxel{} ({})\n", out, recording.rows.size(), taxels, taxels == 1 ? "" : "s",
                       format);
  }
};

/// Returns the archive of a run. Throws Error if the input is no run.
fs::path archive_of_run(const std::string& in) {
  const fs::path file = recording_file(in);
  std::error_code ignored;
  if (fs::is_directory(in, ignored) && !fs::exists(file, ignored))
    throw Error(in, "is no recorded run: it has no readings.npz");
  if (!fs::is_directory(in, ignored) && read_start(file, 2) != "PK" && fs::exists(file, ignored))
    throw Error(in, "is no recorded run: name the folder of a run, or its readings.npz");
  return file;
}

/// Returns true if a file is a recording by its name: *.jsonl, the messages of tactile_msgs/TactileState.
bool is_recording_output(const std::string& out) {
  return out.ends_with(".jsonl");
}

/// Returns true if a file is the unfinished.rows of a run that has ended early.
bool is_unfinished_run(const std::string& in) {
  return in.ends_with(".rows");
}

/// Writes the rows of such a run as write_recording() does, and leaves them where they are. Prints a report. Throws
/// Error naming the file.
void convert_unfinished_run(const std::string& in, const std::string& out, Console& console) {
  std::error_code ignored;
  if (!fs::exists(in, ignored)) throw Error(in, "no such file");
  const std::optional<LeftRecording> left = read_recording_journal(fs::path(in).replace_extension());
  if (!left) throw Error(in, "holds no complete row of a run that has ended");
  write_recording(out, left->recording, nullptr);
  print_report(console, ConvertedRecording{in, out, "readings", left->recording});
}

/// Reads a run (a folder, or its readings.npz) and writes `out`: the same bytes as `taxel sweep --tactile-state` writes
/// next to it. Prints a report. Throws Error naming the file.
void convert_recording(const std::string& in, const std::string& out, Console& console) {
  const Recording recording = read_recording(archive_of_run(in));
  write_file_atomically(out, tactile_states(recording));
  print_report(console, ConvertedRecording{in, out, "messages of tactile_msgs/TactileState", recording});
}

struct ConvertOptions {
  std::string in, out, from, to;
  SkinChoice skin;
  std::string link;              ///< another word for skin.sensor
  std::optional<double> radius;  ///< radius of taxels whose file gives none [m]
  std::string mirror;            ///< axis along which the layouts are mirrored, or empty
};

/// The layouts of the input, ready to be written.
struct ConvertInput {
  std::string format;  ///< name of the format
  std::vector<ImportedLayout> layouts;
};

struct WrittenFile {
  std::string file, format;
  std::vector<std::pair<std::string, std::size_t>> layouts;  ///< name of each layout and its number of taxels
};

struct ConvertReport {
  std::string in, format;
  std::vector<WrittenFile> files;
  std::vector<std::string> notes;

  [[nodiscard]] std::size_t taxels() const {
    std::size_t sum = 0;
    for (const WrittenFile& file : files)
      for (const auto& layout : file.layouts) sum += layout.second;
    return sum;
  }
  void visit(ReportWriter& w) const {
    w("input", in);
    w("format", format);
    w("taxels", taxels());
    w.list("files", files, [](ReportWriter& one, const WrittenFile& file) {
      one("file", file.file);
      one("format", file.format);
      one.list("layouts", file.layouts, [](ReportWriter& item, const auto& layout) {
        item("name", layout.first);
        item("taxels", layout.second);
      });
    });
    w("notes", notes);
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const WrittenFile& file : files)
      for (const auto& [name, count] : file.layouts)
        text +=
            fmt::format("{}: \"{}\", {} taxel{} ({})\n", file.file, name, count, count == 1 ? "" : "s", file.format);
    for (const std::string& note : notes) text += "note: " + note + "\n";
    return text;
  }
};

const LayoutFormat& format_of_word(const std::string& word) {
  return *find_layout_format(word);  // the option's rule allows no other word
}

const LayoutFormat& input_format(const ConvertOptions& options, const fs::path& file) {
  if (!options.from.empty()) return format_of_word(options.from);
  if (const LayoutFormat* format = layout_format_of(file)) return *format;
  throw Error(file.string(),
              "is no layout by its name: say its format with --from (" + layout_format_words(false) + ")");
}

/// Returns the files of a folder that are layouts, by name. A scene is one only if --from asks for it.
std::vector<fs::path> layout_files(const ConvertOptions& options) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(options.in)) {
    const LayoutFormat* format = layout_format_of(entry.path());
    const bool is_wanted = format != nullptr && entry.is_regular_file() &&
                           (options.from.empty() ? !format->is_scene : format->word == options.from);
    if (is_wanted) files.push_back(entry.path());
  }
  if (files.empty()) throw Error(options.in, "is a folder without layouts");
  std::sort(files.begin(), files.end());
  return files;
}

/// Makes the name of a layout's mesh absolute.
void make_mesh_absolute(ImportedLayout& imported, const fs::path& file) {
  std::string& mesh = imported.layout.mesh.file;
  if (!mesh.empty()) mesh = fs::absolute(mesh_path(imported.layout, file)).lexically_normal().string();
}

ConvertInput read_input(const ConvertOptions& options) {
  ConvertInput input;
  std::error_code ignored;
  const std::vector<fs::path> files =
      fs::is_directory(options.in, ignored) ? layout_files(options) : std::vector<fs::path>{options.in};
  for (const fs::path& file : files) {
    const LayoutFormat& format = input_format(options, file);
    input.format = format.name;
    for (ImportedLayout& imported :
         format.is_scene ? read_scene_layouts(file) : read_layouts(format, file, options.skin.unit)) {
      make_mesh_absolute(imported, file);
      input.layouts.push_back(std::move(imported));
    }
  }
  const std::string& sensor = options.link.empty() ? options.skin.sensor : options.link;
  if (!sensor.empty()) input.layouts = {choose_sensor(std::move(input.layouts), sensor, options.in)};
  return input;
}

std::string names_of_layouts(const std::vector<ImportedLayout>& layouts) {
  std::string names;
  for (const ImportedLayout& one : layouts) names += (names.empty() ? "\"" : ", \"") + one.layout.name + "\"";
  return names;
}

/// Returns true if the file gives a mesh, but not the values that a skin gives.
bool names_its_skin(const ImportedLayout& one) {
  return !one.layout.mesh.file.empty() && !one.has_frame && !one.has_material;
}

/// Takes the values that the file does not have from the skin.
void take_skin(ImportedLayout& one, ImportedSource read) {
  one.layout = std::move(read.source.layout);
  one.notes = std::move(read.notes);
  one.cell = 0;
  one.has_normals = one.has_density = one.has_material = one.has_frame = true;
  one.missing_radii.clear();
}

/// Puts a layout on the mesh that its file names.
void put_on_mesh_of_layout(ImportedLayout& one, const std::string& in) {
  const MeshRef mesh = one.layout.mesh;
  take_skin(one, put_on_mesh_file(one, mesh.file, mesh.scale, in));
}

/// Puts the layout on the mesh of --mesh and takes the radius of --radius.
void complete_layouts(ConvertInput& input, const ConvertOptions& options) {
  if (options.radius) {
    for (ImportedLayout& one : input.layouts) {
      if (one.has_radii()) continue;
      for (const std::size_t row : one.missing_radii) one.layout.taxels[row].radius = *options.radius;
      one.notes.push_back(fmt::format("taxels without a radius get {} m of --radius", *options.radius));
      one.missing_radii.clear();
    }
  }
  if (options.skin.mesh.empty()) {
    if (options.skin.scale) throw Error("convert", "--scale", "goes with --mesh");
    for (ImportedLayout& one : input.layouts)
      if (names_its_skin(one)) put_on_mesh_of_layout(one, options.in);
    return;
  }
  if (input.layouts.size() > 1)
    throw Error("convert", "--mesh",
                fmt::format("goes with one layout: choose one of {} with --sensor", names_of_layouts(input.layouts)));
  ImportedLayout& one = input.layouts.front();
  take_skin(one, put_on_mesh_file(one, options.skin.mesh, options.skin.scale, options.in));
}

/// Mirrors the layouts along the axis of --mirror.
void mirror_layouts(ConvertInput& input, const ConvertOptions& options) {
  for (ImportedLayout& one : input.layouts) {
    if (one.layout.mesh.file.empty())
      throw Error(
          "convert", "--mirror",
          fmt::format("mirrors a layout with its mesh, and \"{}\" has none: add it with --mesh", one.layout.name));
    one.layout = mirrored_layout(std::move(one.layout), options.mirror[0] - 'x');
  }
}

/// Makes the name of the mesh relative to the folder of the file that is written, unless the mesh is far from it.
std::vector<ImportedLayout> with_relative_meshes(std::vector<ImportedLayout> layouts, const fs::path& out) {
  const fs::path folder = fs::absolute(out).parent_path();
  for (ImportedLayout& one : layouts) {
    std::string& mesh = one.layout.mesh.file;
    const std::string relative = mesh.empty() ? "" : fs::path(mesh).lexically_relative(folder).string();
    if (!relative.empty() && !relative.starts_with("../../..")) mesh = relative;
  }
  return layouts;
}

/// A file that is ready to be written.
struct PreparedFile {
  WrittenFile file;
  std::string bytes;
};

PreparedFile prepared(const LayoutFormat& format, const fs::path& out, const std::vector<ImportedLayout>& given,
                      std::vector<std::string>& notes) {
  const std::vector<ImportedLayout> layouts = with_relative_meshes(given, out);
  PreparedFile ready{{out.string(), std::string(format.name), {}}, {}};
  WrittenLayouts written = checked_layouts(format, layouts, out.string());
  ready.bytes = std::move(written.bytes);
  notes.insert(notes.end(), written.notes.begin(), written.notes.end());
  for (const ImportedLayout& one : layouts) ready.file.layouts.emplace_back(one.layout.name, one.layout.taxels.size());
  return ready;
}

WrittenFile write_one(const LayoutFormat& format, const fs::path& out, const std::vector<ImportedLayout>& layouts,
                      std::vector<std::string>& notes) {
  PreparedFile ready = prepared(format, out, layouts, notes);
  write_file_atomically(out, ready.bytes);
  return std::move(ready.file);
}

/// Returns a name for a file in a folder that none of the names in `used` is, and adds it to them: the layout's name
/// with "_" for characters that are no part of names, and a number if the name is used.
std::string file_name_of(const std::string& name, std::set<std::string>& used) {
  std::string safe = name.substr(0, 100);
  for (char& c : safe)
    if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20) c = '_';
  if (safe.empty() || safe.front() == '.') safe = "layout" + safe;
  std::string free = safe;
  for (int count = 2; !used.insert(free).second; ++count) free = fmt::format("{}_{}", safe, count);
  return free;
}

std::vector<WrittenFile> write_folder(const LayoutFormat& format, const fs::path& folder, const ConvertInput& input,
                                      std::vector<std::string>& notes) {
  std::vector<PreparedFile> ready;
  std::set<std::string> used;
  for (const ImportedLayout& one : input.layouts) {
    const std::string name = file_name_of(one.layout.name, used) + std::string(format.extensions.front());
    ready.push_back(prepared(format, folder / name, {one}, notes));
  }
  OutputFolder out(folder);
  for (const PreparedFile& one : ready) out.write(fs::path(one.file.file).filename().string(), one.bytes);
  out.commit();
  std::vector<WrittenFile> files;
  for (PreparedFile& one : ready) files.push_back(std::move(one.file));
  return files;
}

/// Returns the format of the output. A name without a known extension is a folder of layouts.
const LayoutFormat& output_format(const ConvertOptions& options, bool& is_folder) {
  std::error_code ignored;
  const LayoutFormat* by_name = layout_format_of(fs::path(options.out));
  is_folder = options.out.ends_with('/') || fs::is_directory(options.out, ignored) ||
              (by_name == nullptr && fs::path(options.out).extension().empty());
  if (!options.to.empty()) return format_of_word(options.to);
  if (is_folder) return layout_formats().front();
  if (by_name == nullptr || by_name->write == nullptr)
    throw Error(options.out, by_name != nullptr
                                 ? fmt::format("is not written: {} holds no layout", by_name->name)
                                 : "is no layout by its name: say its format with --to (" + layout_format_words(true) +
                                       "); a recorded run becomes .jsonl, or .mcap by python -m taxel.mcap");
  return *by_name;
}

/// Removes notes that are repeated, and keeps the order of the others.
std::vector<std::string> without_repeats(const std::vector<std::string>& notes) {
  std::vector<std::string> once;
  for (const std::string& note : notes)
    if (std::find(once.begin(), once.end(), note) == once.end()) once.push_back(note);
  return once;
}

/// Throws Error if an option is given that only layouts have.
void expect_no_layout_options(const ConvertOptions& options) {
  const std::pair<const char*, bool> given[] = {
      {"--from", !options.from.empty()},          {"--to", !options.to.empty()},
      {"--mesh", !options.skin.mesh.empty()},     {"--scale", options.skin.scale.has_value()},
      {"--sensor", !options.skin.sensor.empty()}, {"--link", !options.link.empty()},
      {"--radius", options.radius.has_value()},   {"--mirror", !options.mirror.empty()}};
  for (const auto& [name, is_given] : given)
    if (is_given) throw Error("convert", name, "goes with layouts; the output is a recording by its name");
}

int run_convert_command(const ConvertOptions& options, Console& console) {
  if (is_unfinished_run(options.in)) {
    expect_no_layout_options(options);
    convert_unfinished_run(options.in, options.out, console);
    return kDone;
  }
  if (options.to.empty() && is_recording_output(options.out)) {
    expect_no_layout_options(options);
    convert_recording(options.in, options.out, console);
    return kDone;
  }
  bool is_folder = false;
  const LayoutFormat& format = output_format(options, is_folder);
  ConvertInput input = read_input(options);
  complete_layouts(input, options);
  if (!options.mirror.empty()) mirror_layouts(input, options);
  if (!is_folder && input.layouts.size() > 1 && !format.writes_several)
    throw Error(options.in,
                fmt::format("holds {} layouts, {} holds one: choose one with --sensor NAME, or name a folder; "
                            "there are {}",
                            input.layouts.size(), format.name, names_of_layouts(input.layouts)));
  ConvertReport report{options.in, input.format, {}, notes_of(input.layouts)};
  if (is_folder)
    report.files = write_folder(format, options.out, input, report.notes);
  else
    report.files = {write_one(format, options.out, input.layouts, report.notes)};
  report.notes = without_repeats(report.notes);
  print_report(console, report);
  return kDone;
}

Check is_format(bool writable) {
  std::vector<std::string> words;
  for (const LayoutFormat& format : layout_formats())
    if (!writable || format.write != nullptr) words.emplace_back(format.word);
  return one_of(words);
}

}  // namespace

Run add_convert(OptionList& list) {
  const auto options = std::make_shared<ConvertOptions>();
  list.add("IN", &options->in,
           "Layout of any format, or a folder of layouts; for a recording the folder of a run, its readings.npz, "
           "or the unfinished.rows that a run has left which could not be finished",
           required());
  list.add("OUT", &options->out,
           "File to write, in the format of its name; a folder gets a file for each layout (default: .taxels.json); "
           ".jsonl are messages of a recording; unfinished.rows become a folder of readings, or a .csv or .npz",
           required());
  list.add("--from", &options->from, "Format of IN (default: that of its name and content)",
           {.unit = "FORMAT", .check = is_format(false)});
  list.add("--to", &options->to, "Format of OUT (default: that of its name)",
           {.unit = "FORMAT", .check = is_format(true)});
  add_skin(list, options->skin);
  list.add("--link", &options->link, "The same as --sensor, for files whose sensors are named by links",
           {.unit = "NAME", .excludes = {"--sensor"}});
  list.add("--radius", &options->radius, "Radius of taxels whose file gives none [m]",
           {.unit = "M", .check = positive()});
  list.add("--mirror", &options->mirror,
           "Mirror the layout with its mesh along this axis, as for the other hand: taxels, frame and the scale of the "
           "mesh change their sign",
           {.unit = "AXIS", .check = one_of({"x", "y", "z"})});
  return [options](Console& console) { return run_convert_command(*options, console); };
}

}  // namespace taxel::cli
