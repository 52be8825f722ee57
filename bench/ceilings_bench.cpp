// The ceilings of one core of this machine, for every instruction set that it has: arithmetic with
// and without fused multiply-adds, roots, quotients, load bandwidth at the sizes of the caches and
// of memory, and gathers. Names: ceiling/INSTRUCTION SET/WHAT.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "ceiling_kernels.hpp"
#include "parapet/flow/pass_table.hpp"

namespace parapet::bench {

namespace x86_64 {
extern const CeilingKernels kernels;
}
#ifdef PARAPET_X86
namespace x86_64_v3 {
extern const CeilingKernels kernels;
}
namespace x86_64_v4 {
extern const CeilingKernels kernels;
}
#endif

namespace {

using benchmark::Counter;

void add(const CeilingKernels& k, const std::string& what, const char* unit,
         const std::function<double()>& work) {
  const std::string name = std::string("ceiling/") + k.name + "/" + what;
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    double amount = 0.0;
    for ([[maybe_unused]] auto _ : state) amount += work();
    state.counters[unit] = Counter(amount, Counter::kIsRate);
  })->Unit(benchmark::kMicrosecond);
}

void add_arithmetic(const CeilingKernels& k) {
  constexpr std::size_t rounds = 20000;
  const auto run = [](double (*kernel)(std::size_t, double*)) {
    return [kernel] {
      double sink = 0.0;
      const double amount = kernel(rounds, &sink);
      benchmark::DoNotOptimize(sink);
      return amount;
    };
  };
  add(k, "multiply_add", "flop_per_s", run(k.multiply_add));
  if (k.fused_multiply_add) add(k, "fused_multiply_add", "flop_per_s", run(k.fused_multiply_add));
  add(k, "roots", "per_s", run(k.roots));
  add(k, "quotients", "per_s", run(k.quotients));
}

void add_bandwidth(const CeilingKernels& k, const char* level, std::size_t kilobytes) {
  const std::size_t n = kilobytes * 1024 / sizeof(double);
  add(k, std::string("load_") + level, "bytes_per_s", [&k, values = std::vector<double>(n, 1.0)] {
    const std::size_t rounds = std::max<std::size_t>(1, 100'000 / values.size());
    double sum = k.sum(values.data(), values.size(), rounds);
    benchmark::DoNotOptimize(sum);
    return static_cast<double>(rounds * values.size() * sizeof(double));
  });
}

// Indices like those of a neighbour row: near each other, three ascending runs.
void add_gather(const CeilingKernels& k, const char* level, std::size_t n) {
  std::vector<std::int32_t> index;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t run = 0; run < 3; ++run) {
      for (std::size_t s = 0; s < 8; ++s) {
        index.push_back(static_cast<std::int32_t>((i + 61 * run + s) % n));
      }
    }
  }
  add(k, std::string("gather_") + level, "per_s",
      [&k, values = std::vector<double>(n, 1.0), index = std::move(index)] {
        double sum = k.gather_sum(values.data(), index.data(), index.size());
        benchmark::DoNotOptimize(sum);
        return static_cast<double>(index.size());
      });
}

void add_all(const CeilingKernels& k) {
  if (solver::find_passes(k.name) == nullptr) return;  // not on this machine
  add_arithmetic(k);
  add_bandwidth(k, "16_kB", 16);
  add_bandwidth(k, "256_kB", 256);
  add_bandwidth(k, "4_MB", 4UL * 1024);
  add_bandwidth(k, "256_MB", 256UL * 1024);
  add_gather(k, "2400", 2400);
  add_gather(k, "60000", 60000);
}

}  // namespace
}  // namespace parapet::bench

int main(int argc, char** argv) {
  using namespace parapet::bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  add_all(x86_64::kernels);
#ifdef PARAPET_X86
  add_all(x86_64_v3::kernels);
  add_all(x86_64_v4::kernels);
#endif
  benchmark::RunSpecifiedBenchmarks();
}
