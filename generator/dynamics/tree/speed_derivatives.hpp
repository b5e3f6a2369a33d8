// Derivatives along the speeds. In: expressions over coordinates and time. Out: D_k f = sum_a N_ak df/dq_a
// for each speed k (and D_t f for time), and the total time derivatives they make: fdot = sum_k D_k f u_k +
// D_t f.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "mechanism/model.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// Derivatives of several functions along one speed.
struct SpeedPartial {
  int speed;                 ///< index of the speed, or Mechanism::nv for time
  std::vector<Expr> values;  ///< one for each function, in their order
};

/// Computes derivatives along the speeds of one mechanism.
class SpeedDerivatives {
 public:
  SpeedDerivatives(const Mechanism& mechanism, ExprGraph& graph);

  /// Partials along every speed (and time) that the functions depend on, in ascending order, simplified.
  std::vector<SpeedPartial> partials(std::span<const Expr> functions) const;

  /// Whether one of the functions depends on a coordinate or on time.
  bool moves(std::span<const Expr> functions) const;

  /// d/dt of `functions` given their partials: sum_k D_k f u_k + D_t f.
  std::vector<Expr> first_rate(std::span<const SpeedPartial> partials, std::size_t count) const;
  /// Given g = sum_k D_k u_k (+ D_t), its rate: sum_k D_k ud_k + sum_kl (D_l D_k) u_k u_l, time counting as a
  /// speed that is 1.
  std::vector<Expr> second_rate(std::span<const SpeedPartial> partials, std::size_t count) const;
  /// The part of second_rate that has no rates: sum_kl (D_l D_k) u_k u_l.
  std::vector<Expr> quadratic_rate(std::span<const SpeedPartial> partials, std::size_t count) const;

  Expr speed(int index) const;  ///< u_k; 1 for time
  Expr rate(int index) const;   ///< ud_k; 0 for time
  int time_index() const { return time_index_; }
  /// How often D* reached its step cap and another method was kept.
  std::size_t d_star_gave_up() const { return d_star_gave_up_; }

  /// Of derivatives by the coordinates' symbols, those along the speeds, without simplification: a row of nv for each
  /// row of nq.
  std::vector<Expr> along_speeds(std::span<const Expr> by_coordinates) const;

  /// N(q), nq x nv row major: qdot = N u.
  std::vector<Expr> coordinate_rate_matrix() const;

 private:
  void add_quadratic_rate(std::span<const SpeedPartial> partials, std::vector<Expr>& result) const;

  struct Variable {
    Expr symbol;
    int coordinate;  ///< -1: time
    int component;
  };
  std::vector<SpeedPartial> derived(std::span<const Expr> functions) const;
  /// Indices into variables_ of those that the functions depend on, ascending.
  std::vector<int> variables_in(std::span<const Expr> functions) const;

  const Mechanism& mechanism_;
  ExprGraph& graph_;
  int time_index_;
  mutable std::size_t d_star_gave_up_ = 0;
  std::vector<Variable> variables_;      ///< all coordinates' symbols, then time
  std::vector<int> variable_of_symbol_;  ///< by symbol index; -1: not a variable
  std::vector<Expr> speeds_, rates_;
  mutable std::map<std::vector<std::uint32_t>, std::vector<SpeedPartial>> known_;  ///< by the functions' bits
};

/// Column `speed` (0..2) of N for a unit quaternion x y z w with qdot = 1/2 q (u, 0): four entries.
std::array<Expr, 4> quaternion_rate_column(std::span<const Expr> quaternion, int speed);

}  // namespace alembert
