// Loaded before the C library (LD_PRELOAD): makes the n-th call that changes files under a folder
// fail, or ends the process there as a power cut would. What it does is told by environment
// variables:
//
//   PARAPET_FAULT_UNDER   only files whose path holds this text
//   PARAPET_FAULT_CALL    open, write, fsync, rename or any
//   PARAPET_FAULT_AT      which of these calls, from 1; 0: none, only count
//   PARAPET_FAULT_KIND    ENOSPC, EIO, EACCES (the call fails), short (a write takes half of its
//                         bytes and the next one fails with ENOSPC), kill (SIGKILL before the call)
//   PARAPET_FAULT_STAYS   1: all later calls fail too, as on a full disk
//   PARAPET_FAULT_COUNT   file that gets the number of calls when the process ends
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

const char* setting(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): at load time
  return value == nullptr ? "" : value;
}

/// The function of the C library that a wrapper stands before.
template <typename Function>
Function* original(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

std::atomic<int>& calls() {
  static std::atomic<int> count{0};
  return count;
}

int error_number() {
  const char* kind = setting("PARAPET_FAULT_KIND");
  if (std::strcmp(kind, "EIO") == 0) return EIO;
  if (std::strcmp(kind, "EACCES") == 0) return EACCES;
  return ENOSPC;
}

bool is_watched(const char* path) {
  const char* under = setting("PARAPET_FAULT_UNDER");
  return *under != '\0' && path != nullptr && std::strstr(path, under) != nullptr;
}

bool is_watched(int descriptor) {
  char link[64], path[PATH_MAX];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t size = ::readlink(link, path, sizeof path - 1);
  if (size < 0) return false;
  path[size] = '\0';
  return is_watched(path);
}

enum class Fate { as_usual, fails, half };

/// Counts a call on a watched file and says what becomes of it.
Fate fate(const char* call) {
  const char* wanted = setting("PARAPET_FAULT_CALL");
  if (std::strcmp(wanted, "any") != 0 && std::strcmp(wanted, call) != 0) return Fate::as_usual;
  const int number = ++calls();
  const int at = std::atoi(setting("PARAPET_FAULT_AT"));
  const char* kind = setting("PARAPET_FAULT_KIND");
  const bool is_short = std::strcmp(kind, "short") == 0;
  if (at == 0 || number < at) return Fate::as_usual;
  if (number > at && is_short) return number == at + 1 ? Fate::fails : Fate::as_usual;
  if (number > at && std::strcmp(setting("PARAPET_FAULT_STAYS"), "1") != 0) return Fate::as_usual;
  if (std::strcmp(kind, "kill") == 0) ::raise(SIGKILL);
  return is_short ? Fate::half : Fate::fails;
}

int failed() {
  errno = error_number();
  return -1;
}

/// Opening counts where it may change something.
bool changes(int flags) {
  return (flags & O_ACCMODE) != O_RDONLY;
}

mode_t mode_of(int flags, va_list arguments) {
  return (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
}

struct CountKeeper {
  ~CountKeeper() {
    const char* file = setting("PARAPET_FAULT_COUNT");
    if (*file == '\0') return;
    if (std::FILE* stream = std::fopen(file, "w")) {
      std::fprintf(stream, "%d\n", calls().load());
      std::fclose(stream);
    }
  }
};
const CountKeeper keeper;

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  if (changes(flags) && is_watched(path) && fate("open") != Fate::as_usual) return failed();
  return original<int(const char*, int, ...)>("open")(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  const bool watched = is_watched(path) || (folder != AT_FDCWD && is_watched(folder));
  if (changes(flags) && watched && fate("open") != Fate::as_usual) return failed();
  return original<int(int, const char*, int, ...)>("openat")(folder, path, flags, mode);
}

ssize_t write(int descriptor, const void* data, size_t size) {
  const auto real = original<ssize_t(int, const void*, size_t)>("write");
  if (!is_watched(descriptor)) return real(descriptor, data, size);
  switch (fate("write")) {
    case Fate::fails:
      return failed();
    case Fate::half:
      return real(descriptor, data, size > 1 ? size / 2 : size);
    case Fate::as_usual:
      break;
  }
  return real(descriptor, data, size);
}

int fsync(int descriptor) {
  if (is_watched(descriptor) && fate("fsync") != Fate::as_usual) return failed();
  return original<int(int)>("fsync")(descriptor);
}

int rename(const char* from, const char* to) {
  if (is_watched(to) && fate("rename") != Fate::as_usual) return failed();
  return original<int(const char*, const char*)>("rename")(from, to);
}

}  // extern "C"
