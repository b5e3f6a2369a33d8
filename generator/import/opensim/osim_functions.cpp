#include "import/opensim/osim_functions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "import/common/snapped_angle.hpp"

namespace alembert {
namespace {

constexpr int kMaximumNesting = 16;

OsimFunction constant_function(double value) {
  OsimFunction out;
  out.text = number_text(value);
  out.constant = value;
  return out;
}

std::string product_text(double factor, const std::string& of) {
  if (factor == 1) return of;
  if (factor == -1) return "-" + of;
  return fmt::format("{}*{}", number_text(factor), of);
}

class FunctionReader {
 public:
  FunctionReader(const OsimXml& xml, const std::vector<std::string>& arguments)
      : xml_(xml), arguments_(arguments) {}

  OsimFunction read(pugi::xml_node element, int nesting) const {
    const std::string_view type = element.name();
    if (type == "Constant") return constant_function(xml_.number(element, "value", 0));
    if (type == "LinearFunction") return linear(element);
    if (type == "PolynomialFunction") return polynomial(element);
    if (type == "MultivariatePolynomialFunction") return multivariate_polynomial(element);
    if (type == "MultiplierFunction") return multiplier(element, nesting);
    if (type == "SimmSpline" || type == "NaturalCubicSpline" || type == "natCubicSpline")
      return curve(element, type == "SimmSpline" ? "simm_spline" : "spline", true);
    if (type == "PiecewiseLinearFunction") return piecewise_linear(element);
    if (type == "Sine") return sine(element);
    throw InputError(
        xml_.where(element), fmt::format("the function <{}> cannot be expressed", printable(type)),
        "Constant, LinearFunction, PolynomialFunction, MultivariatePolynomialFunction, SimmSpline, "
        "NaturalCubicSpline, PiecewiseLinearFunction, Sine and MultiplierFunction can");
  }

 private:
  const std::string& only_argument(pugi::xml_node element) const {
    if (arguments_.size() != 1)
      throw InputError(xml_.where(element),
                       fmt::format("<{}> is a function of one variable, and there are {}", element.name(),
                                   arguments_.size()));
    return arguments_[0];
  }

  OsimFunction linear(pugi::xml_node element) const {
    const pugi::xml_node coefficients = element.child("coefficients");
    if (!coefficients) throw InputError(xml_.where(element), "no <coefficients> in a LinearFunction");
    return linear_function(xml_.numbers(coefficients, arguments_.size() + 1));
  }

  /// Of a factor for each argument and an offset.
  OsimFunction linear_function(const std::vector<double>& c) const {
    std::vector<std::string> terms;
    for (std::size_t i = 0; i < arguments_.size(); ++i)
      if (c[i] != 0) terms.push_back(product_text(c[i], arguments_[i]));
    if (terms.empty()) return constant_function(c.back());
    if (c.back() != 0) terms.push_back(number_text(c.back()));
    OsimFunction out;
    out.text = sum_text(terms);
    if (arguments_.size() == 1) out.linear = {c[0], c[1]};
    return out;
  }

  /// Without kinks where its points are on one line, but for rounding.
  OsimFunction piecewise_linear(pugi::xml_node element) const {
    constexpr double kRounding = 1e-14;
    OsimFunction out = curve(element, "linear", false);
    if (out.constant) return out;
    const std::vector<double> x = xml_.numbers(element.child("x")), y = xml_.numbers(element.child("y"));
    const double slope = (y.back() - y.front()) / (x.back() - x.front());
    const double largest = std::max(std::abs(y.front()), std::abs(y.back()));
    for (std::size_t i = 1; i + 1 < x.size(); ++i)
      if (std::abs(y[i] - y.front() - slope * (x[i] - x.front())) > kRounding * largest) return out;
    const double offset = y.front() - slope * x.front();
    return linear_function({slope, std::abs(offset) > kRounding * largest ? offset : 0});
  }

  /// The coefficient of the highest power comes first.
  OsimFunction polynomial(pugi::xml_node element) const {
    const std::string& x = only_argument(element);
    const pugi::xml_node coefficients = element.child("coefficients");
    if (!coefficients) throw InputError(xml_.where(element), "no <coefficients> in a PolynomialFunction");
    const std::vector<double> c = xml_.numbers(coefficients);
    std::vector<std::string> terms;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const std::size_t power = c.size() - 1 - i;
      if (c[i] == 0) continue;
      if (power == 0)
        terms.push_back(number_text(c[i]));
      else
        terms.push_back(product_text(c[i], power == 1 ? x : fmt::format("{}^{}", x, power)));
    }
    if (terms.empty() || (terms.size() == 1 && c.back() != 0))
      return constant_function(c.empty() ? 0 : c.back());
    OsimFunction out;
    out.text = sum_text(terms);
    return out;
  }

  /// A coefficient for each product of powers up to an order, the power of the last variable growing first.
  OsimFunction multivariate_polynomial(pugi::xml_node element) const {
    const std::size_t variables = arguments_.size();
    if (xml_.number(element, "dimension", 0) != static_cast<double>(variables))
      throw InputError(
          xml_.where(element),
          fmt::format("the <dimension> of a {} is that of its variables, {}", element.name(), variables));
    const double order = xml_.number(element, "order", 0);
    const pugi::xml_node coefficients = element.child("coefficients");
    if (!coefficients)
      throw InputError(xml_.where(element), fmt::format("no <coefficients> in a {}", element.name()));
    std::vector<std::string> terms;
    std::vector<std::size_t> powers(variables, 0);
    bool moves = false, more = true;
    for (const double factor : xml_.numbers(coefficients)) {
      if (!more)
        throw InputError(xml_.where(coefficients),
                         fmt::format("more <coefficients> than terms of order {}", number_text(order)));
      std::string product;
      for (std::size_t i = 0; i < variables; ++i) {
        if (powers[i] == 0) continue;
        if (!product.empty()) product += "*";
        product += powers[i] == 1 ? arguments_[i] : fmt::format("{}^{}", arguments_[i], powers[i]);
      }
      if (factor != 0) {
        terms.push_back(product.empty() ? number_text(factor) : product_text(factor, product));
        moves = moves || !product.empty();
      }
      more = false;
      for (std::size_t i = variables; i-- > 0 && !more;) {
        ++powers[i];
        more = static_cast<double>(std::accumulate(powers.begin(), powers.end(), std::size_t{0})) <= order;
        if (!more) powers[i] = 0;
      }
    }
    if (more)
      throw InputError(xml_.where(coefficients),
                       fmt::format("fewer <coefficients> than terms of order {}", number_text(order)));
    OsimFunction out;
    out.text = sum_text(terms);
    if (!moves) return constant_function(terms.empty() ? 0 : xml_.numbers(coefficients)[0]);
    return out;
  }

  OsimFunction multiplier(pugi::xml_node element, int nesting) const {
    const pugi::xml_node inner = find_osim_function(element, "function");
    if (!inner || nesting == kMaximumNesting)
      throw InputError(xml_.where(element), inner ? "functions of functions are nested too deep"
                                                  : "no <function> in a MultiplierFunction");
    const double scale = xml_.number(element, "scale", 1);
    OsimFunction out = read(inner, nesting + 1);
    if (out.constant || scale == 0) return constant_function(scale == 0 ? 0 : scale * *out.constant);
    if (scale == 1) return out;
    if (out.linear) {
      const auto [factor, offset] = *out.linear;
      out.linear = {scale * factor, scale * offset};
      std::vector<std::string> terms{product_text(scale * factor, only_argument(element))};
      if (offset != 0) terms.push_back(number_text(scale * offset));
      out.text = sum_text(terms);
    } else {
      out.text = scaled_text(scale, out);
    }
    return out;
  }

  OsimFunction curve(pugi::xml_node element, const char* name, bool smooth) const {
    const std::string& argument = only_argument(element);
    const pugi::xml_node x = element.child("x"), y = element.child("y");
    if (!x || !y)
      throw InputError(xml_.where(element), fmt::format("no <{}> in {}", x ? "y" : "x", element.name()));
    const std::vector<double> knots = xml_.numbers(x), values = xml_.numbers(y, knots.size());
    if (knots.size() == 1) return constant_function(values[0]);
    if (knots.empty()) throw InputError(xml_.where(x), fmt::format("{} without points", element.name()));
    const auto second = std::ranges::adjacent_find(knots, [](double a, double b) { return !(a < b); });
    if (second != knots.end())
      throw InputError(xml_.where(x), fmt::format("knots must increase, and {} is followed by {}",
                                                  number_text(second[0]), number_text(second[1])));
    if (std::ranges::all_of(values, [&](double value) { return value == values[0]; }))
      return constant_function(values[0]);
    const auto list = [](const std::vector<double>& numbers) {
      std::vector<std::string> texts;
      for (const double number : numbers) texts.push_back(number_text(number));
      return fmt::format("[{}]", fmt::join(texts, ", "));
    };
    OsimFunction out;
    out.text = fmt::format("{}({}; {}; {})", name, argument, list(knots), list(values));
    out.smooth = smooth;
    return out;
  }

  OsimFunction sine(pugi::xml_node element) const {
    const double amplitude = xml_.number(element, "amplitude", 1), phase = xml_.number(element, "phase", 0),
                 offset = xml_.number(element, "offset", 0);
    const double omega = xml_.number(element, "omega", 1);
    std::vector<std::string> angle{product_text(omega, only_argument(element))};
    if (phase != 0) angle.push_back(number_text(phase));
    std::vector<std::string> terms{product_text(amplitude, fmt::format("sin({})", sum_text(angle)))};
    if (offset != 0) terms.push_back(number_text(offset));
    OsimFunction out;
    out.text = sum_text(terms);
    return out;
  }

  const OsimXml& xml_;
  const std::vector<std::string>& arguments_;
};

}  // namespace

OsimFunction read_osim_function(const OsimXml& xml, pugi::xml_node element,
                                const std::vector<std::string>& arguments) {
  return FunctionReader(xml, arguments).read(element, 0);
}

pugi::xml_node find_osim_function(pugi::xml_node owner, const char* property) {
  for (const pugi::xml_node child : owner.children()) {
    if (std::string_view(child.name()) == property) {
      const std::vector<pugi::xml_node> inner = OsimXml::elements(child);
      return inner.empty() ? pugi::xml_node() : inner[0];
    }
    if (child.attribute("name").value() == std::string_view(property)) return child;
  }
  return {};
}

std::string scaled_text(double factor, const OsimFunction& function) {
  const std::string& text = function.text;
  if (factor == 1) return text;
  // Calls and names need no parentheses: what has no operator outside of brackets.
  int depth = 0;
  bool sum = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' || text[i] == '[' ? 1 : text[i] == ')' || text[i] == ']' ? -1 : 0;
    sum = sum || (depth == 0 && (text[i] == '+' || text[i] == '-'));
  }
  const std::string of = sum ? "(" + text + ")" : text;
  return factor == -1 ? "-" + of : fmt::format("{}*{}", number_text(factor), of);
}

std::string sum_text(const std::vector<std::string>& terms) {
  std::string out;
  for (const std::string& term : terms) {
    if (out.empty())
      out = term;
    else if (term[0] == '-')
      out += " - " + term.substr(1);
    else
      out += " + " + term;
  }
  return out.empty() ? "0" : out;
}

std::string times_text(double factor, const std::string& of) {
  return factor == 1 ? of : fmt::format("{}*{}", number_text(factor), of);
}

std::string read_osim_expression(const OsimXml& xml, pugi::xml_node element, const char* property,
                                 const std::vector<OsimVariable>& variables) {
  constexpr std::string_view kFunctions[] = {"sqrt", "exp",  "log",  "sin",  "cos",  "tan", "asin", "acos",
                                             "atan", "sinh", "cosh", "tanh", "step", "min", "max",  "abs"};
  const pugi::xml_node found = xml.property(element, property);
  const std::string text = text_of_element(found);
  const auto is_digit = [](char c) { return ('0' <= c && c <= '9') || c == '.'; };
  const auto is_letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; };
  std::string out;
  bool moves = false;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (is_digit(text[i])) {
      while (end < text.size() && is_digit(text[end])) ++end;
      if (end + 1 < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        ++end;
        if (text[end] == '+' || text[end] == '-') ++end;
        while (end < text.size() && is_digit(text[end])) ++end;
      }
      out += text.substr(i, end - i);
    } else if (is_letter(text[i])) {
      while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
      const std::string word = text.substr(i, end - i);
      const auto variable = std::ranges::find(variables, word, &OsimVariable::name);
      moves = true;
      if (variable != variables.end())
        out += variable->text;
      else if (std::ranges::find(kFunctions, word) != std::end(kFunctions))
        out += word;
      else
        throw InputError(xml.where(found), fmt::format("'{}' in the <{}> of {} cannot be expressed",
                                                       printable(word), property, OsimXml::title(element)));
    } else if (std::string_view("+-*/^(), \t\n\r").find(text[i]) == std::string_view::npos) {
      throw InputError(xml.where(found),
                       fmt::format("'{}' in the <{}> of {} is no operation", printable(text.substr(i, 1)),
                                   property, OsimXml::title(element)));
    } else if (std::string_view(" \t\n\r").find(text[i]) == std::string_view::npos) {
      out += text[i];
    }
    i = end;
  }
  if (out.empty() || (!moves && out.find_first_not_of("0.+-") == std::string::npos)) return "0";
  return out;
}

}  // namespace alembert
