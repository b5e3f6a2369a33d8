#include "dynamics/choice/axis_form.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "alembert/mechanism.hpp"
#include "dynamics/choice/force_derivatives.hpp"
#include "dynamics/recursions/armature.hpp"
#include "dynamics/rewrites/rigid_links.hpp"
#include "dynamics/tree/motion_tree.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/extended.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {
namespace {

/// Values of constants; nothing if one is none.
std::optional<std::vector<Extended>> constant_numbers(std::span<const Expr> values) {
  if (!std::ranges::all_of(values, &Expr::is_constant)) return std::nullopt;
  return evaluate_extended(values, std::span<const Extended>());
}

/// The rows of a tree of motions.
class AxisRows {
 public:
  AxisRows(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph)
      : mechanism_(mechanism), tree_(tree), graph_(graph), rows_of_(tree.nodes.size(), kNone) {}

  /// Whether the tree is one of axes.
  bool find() {
    std::vector<std::vector<std::size_t>> children(tree_.nodes.size());
    std::vector<std::size_t> waiting;
    for (std::size_t i = tree_.nodes.size(); i-- > 0;) {
      const int parent = tree_.nodes[i].parent;
      (parent < 0 ? waiting : children[static_cast<std::size_t>(parent)]).push_back(i);
    }
    while (!waiting.empty()) {
      const std::size_t node = waiting.back();
      waiting.pop_back();
      if (!add(node)) return false;
      std::ranges::copy(children[node], std::back_inserter(waiting));
    }
    std::vector<int> found = table_.speeds;
    std::ranges::sort(found);
    for (int k = 0; k < mechanism_.nv; ++k)
      if (k >= static_cast<int>(found.size()) || found[static_cast<std::size_t>(k)] != k) return false;
    return static_cast<int>(found.size()) == mechanism_.nv;
  }

  const AxisTable& table() const { return table_; }

  /// As AxisForm::frames.
  std::vector<Expr> frames() const {
    const std::size_t nodes = tree_.nodes.size(), n = table_.speeds.size();
    const Pose world = identity_pose(graph_);
    // Of each node its rotation in the world, and what its motion shifts it by, in world axes.
    std::vector<Pose> steps;
    for (const MotionNode& node : tree_.nodes) {
      const Mat3& before =
          node.parent < 0 ? world.rotation : steps[static_cast<std::size_t>(node.parent)].rotation;
      steps.push_back(moved({before, world.origin}, node.motion));
    }
    std::vector<std::optional<Vec3>> places(nodes);
    std::optional<Vec3> of_world;
    const auto place_of_parent = [&](std::size_t i) -> std::optional<Vec3>& {
      const int parent = tree_.nodes[i].parent;
      return parent < 0 ? of_world : places[static_cast<std::size_t>(parent)];
    };
    const std::size_t middle = nodes_[middle_row()];
    places[middle] = world.origin;
    for (std::size_t at = middle;; at = static_cast<std::size_t>(tree_.nodes[at].parent)) {
      place_of_parent(at) = *places[at] - steps[at].origin;
      if (tree_.nodes[at].parent < 0) break;
    }
    for (std::size_t i = 0; i < nodes; ++i)
      if (!places[i]) places[i] = *place_of_parent(i) + steps[i].origin;
    std::vector<Expr> out(12 * n, graph_.zero());
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) out[(4 * r + c) * n + k] = steps[nodes_[k]].rotation(r, c);
        out[(4 * r + 3) * n + k] = (*places[nodes_[k]])[r];
      }
    return out;
  }

 private:
  static constexpr int kNone = -1;

  bool add(std::size_t i) {
    const MotionNode& node = tree_.nodes[i];
    int carrier = node.parent < 0 ? kNone : rows_of_[static_cast<std::size_t>(node.parent)];
    const bool turns = node.motion.kind != MotionKind::translation;
    const std::size_t count = node.partials.size();
    if (turns && count != 0 && count != 1 && count != 3) return false;
    for (std::size_t k = 0; k < count; ++k) {
      const TwistPartial& partial = node.partials[k];
      const auto direction = constant_numbers(partial.direction.entries);
      if (partial.speed >= mechanism_.nv || !direction) return false;
      table_.speeds.push_back(partial.speed);
      table_.parents.push_back(carrier);
      carrier = static_cast<int>(nodes_.size());
      nodes_.push_back(i);
      for (std::size_t c = 0; c < 3; ++c)
        table_.directions[c].push_back((*direction)[c].convert_to<double>());
      table_.turns.push_back(turns);
      table_.first_of_three.push_back(turns && count == 3 && k == 0);
      table_.masses.push_back(0);
      for (std::vector<double>& entries : table_.centers) entries.push_back(0);
      for (std::vector<double>& entries : table_.inertias) entries.push_back(0);
    }
    rows_of_[i] = carrier;
    return add_mass(tree_.masses[i], carrier, count > 0);
  }

  /// \param moves  whether the frame of the row is that of the node
  bool add_mass(const NodeMass& given, int row, bool moves) {
    if (given.is_zero() || row == kNone) return true;
    std::vector<Expr> values{given.mass};
    std::ranges::copy(given.moment.entries, std::back_inserter(values));
    std::ranges::copy(given.inertia.entries, std::back_inserter(values));
    const auto found = constant_numbers(values);
    if (!found || !moves) return false;
    const Extended mass = (*found)[0];
    Vector3e center = Vector3e::Zero();
    for (int c = 0; c < 3; ++c) {
      const Extended moment = (*found)[static_cast<std::size_t>(1 + c)];
      if (mass == 0 && moment != 0) return false;
      if (mass != 0) center[c] = moment / mass;
    }
    Matrix3e inertia = -mass * (center.squaredNorm() * Matrix3e::Identity() - center * center.transpose());
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) inertia(r, c) += (*found)[static_cast<std::size_t>(4 + 3 * r + c)];
    const auto at = static_cast<std::size_t>(row);
    table_.masses[at] = mass.convert_to<double>();
    for (int c = 0; c < 3; ++c)
      table_.centers[static_cast<std::size_t>(c)][at] = center[c].convert_to<double>();
    constexpr std::array<std::pair<int, int>, 6> kEntries{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
    for (std::size_t e = 0; e < kEntries.size(); ++e)
      table_.inertias[e][at] = inertia(kEntries[e].first, kEntries[e].second).convert_to<double>();
    return true;
  }

  /// The row from which it is the fewest rows to the farthest.
  std::size_t middle_row() const {
    const auto n = static_cast<int>(table_.parents.size());
    const auto parent = [&](int row) { return table_.parents[static_cast<std::size_t>(row)]; };
    int best = 0, fewest = std::numeric_limits<int>::max();
    for (int from = 0; from < n; ++from) {
      // Those that carry it come before it, all others after one that is as far as known.
      std::vector<int> steps(static_cast<std::size_t>(n), kNone);
      int count = 0;
      for (int at = from; at != kNone; at = parent(at)) steps[static_cast<std::size_t>(at)] = count++;
      const int of_roots = count;
      int farthest = 0;
      for (int k = 0; k < n; ++k) {
        int& own = steps[static_cast<std::size_t>(k)];
        if (own == kNone)
          own = 1 + (parent(k) == kNone ? of_roots : steps[static_cast<std::size_t>(parent(k))]);
        farthest = std::max(farthest, own);
      }
      if (farthest >= fewest) continue;
      fewest = farthest;
      best = from;
    }
    return static_cast<std::size_t>(best);
  }

  const Mechanism& mechanism_;
  const MotionTree& tree_;
  ExprGraph& graph_;
  AxisTable table_;
  std::vector<std::size_t> nodes_;  ///< of each row
  std::vector<int> rows_of_;        ///< of each node the row that it moves with
};

}  // namespace

std::optional<AxisForm> axis_form(const Kinematics& kinematics) {
  const Mechanism& mechanism = kinematics.mechanism;
  ExprGraph& graph = kinematics.graph;
  const auto gravity = constant_numbers(mechanism.gravity.entries);
  const auto inertias = constant_numbers(armatures(mechanism));
  const bool pushed = std::ranges::any_of(mechanism.bodies, &Body::external_wrench);
  if (mechanism.nv < detail::kFewestByAxes || mechanism.nv > kMostAxes || !gravity || !inertias || pushed)
    return std::nullopt;

  std::optional<AxisForm> best;
  std::size_t fewest = 0;
  const auto offer = [&](const MotionTree& tree) {
    AxisRows rows(mechanism, tree, graph);
    if (!rows.find()) return;
    std::vector<Expr> frames = value_number(rows.frames());
    const std::size_t operations = count_operations(frames).total();
    if (best && operations >= fewest) return;
    fewest = operations;
    best = AxisForm{rows.table(), std::move(frames), {}, {}};
  };
  for (const MotionTree* tree : {&kinematics.tree, kinematics.peeled ? &*kinematics.peeled : nullptr}) {
    if (tree == nullptr) continue;
    offer(*tree);
    const RigidLinks links(mechanism, *tree, graph);
    offer(links.link_tree(std::vector<Regrouping>(links.links().size()), graph).tree);
  }
  if (!best) return std::nullopt;
  for (std::size_t c = 0; c < 3; ++c) best->table.gravity[c] = (*gravity)[c].convert_to<double>();
  for (const int speed : best->table.speeds)
    best->table.armatures.push_back((*inertias)[static_cast<std::size_t>(speed)].convert_to<double>());
  if (const std::vector<Expr>& Q = kinematics.applied.Q;
      std::ranges::any_of(Q, [](Expr x) { return !x.is_zero(); })) {
    const std::vector<Expr> both = derivatives_of_the_whole(kinematics, Q);
    const std::vector<int>& speeds = best->table.speeds;
    const std::size_t n = speeds.size();
    const auto speed = [&](std::size_t row) { return static_cast<std::size_t>(speeds[row]); };
    for (std::size_t row = 0; row < n; ++row) best->Q.push_back(Q[speed(row)]);
    for (std::size_t k = 0; k < 2 * n * n; ++k) {
      const Expr change = both[k / (n * n) * n * n + speed(k / n % n) * n + speed(k % n)];
      if (change.is_zero()) continue;
      best->table.force_entries.push_back(static_cast<int>(k));
      best->changes.push_back(change);
    }
    // Of forces that nothing changes: an array of nothing is none.
    if (best->changes.empty()) {
      best->table.force_entries.push_back(0);
      best->changes.push_back(graph.zero());
    }
  }
  return best;
}

}  // namespace alembert
