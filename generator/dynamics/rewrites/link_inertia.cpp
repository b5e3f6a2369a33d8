// Inertias linear in runtime terms (see the header).
#include "dynamics/rewrites/link_inertia.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>

#include "symbolic/coefficient.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {

namespace {

/// m, h, and J row by row.
using Entries = std::array<Expr, 13>;

Entries entries_of(const NodeMass& mass) {
  Entries out;
  out[0] = mass.mass;
  std::copy(mass.moment.entries.begin(), mass.moment.entries.end(), out.begin() + 1);
  std::copy(mass.inertia.entries.begin(), mass.inertia.entries.end(), out.begin() + 4);
  return out;
}

bool is_number(const Entries& entries) {
  return std::all_of(entries.begin(), entries.end(), [](const Expr& e) { return e.is_constant(); });
}

using InertiaNumbers = std::array<Extended, 13>;

/// K = tr(J)/2 - J.
Matrix4e pseudo_inertia(const InertiaNumbers& v) {
  Matrix3e J;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) J(r, c) = v[static_cast<std::size_t>(4 + 3 * r + c)];
  }
  Matrix4e S;
  S.topLeftCorner<3, 3>() = Extended(J.trace() / 2) * Matrix3e::Identity() - J;
  for (int r = 0; r < 3; ++r) S(r, 3) = S(3, r) = v[static_cast<std::size_t>(1 + r)];
  S(3, 3) = v[0];
  return S;
}

Matrix4e number_inertia(const Entries& entries) {
  const std::vector<Extended> values = evaluate_extended(entries, std::span<const Extended>());
  InertiaNumbers v;
  std::copy(values.begin(), values.end(), v.begin());
  return pseudo_inertia(v);
}

/// Expressions as polynomials with numbers for coefficients, in bases that are no sums and no products.
class PolynomialReader {
 public:
  using Monomial = std::vector<std::size_t>;  ///< indices of bases, ascending
  using Polynomial = std::map<Monomial, Extended>;

  PolynomialReader(std::span<const Expr> roots, ExprGraph& graph) : graph_(graph) {
    for (const std::uint32_t id : postorder(roots)) {
      Polynomial p = read(id);
      if (p.size() > kMostTerms) p = base(id);
      read_.emplace(id, std::move(p));
    }
  }

  Polynomial of(Ref x) const {
    Polynomial p = read_.at(x.node());
    if (x.negative()) p = scaled(p, -1);
    return p;
  }
  /// The product of a monomial's bases.
  Expr expression(const Monomial& monomial) const {
    Expr product = bases_[monomial.front()];
    for (std::size_t k = 1; k < monomial.size(); ++k) product = product * bases_[monomial[k]];
    return product;
  }

 private:
  static constexpr std::size_t kMostTerms = 64;  ///< of a polynomial; a longer one is taken as a base

  static Polynomial scaled(Polynomial p, const Extended& factor) {
    for (auto& [monomial, number] : p) number *= factor;
    return p;
  }

  Polynomial base(std::uint32_t id) {
    bases_.emplace_back(graph_, Ref(id, false));
    return {{Monomial{bases_.size() - 1}, Extended(1)}};
  }

  Polynomial read(std::uint32_t id) {
    const Node node = graph_.node(id);
    if (node.constant) return {{Monomial{}, extended_value_of(Expr(graph_, Ref(id, false)))}};
    if (node.op == Operation::add) {
      Polynomial sum = of(node.a);
      for (const auto& [monomial, number] : of(node.b)) sum[monomial] += number;
      return sum;
    }
    if (node.op == Operation::mul) {
      const Polynomial x = of(node.a), y = of(node.b);
      if (x.size() * y.size() > kMostTerms) return base(id);
      Polynomial product;
      for (const auto& [left, a] : x) {
        for (const auto& [right, b] : y) {
          Monomial both;
          std::merge(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(both));
          product[both] += a * b;
        }
      }
      return product;
    }
    if (node.op == Operation::div && graph_.node(node.b.node()).constant) {
      return scaled(of(node.a), 1 / of(node.b).at(Monomial{}));
    }
    return base(id);
  }

  ExprGraph& graph_;
  std::vector<Expr> bases_;
  std::unordered_map<std::uint32_t, Polynomial> read_;  ///< looked up only
};

/// J_rr = K_ii + K_jj.
Extended moment_of_inertia(const Matrix4e& S, int r) {
  const int i = (r + 1) % 3, j = (r + 2) % 3;
  const Extended sum = S(i, i) + S(j, j);
  return abs(sum) <= kExtendedRounding * abs(S(i, i)) ? Extended(0) : sum;
}

/// Coefficients of one term in mass, first moment and inertia: m, h, J xx yy zz xy xz yz. What is a whole
/// number but for rounding is one.
std::array<Extended, 10> coefficients(const Matrix4e& S) {
  std::array<Extended, 10> out{S(3, 3),
                               S(0, 3),
                               S(1, 3),
                               S(2, 3),
                               moment_of_inertia(S, 0),
                               moment_of_inertia(S, 1),
                               moment_of_inertia(S, 2),
                               -S(0, 1),
                               -S(0, 2),
                               -S(1, 2)};
  for (Extended& x : out) {
    const Extended whole = round(x);
    if (abs(x - whole) <= kExtendedRounding * abs(whole)) x = whole;
  }
  return out;
}

}  // namespace

Extended mass_scale(const Matrix4e& S, const Extended& length) {
  Extended mass = abs(S(3, 3));
  if (length == 0) return mass;
  for (int r = 0; r < 3; ++r) {
    mass = std::max(mass, Extended(abs(S(r, 3)) / length));
    for (int c = 0; c < 3; ++c) mass = std::max(mass, Extended(abs(S(r, c)) / (length * length)));
  }
  return mass;
}

void drop_rounding(Matrix4e& S, const Extended& mass, const Extended& length) {
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      const Extended size = mass * (r < 3 ? length : Extended(1)) * (c < 3 ? length : Extended(1));
      if (abs(S(r, c)) <= kExtendedRounding * size) S(r, c) = 0;
    }
  }
}

Expr rounded_number(ExprGraph& graph, const Extended& x) {
  return graph.real(x.convert_to<double>());
}

LinkInertia& LinkInertia::operator+=(const LinkInertia& other) {
  number += other.number;
  for (const auto& [k, S] : other.terms) {
    const auto [entry, inserted] = terms.try_emplace(k, S);
    if (!inserted) entry->second += S;
  }
  return *this;
}

LinkInertia& LinkInertia::operator-=(const LinkInertia& other) {
  number -= other.number;
  for (const auto& [k, S] : other.terms) {
    const auto [entry, inserted] = terms.try_emplace(k, -S);
    if (!inserted) entry->second -= S;
  }
  return *this;
}

LinkInertia LinkInertia::seen_through(const Matrix4e& X) const {
  LinkInertia out;
  out.number = X * number * X.transpose();
  for (const auto& [k, S] : terms) out.terms.emplace(k, X * S * X.transpose());
  return out;
}

std::size_t RuntimeTerms::index_of(Expr term) {
  const auto found = std::find(terms_.begin(), terms_.end(), term);
  if (found != terms_.end()) return static_cast<std::size_t>(found - terms_.begin());
  terms_.push_back(term);
  return terms_.size() - 1;
}

LinkInertia RuntimeTerms::of_node(const Mechanism& mechanism, const MotionTree& tree, std::size_t node,
                                  ExprGraph& graph) {
  LinkInertia out;
  const Entries sum = entries_of(tree.masses[node]);
  if (is_number(sum)) {
    out.number = number_inertia(sum);
    return out;
  }
  // Body by body, so that the numbers of one are not mixed with what another has for terms.
  for (const int body : tree.nodes[node].bodies) {
    const std::size_t b = static_cast<std::size_t>(body);
    out += with_terms(mass_at_node(mechanism.bodies[b], tree.places[b], graph), graph);
  }
  return out;
}

LinkInertia RuntimeTerms::with_terms(const NodeMass& mass, ExprGraph& graph) {
  const Entries entries = entries_of(mass);
  LinkInertia out;
  if (is_number(entries)) {
    out.number = number_inertia(entries);
    return out;
  }
  const PolynomialReader reader(entries, graph);
  InertiaNumbers constants{};
  std::map<PolynomialReader::Monomial, InertiaNumbers> by_monomial;
  std::vector<Expr> moving;  // entries that are no numbers, up to sign
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (const auto& [monomial, number] : reader.of(entries[i].ref())) {
      if (monomial.empty()) {
        constants[i] = number;
      } else if (number != 0) {
        by_monomial.try_emplace(monomial).first->second[i] = number;
      }
    }
    const Expr size(graph, Ref(entries[i].ref().node(), false));
    if (!size.is_constant() && std::find(moving.begin(), moving.end(), size) == moving.end())
      moving.push_back(size);
  }
  std::vector<std::pair<Expr, InertiaNumbers>> terms;
  if (by_monomial.size() <= moving.size()) {
    for (const auto& [monomial, numbers] : by_monomial)
      terms.emplace_back(reader.expression(monomial), numbers);
  } else {
    for (const Expr& entry : moving) {
      // Without its number the entry is the same term wherever it goes.
      const PolynomialReader::Polynomial p = reader.of(entry.ref());
      const auto constant = p.find({});
      Expr term = entry;
      if (constant != p.end() && constant->second != 0) {
        term = graph.zero();
        for (const auto& [monomial, number] : p) {
          if (!monomial.empty()) term += rounded_number(graph, number) * reader.expression(monomial);
        }
      }
      InertiaNumbers numbers{};
      for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i].ref().node() == entry.ref().node()) numbers[i] = entries[i].ref().negative() ? -1 : 1;
      }
      terms.emplace_back(term, numbers);
    }
  }
  out.number = pseudo_inertia(constants);
  for (auto& [term, numbers] : terms) {
    const bool negative = term.ref().negative();
    LinkInertia part;
    part.terms.emplace(index_of(negative ? -term : term),
                       Extended(negative ? -1 : 1) * pseudo_inertia(numbers));
    out += part;
  }
  return out;
}

NodeMass RuntimeTerms::node_mass(const LinkInertia& inertia, ExprGraph& graph) const {
  const Matrix4e& S = inertia.number;
  NodeMass mass{rounded_number(graph, S(3, 3)), zeros<3, 1>(graph), zeros<3, 3>(graph)};
  for (int r = 0; r < 3; ++r) {
    mass.moment[static_cast<std::size_t>(r)] = rounded_number(graph, S(r, 3));
    for (int c = 0; c < 3; ++c) {
      mass.inertia(static_cast<std::size_t>(r), static_cast<std::size_t>(c)) =
          rounded_number(graph, r == c ? moment_of_inertia(S, r) : Extended(-S(r, c)));
    }
  }
  if (inertia.terms.empty()) return mass;
  std::array<Expr, 10> sums;
  sums.fill(graph.zero());
  for (const auto& [k, coefficient] : inertia.terms) {
    const std::array<Extended, 10> numbers = coefficients(coefficient);
    for (std::size_t e = 0; e < sums.size(); ++e) sums[e] += rounded_number(graph, numbers[e]) * terms_[k];
  }
  mass.mass += sums[0];
  for (std::size_t r = 0; r < 3; ++r) {
    mass.moment[r] += sums[1 + r];
    mass.inertia(r, r) += sums[4 + r];
  }
  const std::array<std::size_t, 3> rows{0, 0, 1}, columns{1, 2, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    mass.inertia(rows[k], columns[k]) += sums[7 + k];
    mass.inertia(columns[k], rows[k]) = mass.inertia(rows[k], columns[k]);
  }
  return mass;
}

std::size_t composition_cost(const LinkInertia& inertia, bool about_z_only) {
  if (inertia.terms.empty()) return 0;
  const std::array<Extended, 10> numbers = coefficients(inertia.number);
  std::array<std::size_t, 10> summands{};
  std::size_t cost = 0;
  constexpr std::size_t kJzz = 6;
  const auto wanted = [&](std::size_t e) { return !about_z_only || e == kJzz; };
  for (const auto& [k, coefficient] : inertia.terms) {
    const std::array<Extended, 10> c = coefficients(coefficient);
    for (std::size_t e = 0; e < c.size(); ++e) {
      if (c[e] == 0 || !wanted(e)) continue;
      ++summands[e];
      if (abs(c[e]) != 1) ++cost;
    }
  }
  for (std::size_t e = 0; e < summands.size(); ++e) {
    if (summands[e] > 0) cost += summands[e] - (numbers[e] != 0 ? 0 : 1);
  }
  return cost;
}

}  // namespace alembert
