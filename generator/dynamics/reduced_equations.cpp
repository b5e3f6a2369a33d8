// The shortest equations among those of several trees of motions (see the header).
#include "dynamics/reduced_equations.hpp"

#include <algorithm>

#include "dynamics/formulations.hpp"
#include "dynamics/rigid_links.hpp"
#include "symbolic/passes.hpp"

namespace alembert {

namespace {

std::size_t weight(std::span<const Expr> values) {
  const ExprCount n = count_operations(values);
  return n.total() + n.trig;
}

/// Keeps the list of equal values with fewer operations; the first where they are equal.
class Shortest {
 public:
  void offer(std::vector<Expr> values) {
    const std::size_t weight = alembert::weight(values);
    if (!values_.empty() && weight >= weight_) return;
    values_ = std::move(values);
    weight_ = weight;
  }
  std::size_t weight() const { return weight_; }
  std::vector<Expr> take() { return std::move(values_); }

 private:
  std::vector<Expr> values_;
  std::size_t weight_ = 0;
};

/// Trees of motions that describe the same dynamics, to be tried for Q and for M: as given, and with placed
/// frames and regrouped inertias.
struct ReducedTrees {
  std::vector<MotionTree> force, mass;
};

ReducedTrees reduced_trees(const Kinematics& kinematics, Passes passes) {
  ReducedTrees trees;
  const MotionTree& tree = passes.peeling && kinematics.peeled ? *kinematics.peeled : kinematics.tree;
  const auto add_both_forms = [&](MotionTree given) {
    trees.force.push_back(given);
    for (NodeMass& mass : given.masses) mass.forms.fill(MomentForm::inertia);
    trees.force.push_back(std::move(given));
  };
  add_both_forms(tree);
  trees.mass.push_back(tree);
  if (!passes.placement) return trees;
  const std::optional<RigidLinks> links = RigidLinks::of(kinematics.mechanism, tree, kinematics.graph);
  if (!links) return trees;
  const std::vector<Regrouping> as_given(links->links().size());
  add_both_forms(links->link_tree(as_given, kinematics.graph));
  trees.mass.push_back(links->link_tree(as_given, kinematics.graph));
  if (!passes.regrouping) return trees;
  trees.force.push_back(links->link_tree(choose_regroupings(*links), kinematics.graph));
  trees.mass.push_back(links->link_tree(minimal_regroupings(*links), kinematics.graph));
  return trees;
}

}  // namespace

EquationsOfMotion reduced_equations(const Kinematics& kinematics, Passes passes) {
  const Mechanism& mechanism = kinematics.mechanism;
  ExprGraph& graph = kinematics.graph;
  const ReducedTrees trees = reduced_trees(kinematics, passes);

  Shortest Q, M, c;
  std::vector<std::vector<Expr>> all;
  for (const MotionTree& tree : trees.force) {
    all.push_back(value_number(reduced_inverse_dynamics(mechanism, tree, graph)));
    Q.offer(all.back());
  }
  // The shortest c need not belong to the shortest Q, but a much longer one it does not.
  for (const std::vector<Expr>& forces : all) {
    if (weight(forces) <= Q.weight() + Q.weight() / 5)
      c.offer(value_number(bias_by_substitution(mechanism, forces, graph)));
  }
  for (const MotionTree& tree : trees.mass)
    M.offer(value_number(composite_mass_matrix(mechanism, tree, graph)));

  EquationsOfMotion equations;
  equations.formulation = Formulation::reduced;
  equations.Q = Q.take();
  // A column of M by `coefficient` is as long as the chain: the whole is only tried where there are few
  // speeds for the bodies.
  if (mechanism.nv <= 12 || mechanism.bodies.size() > 2 * static_cast<std::size_t>(mechanism.nv)) {
    M.offer(value_number(coefficient_mass_matrix(mechanism, equations.Q)));
  }
  equations.M = M.take();
  equations.c = c.take();
  return equations;
}

}  // namespace alembert
