// What registers hold: costs by hand, searched orders that obey dependences, and planned statements, which
// are read here as a compiler reads them: same values bit for bit, never more names alive than there are
// registers, and nothing that is read from memory again without a word.
#include <gtest/gtest.h>

#include <bit>
#include <cctype>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "emit/statements/statements.hpp"
#include "program/optimized.hpp"
#include "program/program_maker.hpp"
#include "program/schedule.hpp"
#include "registers/order_search.hpp"
#include "registers/register_file.hpp"
#include "registers/register_order.hpp"
#include "support/no_index.hpp"

namespace alembert {
namespace {

constexpr std::uint32_t kNoResult = kNoIndex;

/// Statements that read values and give the value of their own number, or none; the first `inputs` values are
/// in memory.
RegisterUses uses_of(const std::vector<std::pair<std::vector<std::uint32_t>, std::uint32_t>>& statements,
                     std::uint32_t inputs, std::uint32_t values) {
  RegisterUses uses;
  for (const auto& [reads, result] : statements) uses.add(reads, result);
  uses.in_memory.assign(values, 0);
  std::fill(uses.in_memory.begin(), uses.in_memory.begin() + inputs, 1);
  return uses;
}

std::vector<std::uint32_t> in_order(const RegisterUses& uses) {
  std::vector<std::uint32_t> order(uses.statements.size());
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

TEST(RegisterFile, ReadsOnceWhatStaysInARegister) {
  // c = a + b; d = a c; result d b: both inputs are read again, and so loaded.
  const RegisterUses uses = uses_of({{{0, 1}, 2}, {{0, 2}, 3}, {{3, 1}, kNoResult}}, 2, 4);
  EXPECT_EQ(RegisterFile(uses).cost(in_order(uses)), 2 * (4 + 1));
  const RegisterFile::Record record = RegisterFile(uses).record(in_order(uses));
  EXPECT_EQ(record.operands[0],
            (std::vector{OperandFrom::memory_into_register, OperandFrom::memory_into_register}));
  EXPECT_EQ(record.operands[1], (std::vector{OperandFrom::a_register, OperandFrom::a_register}));
  EXPECT_EQ(record.stored, std::vector<bool>(4, false));
}

TEST(RegisterFile, TakesWhatIsReadOnceFromMemory) {
  const RegisterUses uses = uses_of({{{0, 1}, kNoResult}}, 2, 2);
  EXPECT_EQ(RegisterFile(uses).cost(in_order(uses)), 2 * 4);
  EXPECT_EQ(RegisterFile(uses).record(in_order(uses)).operands[0],
            (std::vector{OperandFrom::memory, OperandFrom::memory}));
}

/// `count` values, each of one input, all alive before the first is read.
RegisterUses all_at_once(std::uint32_t count) {
  std::vector<std::pair<std::vector<std::uint32_t>, std::uint32_t>> statements;
  for (std::uint32_t i = 0; i < count; ++i) statements.push_back({{0}, 1 + i});
  for (std::uint32_t i = 0; i < count; ++i) statements.push_back({{1 + i}, kNoResult});
  return uses_of(statements, 1, 1 + count);
}

TEST(RegisterFile, StoresWhatDoesNotFit) {
  // With the input there are fourteen.
  RegisterUses uses = all_at_once(13);
  EXPECT_EQ(RegisterFile(uses).cost(in_order(uses)), 4 + 1);
  uses = all_at_once(20);
  const RegisterFile::Record record = RegisterFile(uses).record(in_order(uses));
  EXPECT_EQ(std::ranges::count(record.stored, true), 20 - 14);
  // Those stay that are read first.
  for (std::uint32_t v = 1; v <= 13; ++v) EXPECT_FALSE(record.stored[v]) << v;
  EXPECT_EQ(RegisterFile(uses).cost(in_order(uses)), 4 + 1 + 6 * (4 + 4));
  EXPECT_GT(RegisterFile(uses).cost(in_order(uses), 10), 10u);
}

TEST(SearchOrder, ObeysDependencesAndCostsNoMore) {
  std::mt19937_64 random(21);
  for (int round = 0; round < 2; ++round) {
    std::vector<std::pair<std::vector<std::uint32_t>, std::uint32_t>> statements;
    Predecessors predecessors;
    constexpr std::uint32_t kInputs = 8, kCount = 320;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      std::set<std::uint32_t> reads;
      while (reads.size() < 2) reads.insert(static_cast<std::uint32_t>(random() % (kInputs + i)));
      statements.push_back({{reads.begin(), reads.end()}, kInputs + i});
      predecessors.emplace_back();
      for (const std::uint32_t v : reads)
        if (v >= kInputs) predecessors.back().push_back(v - kInputs);
    }
    const RegisterUses uses = uses_of(statements, kInputs, kInputs + kCount);
    std::vector<std::uint32_t> order = in_order(uses);
    const std::uint64_t before = RegisterFile(uses).cost(order);
    search_order(uses, predecessors, order);
    EXPECT_LT(RegisterFile(uses).cost(order), before);
    std::vector<std::uint32_t> place(kCount, kCount);
    for (std::uint32_t i = 0; i < kCount; ++i) place[order[i]] = i;
    for (std::uint32_t s = 0; s < kCount; ++s) {
      ASSERT_LT(place[s], kCount);
      for (const std::uint32_t p : predecessors[s]) ASSERT_LT(place[p], place[s]);
    }
    std::vector<std::uint32_t> again = in_order(uses);
    search_order(uses, predecessors, again);
    EXPECT_EQ(again, order);
  }
}

/// Runs planned statements of + - * and signs. Throws at an element that is read a second time, or after it
/// was written, without ALEMBERT_FROM_MEMORY between: a compiler would keep it in a register.
class Reader {
 public:
  explicit Reader(std::map<std::string, double> arrays) : memory_(std::move(arrays)) {}

  void run(const std::string& lines) {
    std::istringstream in(lines);
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line.substr(0, line.find("  //")));
    names_.clear();
    known_.clear();
    count_alive(all);
    for (const std::string& line : all) {
      if (line == "ALEMBERT_FROM_MEMORY;") {
        known_.clear();
        continue;
      }
      const std::size_t equal = line.find(" = ");
      const bool named = line.starts_with("const S ");
      const std::string target = line.substr(named ? 8 : 0, equal - (named ? 8 : 0));
      text_ = line.substr(equal + 3);
      at_ = 0;
      const double value = sum();
      if (text_.substr(at_) != ";") throw std::runtime_error("not read to its end: " + line);
      if (named) {
        names_[target] = value;
      } else {
        memory_[target] = value;
        known_.insert(target);
      }
    }
  }

  double result(std::uint32_t i) const { return memory_.at("tau[" + std::to_string(i) + "]"); }
  std::size_t most_alive() const { return most_alive_; }
  std::size_t stores() const { return stores_; }

 private:
  static std::vector<std::string> words(const std::string& text) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < text.size();) {
      std::size_t end = i;
      while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
        ++end;
      if (end > i) out.push_back(text.substr(i, end - i));
      i = std::max(end, i + 1);
    }
    return out;
  }

  void count_alive(const std::vector<std::string>& lines) {
    std::map<std::string, std::size_t> last;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const std::string& word : words(lines[i])) last[word] = i;
    std::set<std::string> alive;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].starts_with("const S ")) alive.insert(words(lines[i])[2]);
      if (lines[i].starts_with("kept[")) ++stores_;
      most_alive_ = std::max(most_alive_, alive.size());
      std::erase_if(alive, [&](const std::string& name) { return last[name] <= i; });
    }
  }

  double sum() {
    double value = product();
    while (text_.compare(at_, 3, " + ") == 0 || text_.compare(at_, 3, " - ") == 0) {
      const char sign = text_[at_ + 1];
      at_ += 3;
      const double next = product();
      value = sign == '+' ? value + next : value - next;
    }
    return value;
  }
  double product() {
    double value = factor();
    while (text_.compare(at_, 3, " * ") == 0) {
      at_ += 3;
      value *= factor();
    }
    return value;
  }
  double factor() {
    if (text_[at_] == '-') {
      ++at_;
      return -factor();
    }
    if (text_[at_] == '(') {
      ++at_;
      const double value = sum();
      ++at_;
      return value;
    }
    std::size_t end = at_;
    while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) || text_[end] == '_'))
      ++end;
    std::string name = text_.substr(at_, end - at_);
    if (name == "S") {
      char* stop = nullptr;
      const double value = std::strtod(text_.c_str() + at_ + 2, &stop);
      at_ = static_cast<std::size_t>(stop - text_.c_str()) + 1;
      return value;
    }
    if (text_[end] == '[') {
      end = text_.find(']', end) + 1;
      name = text_.substr(at_, end - at_);
      at_ = end;
      if (known_.contains(name) && !read_here(name)) throw std::runtime_error(name + " is known already");
      known_.insert(name);
      here_ = text_;
      return memory_.at(name);
    }
    at_ = end;
    return names_.at(name);
  }
  /// The same statement may read an element twice.
  bool read_here(const std::string& name) const {
    return here_ == text_ && text_.find(name) < at_ - name.size();
  }

  std::map<std::string, double> memory_, names_;
  std::set<std::string> known_;
  std::string text_, here_;
  std::size_t at_ = 0, most_alive_ = 0, stores_ = 0;
};

TEST(PlannedStatements, GiveEveryBitWithSixteenRegisters) {
  std::mt19937_64 random(31);
  std::size_t stores = 0;
  for (int round = 0; round < 22; ++round) {
    Program program = schedule(optimized(random_program(round < 20 ? 200 : 900, Mix::arithmetic, random)));
    program.function = "inverse_dynamics";
    program.outputs = {{"tau", 0, 1, {}}};
    for (std::uint32_t v = 0; v < program.code.size(); v += 7) program.outputs[0].values.push_back(v);
    program.outputs[0].rows = static_cast<std::uint32_t>(program.outputs[0].values.size());
    const std::vector<double> x = random_point(program.inputs.size(), random);
    std::map<std::string, double> arrays;
    for (std::uint32_t i = 0; i < program.inputs.size(); ++i) {
      program.inputs[i] = {ArgumentKind::q, i, "q"};
      arrays["q[" + std::to_string(i) + "]"] = x[i];
    }
    const Program ordered = order_for_registers(program, States::many);
    const BlockSizes sizes = round % 2 == 0 ? BlockSizes{} : BlockSizes{120, 80};
    const FunctionBody body =
        function_body(ordered, *find_function("inverse_dynamics"), sizes, Registers::planned);
    Reader reader(arrays);
    for (const CodeBlock& block : body.blocks) reader.run(block.statement_lines);
    const std::vector<double> expected = run(program, x);
    for (std::uint32_t i = 0; i < expected.size(); ++i)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(reader.result(i)), std::bit_cast<std::uint64_t>(expected[i]));
    // Fourteen, what a statement reads and what it gives.
    EXPECT_LE(reader.most_alive(), 16u);
    stores += reader.stores();
  }
  EXPECT_GT(stores, 100u);
}

TEST(PlannedStatements, NameAnElementOnceThoughTwoInputsAreIt) {
  ProgramMaker m(2);
  const std::uint32_t a = m.input(0), b = m.input(1);
  const std::uint32_t square = m.mul(a, a), product = m.mul(b, b);
  Program program = m.returning({m.add(square, product), m.add(m.mul(a, square), m.mul(b, product))});
  program.function = "inverse_dynamics";
  program.outputs[0].name = "tau";
  for (InputSlot& slot : program.inputs) slot = {ArgumentKind::q, 0, "q"};
  const FunctionBody body =
      function_body(program, *find_function("inverse_dynamics"), {}, Registers::planned);
  EXPECT_NE(body.blocks[0].statement_lines.find("const S q0 = q[0];"), std::string::npos);
  EXPECT_NE(body.blocks[0].statement_lines.find("const S q0_2 = q[0];"), std::string::npos);
  Reader reader({{"q[0]", 3}});
  reader.run(body.blocks[0].statement_lines);
  EXPECT_EQ(reader.result(0), 18);
  EXPECT_EQ(reader.result(1), 54);
}

}  // namespace
}  // namespace alembert
