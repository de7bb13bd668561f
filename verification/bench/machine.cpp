// What the machine can do: bandwidth of copying and adding arrays, and rates of arithmetic in
// vector instructions without fused multiply-add, as the solver is compiled. Prints lines
// `name,value,unit`; the number of threads is OMP_NUM_THREADS.
#include <chrono>
#include <cstdio>
#include <functional>

#include "tinydem.hpp"
#ifdef _OPENMP
#include <omp.h>
#endif

namespace {
double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
/// The shortest of a few times [s] of something.
double shortest(const std::function<void()>& work) {
  double best = HUGE_VAL;
  for (int k = 0; k < 7; ++k) {
    const double start = now();
    work(), best = std::min(best, now() - start);
  }
  return best;
}
int threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}
volatile double sink;

/// a = b + s c on arrays of `bytes` altogether per thread; bytes read and written per second, of
/// all threads.
double bandwidth(size_t bytes) {
  const size_t n = bytes / 3 / sizeof(double);
  const int rounds = int(std::max<size_t>(1, (size_t(1) << 28) / bytes)), team = threads();
  const auto arrays = std::make_unique<tinydem::vector<double>[]>(size_t(3 * team));
#pragma omp parallel for
  for (int k = 0; k < team; ++k)
    for (int m = 0; m < 3; ++m) arrays[size_t(3 * k + m)].assign(n, 1 + m);
  const double seconds = shortest([&] {
#pragma omp parallel for
    for (int k = 0; k < team; ++k) {
      double* a = arrays[size_t(3 * k)].data();
      const double *b = arrays[size_t(3 * k + 1)].data(), *c = arrays[size_t(3 * k + 2)].data();
      for (int r = 0; r < rounds; ++r) {
        const double s = 1e-3 * r;
#pragma omp simd
        for (size_t i = 0; i < n; ++i) a[i] = b[i] + s * c[i];
      }
    }
    sink = arrays[0][n / 2];
  });
  return 3 * sizeof(double) * double(n) * rounds * team / seconds;
}

// ------------------------------------------------------------------------------------ arithmetic

constexpr int wide = 8, chains = 10;  // numbers of a vector, independent chains
typedef double Pack __attribute__((vector_size(wide * sizeof(double))));
constexpr long rounds = 2'000'000;

/// Multiplications and additions in independent chains: their number.
inline __attribute__((always_inline)) long add_multiply() {
  Pack a[chains];
  for (int k = 0; k < chains; ++k) a[k] = Pack{} + 1.0 + k;
  Pack m = Pack{} + 0.999999, c = Pack{} + 1e-6;
  for (long r = 0; r < rounds; ++r)
#pragma GCC unroll 16
    for (int k = 0; k < chains; ++k) a[k] = a[k] * m + c;
  for (int k = 1; k < chains; ++k) a[0] += a[k];
  sink = a[0][0];
  return 2 * rounds * chains * wide;
}
/// The same for one operation on an array that stays in the nearest cache.
template <class F> inline __attribute__((always_inline)) long on_array(const F& f) {
  constexpr int n = 256;
  alignas(64) double a[n];
  for (int k = 0; k < n; ++k) a[k] = 1 + 0.01 * k;
  const long times = rounds / 40;
  for (long r = 0; r < times; ++r) {
    for (int k = 0; k < n; ++k) a[k] = f(a[k]);
    asm volatile("" : : "r"(a) : "memory");
  }
  sink = a[n / 2];
  return times * n;
}
typedef long Kernel();
#define KERNELS(suffix, attribute)                                                         \
  attribute long sums##suffix() { return add_multiply(); }                                  \
  attribute long divisions##suffix() {                                                      \
    return on_array([](double x) attribute { return 1.5 / x; });                            \
  }                                                                                         \
  attribute long roots##suffix() {                                                          \
    return on_array([](double x) attribute { return sqrt(x); });                            \
  }
#define PLAIN
KERNELS(_base, PLAIN)
#if defined(__x86_64__)
#define AVX2 __attribute__((target("avx2")))
#define AVX512 __attribute__((target("avx512f,avx512vl,avx512dq")))
KERNELS(_avx2, AVX2)
KERNELS(_avx512, AVX512)
/// The widest that the machine has, by the rule of the solver.
int level() {
  if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) return 2;
  return __builtin_cpu_supports("avx2") ? 1 : 0;
}
#define BEST(name) (level() == 2 ? name##_avx512 : level() == 1 ? name##_avx2 : name##_base)
#else
#define BEST(name) name##_base
#endif

/// Operations per second of all threads.
double rate(Kernel* kernel) {
  long operations = 0;
  const int team = threads();
  const double seconds = shortest([&] {
    operations = 0;
#pragma omp parallel for reduction(+ : operations)
    for (int k = 0; k < team; ++k) operations += kernel();
  });
  return double(operations) / seconds;
}
void print(const char* name, double value, const char* unit) {
  std::printf("%s,%.6g,%s\n", name, value, unit);
}
}  // namespace

int main(int argc, char**) {
  const size_t most = argc > 1 ? size_t(1) << 24 : size_t(3) << 27;  // any word: a short run
  print("bandwidth_memory", bandwidth(most / size_t(threads())), "B/s");
  print("bandwidth_cache", bandwidth(size_t(1) << 19), "B/s");  // 512 kB per thread
  print("plain", rate(BEST(sums)), "1/s");
  print("divisions", rate(BEST(divisions)), "1/s");
  print("roots", rate(BEST(roots)), "1/s");
}
