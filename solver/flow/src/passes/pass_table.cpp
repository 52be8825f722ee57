#include "parapet/flow/pass_table.hpp"

#include <array>

namespace parapet::solver {

namespace x86_64 {
extern const PassTable table;
}
#ifdef PARAPET_X86
namespace x86_64_v3 {
extern const PassTable table;
}
namespace x86_64_v4 {
extern const PassTable table;
}
#endif

namespace {

// Fastest first. The names are those of the x86-64 psABI levels; the first level also serves other
// processors, where it is plain portable code.
bool runs_here([[maybe_unused]] const PassTable* table) {
#ifdef PARAPET_X86
  if (table == &x86_64_v4::table) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
  if (table == &x86_64_v3::table) {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
           __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  }
#endif
  return true;
}

constexpr std::array tables{
#ifdef PARAPET_X86
    &x86_64_v4::table, &x86_64_v3::table,
#endif
    &x86_64::table};

}  // namespace

const PassTable& best_passes() {
  for (const PassTable* table : tables) {
    if (runs_here(table)) return *table;
  }
  return x86_64::table;
}

const PassTable* find_passes(std::string_view name) {
  for (const PassTable* table : tables) {
    if (name == table->name && runs_here(table)) return table;
  }
  return nullptr;
}

}  // namespace parapet::solver
