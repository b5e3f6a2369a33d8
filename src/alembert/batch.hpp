// Calls over many states: what their generated functions share. In: arrays with a state in each lane,
// options. Out: the choice of instructions at run time, ranges of states for threads. Needs the standard
// library only.
//
// Entry i of state s of an array x stands at x[i * stride + s], the rows of M and poses one after the other:
// a "structure of arrays". The columns of a column-major matrix with a row for each state lie so, with the
// outer stride of the matrix.
#pragma once

#include <cstddef>

#if defined(__has_include) && !defined(ALEMBERT_NO_THREADS)
#if __has_include(<thread>)
#define ALEMBERT_BATCH_THREADS 1
#include <thread>
#include <vector>
#endif
#endif

namespace alembert {

/// Sets of instructions that functions over many states are compiled for.
enum class Instructions {
  best,      ///< the widest that the machine has and the functions were compiled for
  baseline,  ///< those that the compiler may assume: two lanes
  avx2,      ///< with FMA: four lanes
  avx512,    ///< F, DQ and VL: eight lanes
};

/// How a batch is done. Its results do not depend on the number of threads, on the number of states or on the
/// place of a state among them; between sets of instructions they differ by rounding.
struct BatchOptions {
  int threads = 1;  ///< threads to spread the states over, started and joined in the call; 0: one a core
  Instructions instructions = Instructions::best;  ///< if the machine has them, otherwise the best below
};

/// Arrays of one call, for a function over a range of its states.
struct BatchCall {
  std::size_t stride;
  const double* arguments[3];
  double* results[4];
  double t;                  ///< of all states, unless t_of_state is given
  const double* parameters;  ///< of all states, unless parameters_of_state is given
  const double* wrenches;    ///< of all states, unless wrenches_of_state is given
  const double* t_of_state;  ///< may be null, as the following
  const double* parameters_of_state;
  const double* wrenches_of_state;
};

/// Does states first ... last - 1 and returns for how many there is no result.
using BatchFunction = std::size_t (*)(const BatchCall& call, std::size_t first, std::size_t last);

/// True if this machine has the instructions.
inline bool has_instructions(Instructions instructions) {
  switch (instructions) {
    case Instructions::best:
    case Instructions::baseline:
      return true;
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
    case Instructions::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case Instructions::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
#else
    case Instructions::avx2:
    case Instructions::avx512:
      return false;
#endif
  }
  return false;
}

/// Does all n states, spread over threads, and returns for how many there is no result. If a thread cannot be
/// had, the caller's does its share.
inline std::size_t run_batch(BatchFunction function, const BatchCall& call, std::size_t n, int threads) {
#ifdef ALEMBERT_BATCH_THREADS
  // A thread is worth starting for some microseconds of work; shares are multiples of a cache line of lanes.
  constexpr std::size_t kLeastShare = 64;
  std::size_t count = threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
  const std::size_t most = (n + kLeastShare - 1) / kLeastShare;
  if (count > most) count = most;
  if (count > 1) {
    const std::size_t share = ((n + count - 1) / count + 7) / 8 * 8;
    std::vector<std::size_t> failed(count, 0);
    std::vector<std::thread> started;
    started.reserve(count);
    const auto work = [&](std::size_t k) {
      const std::size_t first = k * share < n ? k * share : n;
      const std::size_t last = n - first < share ? n : first + share;
      if (first < last) failed[k] = function(call, first, last);
    };
    std::size_t next = 1;
#if defined(__cpp_exceptions)
    try {
      for (; next < count; ++next) started.emplace_back(work, next);
    } catch (...) {
    }
#else
    for (; next < count; ++next) started.emplace_back(work, next);
#endif
    work(0);
    for (; next < count; ++next) work(next);
    std::size_t sum = 0;
    for (std::thread& thread : started) thread.join();
    for (const std::size_t f : failed) sum += f;
    return sum;
  }
#else
  static_cast<void>(threads);
#endif
  return n > 0 ? function(call, 0, n) : 0;
}

}  // namespace alembert
