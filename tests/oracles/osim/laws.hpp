// Functions of a model file of OpenSim, with two derivatives: the oracle's own reading of them.
#pragma once

#include <array>
#include <functional>
#include <pugixml.hpp>
#include <vector>

namespace alembert::oracles {

/// A function of several variables: weights and an offset, or a curve of the only variable.
struct Law {
  std::vector<double> weights;
  double offset = 0;
  std::function<std::array<double, 3>(double)> curve;  ///< value, first and second derivative
  /// Products of powers, that many of each variable, besides.
  std::vector<std::pair<double, std::vector<int>>> products;

  double value(const std::vector<double>& x) const;
  double first(const std::vector<double>& x, std::size_t i) const;
  double second(const std::vector<double>& x, std::size_t i, std::size_t j) const;
  Law times(double factor) const;
};

/// \param element    such as <SimmSpline>
/// \param variables  how many there are
Law read_law(pugi::xml_node element, std::size_t variables);

/// <SimmSpline name="property"/> among the children, or <property><SimmSpline/></property>.
pugi::xml_node law_element(pugi::xml_node owner, const char* property);

/// Numbers of an element's text.
std::vector<double> numbers_in(pugi::xml_node element);

}  // namespace alembert::oracles
