#include "parapet/records/evaluation_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <string_view>

#include "parapet/records/atomic_file.hpp"

namespace parapet::records {
namespace {

void write_all(int descriptor, std::string_view text, const std::filesystem::path& file) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      throw_file_error("write", file, errno);
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void sync(int descriptor, const std::filesystem::path& file) {
  if (::fsync(descriptor) != 0) throw_file_error("sync", file, errno);
}

/// What is wrong with a line, or empty and the record filled in.
std::string parse_line(std::string_view line, EvaluationRecord& record) {
  try {
    record = record_from_json(designs::Json::parse(line));
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

[[noreturn]] void throw_damaged(const std::filesystem::path& file, std::size_t line_number,
                                const std::string& what) {
  throw designs::InputError(
      {{.file = file.string(),
        .pointer = "",
        .value = fmt::format("line {}", line_number),
        .problem = "this line of the log is damaged (" + what + ")",
        .allowed = "one evaluation record per line; correct or remove the line"}});
}

}  // namespace

std::string evaluation_id(int number) {
  return fmt::format("{:04}", number);
}

LogContent read_evaluation_log(const std::filesystem::path& file) {
  LogContent result;
  std::set<std::string> ids;
  const std::string content = read_file(file);
  for (std::size_t line_number = 1; result.whole_bytes < content.size(); ++line_number) {
    const std::size_t begin = result.whole_bytes, end = content.find('\n', begin);
    const bool ended = end != std::string::npos;
    const std::string_view line =
        std::string_view(content).substr(begin, (ended ? end : content.size()) - begin);
    const bool last = !ended || end + 1 == content.size();
    EvaluationRecord record;
    std::string problem = parse_line(line, record);
    if (problem.empty() && !ids.insert(record.id).second) {
      problem = "the id " + record.id + " stands in an earlier line too";
    }
    if (!problem.empty()) {
      if (!last) throw_damaged(file, line_number, problem);
      result.incomplete_last_line = true;
      return result;
    }
    result.ends_with_line = ended;
    result.whole_bytes += line.size() + (ended ? 1 : 0);
    result.records.push_back(std::move(record));
  }
  return result;
}

EvaluationLog::EvaluationLog(std::filesystem::path file) : file_(std::move(file)) {
  const bool is_new = !std::filesystem::exists(file_);
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor_ < 0) throw_file_error("open", file_, errno);
  try {
    if (is_new) {
      sync(descriptor_, file_);
      sync_folder(file_.has_parent_path() ? file_.parent_path() : std::filesystem::path("."));
    }
    read_and_repair();
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

EvaluationLog::~EvaluationLog() {
  ::close(descriptor_);
}

void EvaluationLog::read_and_repair() {
  LogContent content = read_evaluation_log(file_);
  for (EvaluationRecord& record : content.records) {
    by_design_.emplace(std::pair(record.design, record.spacing), records_.size());
    by_id_.emplace(record.id, records_.size());
    records_.push_back(std::move(record));
  }
  if (content.incomplete_last_line) {
    set_damage_aside(read_file(file_), content.whole_bytes);
  } else if (!content.ends_with_line) {  // complete but for its line end: nothing is lost
    write_all(descriptor_, "\n", file_);
    sync(descriptor_, file_);
  }
}

void EvaluationLog::set_damage_aside(const std::string& content, std::size_t good_size) {
  std::filesystem::path aside = file_;
  aside += ".damaged";
  const int descriptor = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor < 0) throw_file_error("open", aside, errno);
  try {
    write_all(descriptor, content.substr(good_size) + "\n", aside);
    sync(descriptor, aside);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  ::close(descriptor);
  if (::ftruncate(descriptor_, static_cast<off_t>(good_size)) != 0) {
    throw_file_error("repair", file_, errno);
  }
  sync(descriptor_, file_);
  repair_note_ = fmt::format(
      "the last line of {} was only half written: cut off ({} bytes, kept in {}); that design is "
      "evaluated again",
      file_.string(), content.size() - good_size, aside.filename().string());
}

void EvaluationLog::append(const EvaluationRecord& record) {
  const off_t size = ::lseek(descriptor_, 0, SEEK_END);
  try {
    write_all(descriptor_, to_json(record).dump() + "\n", file_);
    sync(descriptor_, file_);
  } catch (...) {
    // A disk that is full leaves half a line: take it back. If even that fails, the next opening
    // repairs it.
    if (size >= 0) [[maybe_unused]]
      const int failed = ::ftruncate(descriptor_, size);
    throw;
  }
  by_design_.emplace(std::pair(record.design, record.spacing), records_.size());
  by_id_.emplace(record.id, records_.size());
  records_.push_back(record);
}

const EvaluationRecord* EvaluationLog::find(const designs::Design& design, double spacing) const {
  const auto found = by_design_.find(std::pair(design, spacing));
  return found == by_design_.end() ? nullptr : &records_[found->second];
}

bool EvaluationLog::has_id(const std::string& id) const {
  return by_id_.count(id) != 0;
}

}  // namespace parapet::records
