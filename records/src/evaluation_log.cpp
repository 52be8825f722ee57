#include "parapet/records/evaluation_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <utility>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/checksum.hpp"

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

}  // namespace

std::string evaluation_id(int number) {
  return fmt::format("{:04}", number);
}

std::string log_line(const EvaluationRecord& record) {
  return line_with_checksum(to_json(record));
}

EvaluationLog::EvaluationLog(std::filesystem::path file) : file_(std::move(file)) {
  const bool is_new = !std::filesystem::exists(file_);
  open();
  try {
    if (is_new) {
      sync(descriptor_, file_);
      sync_folder(file_.has_parent_path() ? file_.parent_path() : std::filesystem::path("."));
    }
    read_and_repair();
  } catch (...) {
    if (descriptor_ >= 0) ::close(descriptor_);
    throw;
  }
}

EvaluationLog::~EvaluationLog() {
  ::close(descriptor_);
}

void EvaluationLog::open() {
  descriptor_ = open_own_file(file_, O_RDWR | O_CREAT | O_APPEND);
}

void EvaluationLog::read_and_repair() {
  LogContent content = read_evaluation_log(file_);
  checksum_note_ = records::checksum_note(content, file_);
  for (EvaluationRecord& record : content.records) {
    by_design_.emplace(std::pair(record.design, record.spacing), records_.size());
    by_id_.emplace(record.id, records_.size());
    records_.push_back(std::move(record));
  }
  for (const RefusedDesign& refused : content.refused) refused_designs_.insert(refused.design);
  refused_ = std::move(content.refused);
  damaged_ = std::move(content.damaged);
  if (content.incomplete_last_line) {
    cut_off_last_line(read_own_file(file_), content.whole_bytes);
  } else if (!content.ends_with_line) {  // complete but for its line end: nothing is lost
    write_all(descriptor_, "\n", file_);
    sync(descriptor_, file_);
  }
  if (!damaged_.empty()) remove_damaged_lines(read_own_file(file_));
}

/// Keeps what is taken out of the log.
void EvaluationLog::set_aside(const std::string& text) const {
  std::filesystem::path aside = file_;
  aside += ".damaged";
  const int descriptor = open_own_file(aside, O_WRONLY | O_CREAT | O_APPEND);
  try {
    write_all(descriptor, text, aside);
    sync(descriptor, aside);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  ::close(descriptor);
}

void EvaluationLog::cut_off_last_line(const std::string& content, std::size_t good_size) {
  set_aside(content.substr(good_size) + "\n");
  if (::ftruncate(descriptor_, static_cast<off_t>(good_size)) != 0) {
    throw_file_error("repair", file_, errno);
  }
  sync(descriptor_, file_);
  repairs_.push_back(fmt::format(
      "the last line of {} was only half written: cut off ({} bytes, kept in {}.damaged); that "
      "design is evaluated again",
      file_.string(), content.size() - good_size, file_.filename().string()));
}

void EvaluationLog::remove_damaged_lines(const std::string& content) {
  std::string aside, sound;
  std::size_t number = 1;
  auto next = damaged_.begin();
  for (std::size_t begin = 0; begin < content.size(); ++number) {
    const std::size_t end = content.find('\n', begin) + 1;
    const bool damaged = next != damaged_.end() && next->number == number;
    (damaged ? aside : sound).append(content, begin, end - begin);
    if (damaged) {
      repairs_.push_back(to_string(*next, file_) + "; it is moved to " + file_.filename().string() +
                         ".damaged and its design evaluated again");
      ++next;
    }
    begin = end;
  }
  set_aside(aside);
  write_file_atomically(file_, sound);
  ::close(std::exchange(descriptor_, -1));
  open();
}

void EvaluationLog::append_line(const std::string& line, bool durable) {
  const off_t size = ::lseek(descriptor_, 0, SEEK_END);
  try {
    write_all(descriptor_, line + "\n", file_);
    if (durable) sync(descriptor_, file_);
  } catch (...) {
    // A disk that is full leaves half a line: take it back. If even that fails, the next opening
    // repairs it.
    if (size >= 0) [[maybe_unused]]
      const int failed = ::ftruncate(descriptor_, size);
    throw;
  }
}

void EvaluationLog::append(const EvaluationRecord& record) {
  append(std::vector<EvaluationRecord>{record});
}

void EvaluationLog::append(const std::vector<EvaluationRecord>& records) {
  if (records.empty()) return;
  std::string lines;
  for (const EvaluationRecord& record : records) {
    if (!lines.empty()) lines += '\n';
    lines += log_line(record);
  }
  append_line(lines, true);
  for (const EvaluationRecord& record : records) {
    by_design_.emplace(std::pair(record.design, record.spacing), records_.size());
    by_id_.emplace(record.id, records_.size());
    records_.push_back(record);
  }
}

void EvaluationLog::append(RefusedDesign refused) {
  if (!refused_designs_.insert(refused.design).second) return;
  refused.id = fmt::format("refused-{:04}", refused_.size() + 1);
  append_line(line_with_checksum(to_json(refused)), false);
  refused_.push_back(std::move(refused));
}

const EvaluationRecord* EvaluationLog::find(const designs::Design& design, double spacing) const {
  const auto found = by_design_.find(std::pair(design, spacing));
  return found == by_design_.end() ? nullptr : &records_[found->second];
}

bool EvaluationLog::has_id(const std::string& id) const {
  return by_id_.count(id) != 0;
}

}  // namespace parapet::records
