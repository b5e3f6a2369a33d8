// A scalar node in; an expression of the graph out, with its value at the initial state. Everything that can
// be wrong with an expression is found here, at the place of the subexpression that is wrong.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanism/document.hpp"
#include "mechanism/expression_grammar.hpp"
#include "mechanism/model.hpp"
#include "mechanism/scope.hpp"
#include "symbolic/expr.hpp"
#include "symbolic/matrix.hpp"

namespace alembert {

/// What an expression at some place may depend on.
enum class Allowed {
  constants,   ///< numbers and parameters that are folded in
  parameters,  ///< and runtime parameters
  motion,      ///< and coordinates and time
  transform,   ///< as motion, and must be twice differentiable
  pfaffian,    ///< as transform, and linear in the speeds
  holonomic,   ///< as transform, and positions of frames
  potential,   ///< as motion, and inputs, positions and rotations of frames, and lengths of paths
  force,       ///< and speeds, and whatever moves with them
};

class ExpressionReader {
 public:
  /// Speeds are those of the mechanism's coordinates; frames whose positions are used are noted in it.
  ExpressionReader(const Document& document, ExprGraph& graph, Scope& scope, Mechanism& mechanism)
      : document_(document), graph_(graph), scope_(scope), mechanism_(mechanism) {}
  /// One that knows what another does, for another document.
  ExpressionReader(const ExpressionReader& other, const Document& document)
      : document_(document),
        graph_(other.graph_),
        scope_(other.scope_),
        mechanism_(other.mechanism_),
        frames_(other.frames_),
        paths_(other.paths_) {}

  /// Reads one expression; `what` says for what (`the mass`).
  Quantity read(const YamlNode& node, Allowed allowed, std::string_view what);
  /// A list of three expressions.
  Vec3 read_vector(const YamlNode& node, Allowed allowed, std::string_view what);
  /// Of constants and runtime parameters; throws where it is negative or, if it is to be positive, 0.
  Expr coefficient(const YamlNode& node, std::string_view what, bool positive);
  /// A name that only some expressions know, and its symbol.
  struct LocalName {
    std::string name;
    Expr value;
    Dependence dependence = Dependence::local;
  };
  /// As read, with names that only this expression knows.
  Quantity read_with(const YamlNode& node, std::vector<LocalName> names, Allowed allowed,
                     std::string_view what);
  /// As read_with in a force; throws where it is known to be negative at the initial state.
  Expr coefficient_with(const YamlNode& node, std::vector<LocalName> names, std::string_view what);
  /// As read_vector, over constants, runtime parameters and the names given.
  Vec3 read_point(const YamlNode& node, std::vector<LocalName> names, std::string_view what);
  /// Makes the last frame of the mechanism known to expressions.
  void declare_last_frame();
  /// Makes a path known to expressions, by its length and what stands for the length's rate.
  void declare_path(const std::string& name, Expr length, Expr rate);
  /// Makes the tension of a declared path known.
  void set_tension(const std::string& name, const Quantity& tension);
  /// The frame of that name, an index into Mechanism::frames. Throws if there is none.
  int expect_frame(const YamlNode& name, std::string_view what);
  /// A quantity of a frame; its symbols are noted in the mechanism.
  const std::vector<Expr>& frame_symbols(int frame, FrameQuantity quantity);
  /// The same as a vector, or of its rotation as a matrix.
  Vec3 vector_of(int frame, FrameQuantity quantity);
  Mat3 rotation_of(int frame);
  /// The distance between the origins of two frames.
  Expr distance(int from, int to);

  const Document& document() const { return document_; }
  ExprGraph& graph() const { return graph_; }
  Scope& scope() const { return scope_; }

 private:
  struct Operand {
    Quantity value;
    std::size_t begin, end;  ///< of its text
  };
  /// What is being read, for messages.
  struct Reading {
    const YamlNode& node;
    Allowed allowed;
    std::string_view what;
    /// Texts of arguments of select(): what is not chosen may have no value.
    std::vector<std::pair<std::size_t, std::size_t>> choices = {};
    bool may_lack_value(const Operand& operation) const;
  };

  Quantity number(const Reading& reading, const PostfixToken& token) const;
  Quantity name(const Reading& reading, const PostfixToken& token) const;
  Quantity speed(const Reading& reading, const PostfixToken& token) const;
  Quantity reference(const Reading& reading, const PostfixToken& token);
  Quantity of_frame(const Reading& reading, const PostfixToken& token, FrameQuantity quantity);
  Quantity of_path(const Reading& reading, const PostfixToken& token, std::string_view word) const;
  int frame_called(const Reading& reading, std::size_t begin, std::size_t end) const;
  void check_reference(const Reading& reading, const PostfixToken& token, bool speeds) const;
  /// The entry of the coordinate whose speed is called `name` (qd_NAME; qd1 for q1), or null.
  NameEntry* coordinate_of_speed(const Reading& reading, std::size_t offset, std::string_view name) const;
  Quantity speed_of(const Reading& reading, std::size_t offset, NameEntry& coordinate,
                    std::string_view part) const;
  InputError unknown_name(const Reading& reading, std::size_t offset, std::string_view name) const;
  Expr checked_sign(const YamlNode& node, const Quantity& value, std::string_view what, bool positive) const;
  Operand binary(const Reading& reading, const PostfixToken& token, const Operand& a, const Operand& b) const;
  Operand call(const Reading& reading, const PostfixToken& token,
               const std::vector<Operand>& arguments) const;
  Operand table(const Reading& reading, const PostfixToken& token,
                const std::vector<Operand>& operands) const;
  static void choose(std::string_view function, const std::vector<Operand>& arguments, Operand& result);
  void check_power(const Reading& reading, const Operand& base, const Operand& exponent,
                   Operand& result) const;
  void check_call(const Reading& reading, std::string_view function, const Operand& x, Operand& result) const;
  InputError error(const Reading& reading, std::size_t offset, const std::string& message,
                   const std::string& note = {}) const;
  /// An operation makes a row of speeds anything but linear; `how` says what it does with them.
  InputError not_linear(const Reading& reading, const Operand& operation, std::string_view how) const;
  static void make_rough(Operand& result, const std::string& reason);
  std::string text_of(const Reading& reading, const Operand& operand) const;

  const Document& document_;
  ExprGraph& graph_;
  Scope& scope_;
  Mechanism& mechanism_;
  struct Path {
    Expr length, rate;
    std::optional<Quantity> tension = {};
  };
  std::vector<LocalName> locals_;
  std::map<std::string, int, std::less<>> frames_;  ///< indices into Mechanism::frames
  std::map<std::string, Path, std::less<>> paths_;
};

}  // namespace alembert
