// Nanoseconds a point of what runs over lanes, at each width that the machine has.
#include "tests/render/each_target.h"
#include "tests/render/kernels.h"

#include <benchmark/benchmark.h>

namespace {

using namespace firstlight::render;

void run(benchmark::State& state, const Kernel& kernel, std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  constexpr int kBlocks = 16;
  std::vector<Columns3<double>> blocks;
  for (int block = 0; block < kBlocks; ++block) blocks.push_back(kernel_points(3 * block));
  for (auto _ : state) {
    for (const Columns3<double>& at : blocks) {
      Columns3<double> results;
      kernel.run(at, kRaysAtOnce, results);
      benchmark::DoNotOptimize(results.of[0].at.data());
    }
  }
  state.counters["a point"] = benchmark::Counter(static_cast<double>(state.iterations()) * kBlocks * kRaysAtOnce,
                                                 benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

int main(int argument_count, char** arguments) {
  const KernelList list;
  for (const Kernel& kernel : list.kernels()) {
    for_each_target([&](const std::string& name) {
      const std::int64_t target = hwy::SupportedTargets();
      benchmark::RegisterBenchmark((kernel.name + "/" + name).c_str(),
                                   [&kernel, target](benchmark::State& state) { run(state, kernel, target); });
    });
  }
  benchmark::Initialize(&argument_count, arguments);
  benchmark::RunSpecifiedBenchmarks();
}
