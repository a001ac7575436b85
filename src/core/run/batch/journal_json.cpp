#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/run/batch/batch_folder.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

constexpr const char* kJournalFormat = "taxel-batch-journal";
constexpr int kJournalVersion = 2;
constexpr std::size_t kChecksumDigits = 16;

/// FNV-1a, 64 bit (Fowler, Noll, Vo): detects a line that was written in part.
std::string line_checksum(std::string_view text) {
  constexpr std::uint64_t kBasis = 0xcbf29ce484222325, kPrime = 0x100000001b3;
  std::uint64_t hash = kBasis;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return fmt::format("{:016x}", hash);
}

std::string journal_line(const Json& json) {
  const std::string text = json_line(json);
  return line_checksum(text) + " " + text + "\n";
}

std::string head_line(const BatchIdentity& identity) {
  const BatchFormat& format = identity.format;
  Json head{{"format", kJournalFormat},       {"version", kJournalVersion}, {"jobs", identity.list_sha256},
            {"program", identity.program},    {"float64", format.float64},  {"poses", format.poses},
            {"group_size", format.group_size}};
  if (format.fps > 0) head["fps"] = format.fps;
  return journal_line(head);
}

std::string files_line(const std::vector<PublishedFile>& files) {
  Json all = Json::array();
  for (const PublishedFile& file : files)
    all.push_back(Json{{"name", file.name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  return journal_line(Json{{"files", all}});
}

/// Returns the JSON text of a line, or nothing if the checksum is wrong.
std::optional<std::string> checked_text(const std::string& line) {
  if (line.size() <= kChecksumDigits || line[kChecksumDigits] != ' ') return std::nullopt;
  std::string text = line.substr(kChecksumDigits + 1);
  if (line_checksum(text) != line.substr(0, kChecksumDigits)) return std::nullopt;
  return text;
}

BatchIdentity read_identity(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  if (const auto format = root.find("format"); !format || !format->is_text() || format->text() != kJournalFormat)
    throw Error(file, "is not the journal of a batch");
  if (const double version = root.at("version").number(); version != kJournalVersion)
    throw Error(file, "/version",
                fmt::format("is {}, this program continues version {}: finish the batch with the program that began "
                            "it, or give another folder",
                            version, kJournalVersion));
  const double size = root.at("group_size").number();
  const auto fps = root.find("fps");
  return {root.at("jobs").text(),
          root.at("program").text(),
          {root.at("float64").flag(), root.at("poses").flag(), static_cast<int>(size), fps ? fps->small_integer() : 0}};
}

void read_entry(const std::string& text, const std::string& file, JournalContent& content) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  if (const auto group = root.find("group")) content.groups.insert(group->text());
  if (const auto group = root.find("again")) content.groups.erase(group->text());
  if (root.find("complete")) content.is_complete = true;
  if (const auto files = root.find("files")) {
    content.files.clear();
    for (std::size_t i = 0; i < files->length(); ++i) {
      const Node one = files->item(i);
      content.files.push_back({one.at("name").text(), one.at("bytes").natural(), one.at("sha256").text()});
    }
  }
  if (root.find("reopened")) content.is_complete = false;
}

}  // namespace

JournalContent replay_journal(const std::string& text, const std::string& file) {
  JournalContent content;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const bool is_first = begin == 0;
    const std::string line = text.substr(begin, end - begin);
    const std::optional<std::string> checked = end != std::string::npos ? checked_text(line) : std::nullopt;
    begin = end != std::string::npos ? end + 1 : text.size();
    if (is_first && !checked && end != std::string::npos) throw Error(file, "is not the journal of a batch");
    if (!checked) {
      ++content.broken_lines;
    } else if (is_first) {
      content.identity = read_identity(*checked, file);
    } else {
      read_entry(*checked, file, content);
    }
  }
  return content;
}

void check_same_batch(const BatchIdentity& found, const BatchIdentity& expected, const std::string& file) {
  const auto refuse = [&](const std::string& difference) {
    throw Error(file, fmt::format("belongs to another batch: {}; give another folder, or remove this one", difference));
  };
  if (found.program != expected.program)
    refuse(fmt::format("it was begun by {}, this is {}", found.program, expected.program));
  if (found.format.float64 != expected.format.float64)
    refuse(fmt::format("its numbers have {} bits", found.format.float64 ? 64 : 32));
  if (found.format.poses != expected.format.poses)
    refuse(found.format.poses ? "it records poses" : "it records no poses");
  if (found.format.group_size != expected.format.group_size)
    refuse(fmt::format("its groups have up to {} jobs", found.format.group_size));
  if (found.format.fps != expected.format.fps)
    refuse(found.format.fps > 0 ? fmt::format("it is resampled to {} rows a second", found.format.fps)
                                : std::string("it has the rows of the runs"));
  if (found.list_sha256 != expected.list_sha256) refuse("its list has other jobs");
}

BatchJournal::BatchJournal(std::filesystem::path path, const BatchIdentity& identity)
    : path_(std::move(path)), identity_(identity) {
  std::error_code ec;
  if (std::filesystem::exists(path_, ec)) content_ = replay_journal(read_file(path_), path_.string());
  if (content_.identity) check_same_batch(*content_.identity, identity_, path_.string());
  if (!content_.identity || content_.broken_lines > 0) write_again();
  file_ = os::File(path_, os::Open::append);
  if (!file_.is_open())
    throw Error(path_.string(), fmt::format("cannot be written: {}", os::error_text(file_.error())));
}

void BatchJournal::write_again() {
  std::string text = head_line(identity_);
  for (const std::string& group : content_.groups) text += journal_line(Json{{"group", group}});
  if (!content_.files.empty()) text += files_line(content_.files);
  if (content_.is_complete) text += journal_line(Json{{"complete", true}});
  write_file_atomically(path_, text);
  content_.identity = identity_;
}

void BatchJournal::write(const std::string& line) {
  int why = file_.write_at_once(line);
  if (why == 0) why = file_.sync();
  if (why != 0) throw Error(path_.string(), fmt::format("writing failed: {}", os::error_text(why)));
}

void BatchJournal::add_group(const std::string& group) {
  write(journal_line(Json{{"group", group}}));
  content_.groups.insert(group);
}

void BatchJournal::forget_group(const std::string& group) {
  write(journal_line(Json{{"again", group}}));
  content_.groups.erase(group);
}

void BatchJournal::publish(const std::vector<PublishedFile>& files) {
  write(files_line(files));
  content_.files = files;
}

void BatchJournal::reopen() {
  write(journal_line(Json{{"reopened", true}}));
  content_.is_complete = false;
}

void BatchJournal::complete() {
  write(journal_line(Json{{"complete", true}}));
  content_.is_complete = true;
}

}  // namespace taxel
