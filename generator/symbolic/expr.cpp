// Storage of expressions: interning, constants, symbols, and the operators on handles. In: operations from
// user code. Out: calls of the construction rules (builder.hpp), nodes in the arena.
#include "symbolic/expr.hpp"

#include <bit>
#include <cmath>
#include <stdexcept>

#include "symbolic/builder.hpp"

namespace alembert {
namespace {

// Ranks order operands: constants come first, so that c*x has c in front, then symbols.
enum class Rank : std::uint64_t { number, constant, symbol, other };
constexpr int kRankShift = 62;
constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;

constexpr std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  hash = (hash ^ value) * kGolden;
  return hash ^ (hash >> 29);
}

constexpr std::uint64_t ranked(Rank rank, std::uint64_t hash) {
  return static_cast<std::uint64_t>(rank) << kRankShift | hash >> 2;
}

constexpr std::uint64_t seed(Operation op) {
  return (static_cast<std::uint64_t>(op) + 1) * 0xd1b54a32d192ed03u;
}

// Vectors grow by a quarter: little slack, and copying stays a constant number of times the size.
template <class T>
void push(std::vector<T>& to, T value) {
  if (to.size() == to.capacity()) to.reserve(to.size() + to.size() / 4 + 64);
  to.push_back(value);
}

constexpr std::size_t kFirstSlots = 1024;
// The low half of a key, scaled to the number of slots, which need not be a power of two: the table grows by
// a half.
constexpr std::size_t home(std::uint64_t key, std::size_t slots) {
  return (key & 0xffffffffu) * slots >> 32;
}
constexpr std::size_t next(std::size_t slot, std::size_t slots) {
  return slot + 1 == slots ? 0 : slot + 1;
}
constexpr std::uint8_t tag(std::uint64_t key) {
  return static_cast<std::uint8_t>(key >> 48 | 0x80);
}
constexpr std::uint32_t kMostNodes = 0x7fffffffu;

ExprGraph& common_graph(const Expr& a, const Expr& b) {
  if (!a.valid() || !b.valid()) throw std::logic_error("an expression that belongs to no graph was used");
  if (&a.graph() != &b.graph()) throw std::logic_error("expressions of different graphs cannot be combined");
  return a.graph();
}

Expr apply(Operation op, const Expr& x) {
  ExprGraph& graph = common_graph(x, x);
  return {graph, graph.make(op, x.ref())};
}

}  // namespace

Expr apply(Operation op, Expr a, Expr b) {
  ExprGraph& graph = common_graph(a, b);
  return {graph, graph.make(op, a.ref(), b.ref())};
}

bool Expr::is_zero() const {
  return ref_ == kZero;
}
bool Expr::is_one() const {
  return ref_ == kOne;
}
bool Expr::is_constant() const {
  return graph_->node(ref_.node()).constant;
}

Expr operator+(Expr a, Expr b) {
  return apply(Operation::add, a, b);
}
Expr operator-(Expr a, Expr b) {
  return apply(Operation::add, a, -b);
}
Expr operator*(Expr a, Expr b) {
  return apply(Operation::mul, a, b);
}
Expr operator/(Expr a, Expr b) {
  return apply(Operation::div, a, b);
}
Expr sqrt(Expr x) {
  return apply(Operation::sqrt, x);
}
Expr sin(Expr x) {
  return apply(Operation::sin, x);
}
Expr cos(Expr x) {
  return apply(Operation::cos, x);
}
Expr tan(Expr x) {
  return apply(Operation::tan, x);
}
Expr asin(Expr x) {
  return apply(Operation::asin, x);
}
Expr acos(Expr x) {
  return apply(Operation::acos, x);
}
Expr atan(Expr x) {
  return apply(Operation::atan, x);
}
Expr atan2(Expr y, Expr x) {
  return apply(Operation::atan2, y, x);
}
Expr exp(Expr x) {
  return apply(Operation::exp, x);
}
Expr log(Expr x) {
  return apply(Operation::log, x);
}
Expr abs(Expr x) {
  return apply(Operation::abs, x);
}
Expr sign(Expr x) {
  return apply(Operation::sign, x);
}
Expr sinh(Expr x) {
  return apply(Operation::sinh, x);
}
Expr cosh(Expr x) {
  return apply(Operation::cosh, x);
}
Expr tanh(Expr x) {
  return apply(Operation::tanh, x);
}
Expr rounding(Expr x) {
  return apply(Operation::rounding, x);
}
Expr if_positive(Expr c, Expr x) {
  return apply(Operation::if_positive, c, x);
}
Expr unless_positive(Expr c, Expr x) {
  return apply(Operation::unless_positive, c, x);
}
Expr pow(Expr x, Expr y) {
  return apply(Operation::pow, x, y);
}
Expr pow(Expr x, int n) {
  ExprGraph& graph = common_graph(x, x);
  return {graph, Builder(graph).integer_power(x.ref(), n)};
}

ExprGraph::ExprGraph() : tags_(kFirstSlots, 0), table_(kFirstSlots, 0) {
  // Nodes 0 and 1 are the numbers 0 and 1: every rule knows them by their handle.
  rationals_.push_back(Rational(0));
  nodes_.push_back({Operation::rational, true, Ref(), Ref()});
  keys_.push_back(ranked(Rank::number, 0));
  intern_number(Operation::rational, Rational(1));
}

Expr ExprGraph::integer(std::int64_t value) {
  return {*this, Builder(*this).number(Rational(value))};
}
Expr ExprGraph::rational(Rational value) {
  return {*this, Builder(*this).number(value)};
}
Expr ExprGraph::pi(Rational multiple) {
  return {*this, Builder(*this).pi(multiple)};
}
Expr ExprGraph::real(double value) {
  return {*this, Builder(*this).real(value)};
}

Expr ExprGraph::symbol(std::string_view name) {
  const auto [found, added] = symbol_ids_.try_emplace(std::string(name), symbol_count());
  if (added) {
    std::uint64_t hash = seed(Operation::symbol);
    for (const char c : name) hash = mix(hash, static_cast<unsigned char>(c) + 1u);
    Node node{Operation::symbol, false, Ref(), Ref()};
    node.a.bits = symbol_count();
    const std::uint32_t id = append(node, ranked(Rank::symbol, mix(hash, name.size())));
    push(symbols_, Symbol{&found->first, id, {-HUGE_VAL, HUGE_VAL}});
  }
  return symbol_at(found->second);
}

void ExprGraph::assume(Expr symbol, Interval interval) {
  if (symbol.ref().negative() || node(symbol.ref().node()).op != Operation::symbol) {
    throw std::logic_error("bounds can only be assumed of symbols");
  }
  symbols_[symbol_index(symbol.ref().node())].interval = interval;
  bounds_.clear();
}

Rational ExprGraph::rational_value(std::uint32_t id) const {
  return rationals_[nodes_[id].a.bits];
}
double ExprGraph::real_value(std::uint32_t id) const {
  return reals_[nodes_[id].a.bits];
}

std::size_t ExprGraph::memory_bytes() const {
  std::size_t names = 0;
  for (const Symbol& symbol : symbols_) names += symbol.name->capacity();
  constexpr std::size_t kMapEntry = 2 * sizeof(void*);  // what a node of a hash map costs beside its value
  return sizeof *this + nodes_.capacity() * sizeof(Node) + keys_.capacity() * sizeof(std::uint64_t) +
         tags_.capacity() + table_.capacity() * sizeof(std::uint32_t) +
         rationals_.capacity() * sizeof(Rational) + reals_.capacity() * sizeof(double) +
         symbols_.capacity() * sizeof(Symbol) + names +
         symbol_ids_.size() * (sizeof(std::pair<std::string, std::uint32_t>) + kMapEntry) +
         bounds_.size() * (sizeof(std::pair<std::uint32_t, Interval>) + kMapEntry);
}

std::uint32_t ExprGraph::append(Node node, std::uint64_t key) {
  if (size() >= kMostNodes) throw std::length_error("expression graph is full");
  if ((nodes_.size() + 1) * 4 > table_.size() * 3) rehash(table_.size() + table_.size() / 2);
  const std::uint32_t id = size();
  push(nodes_, node);
  push(keys_, key);
  place(key, id);
  return id;
}

template <class Same>
std::uint32_t ExprGraph::find(std::uint64_t key, Same same) const {
  for (std::size_t slot = home(key, tags_.size()); tags_[slot] != 0; slot = next(slot, tags_.size())) {
    if (tags_[slot] == tag(key) && same(table_[slot])) return table_[slot];
  }
  return 0;
}

void ExprGraph::place(std::uint64_t key, std::uint32_t id) {
  std::size_t slot = home(key, tags_.size());
  while (tags_[slot] != 0) slot = next(slot, tags_.size());
  tags_[slot] = tag(key);
  table_[slot] = id;
}

void ExprGraph::rehash(std::size_t slots) {
  tags_.assign(slots, 0);
  table_.assign(slots, 0);
  for (std::uint32_t id = 1; id < size(); ++id) place(keys_[id], id);
}

Ref ExprGraph::intern_number(Operation op, Rational value) {
  const bool negative = value.negative();
  if (negative) value.numerator = -value.numerator;
  const std::uint64_t hash = mix(mix(seed(op), static_cast<std::uint64_t>(value.numerator)),
                                 static_cast<std::uint64_t>(value.denominator));
  const std::uint64_t key = ranked(Rank::number, hash);
  const std::uint32_t known =
      find(key, [&](std::uint32_t id) { return nodes_[id].op == op && rational_value(id) == value; });
  if (known != 0) return {known, negative};
  Node node{op, true, Ref(), Ref()};
  node.a.bits = static_cast<std::uint32_t>(rationals_.size());
  push(rationals_, value);
  return {append(node, key), negative};
}

Ref ExprGraph::intern_real(double value) {
  const bool negative = value < 0;
  if (negative) value = -value;
  const std::uint64_t key =
      ranked(Rank::number, mix(seed(Operation::real), std::bit_cast<std::uint64_t>(value)));
  const std::uint32_t known = find(
      key, [&](std::uint32_t id) { return nodes_[id].op == Operation::real && real_value(id) == value; });
  if (known != 0) return {known, negative};
  Node node{Operation::real, true, Ref(), Ref()};
  node.a.bits = static_cast<std::uint32_t>(reals_.size());
  push(reals_, value);
  return {append(node, key), negative};
}

Ref Builder::intern(Operation op, Ref a, Ref b) {
  ExprGraph& g = graph;
  const bool binary = operand_count(op) == 2;
  std::uint64_t hash = mix(seed(op), g.keys_[a.node()] + (a.negative() ? kGolden : 0));
  bool is_constant = g.nodes_[a.node()].constant;
  if (binary) {
    hash = mix(hash, g.keys_[b.node()] + (b.negative() ? kGolden : 0));
    is_constant = is_constant && g.nodes_[b.node()].constant;
  }
  const std::uint64_t key = ranked(is_constant ? Rank::constant : Rank::other, hash);
  const std::uint32_t known = g.find(key, [&](std::uint32_t id) {
    const Node& found = g.nodes_[id];
    return found.op == op && found.a == a && found.b == b;
  });
  if (known != 0) return {known, false};
  return {g.append({op, is_constant, a, b}, key), false};
}

bool Builder::before(Ref a, Ref b) const {
  const std::uint64_t ka = graph.keys_[a.node()], kb = graph.keys_[b.node()];
  return ka != kb ? ka < kb : a.node() < b.node();
}

Ref Builder::number(Rational value) {
  return value.numerator == 0 ? kZero : graph.intern_number(Operation::rational, value);
}

Ref Builder::pi(Rational multiple) {
  return multiple.numerator == 0 ? kZero : graph.intern_number(Operation::pi_multiple, multiple);
}

Ref Builder::real(double value) {
  if (!std::isfinite(value)) throw ConstantOutOfRange();
  const std::optional<Rational> exact = rational_from_double(value);
  return exact ? number(*exact) : graph.intern_real(value);
}

Rational Builder::rational_of(Ref x) const {
  Rational value = graph.rational_value(x.node());
  if (x.negative()) value.numerator = -value.numerator;
  return value;
}

double Builder::numeric_value(Ref x) const {
  constexpr double kPi = 3.14159265358979323846;
  const Operation o = op(x);
  const double value = o == Operation::real          ? graph.real_value(x.node())
                       : o == Operation::pi_multiple ? graph.rational_value(x.node()).to_double() * kPi
                                                     : graph.rational_value(x.node()).to_double();
  return x.negative() ? -value : value;
}

Ref ExprGraph::remade(std::uint32_t id, Ref a, Ref b) {
  const Node n = node(id);  // a copy: the graph grows
  return n.arity() == 0 || (a == n.a && b == n.b) ? Ref(id, false) : make(n.op, a, b);
}

Ref ExprGraph::make(Operation op, Ref a, Ref b) {
  Builder builder(*this);
  if (op == Operation::add) return builder.sum(a, b);
  if (op == Operation::sub) return builder.difference(a, b);
  if (op == Operation::mul) return builder.product(a, b);
  if (op == Operation::div) return builder.quotient(a, b);
  if (op == Operation::neg) return -a;
  if (op == Operation::atan2) return builder.arctangent2(a, b);
  if (op == Operation::pow) return builder.power(a, b);
  if (is_choice(op)) return builder.choice(op, a, b);
  if (operand_count(op) == 1) return builder.function(op, a);
  throw std::logic_error("constants and symbols are not made from operands");
}

}  // namespace alembert
