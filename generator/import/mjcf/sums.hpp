// Expressions of the language, as text.
#pragma once

#include <string>
#include <vector>

namespace alembert {

inline constexpr const char* kAxes[] = {"x", "y", "z"};

struct SumTerm {
  double factor;
  std::string of;  ///< a product, or nothing: the factor is a term of its own
};

/// `2*a - b + 3`; terms with the factor 0 are left out.
std::string sum_text(const std::vector<SumTerm>& terms);

/// A sum as a factor: in parentheses.
std::string factor_text(const std::string& text);

/// factor*text, or text alone where the factor is 1.
std::string product_text(double factor, const std::string& text);

/// The product of a row of three with three expressions.
std::string dot_text(const std::string (&row)[3], const std::string (&with)[3]);

}  // namespace alembert
