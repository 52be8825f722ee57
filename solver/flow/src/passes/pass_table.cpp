#include "parapet/flow/pass_table.hpp"

#include <array>

#include "parapet/solver/numerics.hpp"

namespace parapet::solver {

namespace x86_64 {
extern const PassTable table, as_published_table;
}
#ifdef PARAPET_X86
namespace x86_64_v3 {
extern const PassTable table, as_published_table;
}
namespace x86_64_v4 {
extern const PassTable table, as_published_table;
}
#endif

namespace {

// The passes of one instruction set, one table for each scheme.
struct Tables {
  const PassTable *corrected, *as_published;
  const PassTable& of(Scheme scheme) const {
    return scheme == Scheme::as_published ? *as_published : *corrected;
  }
};

// Fastest first. The names are those of the x86-64 psABI levels; the first level also serves other
// processors, where it is plain portable code.
constexpr std::array tables{
#ifdef PARAPET_X86
    Tables{&x86_64_v4::table, &x86_64_v4::as_published_table},
    Tables{&x86_64_v3::table, &x86_64_v3::as_published_table},
#endif
    Tables{&x86_64::table, &x86_64::as_published_table}};

bool runs_here([[maybe_unused]] const Tables& of) {
#ifdef PARAPET_X86
  if (of.corrected == &x86_64_v4::table) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
  if (of.corrected == &x86_64_v3::table) {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
           __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  }
#endif
  return true;
}

}  // namespace

const PassTable& best_passes(Scheme scheme) {
  for (const Tables& of : tables) {
    if (runs_here(of)) return of.of(scheme);
  }
  return tables.back().of(scheme);
}

const PassTable& best_passes() {
  return best_passes(Scheme::corrected);
}

const PassTable* find_passes(std::string_view name, Scheme scheme) {
  for (const Tables& of : tables) {
    if (name == of.corrected->name && runs_here(of)) return &of.of(scheme);
  }
  return nullptr;
}

const PassTable* find_passes(std::string_view name) {
  return find_passes(name, Scheme::corrected);
}

}  // namespace parapet::solver
