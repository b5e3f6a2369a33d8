// Operation counts of every mechanism of the catalogue against a golden table, so that a worse (or better)
// optimiser shows in review. ALEMBERT_UPDATE_GOLDEN=1 rewrites the table.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "dynamics/mechanism_file.hpp"
#include "pipeline.hpp"

namespace alembert::test {
namespace {

const char* const kTable = ALEMBERT_SOURCE_DIR "/tests/golden/operation_counts.txt";
const char* const kHeader =
    "mechanism                function                                   mul    add   div  trig other  "
    "formulation";

/// Rows of the table by mechanism.
std::map<std::string, std::string> read_table() {
  std::map<std::string, std::string> rows;
  std::ifstream in(kTable);
  for (std::string line; std::getline(in, line);) {
    if (line == kHeader) continue;
    rows[line.substr(0, line.find(' '))] += line + "\n";
  }
  return rows;
}

std::string rows_of(const std::string& path) {
  CompileOptions options;
  for (const OutputFunction& row : kOutputFunctions) options.functions.emplace_back(row);
  options.inapplicable = Inapplicable::leave_out;
  const CompiledMechanism compiled = compile_mechanism(read_source(path), options);
  std::string rows;
  for (const CompiledFunction& f : compiled.functions) {
    rows += fmt::format("{:<24} {:<38} {:>7} {:>6} {:>5} {:>5} {:>5}  {}\n", compiled.mechanism->name,
                        to_string(f.kind), f.count.mul, f.count.add, f.count.div, f.count.trig, f.count.other,
                        to_string(f.formulation));
  }
  return rows;
}

TEST(OperationCounts, AreThoseOfTheGoldenTable) {
  std::map<std::string, std::string> now;
  for (const std::string& path : catalogue()) now[test_name(path)] = rows_of(path);
  if (std::getenv("ALEMBERT_UPDATE_GOLDEN") != nullptr) {
    std::ofstream out(kTable);
    out << kHeader << '\n';
    for (const auto& [name, rows] : now) out << rows;
    ASSERT_TRUE(out.good());
    GTEST_SKIP() << "table rewritten";
  }
  const std::map<std::string, std::string> golden = read_table();
  ASSERT_FALSE(golden.empty());
  for (const auto& [name, rows] : now) {
    const auto found = golden.find(name);
    EXPECT_EQ(found == golden.end() ? "" : found->second, rows) << name;
  }
  for (const auto& [name, rows] : golden)
    EXPECT_TRUE(now.contains(name)) << name << " is in the table but not in mechanisms/";
}

/// The mechanisms of the paper take the greater part of the time and nothing that the others do not.
std::vector<std::string> without_the_papers() {
  std::vector<std::string> files = catalogue();
  std::erase_if(files,
                [](const std::string& path) { return path.find("/mechanisms/paper/") != std::string::npos; });
  return files;
}

/// A pass only offers further ways to write the equations: with it there are never more operations.
class Pass : public testing::TestWithParam<std::string> {};
TEST_P(Pass, NeverCostsOperations) {
  const auto operations = [](Passes passes) {
    passes.effort = 0;
    CompileOptions options;
    options.formulation = Formulation::reduced;
    options.functions = {FunctionKind("inverse_dynamics"), FunctionKind("mass_matrix")};
    options.passes = passes;
    const CompiledMechanism compiled = compile_mechanism(read_source(GetParam()), options);
    std::vector<std::size_t> sums;
    for (const CompiledFunction& f : compiled.functions)
      sums.push_back(f.count.mul + f.count.add + f.count.div + f.count.trig + f.count.other);
    return sums;
  };
  Passes passes;
  passes.peeling = passes.placement = passes.regrouping = passes.scaling = false;
  std::vector<std::size_t> before = operations(passes);
  for (bool Passes::*const pass :
       {&Passes::placement, &Passes::regrouping, &Passes::scaling, &Passes::peeling}) {
    passes.*pass = true;
    const std::vector<std::size_t> now = operations(passes);
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_LE(now[i], before[i]) << "function " << i;
    before = now;
  }
}
TEST_P(Pass, ArticulatedBodiesNeverCostOperations) {
  const auto operations = [](bool articulation) {
    CompileOptions options;
    options.formulation = Formulation::reduced;
    options.functions = {FunctionKind("forward_dynamics")};
    options.passes.effort = 0;
    options.passes.articulation = articulation;
    const OperationCount n = compile_mechanism(read_source(GetParam()), options).functions[0].count;
    return n.mul + n.add + n.div + n.trig + n.other;
  };
  EXPECT_LE(operations(true), operations(false));
}
INSTANTIATE_TEST_SUITE_P(Catalogue, Pass, testing::ValuesIn(without_the_papers()),
                         [](const auto& file) { return test_name(file.param); });

/// A load that is an argument costs what puts its inertia together and little else: the links before it are
/// placed and regrouped as with a load of numbers. Without these passes they are not.
class Load : public testing::TestWithParam<const char*> {};
TEST_P(Load, CostsLittleMoreThanOneOfNumbers) {
  const std::string path = std::string(ALEMBERT_SOURCE_DIR "/mechanisms/robots/") + GetParam() + ".yaml";
  const auto operations = [](const std::shared_ptr<const SourceText>& source, bool passes) {
    CompileOptions options;
    options.functions = {FunctionKind("inverse_dynamics")};
    options.passes.placement = options.passes.regrouping = passes;
    return compile_mechanism(source, options).functions[0].count.arithmetic();
  };
  const std::shared_ptr<const SourceText> runtime = read_source(path);
  std::string text = runtime->text;
  for (std::size_t at = 0; (at = text.find("runtime: true", at)) != std::string::npos;)
    text.replace(at, 13, "runtime: false");
  const auto numbers = std::make_shared<const SourceText>(SourceText{path, text});
  ASSERT_NE(runtime->text, numbers->text);
  EXPECT_LE(operations(runtime, true), operations(numbers, true) + 70);
  EXPECT_GE(operations(runtime, false), operations(runtime, true) + 30);
}
INSTANTIATE_TEST_SUITE_P(Robots, Load, testing::Values("chain6r_load", "puma560_load"),
                         [](const auto& test) { return std::string(test.param); });

/// Inverse dynamics is O(n), and forward dynamics by articulated bodies: the operations of a generic revolute
/// chain grow by the same number with each further link.
TEST(OperationCounts, DynamicsOfAChainAreLinear) {
  const auto chain = [](int n, FunctionKind kind) {
    std::string text = "alembert: 1\nname: chain\ncoordinates: [";
    for (int i = 1; i <= n; ++i) text += fmt::format("{}q{}", i > 1 ? ", " : "", i);
    text += "]\nbodies:\n";
    for (int i = 1; i <= n; ++i) {
      text += fmt::format("  - name: b{}\n", i);
      if (i > 1) text += fmt::format("    parent: b{}\n", i - 1);
      text += fmt::format(
          "    transform: [{{rotate: {{axis: x, angle: 0.3}}}}, {{translate: [0.4, 0, 0.2]}}, {{rotate: "
          "{{axis: z, "
          "angle: q{}}}}}]\n",
          i);
      text +=
          "    mass: 1.5\n    com: [0.1, 0.2, 0.3]\n    inertia: {xx: 1.1, yy: 1.2, zz: 1.3, xy: 0.1, xz: "
          "0.05, yz: 0.02}\n";
    }
    CompileOptions options;
    options.functions = {kind};
    options.formulation = Formulation::reduced;
    options.passes.effort = 0;  // short chains would be searched further than long ones
    return compile_mechanism(std::make_shared<const SourceText>(SourceText{"chain.yaml", text}), options)
        .functions[0]
        .count;
  };
  // The first links see a base at rest and the last ones carry nothing; from there on every link costs the
  // same.
  const std::size_t eight = chain(8, FunctionKind("inverse_dynamics")).arithmetic();
  const std::size_t per_link = chain(9, FunctionKind("inverse_dynamics")).arithmetic() - eight;
  const std::size_t twelve = chain(12, FunctionKind("forward_dynamics")).arithmetic();
  const std::size_t per_link_forward = chain(13, FunctionKind("forward_dynamics")).arithmetic() - twelve;
  for (const std::size_t n : {14u, 36u}) {
    const int links = static_cast<int>(n);
    EXPECT_EQ(chain(links, FunctionKind("inverse_dynamics")).arithmetic(), eight + (n - 8) * per_link)
        << "links: " << n;
    // The optimiser finds a little more in some lengths than in others.
    const double expected = static_cast<double>(twelve + (n - 12) * per_link_forward);
    EXPECT_NEAR(static_cast<double>(chain(links, FunctionKind("forward_dynamics")).arithmetic()), expected,
                0.005 * expected)
        << "links: " << n;
  }
  RecordProperty("operations_per_link", static_cast<int>(per_link));
}

}  // namespace
}  // namespace alembert::test
