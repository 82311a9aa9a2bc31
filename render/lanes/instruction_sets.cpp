// Which instruction sets the machine has: all that is needed of Highway's library, which measures a clock for 8 ms in each
// process that it is loaded into. It is not linked.

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <atomic>
#include <cstdint>

#if HWY_ARCH_X86
#include <cpuid.h>
#endif

namespace hwy {
namespace {

#if HWY_ARCH_X86
/// Whether zeros at the front of a number can be counted, for which compilers have no name to ask by.
bool has_lzcnt() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  constexpr unsigned kLzcnt = 1u << 5;
  return __get_cpuid(0x80000001, &a, &b, &c, &d) != 0 && (c & kLzcnt) != 0;
}
#endif

/// All that Highway compiles for an instruction set is there, and kept by the operating system.
std::int64_t sets_of_machine() {
  std::int64_t sets = HWY_STATIC_TARGET;
#if HWY_ARCH_X86
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("sse4.2") || !__builtin_cpu_supports("pclmul") || !__builtin_cpu_supports("aes"))
    return sets;
  sets |= HWY_SSE4;
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma") || !__builtin_cpu_supports("bmi") ||
      !__builtin_cpu_supports("bmi2") || !has_lzcnt()) {
    return sets;
  }
  sets |= HWY_AVX2;
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw")) {
    sets |= HWY_AVX3;
  }
#endif
  return sets;
}

std::atomic<std::int64_t> for_test{0};
ChosenTarget chosen;

}  // namespace

ChosenTarget& GetChosenTarget() { return chosen; }

std::int64_t SupportedTargets() {
  static const std::int64_t sets = sets_of_machine();
  const std::int64_t given = for_test.load(std::memory_order_relaxed);
  return given != 0 ? given : sets;
}

void SetSupportedTargetsForTest(std::int64_t targets) { for_test.store(targets, std::memory_order_relaxed); }

}  // namespace hwy
