// Names of a description in (parameters, coordinates, definitions: one namespace); their values out. Knows
// which names exist but are not defined yet, and which were never used.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mechanism/document.hpp"
#include "support/error.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// What a value depends on, as written.
enum class Dependence : unsigned {
  none = 0,
  runtime_parameter = 1,
  coordinate = 2,
  time = 4,
  speed = 8,
  local = 16,
  input = 32,
  state = 64
};
constexpr Dependence operator|(Dependence a, Dependence b) {
  return static_cast<Dependence>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool includes(Dependence all, Dependence one) {
  return (static_cast<unsigned>(all) & static_cast<unsigned>(one)) != 0;
}
constexpr bool moves(Dependence d) {
  return includes(d, Dependence::coordinate) || includes(d, Dependence::time);
}

/// Why a value is not twice differentiable.
struct Roughness {
  std::size_t
      offset;  ///< in the expression's text: of the function to blame, or of the definition that holds it
  std::string reason;
  bool in_definition;  ///< the reason names the definition already
};

/// An expression with its value at the initial state (t = 0, coordinates at their initial values, runtime
/// parameters at their defaults).
struct Quantity {
  Expr expr;
  double initial = 0;  ///< NaN where there is none yet: positions of frames, names local to a shape
  Dependence dependence = Dependence::none;
  std::shared_ptr<const Roughness> roughness;  ///< null if the value may be used for a transform
};

enum class NameKind { parameter, runtime_parameter, input, state, coordinate, quaternion, definition };
/// `parameter 'r'`, `coordinate 'q'` ...
std::string_view noun(NameKind kind);
/// `a parameter`, `an input` ...
std::string a_noun(NameKind kind);

struct NameEntry {
  NameKind kind;
  SourceLocation where;
  Quantity value;  ///< valid once `ready`
  bool ready = false;
  bool used = false;
  int index = -1;  ///< of a coordinate, in Mechanism::coordinates
};

class Scope {
 public:
  /// Makes a name known. Throws if it is no fit name, reserved or taken.
  NameEntry& declare(const Document& document, const YamlNode& name, NameKind kind);
  NameEntry* find(std::string_view name);
  /// Names to choose from in a message, sorted.
  std::vector<std::string> names() const;
  /// Names of coordinates only.
  std::vector<std::string> coordinate_names() const;
  /// Warns of parameters, definitions and inputs that nothing uses, in file order.
  void check_used(Warnings& warnings) const;

 private:
  std::map<std::string, NameEntry, std::less<>> entries_;
  std::vector<const std::pair<const std::string, NameEntry>*> in_order_;
};

}  // namespace alembert
