// Functions of OpenSim as expressions of the language.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "import/opensim/osim_xml.hpp"

namespace alembert {

struct OsimFunction {
  std::string text;                ///< an expression; a sum stands without parentheses
  std::optional<double> constant;  ///< its value, if it has one
  /// Factor and offset, if it is factor * argument + offset of its only argument.
  std::optional<std::array<double, 2>> linear;
  bool smooth = true;  ///< twice differentiable
  bool simple() const { return constant.has_value() || linear.has_value(); }
};

/// \param element    such as <SimmSpline>
/// \param arguments  names, or expressions that need no parentheses
/// Throws InputError at a function that the language has no words for.
OsimFunction read_osim_function(const OsimXml& xml, pugi::xml_node element,
                                const std::vector<std::string>& arguments);

/// The element of a function that is a property: <function><Constant/></function>, or <Constant
/// name="function"/> among the children. Null if there is none.
pugi::xml_node find_osim_function(pugi::xml_node owner, const char* property);

/// What a variable of an expression in a model stands for.
struct OsimVariable {
  std::string_view name;
  std::string text;  ///< which needs no parentheses
};

/// A property that is an expression of variables; 0 if there is none. Throws InputError at words that are neither
/// variables nor functions that the language has.
std::string read_osim_expression(const OsimXml& xml, pugi::xml_node element, const char* property,
                                 const std::vector<OsimVariable>& variables);

/// factor * text, of which the text is a factor itself.
std::string times_text(double factor, const std::string& of);

/// factor * (text) as a term of a product or sum.
std::string scaled_text(double factor, const OsimFunction& function);

/// The sum of terms, of which any may be negative; 0 if there are none.
std::string sum_text(const std::vector<std::string>& terms);

}  // namespace alembert
