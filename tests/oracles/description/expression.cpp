// Recursive descent over the text of an expression (see the header).
#include "oracles/description/expression.hpp"

#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

namespace alembert::oracles {

namespace {

Expression make(Operation operation, Expression a, Expression b = nullptr, Expression c = nullptr) {
  auto node = std::make_shared<ExpressionNode>();
  node->operation = operation;
  node->operand = {std::move(a), std::move(b), std::move(c)};
  return node;
}

const std::map<std::string, Operation>& functions() {
  static const std::map<std::string, Operation> table = {{"sin", Operation::sin},
                                                         {"cos", Operation::cos},
                                                         {"tan", Operation::tan},
                                                         {"asin", Operation::asin},
                                                         {"acos", Operation::acos},
                                                         {"atan", Operation::atan},
                                                         {"atan2", Operation::atan2},
                                                         {"sqrt", Operation::sqrt},
                                                         {"exp", Operation::exp},
                                                         {"log", Operation::log},
                                                         {"abs", Operation::abs},
                                                         {"sinh", Operation::sinh},
                                                         {"cosh", Operation::cosh},
                                                         {"tanh", Operation::tanh},
                                                         {"min", Operation::min},
                                                         {"max", Operation::max},
                                                         {"clamp", Operation::clamp},
                                                         {"step", Operation::step},
                                                         {"smoothstep", Operation::smoothstep},
                                                         {"select", Operation::select},
                                                         {"sign", Operation::sign}};
  return table;
}

std::size_t operands_of(Operation operation) {
  if (operation == Operation::clamp || operation == Operation::select) return 3;
  const bool two =
      operation == Operation::atan2 || operation == Operation::min || operation == Operation::max;
  return two ? 2 : 1;
}

const std::map<std::string, Fit>& tables() {
  static const std::map<std::string, Fit> fits = {
      {"spline", Fit::natural}, {"linear", Fit::straight}, {"simm_spline", Fit::simm}};
  return fits;
}

/// What is asked of things that are no numbers.
bool is_quantity(const std::string& name) {
  static const std::set<std::string> names = {
      "d", "position", "velocity", "rotation", "angular_velocity", "length", "rate", "tension", "distance"};
  return names.count(name) != 0;
}

class Parser {
 public:
  Parser(const std::string& text, const std::function<Expression(const std::string&)>& lookup)
      : text_(text), lookup_(lookup) {}

  Expression whole() {
    Expression result = sum();
    if (peek() != '\0') fail("unexpected character");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(what + " at " + std::to_string(at_) + " of expression '" + text_ + "'");
  }
  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!accept(c)) fail(std::string("expected ") + c);
  }

  Expression sum() {
    Expression left = term();
    while (true) {
      if (accept('+'))
        left = make(Operation::add, left, term());
      else if (accept('-'))
        left = make(Operation::subtract, left, term());
      else
        return left;
    }
  }
  Expression term() {
    Expression left = signed_power();
    while (true) {
      if (accept('*'))
        left = make(Operation::multiply, left, signed_power());
      else if (accept('/'))
        left = make(Operation::divide, left, signed_power());
      else
        return left;
    }
  }
  Expression signed_power() {
    if (accept('-')) return negated(signed_power());
    if (accept('+')) return signed_power();
    Expression base = atom();
    if (accept('^')) return make(Operation::power, base, signed_power());
    return base;
  }
  Expression atom() {
    const char c = peek();
    if (accept('(')) {
      Expression inner = sum();
      expect(')');
      return inner;
    }
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') {
      std::size_t used = 0;
      const double value = std::stod(text_.substr(at_), &used);
      at_ += used;
      return number(value);
    }
    std::string name;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                  text_[at_] == '_' || text_[at_] == '.')) {
      name += text_[at_++];
    }
    if (name.empty()) fail("expected a number, a name or a parenthesis");
    if (peek() == '(') return is_quantity(name) ? quantity(name) : call(name);
    // To all digits of the scalar type: its sine times a weight is no force.
    if (name == "pi") return make(Operation::multiply, number(4), make(Operation::atan, number(1)));
    if (name == "t") return make(Operation::time, nullptr);
    Expression value = lookup_(name);
    if (!value) fail("unknown name '" + name + "'");
    return value;
  }
  /// d(NAME), position(NAME).x, distance(NAME, NAME): one name to whoever looks it up.
  Expression quantity(std::string name) {
    expect('(');
    name += '(';
    while (peek() != ')' && peek() != '\0') name += text_[at_++];
    expect(')');
    name += ')';
    if (accept('.')) {
      name += '.';
      while (std::isalpha(static_cast<unsigned char>(peek())) != 0) name += text_[at_++];
    }
    Expression value = lookup_(name);
    if (!value) fail("unknown name '" + name + "'");
    return value;
  }
  /// After the opening parenthesis: x; knots; values), lists in brackets or without.
  Expression table(Fit fit) {
    Expression x = sum();
    std::array<std::vector<double>, 2> lists;
    for (std::vector<double>& list : lists) {
      expect(';');
      const bool brackets = accept('[');
      do {
        const Expression entry = sum();
        if (!is_constant(entry)) fail("a table's knots and values are constants");
        list.push_back(constant_value(entry));
      } while (accept(','));
      if (brackets) expect(']');
    }
    expect(')');
    auto node = std::make_shared<ExpressionNode>();
    node->operation = Operation::table;
    node->operand[0] = std::move(x);
    node->table = Table(std::move(lists[0]), std::move(lists[1]), fit);
    return node;
  }
  Expression call(const std::string& name) {
    const auto fit = tables().find(name);
    const auto found = functions().find(name);
    if (fit == tables().end() && found == functions().end()) fail("unknown function '" + name + "'");
    expect('(');
    if (fit != tables().end()) return table(fit->second);
    std::array<Expression, 3> operand;
    const std::size_t count = operands_of(found->second);
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) expect(',');
      operand[i] = sum();
    }
    expect(')');
    return make(found->second, operand[0], operand[1], operand[2]);
  }

  const std::string& text_;
  const std::function<Expression(const std::string&)>& lookup_;
  std::size_t at_ = 0;
};

}  // namespace

/// The bends m: for three neighbouring knots, with lengths l and slopes s of the pieces between them,
/// l0 m0 + 2 (l0 + l1) m1 + l1 m2 = 6 (s1 - s0). At an end either m = 0, or (m1 - m0)/l = f''' as that of the cubic
/// through four points, six times their third divided difference; through three points goes a parabola.
/// Eliminated downward, solved upward.
Table::Table(std::vector<double> at, std::vector<double> through, Fit fit)
    : knots(std::move(at)), values(std::move(through)), bends(knots.size(), 0.0) {
  if (knots.size() != values.size() || knots.size() < 2)
    throw std::runtime_error("a table needs as many values as knots, two or more");
  const std::size_t n = knots.size();
  if (fit == Fit::straight || n == 2) return;
  const auto length = [&](std::size_t i) { return knots[i + 1] - knots[i]; };
  const auto slope = [&](std::size_t i) { return (values[i + 1] - values[i]) / length(i); };
  const auto second = [&](std::size_t i) { return (slope(i + 1) - slope(i)) / (knots[i + 2] - knots[i]); };
  const auto third = [&](std::size_t i) {
    return n == 3 ? 0 : 6 * (second(i + 1) - second(i)) / (knots[i + 3] - knots[i]);
  };
  std::vector<double> below(n, 0.0), pivot(n, 1.0), above(n, 0.0), right(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    below[i] = length(i - 1);
    pivot[i] = 2 * (length(i - 1) + length(i));
    above[i] = length(i);
    right[i] = 6 * (slope(i) - slope(i - 1));
  }
  if (fit == Fit::simm) {
    above[0] = below[n - 1] = -1;
    right[0] = -length(0) * third(0);
    right[n - 1] = length(n - 2) * third(n == 3 ? 0 : n - 4);
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = below[i] / pivot[i - 1];
    pivot[i] -= factor * above[i - 1];
    right[i] -= factor * right[i - 1];
  }
  bends[n - 1] = right[n - 1] / pivot[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) bends[i] = (right[i] - above[i] * bends[i + 1]) / pivot[i];
}

Expression number(double value) {
  auto node = std::make_shared<ExpressionNode>();
  node->number = value;
  return node;
}

Expression negated(const Expression& of) {
  return make(Operation::negate, of);
}

Expression product(const Expression& a, const Expression& b) {
  return make(Operation::multiply, a, b);
}

Expression parse(const std::string& text, const std::function<Expression(const std::string&)>& lookup) {
  return Parser(text, lookup).whole();
}

bool is_constant(const Expression& expression) {
  if (expression->operation == Operation::coordinate || expression->operation == Operation::time)
    return false;
  for (const Expression& operand : expression->operand) {
    if (operand && !is_constant(operand)) return false;
  }
  return true;
}

}  // namespace alembert::oracles
