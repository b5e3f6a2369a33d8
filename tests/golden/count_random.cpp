// Operations of random mechanisms that are in no table: general chains of six revolute joints and trees of
// joints of every kind, axes and inertias as they come. Prints each and then median and worst. `count_random
// [SEED]`
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "pipeline.hpp"

namespace alembert {
namespace {

constexpr int kMechanisms = 20;

class Writer {
 public:
  explicit Writer(unsigned seed) : random_(seed) {}

  /// A tree of `joints` bodies, or a chain of them; revolute joints about generic axes only, or also sliding
  /// and screwing ones.
  std::string description(int joints, bool chain, bool every_joint) {
    std::string coordinates, bodies;
    for (int i = 0; i < joints; ++i) {
      coordinates += fmt::format("{}q{}", i > 0 ? ", " : "", i);
      bodies += fmt::format("  - name: b{}\n", i);
      if (i > 0) bodies += fmt::format("    parent: b{}\n", chain ? i - 1 : below(i));
      bodies +=
          fmt::format("    transform:\n      - translate: [{}, {}, {}]\n", length(), length(), length());
      bodies += fmt::format("      - rotate: {{axis: {}, angle: {:.2f}}}\n", axis(), uniform(-2, 2));
      const int kind = every_joint ? below(6) : 0;
      if (kind == 4) {
        bodies += fmt::format("      - translate: [0, 0, q{}]\n", i);
      } else if (kind == 5) {
        bodies +=
            fmt::format("      - joint: {{type: helical, axis: z, pitch: 0.03, coordinates: [q{}]}}\n", i);
      } else {
        bodies += fmt::format("      - rotate: {{axis: {}, angle: q{}}}\n", axis(), i);
      }
      bodies += fmt::format("    mass: {:.2f}\n    com: [{}, {}, {}]\n", uniform(1, 4), length(), length(),
                            length());
      bodies += fmt::format(
          "    inertia: {{xx: {:.3f}, yy: {:.3f}, zz: {:.3f}, xy: {:.4f}, xz: {:.4f}, yz: {:.4f}}}\n",
          uniform(0.2, 0.3), uniform(0.2, 0.3), uniform(0.2, 0.3), uniform(-0.03, 0.03), uniform(-0.03, 0.03),
          uniform(-0.03, 0.03));
    }
    return fmt::format("alembert: 1\nname: random\ncoordinates: [{}]\nbodies:\n{}", coordinates, bodies);
  }

  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }

 private:
  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  std::string length() { return fmt::format("{:.3f}", uniform(-0.5, 0.5)); }
  std::string axis() {
    return fmt::format("[{:.1f}, {:.1f}, {:.1f}]", uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1));
  }
  std::mt19937_64 random_;
};

void print_counts(const std::string& title, int joints, bool chain, bool every_joint, unsigned seed) {
  std::vector<std::size_t> inverse, forward;
  fmt::print("{}\n", title);
  for (int i = 0; i < kMechanisms; ++i) {
    Writer writer(seed + static_cast<unsigned>(i));
    CompileOptions options;
    options.functions = {FunctionKind("inverse_dynamics"), FunctionKind("forward_dynamics")};
    const auto source = std::make_shared<const SourceText>(
        SourceText{"random.yaml", writer.description(joints, chain, every_joint)});
    const CompiledMechanism compiled = compile_mechanism(source, options);
    const OperationCount &id = compiled.functions[0].count, &fd = compiled.functions[1].count;
    fmt::print(
        "  inverse dynamics {:>4} x {:>4} + {:>5}   forward dynamics {:>4} x {:>4} + {:>5} and {} "
        "divisions\n",
        id.mul, id.add, id.arithmetic(), fd.mul, fd.add, fd.arithmetic(), fd.div);
    inverse.push_back(id.arithmetic());
    forward.push_back(fd.arithmetic());
  }
  std::sort(inverse.begin(), inverse.end());
  std::sort(forward.begin(), forward.end());
  fmt::print("  median {} and {}, worst {} and {}\n", inverse[kMechanisms / 2], forward[kMechanisms / 2],
             inverse.back(), forward.back());
}

}  // namespace
}  // namespace alembert

int main(int argc, char** argv) {
  const unsigned seed = argc > 1 ? static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10)) : 1;
  alembert::print_counts("chains of six revolute joints about generic axes, full inertias", 6, true, false,
                         seed);
  alembert::print_counts("trees of ten revolute, prismatic and helical joints, full inertias", 10, false,
                         true, seed);
  return 0;
}
