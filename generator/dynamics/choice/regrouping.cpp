// Which entries of the inertias to zero (rigid_links.hpp), decided by counting. What an inertia costs depends
// only on which of its entries are zero, where it is written down, and what moves there: so the cost of a
// link is that of a small model of it, kept by pattern. Entries that have runtime terms cost what puts them
// together besides.
#include "dynamics/choice/regrouping.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

#include "dynamics/recursions/body_forces.hpp"
#include "dynamics/rewrites/rigid_links.hpp"
#include "symbolic/count_operations.hpp"

namespace alembert {

namespace {

constexpr std::size_t kMass = 9, kHz = 8, kKzz = 2;
constexpr unsigned bit(std::size_t i) {
  return 1u << i;
}

/// What the cost of a link depends on.
struct LinkPattern {
  unsigned entries = 0;  ///< nonzero entries of the remaining inertia
  unsigned terms = 0;    ///< those of them that have runtime terms
  unsigned points = 0;   ///< point masses at the frames
  MassFrame frame = MassFrame::joint;
  bool first = false;  ///< it turns about an axis that stands still, and only the moment about it is wanted
  bool child = false, twisted = false, length = false, offset = false;
  auto key() const {
    return std::tuple(entries, terms, points, frame, first, child, twisted, length, offset);
  }
};

Vec3 symbols(ExprGraph& g, const std::string& name) {
  return {{g.symbol(name + "x"), g.symbol(name + "y"), g.symbol(name + "z")}};
}

/// Operations of the forces of one link: the inertia's, the shifts of acceleration towards the main child and
/// of forces back.
std::size_t pattern_cost(const LinkPattern& p, const MomentForms& forms) {
  ExprGraph g;
  const Expr zero = g.zero();
  // Constants of no particular value: sums and products of them are folded, as they are in the real
  // expressions.
  std::int64_t next = 1;
  const auto number = [&] { return g.rational(Rational(next += 2, 1009)); };
  const auto frame_motion = [&](const std::string& name, bool tilted) {
    Vec3 om = symbols(g, name + "w"), al = symbols(g, name + "a");
    if (p.first) {
      om[0] = al[0] = zero;
      if (!tilted) om[1] = al[1] = zero;
    }
    return FrameMotion(om, al, symbols(g, name + "v"));
  };
  const FrameMotion joint = frame_motion("j", false);
  const FrameMotion twist = p.twisted ? frame_motion("t", true) : joint;
  const Vec3 length{{p.length ? number() : zero, zero, zero}};
  const Vec3 offset{{zero, zero, p.offset ? number() : zero}};
  std::array<FrameMotion, 4> motions{joint, twist, twist, twist};
  motions[2].acc = twist.at(length);
  motions[3].acc = motions[2].at(offset);

  NodeMass mass{zero, zeros<3, 1>(g), zeros<3, 3>(g)};
  const auto is_term = [&](std::size_t e) { return (p.terms & bit(e)) != 0; };
  const auto entry = [&](std::size_t e) {
    if (is_term(e)) return g.symbol("e" + std::to_string(e));
    return (p.entries & bit(e)) != 0 ? number() : zero;
  };
  const std::array<Expr, 3> K{entry(0), entry(1), entry(2)};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    // With runtime terms the sum is what is given, and K is made of it.
    mass.inertia(i, i) = is_term(j) || is_term(k) ? g.symbol("J" + std::to_string(i)) : K[j] + K[k];
  }
  const std::array<std::size_t, 3> rows{0, 0, 1}, columns{1, 2, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    mass.inertia(rows[k], columns[k]) = mass.inertia(columns[k], rows[k]) = -entry(3 + k);
  }
  mass.moment = {{entry(6), entry(7), entry(8)}};
  mass.mass = entry(9);

  std::array<Wrench, 4> at;
  for (std::size_t k = 0; k < 4; ++k) {
    at[k] = zero_wrench(g);
    if ((p.points & bit(k)) != 0) at[k].force = number() * motions[k].acc;
    if (kMassFrames[k] == p.frame) at[k] = at[k] + inertia_forces(motions[k], mass, forms, g);
  }
  Wrench total = zero_wrench(g);
  if (p.child) total = {symbols(g, "n"), symbols(g, "f")};
  total = at_offset(total + at[3], offset);
  total = at_offset(total + at[2], length);
  total = total + at[1];
  std::vector<Expr> roots;
  if (p.first) {
    // Turned back by the twist, only the moment about the axis is wanted.
    Expr moment = p.twisted ? number() * total.moment[2] : total.moment[2];
    if (p.twisted) moment += number() * total.moment[1];
    roots.push_back(moment + at[0].moment[2]);
  } else {
    if (p.twisted) {
      roots.insert(roots.end(), at[0].force.entries.begin(), at[0].force.entries.end());
      roots.insert(roots.end(), at[0].moment.entries.begin(), at[0].moment.entries.end());
    } else {
      total = total + at[0];
    }
    roots.insert(roots.end(), total.force.entries.begin(), total.force.entries.end());
    roots.insert(roots.end(), total.moment.entries.begin(), total.moment.entries.end());
  }
  if (p.child) roots.insert(roots.end(), motions[3].acc.entries.begin(), motions[3].acc.entries.end());
  return count_operations(roots).weight;
}

/// The search over one mechanism's links.
class RegroupingSearch {
 public:
  RegroupingSearch(const RigidLinks& links, bool terms_may_move)
      : links_(links), terms_may_move_(terms_may_move), choices_(links.links().size()) {}

  RegroupingChoices run() {
    const std::size_t n = choices_.size();
    std::vector<std::vector<Regrouping>> candidates(n);
    std::vector<LinkInertia> inertias;
    for (const RigidLink& link : links_.links()) inertias.push_back(link.inertia);
    // From the tips: the best by its own cost; then descent, where a choice is judged by the link's and its
    // ancestors' cost.
    for (std::size_t i = n; i-- > 0;) {
      candidates[i] = ranked_candidates(i, inertias[i]);
      choices_[i] = candidates[i].front();
      const int parent = links_.links()[i].parent;
      if (parent >= 0)
        inertias[static_cast<std::size_t>(parent)] +=
            links_.to_parent(i, links_.split(i, choices_[i], inertias[i])->moved);
    }
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      bool better = false;
      for (std::size_t i = n; i-- > 0;) better = improve(i, candidates[i]) || better;
      if (!better) break;
    }
    const RigidLinks::Flow& flow = links_.flow(choices_);
    for (std::size_t i = 0; i < n; ++i)
      choices_[i].forms = best_forms(pattern(i, choices_[i], flow.splits[i]));
    return {choices_, std::move(candidates)};
  }

 private:
  static constexpr int kSweeps = 3;
  static constexpr std::size_t kKept = 24;      ///< candidates a link, best first
  static constexpr std::size_t kAncestors = 4;  ///< beyond these a choice is taken to have no effect

  LinkPattern pattern(std::size_t i, const Regrouping& how, const RigidLinks::Split& split) const {
    const RigidLink& link = links_.links()[i];
    LinkPattern p;
    for (std::size_t e = 0; e < kInertiaEntries.size(); ++e) {
      const auto [r, c] = kInertiaEntries[e];
      for (const auto& [term, S] : split.remaining.terms) {
        if (S(r, c) != 0) p.terms |= bit(e);
      }
      if (split.remaining.number(r, c) != 0) p.entries |= bit(e);
    }
    p.entries |= p.terms;
    for (std::size_t k = 0; k < 4; ++k) {
      if (split.points[k] != 0) p.points |= bit(k);
    }
    p.frame = how.frame;
    p.first = links_.turns_about_fixed_axis(i);
    if (link.main_child >= 0) {
      const RigidLink& child = links_.links()[static_cast<std::size_t>(link.main_child)];
      p.child = true;
      p.twisted = child.twisted;
      p.length = child.length != 0;
      p.offset = child.offset != 0;
    }
    return p;
  }

  std::size_t cost(std::size_t i, const Regrouping& how, const RigidLinks::Split& split) {
    if (links_.links()[i].grounded) return 0;
    const LinkPattern p = pattern(i, how, split);
    return cost(p) + composition_cost(split.remaining, p.first && !p.twisted);
  }
  std::size_t cost(const LinkPattern& p) {
    const auto [entry, inserted] = costs_.try_emplace(p.key(), 0);
    if (inserted) {
      MomentForms forms;
      forms.fill(MomentForm::pseudo_inertia);
      entry->second = pattern_cost(p, forms);
      forms.fill(MomentForm::inertia);
      entry->second = std::min(entry->second, pattern_cost(p, forms));
    }
    return entry->second;
  }

  /// All ways to write the inertia of link i that can be solved for, cheapest first by its own cost; the
  /// first is never missing.
  std::vector<Regrouping> ranked_candidates(std::size_t i, const LinkInertia& inertia) {
    std::vector<std::pair<std::size_t, Regrouping>> found;
    const auto consider = [&](const RigidLinks::Splits& splits, const Regrouping& how) {
      const auto split = splits.zeroing(how.zeros);
      if (split) found.emplace_back(cost(i, how, *split), how);
    };
    const int movable = links_.movable_count(i);
    for (const MassFrame frame : kMassFrames) {
      if (!links_.has_frame(i, frame)) continue;
      consider(RigidLinks::Splits(links_, i, {frame, 0, 0, false, {}}, inertia), {frame, 0, 0, false, {}});
      for (unsigned points = 0; points < 16; ++points) {
        if ((points & bit(static_cast<std::size_t>(frame))) != 0 || std::popcount(points) > 1) continue;
        if (points != 0 && (links_.links()[i].main_child < 0 || (points & 1u) != 0)) continue;
        const RigidLinks::Splits stay(links_, i, {frame, 0, points, false, {}}, inertia);
        std::optional<RigidLinks::Splits> move;
        if (terms_may_move_ && points == 0 && !inertia.terms.empty())
          move.emplace(links_, i, Regrouping{frame, 0, points, true, {}}, inertia);
        for (unsigned zeros = 1; zeros < bit(kInertiaEntries.size()); ++zeros) {
          const int count = std::popcount(zeros) - std::popcount(points);
          if (count != movable) continue;
          consider(stay, {frame, zeros, points, false, {}});
          if (move) consider(*move, {frame, zeros, points, true, {}});
        }
      }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
    // A few of each number of zeros kept, and "do nothing" always.
    std::vector<Regrouping> kept;
    std::array<std::size_t, 2> counts{};  // of those whose terms stay and move
    for (const auto& [own, how] : found) {
      std::size_t& number = counts[how.moves_terms ? 1 : 0];
      if (number >= kKept && how.zeros != 0) continue;
      kept.push_back(how);
      ++number;
    }
    return kept;
  }

  /// Cost of link i and of the ancestors that its choice can reach, with all choices as they are.
  std::size_t chain_cost(std::size_t i, const Regrouping& how, const RigidLinks::Flow& flow) {
    std::size_t sum = 0;
    Regrouping here = how;
    LinkInertia inertia = flow.inertias[i];
    for (std::size_t step = 0; step <= kAncestors; ++step) {
      auto split = links_.split(i, here, inertia);
      if (!split) return ~std::size_t{0};
      sum += cost(i, here, *split);
      const int parent = links_.links()[i].parent;
      if (parent < 0) break;
      const std::size_t p = static_cast<std::size_t>(parent);
      LinkInertia change = split->moved;
      change -= flow.splits[i].moved;
      inertia = flow.inertias[p];
      inertia += links_.to_parent(i, change);
      i = p;
      here = choices_[i];
    }
    return sum;
  }

  bool improve(std::size_t i, const std::vector<Regrouping>& candidates) {
    const RigidLinks::Flow& flow = links_.flow(choices_);
    std::size_t best = chain_cost(i, choices_[i], flow);
    bool better = false;
    for (const Regrouping& how : candidates) {
      const std::size_t sum = chain_cost(i, how, flow);
      if (sum >= best) continue;
      best = sum;
      choices_[i] = how;
      better = true;
    }
    return better;
  }

  MomentForms best_forms(const LinkPattern& p) {
    MomentForms best{};
    std::size_t least = ~std::size_t{0};
    for (unsigned mask = 0; mask < 8; ++mask) {
      MomentForms forms;
      for (std::size_t k = 0; k < 3; ++k)
        forms[k] = (mask >> k & 1u) != 0 ? MomentForm::inertia : MomentForm::pseudo_inertia;
      const std::size_t here = pattern_cost(p, forms);
      if (here < least) {
        least = here;
        best = forms;
      }
    }
    return best;
  }

  const RigidLinks& links_;
  bool terms_may_move_;
  std::vector<Regrouping> choices_;
  std::map<decltype(LinkPattern{}.key()), std::size_t> costs_;
};

}  // namespace

std::vector<Regrouping> choose_regroupings(const RigidLinks& links, bool terms_may_move) {
  return RegroupingSearch(links, terms_may_move).run().chosen;
}

RegroupingChoices regrouping_choices(const RigidLinks& links, bool terms_may_move) {
  return RegroupingSearch(links, terms_may_move).run();
}

std::vector<Regrouping> minimal_regroupings(const RigidLinks& links, bool terms_move) {
  std::vector<Regrouping> out;
  for (std::size_t i = 0; i < links.links().size(); ++i) {
    Regrouping how;
    how.moves_terms = terms_move;
    if (links.links()[i].turns) {
      how.zeros = bit(kMass) | bit(kHz) | bit(kKzz);
    } else if (links.movable_count(i) == 6) {
      how.zeros = bit(0) | bit(1) | bit(2) | bit(3) | bit(4) | bit(5);
    } else if (links.movable_count(i) == 1) {
      how.zeros = bit(kMass);
    }
    out.push_back(how);
  }
  return out;
}

}  // namespace alembert
