// The shortest equations among those of several trees of motions (see the header).
#include "dynamics/choice/reduced_equations.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>

#include "dynamics/choice/conditioning.hpp"
#include "dynamics/choice/regrouping.hpp"
#include "dynamics/recursions/mass_matrix.hpp"
#include "dynamics/recursions/meeting_frames.hpp"
#include "dynamics/recursions/reduced.hpp"
#include "dynamics/rewrites/rigid_links.hpp"
#include "dynamics/rewrites/scaled_vectors.hpp"
#include "symbolic/count_operations.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/value_number.hpp"

namespace alembert {

namespace {

/// Nodes of expressions that may be written down in trying choices, for an effort of 1: some tenths of a
/// second.
constexpr double kWork = 100'000;

Length length_of(std::span<const Expr> values) {
  const OperationCount n = count_operations(values);
  return {n.all(), n.total()};
}

std::vector<Expr> joined(std::vector<Expr> values, const std::vector<Expr>& others) {
  values.insert(values.end(), others.begin(), others.end());
  return values;
}

/// How a tree of motions is to be written: on which tree it rests, and the choices that can be tried on it.
struct Form {
  const MotionTree* tree = nullptr;     ///< without links: this tree, ...
  const RigidLinks* links = nullptr;    ///< ... otherwise these, ...
  std::vector<Regrouping> regroupings;  ///< ... one for each
  bool inertia_moments = false;         ///< all moments in the form MomentForm::inertia
  FarPairs far = FarPairs::carry;       ///< how M is written
  std::vector<int> scaled;              ///< turns that are scaled
  std::vector<int> ahead;               ///< those of them for which the rotations before them scale
};

WrittenTree tree_of(const Form& form, ExprGraph& graph) {
  WrittenTree written =
      form.links != nullptr ? form.links->link_tree(form.regroupings, graph) : WrittenTree(*form.tree);
  if (form.inertia_moments) {
    for (MomentForms& forms : written.moments) forms.fill(MomentForm::inertia);
  }
  written.scaling = Scaling(written.tree, form.scaled, form.ahead);
  return written;
}

/// Constant turns of a form that can be scaled: all of them, and without those of the first link, of whose
/// force only the moment about one axis is wanted.
std::vector<std::vector<int>> scalings(const Form& form, ExprGraph& graph) {
  const MotionTree tree = tree_of(form, graph).tree;
  const std::vector<int> turns = scalable_turns(tree);
  std::vector<int> later;
  std::vector<int> moving;  // moving frames on the way to the world
  for (const MotionNode& node : tree.nodes) {
    const int before = node.parent < 0 ? 0 : moving[static_cast<std::size_t>(node.parent)];
    moving.push_back(before + (node.partials.empty() ? 0 : 1));
  }
  std::copy_if(turns.begin(), turns.end(), std::back_inserter(later),
               [&](int turn) { return moving[static_cast<std::size_t>(turn)] >= 2; });
  std::vector<std::vector<int>> out;
  if (!turns.empty()) out.push_back(turns);
  if (!later.empty() && later != turns) out.push_back(later);
  return out;
}

/// Takes an element out of an ascending list, or puts it in.
void toggle(std::vector<int>& list, int element) {
  const auto at = std::lower_bound(list.begin(), list.end(), element);
  if (at != list.end() && *at == element) {
    list.erase(at);
  } else {
    list.insert(at, element);
  }
}

/// The shortest of the lists of equal values that forms give, of those that are well conditioned, and the
/// form it came from.
class Search {
 public:
  using Equations = std::vector<Expr> (*)(const Mechanism&, const WrittenTree&, ExprGraph&, FarPairs);
  /// `has_pairs`: the equations depend on Form::far.
  Search(const Kinematics& kinematics, Equations equations, bool has_pairs)
      : kinematics_(kinematics),
        equations_(equations),
        has_pairs_(has_pairs),
        conditioning_(kinematics,
                      equations(kinematics.mechanism, kinematics.tree, kinematics.graph, FarPairs::carry)) {}

  bool try_form(const Form& form) {
    const WrittenTree tree = tree_of(form, kinematics_.graph);
    const std::vector<Expr> raw = equations_(kinematics_.mechanism, tree, kinematics_.graph, form.far);
    std::vector<Expr> values = value_number(raw);
    work_ += static_cast<double>(postorder(raw).size());
    if (values == best_ || is_near(values)) return false;
    // What was tried first is what there is, unless it lost what the description says: bounds alone may be pessimistic.
    const bool is_first = best_.empty();
    const bool good = is_first ? conditioning_.has_values(values) : conditioning_.is_good(values);
    if (!is_first && !good) return false;
    const std::size_t plain = length_of(values).first;
    if (is_first) small_ = plain <= kSmall;
    if (good_ && is_far_longer(plain, plain_)) return false;
    const std::optional<std::size_t> length = length_if_kept(values);
    if (!length) return false;
    const std::size_t here = *length;
    if (good_ && (here > least_ || (here == least_ && plain >= plain_))) {
      keep_near(here, std::move(values));
      return false;
    }
    if (good_) keep_near(least_, std::move(best_));
    good_ = good;
    best_ = std::move(values);
    least_ = here;
    plain_ = plain;
    form_ = form;
    return true;
  }

  /// Whether values that were found in another way are those of the plain equations.
  bool has_values(const std::vector<Expr>& values) const { return conditioning_.has_values(values); }
  /// Whether what was found has them.
  bool is_good() const { return good_; }
  Length measure(const std::vector<Expr>& values) const {
    return small_ ? kinematics_.lengths.of(values) : length_of(values);  // programs of long lists take long
  }
  /// Tries a form with its far pairs as they are estimated to be best. The estimate is right about long
  /// lists; in others it is tried what is best.
  void offer(Form form) {
    form.far = FarPairs::meet;
    try_form(form);
    if (!has_pairs_ || least_ > kMeeting) return;
    if (least_ > kRefined) {
      form.far = FarPairs::meet_sooner;
      try_form(form);
    }
    form.far = FarPairs::carry;
    try_form(form);
  }

  void offer_scaled() {
    const Form from = form_;
    for (const std::vector<int>& turns : scalings(from, kinematics_.graph)) {
      Form scaled = from;
      scaled.scaled = turns;
      offer(scaled);
      if (has_pairs_) continue;  // M has no angular velocities
      scaled.ahead = turns;
      offer(scaled);
    }
  }

  /// Tries one change after another, each kept where it gains, until none does or the work is done.
  void refine(const Passes& passes, const std::vector<std::vector<Regrouping>>& candidates) {
    // A trial of a long list takes all of the work and changes little of it.
    if (least_ > kRefined && passes.effort <= 1) return;
    const double limit = work_ + passes.effort * kWork;
    const auto room = [&] { return work_ < limit; };
    std::vector<int> turns;
    if (passes.scaling) turns = scalable_turns(best_tree().tree);
    for (bool better = true; better && room();) {
      better = false;
      for (const int turn : turns) {
        if (!room()) break;
        Form other = form_;
        toggle(other.scaled, turn);
        better = try_form(other) || better;
        if (has_pairs_ || !std::binary_search(form_.scaled.begin(), form_.scaled.end(), turn)) continue;
        other = form_;
        toggle(other.ahead, turn);
        better = try_form(other) || better;
      }
      if (form_.links == nullptr) continue;
      for (std::size_t i = form_.regroupings.size(); i-- > 0;) {
        for (unsigned mask = 0; mask < 8 && room(); ++mask) {
          Form other = form_;
          for (std::size_t k = 0; k < 3; ++k) {
            other.regroupings[i].forms[k] =
                (mask >> k & 1u) != 0 ? MomentForm::inertia : MomentForm::pseudo_inertia;
          }
          if (other.regroupings[i].forms != form_.regroupings[i].forms) better = try_form(other) || better;
        }
        if (candidates.empty()) continue;
        for (const Regrouping& how : candidates[i]) {
          if (!room()) break;
          Form other = form_;
          other.regroupings[i] = how;
          other.regroupings[i].forms = form_.regroupings[i].forms;
          better = try_form(other) || better;
        }
      }
    }
  }

  std::vector<Expr> best() const { return best_; }
  WrittenTree best_tree() const { return tree_of(form_, kinematics_.graph); }
  /// Other lists that are hardly longer, the shortest first.
  std::vector<std::vector<Expr>> near_ones() const {
    std::vector<std::vector<Expr>> out;
    for (const Near& list : near_) {
      if (list.length <= near_limit()) out.push_back(list.values);
    }
    return out;
  }

 private:
  struct Near {
    std::size_t length;
    std::vector<Expr> values;
  };

  /// Operations of what may be the best list or one of those near it.
  std::optional<std::size_t> length_if_kept(const std::vector<Expr>& values) {
    if (!small_) return length_of(values).first;
    std::size_t most = std::numeric_limits<std::size_t>::max();
    if (good_) most = near_.size() == kNear ? std::min(near_limit(), near_.back().length) : near_limit();
    const std::optional<Length> length = kinematics_.lengths.within(most, values, trend_);
    return length ? std::optional(length->first) : std::nullopt;
  }
  std::size_t near_limit() const { return least_ + least_ / 20; }
  bool is_near(const std::vector<Expr>& values) const {
    return std::any_of(near_.begin(), near_.end(), [&](const Near& list) { return list.values == values; });
  }
  // Of lists of one length those that were found first are kept.
  void keep_near(std::size_t length, std::vector<Expr> values) {
    const auto at = std::upper_bound(near_.begin(), near_.end(), length,
                                     [](std::size_t one, const Near& list) { return one < list.length; });
    near_.insert(at, {length, std::move(values)});
    if (near_.size() > kNear) near_.pop_back();
  }

  static constexpr std::size_t kSmall = 20000, kMeeting = 10000, kRefined = 1000;
  static constexpr std::size_t kNear = 12;

  const Kinematics& kinematics_;
  Equations equations_;
  bool has_pairs_;
  Conditioning conditioning_;
  bool good_ = false;
  bool small_ = false;  ///< programs are counted, not expressions
  Form form_;
  std::vector<Expr> best_;
  std::size_t least_ = ~std::size_t{0} / 4;
  std::size_t plain_ = 0;
  double work_ = 0;
  std::vector<Near> near_;  ///< by length
  LengthTrend trend_;
};

/// The shortest lists of those that were added.
class Shortest {
 public:
  explicit Shortest(std::function<Length(const std::vector<Expr>&)> measure) : measure_(std::move(measure)) {}

  void add(std::vector<Expr> values) {
    if (std::find(lists_.begin(), lists_.end(), values) != lists_.end()) return;
    const Length length = measure_(values);
    if (lists_.empty() || length < least_) {
      lists_.clear();
      least_ = length;
    }
    if (length == least_ && lists_.size() < kMost) lists_.push_back(std::move(values));
  }
  const std::vector<std::vector<Expr>>& lists() const { return lists_; }

 private:
  static constexpr std::size_t kMost = 4;
  std::function<Length(const std::vector<Expr>&)> measure_;
  std::vector<std::vector<Expr>> lists_;
  Length least_;
};

}  // namespace

EquationsOfMotion reduced_equations(const Kinematics& kinematics, Passes passes) {
  const Mechanism& mechanism = kinematics.mechanism;
  ExprGraph& graph = kinematics.graph;
  const MotionTree& tree = passes.peeling && kinematics.peeled ? *kinematics.peeled : kinematics.tree;
  std::optional<RigidLinks> links;
  if (passes.placement) links.emplace(mechanism, tree, graph);

  Search forces(
      kinematics,
      [](const Mechanism& m, const WrittenTree& t, ExprGraph& g, FarPairs) {
        return reduced_inverse_dynamics(m, t, g);
      },
      false);
  Search masses(kinematics, composite_mass_matrix, true);
  const auto offer_both_moments = [&](Form form) {
    forces.offer(form);
    form.inertia_moments = true;
    forces.offer(form);
  };
  Form given;
  given.tree = &tree;
  offer_both_moments(given);
  masses.offer(given);
  Form as_described;
  as_described.tree = &kinematics.tree;
  if (!forces.is_good()) offer_both_moments(as_described);
  if (!masses.is_good()) masses.offer(as_described);
  const std::vector<Expr> given_forces = forces.best();
  RegroupingChoices choices;
  if (links) {
    Form placed;
    placed.links = &*links;
    placed.regroupings.resize(links->links().size());
    offer_both_moments(placed);
    masses.offer(placed);
    if (passes.regrouping) {
      choices = regrouping_choices(*links);
      placed.regroupings = choices.chosen;
      forces.offer(placed);
      placed.regroupings = minimal_regroupings(*links);
      masses.offer(placed);
      if (links->has_terms()) {
        choices = regrouping_choices(*links, true);
        placed.regroupings = choices.chosen;
        forces.offer(placed);
        placed.regroupings = minimal_regroupings(*links, true);
        masses.offer(placed);
      }
    }
  }
  if (passes.scaling) {
    forces.offer_scaled();
    masses.offer_scaled();
  }
  forces.refine(passes, choices.candidates);
  masses.refine(passes, {});

  EquationsOfMotion equations;
  equations.formulation = Formulation::reduced;
  equations.Q = forces.best();
  equations.tree = forces.best_tree();
  if (passes.articulation) equations.articulated = masses.best_tree().tree;
  Shortest M([&](const std::vector<Expr>& values) { return masses.measure(values); });
  Shortest c([&](const std::vector<Expr>& values) { return forces.measure(values); });
  M.add(masses.best());
  const auto add_mass_matrix_of = [&](const std::vector<Expr>& Q) {
    std::vector<Expr> values = value_number(coefficient_mass_matrix(mechanism, Q));
    if (masses.has_values(values)) M.add(std::move(values));
  };
  c.add(value_number(bias_by_substitution(mechanism, equations.Q, graph)));
  // A column of M by `coefficient` is as long as the chain: the whole is only tried where there are few
  // speeds for the bodies.
  if (mechanism.nv <= 12 || mechanism.bodies.size() > 2 * static_cast<std::size_t>(mechanism.nv))
    add_mass_matrix_of(equations.Q);
  // Where little is gained by placing and regrouping for Q, M may be shorter without.
  if (mechanism.nv <= 6) add_mass_matrix_of(given_forces);
  // The shortest c need not belong to the shortest Q, but to a much longer one it does not. Nor need the
  // shortest M.
  for (const std::vector<Expr>& Q : forces.near_ones()) {
    if (mechanism.nv <= 6) add_mass_matrix_of(Q);
    c.add(value_number(bias_by_substitution(mechanism, Q, graph)));
  }
  // Of several the two that share most.
  Length least;
  for (const std::vector<Expr>& masses_of_pair : M.lists()) {
    for (const std::vector<Expr>& bias_of_pair : c.lists()) {
      const bool only = M.lists().size() * c.lists().size() == 1;
      const Length length = only ? Length() : masses.measure(joined(masses_of_pair, bias_of_pair));
      if (!equations.M.empty() && length >= least) continue;
      least = length;
      equations.M = masses_of_pair;
      equations.c = bias_of_pair;
    }
  }
  return equations;
}

}  // namespace alembert
