// Expressions of the language, as text.
#pragma once

#include <span>
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

/// c[0] + c[1]*x + c[2]*x^2 and so on.
std::string polynomial_text(std::span<const double> c, const std::string& x);

/// A sum as a factor: in parentheses.
std::string factor_text(const std::string& text);

/// A base of a power: in parentheses, unless it is a name or a call.
std::string base_text(const std::string& text);

/// factor*text, or text alone where the factor is 1.
std::string product_text(double factor, const std::string& text);

/// The product of a row of three with three expressions.
std::string dot_text(const std::string (&row)[3], const std::string (&with)[3]);

/// Turns a vector in the axes of the world into those of a frame.
void turn_into(const std::string& frame, std::string (&v)[3]);

}  // namespace alembert
