#include "mechanism/expression_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "mechanism/section.hpp"
#include "symbolic/rational.hpp"

namespace alembert {
namespace {

/// The rational that an expression is, if it is one.
std::optional<Rational> as_rational(const Expr& x) {
  const Node& node = x.graph().node(x.ref().node());
  if (node.op != Operation::rational) return std::nullopt;
  Rational value = x.graph().rational_value(x.ref().node());
  if (x.ref().negative()) value.numerator = -value.numerator;
  return value;
}

bool small(std::int64_t n) {
  return n >= -1000000 && n <= 1000000;
}

/// x^y with integer and half-integer exponents as products and square roots, which differentiate to less.
Expr build_power(const Expr& x, const Expr& y) {
  if (const std::optional<Rational> n = as_rational(y); n && small(n->numerator)) {
    if (n->denominator == 1) return pow(x, static_cast<int>(n->numerator));
    if (n->denominator == 2) return pow(sqrt(x), static_cast<int>(n->numerator));
  }
  return pow(x, y);
}

}  // namespace

bool ExpressionReader::Reading::may_lack_value(const Operand& operation) const {
  return operation.value.dependence != Dependence::none &&
         std::ranges::any_of(choices, [&](const auto& choice) {
           return choice.first < operation.begin && operation.end < choice.second;
         });
}

Expr ExpressionReader::coefficient(const YamlNode& node, std::string_view what, bool positive) {
  return checked_sign(node, read(node, Allowed::parameters, what), what, positive);
}

Expr ExpressionReader::coefficient_with(const YamlNode& node, std::vector<LocalName> names,
                                        std::string_view what) {
  return checked_sign(node, read_with(node, std::move(names), Allowed::force, what), what, false);
}

Expr ExpressionReader::checked_sign(const YamlNode& node, const Quantity& value, std::string_view what,
                                    bool positive) const {
  if (positive ? !(value.initial > 0) : value.initial < 0)
    throw InputError(document_.where(node),
                     fmt::format("{} is {:.6g}; expected {}", what, value.initial,
                                 positive ? "a positive number" : "no negative number"));
  return value.expr;
}

Quantity ExpressionReader::read(const YamlNode& node, Allowed allowed, std::string_view what) {
  Reading reading{node, allowed, what};
  if (node.kind != YamlNode::Kind::scalar)
    fail_expected(document_, node, fmt::format("an expression as {}", what));
  std::vector<PostfixToken> postfix;
  try {
    postfix = parse_expression(node.text);
  } catch (const SyntaxError& syntax) {
    const bool cut = syntax.message.find("','") != std::string::npos && syntax.offset == node.text.size() &&
                     is_cut_at_comma(node);
    throw error(reading, syntax.offset, syntax.message, cut ? std::string(kCutNote) : syntax.note);
  }
  for (const PostfixToken& token : postfix)
    if (token.kind == PostfixToken::Kind::call &&
        std::string_view(node.text).substr(token.begin, token.end - token.begin) == "select")
      reading.choices.emplace_back(token.begin, token.close);
  std::vector<Operand> stack;
  for (const PostfixToken& token : postfix) {
    switch (token.kind) {
      case PostfixToken::Kind::number:
        stack.push_back({number(reading, token), token.begin, token.end});
        break;
      case PostfixToken::Kind::name:
        stack.push_back({name(reading, token), token.begin, token.end});
        break;
      case PostfixToken::Kind::reference:
        stack.push_back({reference(reading, token), token.begin, token.close});
        break;
      case PostfixToken::Kind::group:
        stack.back().begin = token.begin;
        stack.back().end = token.end;
        break;
      case PostfixToken::Kind::negate:
        stack.back().value.expr = -stack.back().value.expr;
        stack.back().value.initial = -stack.back().value.initial;
        stack.back().begin = token.begin;
        break;
      case PostfixToken::Kind::call:
      case PostfixToken::Kind::spline: {
        const std::size_t first = stack.size() - static_cast<std::size_t>(token.arguments);
        const std::vector<Operand> arguments(stack.begin() + static_cast<std::ptrdiff_t>(first), stack.end());
        stack.resize(first);
        stack.push_back(token.kind == PostfixToken::Kind::call ? call(reading, token, arguments)
                                                               : table(reading, token, arguments));
        break;
      }
      case PostfixToken::Kind::add:
      case PostfixToken::Kind::subtract:
      case PostfixToken::Kind::multiply:
      case PostfixToken::Kind::divide:
      case PostfixToken::Kind::power: {
        const Operand b = std::move(stack.back());
        stack.pop_back();
        const Operand a = std::move(stack.back());
        stack.back() = binary(reading, token, a, b);
        break;
      }
    }
  }
  Quantity value = std::move(stack.back().value);
  const bool smooth =
      allowed == Allowed::transform || allowed == Allowed::pfaffian || allowed == Allowed::holonomic;
  if (smooth && value.roughness != nullptr)
    throw error(reading, value.roughness->offset,
                fmt::format("{} is not twice differentiable: {}", what, value.roughness->reason));
  return value;
}

Vec3 ExpressionReader::read_vector(const YamlNode& node, Allowed allowed, std::string_view what) {
  const std::vector<const YamlNode*>& items = expect_list(document_, node, what, 3);
  Vec3 out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = read(*items[i], allowed, what).expr;
  return out;
}

Vec3 ExpressionReader::read_point(const YamlNode& node, std::vector<LocalName> names, std::string_view what) {
  locals_ = std::move(names);
  const Vec3 point = read_vector(node, Allowed::parameters, what);
  locals_.clear();
  return point;
}

Quantity ExpressionReader::read_with(const YamlNode& node, std::vector<LocalName> names, Allowed allowed,
                                     std::string_view what) {
  locals_ = std::move(names);
  Quantity value = read(node, allowed, what);
  locals_.clear();
  return value;
}

Quantity ExpressionReader::number(const Reading& reading, const PostfixToken& token) const {
  const char* begin = reading.node.text.data() + token.begin;
  const char* end = reading.node.text.data() + token.end;
  Quantity out;
  const std::from_chars_result result = std::from_chars(begin, end, out.initial);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(out.initial))
    throw error(reading, token.begin,
                fmt::format("number '{}' is out of range", printable({begin, token.end - token.begin})),
                "magnitudes from 2.3e-308 to 1.7e308 are numbers here");
  const std::optional<Rational> exact = rational_from_decimal(begin, end);
  out.expr = exact ? graph_.rational(*exact) : graph_.real(out.initial);
  return out;
}

ExpressionReader::Operand ExpressionReader::binary(const Reading& reading, const PostfixToken& token,
                                                   const Operand& a, const Operand& b) const {
  Operand out{{}, a.begin, b.end};
  out.value.dependence = a.value.dependence | b.value.dependence;
  out.value.roughness = a.value.roughness != nullptr ? a.value.roughness : b.value.roughness;
  const Expr x = a.value.expr, y = b.value.expr;
  const double u = a.value.initial, v = b.value.initial;
  double& value = out.value.initial;
  const bool linear = reading.allowed == Allowed::pfaffian;
  const bool speeds_left = linear && includes(a.value.dependence, Dependence::speed);
  const bool speeds_right = linear && includes(b.value.dependence, Dependence::speed);
  if (token.kind == PostfixToken::Kind::multiply && speeds_left && speeds_right)
    throw not_linear(reading, out, "is a product of speeds");
  if (token.kind == PostfixToken::Kind::divide && speeds_right)
    throw not_linear(reading, out, "divides by a speed");
  if (token.kind == PostfixToken::Kind::power && (speeds_left || speeds_right))
    throw not_linear(reading, out, "is a power of speeds");
  const bool may_lack_value = reading.may_lack_value(out);
  if (token.kind == PostfixToken::Kind::divide && ((v == 0 && !may_lack_value) || y.is_zero()))
    throw error(reading, b.begin,
                fmt::format("division by zero: '{}' is 0{}", text_of(reading, b),
                            b.value.dependence == Dependence::none ? "" : " at the initial state"));
  try {
    switch (token.kind) {
      case PostfixToken::Kind::add:
        out.value.expr = x + y;
        value = u + v;
        break;
      case PostfixToken::Kind::subtract:
        out.value.expr = x - y;
        value = u - v;
        break;
      case PostfixToken::Kind::multiply:
        out.value.expr = x * y;
        value = u * v;
        break;
      case PostfixToken::Kind::divide:
        out.value.expr = x / y;
        value = u / v;
        break;
      case PostfixToken::Kind::power:
        value = std::pow(u, v);
        if (!may_lack_value) check_power(reading, a, b, out);
        out.value.expr = build_power(x, y);
        break;
      case PostfixToken::Kind::number:
      case PostfixToken::Kind::name:
      case PostfixToken::Kind::reference:
      case PostfixToken::Kind::call:
      case PostfixToken::Kind::spline:
      case PostfixToken::Kind::negate:
      case PostfixToken::Kind::group:
        throw InternalError("not a binary operator");
    }
  } catch (const std::domain_error&) {
    throw error(reading, a.begin, fmt::format("'{}' has no finite value", text_of(reading, out)));
  }
  if (!std::isfinite(value) && may_lack_value) value = std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(value) && !std::isnan(u) && !std::isnan(v) && !may_lack_value)
    throw error(reading, a.begin,
                fmt::format("'{}' has no finite value{}", text_of(reading, out),
                            out.value.dependence == Dependence::none ? "" : " at the initial state"));
  // Constants are multiplied as they come: what follows does not make them larger again.
  const bool may_be_zero = token.kind == PostfixToken::Kind::add ||
                           token.kind == PostfixToken::Kind::subtract || x.is_zero() ||
                           (token.kind == PostfixToken::Kind::multiply && y.is_zero());
  if (!may_be_zero && out.value.expr.is_zero())
    throw error(reading, a.begin,
                fmt::format("'{}' is out of range: its constants are too small", text_of(reading, out)),
                "magnitudes from 2.3e-308 to 1.7e308 are numbers here");
  return out;
}

void ExpressionReader::check_power(const Reading& reading, const Operand& base, const Operand& exponent,
                                   Operand& result) const {
  const double u = base.value.initial, v = exponent.value.initial;
  const bool integer = v == std::floor(v) && exponent.value.dependence == Dependence::none;
  const char* when = result.value.dependence == Dependence::none ? "" : " at the initial state";
  if (u == 0 && v < 0)
    throw error(reading, base.begin,
                fmt::format("division by zero: '{}' is 0{}, raised to the power {}", text_of(reading, base),
                            when, v));
  if (u < 0 && !integer)
    throw error(reading, base.begin,
                fmt::format("'{}' is {:.6g}{}; only integers can be exponents of a negative number",
                            text_of(reading, base), u, when));
  if (u == 0 && moves(exponent.value.dependence))
    throw error(
        reading, base.begin,
        fmt::format("'{}' is 0{}; a base of 0 needs a constant exponent", text_of(reading, base), when));
  if (u == 0 && !integer && v < 2 && moves(base.value.dependence))
    make_rough(result, fmt::format("'{}', whose base is 0 at the initial state", text_of(reading, result)));
}

InputError ExpressionReader::error(const Reading& reading, std::size_t offset, const std::string& message,
                                   const std::string& note) const {
  return {document_.where(reading.node, offset), message, note};
}

InputError ExpressionReader::not_linear(const Reading& reading, const Operand& operation,
                                        std::string_view how) const {
  return error(
      reading, operation.begin,
      fmt::format("{} is not linear in the speeds: '{}' {}", reading.what, text_of(reading, operation), how));
}

void ExpressionReader::make_rough(Operand& result, const std::string& reason) {
  if (result.value.roughness == nullptr)
    result.value.roughness = std::make_shared<const Roughness>(Roughness{result.begin, reason, false});
}

std::string ExpressionReader::text_of(const Reading& reading, const Operand& operand) const {
  return printable(std::string_view(reading.node.text).substr(operand.begin, operand.end - operand.begin));
}

}  // namespace alembert
