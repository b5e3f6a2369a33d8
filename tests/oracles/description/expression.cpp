// Recursive descent over the text of an expression (see the header).
#include "oracles/description/expression.hpp"

#include <cctype>
#include <map>
#include <numbers>
#include <stdexcept>

namespace alembert::oracles {

namespace {

Expression make(Operation operation, Expression a, Expression b = nullptr) {
  auto node = std::make_shared<ExpressionNode>();
  node->operation = operation;
  node->operand = {std::move(a), std::move(b)};
  return node;
}

const std::map<std::string, Operation>& functions() {
  static const std::map<std::string, Operation> table = {
      {"sin", Operation::sin},     {"cos", Operation::cos},   {"tan", Operation::tan},
      {"asin", Operation::asin},   {"acos", Operation::acos}, {"atan", Operation::atan},
      {"atan2", Operation::atan2}, {"sqrt", Operation::sqrt}, {"exp", Operation::exp},
      {"log", Operation::log},     {"abs", Operation::abs},   {"sinh", Operation::sinh},
      {"cosh", Operation::cosh},   {"tanh", Operation::tanh}};
  return table;
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
    if (peek() == '(') return name == "d" || name == "position" ? quantity(name) : call(name);
    if (name == "pi") return number(std::numbers::pi);
    if (name == "t") return make(Operation::time, nullptr);
    Expression value = lookup_(name);
    if (!value) fail("unknown name '" + name + "'");
    return value;
  }
  /// d(NAME), d(NAME).x or position(NAME).x: one name to whoever looks it up.
  Expression quantity(std::string name) {
    expect('(');
    name += '(';
    while (peek() != ')' && peek() != '\0') name += text_[at_++];
    expect(')');
    name += ')';
    if (accept('.')) {
      name += '.';
      name += peek();
      ++at_;
    }
    Expression value = lookup_(name);
    if (!value) fail("unknown name '" + name + "'");
    return value;
  }
  /// After the opening parenthesis: x; knots; values), lists in brackets or without.
  Expression spline() {
    Expression x = sum();
    std::array<std::vector<double>, 2> lists;
    for (std::vector<double>& list : lists) {
      expect(';');
      const bool brackets = accept('[');
      do {
        const Expression entry = sum();
        if (!is_constant(entry)) fail("a spline's knots and values are constants");
        list.push_back(constant_value(entry));
      } while (accept(','));
      if (brackets) expect(']');
    }
    expect(')');
    auto node = std::make_shared<ExpressionNode>();
    node->operation = Operation::spline;
    node->operand[0] = std::move(x);
    node->spline = Spline(std::move(lists[0]), std::move(lists[1]));
    return node;
  }
  Expression call(const std::string& name) {
    if (name == "spline") {
      expect('(');
      return spline();
    }
    const auto found = functions().find(name);
    if (found == functions().end()) fail("unknown function '" + name + "'");
    expect('(');
    Expression first = sum();
    Expression second;
    if (found->second == Operation::atan2) {
      expect(',');
      second = sum();
    }
    expect(')');
    return make(found->second, first, second);
  }

  const std::string& text_;
  const std::function<Expression(const std::string&)>& lookup_;
  std::size_t at_ = 0;
};

}  // namespace

/// The bends m of a natural spline: for three neighbouring knots, with lengths l and slopes s of the pieces
/// between them, l0 m0 + 2 (l0 + l1) m1 + l1 m2 = 6 (s1 - s0); eliminated downward, solved upward.
Spline::Spline(std::vector<double> at, std::vector<double> through)
    : knots(std::move(at)), values(std::move(through)), bends(knots.size(), 0.0) {
  if (knots.size() != values.size() || knots.size() < 2)
    throw std::runtime_error("a spline needs as many values as knots, two or more");
  const std::size_t n = knots.size();
  std::vector<double> pivot(n, 1.0), right(n, 0.0), above(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double l0 = knots[i] - knots[i - 1], l1 = knots[i + 1] - knots[i];
    const double factor = l0 / pivot[i - 1];
    pivot[i] = 2 * (l0 + l1) - factor * above[i - 1];
    above[i] = l1;
    right[i] =
        6 * ((values[i + 1] - values[i]) / l1 - (values[i] - values[i - 1]) / l0) - factor * right[i - 1];
  }
  for (std::size_t i = n - 1; i-- > 1;) bends[i] = (right[i] - above[i] * bends[i + 1]) / pivot[i];
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
