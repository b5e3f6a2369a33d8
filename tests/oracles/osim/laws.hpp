// Functions of a model file of OpenSim, with two derivatives: the oracle's own reading of them.
#pragma once

#include <Simbody.h>

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

/// A law as Simbody takes it.
class LawFunction : public SimTK::Function {
 public:
  LawFunction(Law law, std::size_t variables) : law_(std::move(law)), variables_(variables) {}
  SimTK::Real calcValue(const SimTK::Vector& x) const override;
  SimTK::Real calcDerivative(const SimTK::Array_<int>& along, const SimTK::Vector& x) const override;
  int getArgumentSize() const override { return static_cast<int>(variables_); }
  int getMaxDerivativeOrder() const override { return 2; }

 private:
  Law law_;
  std::size_t variables_;
};

}  // namespace alembert::oracles
