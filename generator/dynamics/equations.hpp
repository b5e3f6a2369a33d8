// Stages `kinematics` and `equations`: typed mechanism in, equations of motion out.
//
// Letters: q coordinates, u speeds (qd), ud their rates (qdd), qdot = N(q) u; M(q) ud + c(q, u, t) = Q.
// A_i transform of body i in its parent, E_i its rotation, t_i its translation; W_i = W_p(i) A_i in the world.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mechanism/model.hpp"
#include "program/passes.hpp"
#include "program/program.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

enum class Formulation { factored, reduced };

/// The functions that can be asked for.
enum class FunctionKind { inverse_dynamics, mass_matrix, bias, mass_matrix_and_bias, forward_dynamics, coordinate_rates, energy, body_poses, frame_poses };

/// One function to be generated: its results as expressions over the bound symbols.
struct FunctionExpressions {
  FunctionKind kind;
  std::string name;
  Formulation formulation = Formulation::reduced;
  std::vector<OutputExpressions> outputs;
};

/// Symbols of a mechanism and the argument slots they stand for: q, qd, qdd, t, runtime parameters, wrenches, tau.
std::vector<SymbolBinding> symbol_bindings(const Mechanism& mechanism, ExprGraph& graph);

/// Equations of motion by one formulation.
struct EquationsOfMotion {
  Formulation formulation;
  std::vector<Expr> Q;  ///< nv: generalized forces for given q, u, ud
  std::vector<Expr> M;  ///< nv*nv, symmetric
  std::vector<Expr> c;  ///< nv
};

/// Throws InputError where the mechanism has no equations: a transform that is not twice differentiable, no rigid motion, a singular M.
EquationsOfMotion equations_of_motion(const Mechanism& mechanism, ExprGraph& graph, Formulation formulation);

/// The expressions of one function (mass_matrix_and_bias shares what M and c share; forward_dynamics is M, c and the L^T D L solve).
FunctionExpressions function_expressions(const Mechanism& mechanism, ExprGraph& graph, const EquationsOfMotion& equations, FunctionKind kind);

}  // namespace alembert
