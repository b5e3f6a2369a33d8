// Microbenchmarks of building and differentiating expressions: nodes per second and bytes per node.
#include <benchmark/benchmark.h>

#include <string>

#include "symbolic/matrix.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/random_dag.hpp"
#include "symbolic/simplify.hpp"
#include "symbolic/value_number.hpp"
#ifdef ALEMBERT_BENCH_DIFFERENTIATION
#include "differentiation/d_star.hpp"
#include "differentiation/forward.hpp"
#include "differentiation/jacobian.hpp"
#include "differentiation/reverse.hpp"
#endif

namespace alembert {
namespace {

void report(benchmark::State& state, std::size_t nodes, const ExprGraph& graph) {
  state.counters["nodes/s"] =
      benchmark::Counter(static_cast<double>(nodes), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["bytes/node"] = static_cast<double>(graph.memory_bytes()) / graph.size();
}

// Rotations along a chain: sums of products of sines, cosines and earlier sums, as equations of motion have
// them.
Mat3 rotation_chain(ExprGraph& graph, std::size_t joints) {
  Mat3 out = identity3(graph);
  for (std::size_t i = 0; i < joints; ++i) {
    const Expr q = graph.symbol(numbered('q', i));
    const Expr s = sin(q), c = cos(q);
    Mat3 joint = identity3(graph);
    const std::size_t j = i % 3, k = (i + 1) % 3;
    joint(j, j) = c;
    joint(k, k) = c;
    joint(j, k) = -s;
    joint(k, j) = s;
    out = out * joint;
  }
  return out;
}

void BM_BuildRotationChain(benchmark::State& state) {
  std::size_t nodes = 0;
  for (auto _ : state) {
    ExprGraph graph;
    benchmark::DoNotOptimize(rotation_chain(graph, static_cast<std::size_t>(state.range(0))));
    nodes = graph.size();
    state.PauseTiming();
    report(state, nodes, graph);
    state.ResumeTiming();
  }
}
BENCHMARK(BM_BuildRotationChain)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

// Random sums and products of recent values: hardly any rule applies, every operation is a new node.
void build_random(ExprGraph& graph, std::size_t count, std::size_t window) {
  TestRandom random(7);
  std::vector<Expr> recent;
  for (std::size_t i = 0; i < 16; ++i) recent.push_back(graph.symbol(numbered('s', i)));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = recent.size() > window ? recent.size() - window : 0;
    const std::uint64_t bits = random.next();
    const Expr a = recent[from + (bits >> 40) % (recent.size() - from)];
    const Expr b = recent[from + (bits & 0xffffff) % (recent.size() - from)];
    recent.push_back((bits >> 32 & 1) != 0 ? a + b : a * b);
  }
}

void BM_BuildRandom(benchmark::State& state) {
  std::size_t nodes = 0;
  for (auto _ : state) {
    ExprGraph graph;
    build_random(graph, static_cast<std::size_t>(state.range(0)), 1000);
    nodes = graph.size();
    state.PauseTiming();
    report(state, nodes, graph);
    state.ResumeTiming();
  }
}
BENCHMARK(BM_BuildRandom)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

// Building what is there already: every operation is a look-up.
void BM_BuildAgain(benchmark::State& state) {
  ExprGraph graph;
  build_random(graph, static_cast<std::size_t>(state.range(0)), 1000);
  for (auto _ : state) build_random(graph, static_cast<std::size_t>(state.range(0)), 1000);
  report(state, graph.size(), graph);
}
BENCHMARK(BM_BuildAgain)->Arg(100000)->Unit(benchmark::kMillisecond);

void BM_ValueNumber(benchmark::State& state) {
  ExprGraph graph;
  const Mat3 rotation = rotation_chain(graph, static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(value_number(rotation.entries));
  report(state, postorder(rotation.entries).size(), graph);
}
BENCHMARK(BM_ValueNumber)->Arg(100)->Arg(10000)->Unit(benchmark::kMillisecond);

void BM_SimplifyTwist(benchmark::State& state) {
  for (auto _ : state) {
    ExprGraph graph;
    const Mat3 e = rotation_chain(graph, static_cast<std::size_t>(state.range(0)));
    const Mat3 product = transpose(e) * e;
    benchmark::DoNotOptimize(simplify(product.entries));
  }
}
BENCHMARK(BM_SimplifyTwist)->Arg(2)->Arg(3)->Arg(4)->Unit(benchmark::kMillisecond);

#ifdef ALEMBERT_BENCH_DIFFERENTIATION
// All first partials of a rotation chain with respect to its angles; nodes are those made by differentiating.
void BM_Differentiate(benchmark::State& state) {
  const std::size_t joints = static_cast<std::size_t>(state.range(0));
  std::size_t nodes = 0;
  for (auto _ : state) {
    state.PauseTiming();
    ExprGraph graph;
    const Mat3 rotation = rotation_chain(graph, joints);
    std::vector<Expr> angles;
    for (std::size_t i = 0; i < joints; ++i) angles.push_back(graph.symbol(numbered('q', i)));
    const std::size_t before = graph.size();
    state.ResumeTiming();
    switch (state.range(1)) {
      case 0:
        benchmark::DoNotOptimize(jacobian_forward(rotation.entries, angles));
        break;
      case 1:
        benchmark::DoNotOptimize(jacobian_reverse(rotation.entries, angles));
        break;
      case 2:
        benchmark::DoNotOptimize(jacobian_d_star(rotation.entries, angles));
        break;
      default:
        benchmark::DoNotOptimize(jacobian(rotation.entries, angles));
        break;
    }
    state.PauseTiming();
    nodes = graph.size() - before;
    report(state, nodes, graph);
    state.ResumeTiming();
  }
  constexpr const char* kNames[] = {"forward", "reverse", "D*", "portfolio"};
  state.SetLabel(kNames[state.range(1)]);
}
BENCHMARK(BM_Differentiate)
    ->Args({6, 0})
    ->Args({6, 1})
    ->Args({6, 2})
    ->Args({6, 3})
    ->Args({100, 0})
    ->Args({100, 1})
    ->Unit(benchmark::kMillisecond);
#endif

}  // namespace
}  // namespace alembert
