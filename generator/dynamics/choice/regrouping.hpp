// Which entries of the inertias of rigid links to zero, decided by counting.
#pragma once

#include <vector>

#include "dynamics/rewrites/rigid_links.hpp"

namespace alembert {

/// Chooses for each link how its inertia is written, by counting the operations it causes: coordinate descent
/// over the entries that can be zeroed, "do nothing" included; runtime terms stay where they are unless they
/// may move. Deterministic.
std::vector<Regrouping> choose_regroupings(const RigidLinks& links, bool terms_may_move = false);
/// The same, and for each link the ways that were considered, the cheapest by its own cost first.
struct RegroupingChoices {
  std::vector<Regrouping> chosen;
  std::vector<std::vector<Regrouping>> candidates;
};
RegroupingChoices regrouping_choices(const RigidLinks& links, bool terms_may_move = false);

/// Mass, first moment and one third of the inertia zeroed at each joint: what the composite-body mass matrix
/// wants. Of runtime terms too, if they move.
std::vector<Regrouping> minimal_regroupings(const RigidLinks& links, bool terms_move = false);

}  // namespace alembert
