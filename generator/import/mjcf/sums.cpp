#include "import/mjcf/sums.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "import/common/snapped_angle.hpp"

namespace alembert {

std::string sum_text(const std::vector<SumTerm>& terms) {
  std::string out;
  for (const auto& [factor, of] : terms) {
    if (factor == 0) continue;
    const double size = std::abs(factor);
    const std::string text = of.empty() ? number_text(size) : size == 1 ? of : number_text(size) + "*" + of;
    if (out.empty())
      out = factor < 0 ? "-" + text : text;
    else
      out += (factor < 0 ? " - " : " + ") + text;
  }
  return out.empty() ? "0" : out;
}

std::string polynomial_text(std::span<const double> c, const std::string& x) {
  std::vector<SumTerm> terms;
  for (std::size_t i = 0; i < c.size(); ++i)
    terms.push_back({c[i], i == 0 ? "" : i == 1 ? factor_text(x) : fmt::format("{}^{}", base_text(x), i)});
  return sum_text(terms);
}

std::string factor_text(const std::string& text) {
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth == 0 && c == ' ') return "(" + text + ")";
  }
  return text.starts_with('-') ? "(" + text + ")" : text;
}

std::string base_text(const std::string& text) {
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth == 0 && std::string_view(" +-*/^").find(c) != std::string_view::npos) return "(" + text + ")";
  }
  return text;
}

std::string product_text(double factor, const std::string& text) {
  if (factor == 1) return text;
  return number_text(factor) + "*" + factor_text(text);
}

std::string dot_text(const std::string (&row)[3], const std::string (&with)[3]) {
  std::string out;
  for (int i = 0; i < 3; ++i) {
    if (row[i] == "0" || with[i] == "0") continue;
    out += (out.empty() ? "" : " + ") + row[i] + "*" + factor_text(with[i]);
  }
  return out.empty() ? "0" : out;
}

void turn_into(const std::string& frame, std::string (&v)[3]) {
  std::string turned[3];
  for (int k = 0; k < 3; ++k) {
    const std::string row[3] = {fmt::format("rotation({}).x{}", frame, kAxes[k]),
                                fmt::format("rotation({}).y{}", frame, kAxes[k]),
                                fmt::format("rotation({}).z{}", frame, kAxes[k])};
    turned[k] = dot_text(row, v);
  }
  for (int k = 0; k < 3; ++k) v[k] = turned[k];
}

}  // namespace alembert
