// Solves M X = B for many right-hand sides at once. In: a mass matrix and which speed carries which. Out: its
// factors, without the zeros between branches, and solutions; or a status that says why there are none. No heap
// unless M is a HeapMatrix (matrix.hpp), no exceptions.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "alembert/column_solver.hpp"
#include "alembert/floating_point.hpp"
#include "alembert/matrix.hpp"
#include "alembert/status.hpp"

namespace alembert {
namespace detail {
inline namespace ALEMBERT_INSTRUCTIONS {

/// Rows of a symmetric matrix, branch by branch.
template <std::size_t n>
struct Branches {
  int speeds[n] = {};    ///< of each row
  int places[n] = {};    ///< the row of each speed
  int parents[n] = {};   ///< of each row the one that carries it, or -1
  int starts[n] = {};    ///< where rows start of which each, up to this one, carries the next
  int ends[n] = {};      ///< where rows end that this one carries
  bool in_order = true;  ///< each row is that of its own speed

  /// Rows one after the other that carry the same others, besides those of the group.
  struct Group {
    int first = 0, width = 0;
  };
  Group groups[n] = {};
  int group_count = 0;
};

/// \param tree         of each speed the last one before it that it is tied to, or -1
/// \param most         rows of a group at most
/// \param ends_before  whether no group has this row and the one before
template <std::size_t n, class EndsBefore>
constexpr Branches<n> branches_of(const std::array<int, n>& tree, int most, EndsBefore ends_before) {
  constexpr int kNone = -1, N = static_cast<int>(n);
  const int* const carriers = tree.data();
  Branches<n> out;
  // The first one that a speed carries, and the next one with the same carrier; at N what nothing carries.
  int first[n + 1] = {}, next[n + 1] = {}, by[n] = {};
  for (int& child : first) child = kNone;
  for (int k = N; k-- > 0;) {
    by[k] = carriers[k] == kNone ? N : carriers[k];
    next[k] = first[by[k]];
    first[by[k]] = k;
  }
  for (int k = 0, at = first[N]; k < N; ++k) {
    out.speeds[k] = at;
    out.places[at] = k;
    out.in_order = out.in_order && at == k;
    out.parents[k] = by[at] == N ? kNone : out.places[by[at]];
    out.starts[k] = k > 0 && out.parents[k] == k - 1 ? out.starts[k - 1] : k;
    if (first[at] != kNone) {
      at = first[at];
      continue;
    }
    while (at != N && next[at] == kNone) at = by[at];
    if (at != N) at = next[at];
  }
  for (int k = N; k-- > 0;) {
    out.ends[k] = std::max(out.ends[k], k + 1);
    if (out.parents[k] != kNone) out.ends[out.parents[k]] = std::max(out.ends[out.parents[k]], out.ends[k]);
  }
  for (int k = 0; k < N;) {
    int length = 1;
    while (k + length < N && out.parents[k + length] == k + length - 1 &&
           out.ends[k + length] == out.ends[k] && !ends_before(k + length))
      ++length;
    for (int count = (length + most - 1) / most; count > 0; --count) {
      const int width = (length + count - 1) / count;
      out.groups[out.group_count].first = k;
      out.groups[out.group_count].width = width;
      ++out.group_count;
      k += width;
      length -= width;
    }
  }
  return out;
}

template <class Tree, class = void>
struct HasSpeeds : std::false_type {};
template <class Tree>
struct HasSpeeds<Tree, std::void_t<decltype(Tree::kSpeeds)>> : std::true_type {};

/// Packets that are done together, of four rows: as many as there are registers for.
#ifdef EIGEN_HAS_SINGLE_INSTRUCTION_MADD
inline constexpr int kPacketsOfBranches = EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS >= 32 ? 4 : 3;
#else
inline constexpr int kPacketsOfBranches = 2;
#endif

/// A = L^T D L for a symmetric positive definite A, from the last row up: where each speed stands after those that
/// carry it, L keeps the zeros of A between branches. After Featherstone, Rigid Body Dynamics Algorithms, 2008,
/// section 6.5. Rows are kept branch by branch; up to four that follow each other in a branch are done together, so
/// that each row that they take is loaded once for all of them.
/// \tparam Tree  kParents, std::array<int, n>: of each speed the last one before it that A or L ties it to, or -1.
///               Between speeds neither of which carries the other, A is zero. Where there are kSpeeds, the speed of
///               each row, parents, A and right-hand sides are by rows, branch by branch; only matrices that solutions
///               go to have their rows and columns by speeds.
template <class S, class Tree>
class BranchSolver : public ColumnSolver<BranchSolver<S, Tree>, S, static_cast<int>(Tree::kParents.size()),
                                         kPacketsOfBranches> {
  static constexpr int N = static_cast<int>(Tree::kParents.size());
  static_assert(N > 0, "the size must be positive");
  using Base = ColumnSolver<BranchSolver, S, N, kPacketsOfBranches>;
  friend Base;
  using Base::kLanes;
  using typename Base::Columns;
  using typename Base::Packet;
  template <int columns>
  using Rows = typename Base::template Rows<columns>;
  // Rows that are done together.
  static constexpr int kTogether = 4;
  static constexpr auto kRows = branches_of(Tree::kParents, kTogether, Columns::ends_before);
  static constexpr bool kByRows = HasSpeeds<Tree>::value;
  static_assert(!kByRows || kRows.in_order, "rows stand branch by branch");
  static constexpr auto kOrder = [] {
    if constexpr (kByRows)
      return order_of_speeds<static_cast<std::size_t>(N)>(Tree::kSpeeds);
    else
      return order_of_speeds<static_cast<std::size_t>(N)>(kRows.speeds);
  }();

 public:
  /// \param A  n x n, symmetric, column by column
  /// \return   not_finite or not_positive_definite as of factor_ldlt
  template <class Square>
  [[nodiscard]] Status factor(const Square& A) {
    take_rows(A);
    for (int at = kRows.group_count; at-- > 0;) {
      const auto& group = kRows.groups[at];
      const int last = group.first + group.width - 1;
      Plain plain;
      Status status = Status::ok;
      with_width(group.width, [&](auto width) {
        each<width>([&](auto constant) {
          constexpr int before = constant;
          if (status != Status::ok) return;
          const int k = last - before;
          if constexpr (before > 0) add_rows<before>(plain, last, k);
          status = scale(k, A(given(k), given(k)), plain[before]);
        });
        if (status != Status::ok) return;
        Carriers of(group.first);
        do {
          for (int i = of.from; i < of.to; ++i) add_rows<width>(plain, last, i);
        } while (of.next());
      });
      if (status != Status::ok) return status;
    }
    return Status::ok;
  }

  using Base::solve;
  /// x = A^-1 x.
  void solve(Eigen::Matrix<S, N, 1>& x) const {
    // Measured: many sums in turn take longer than adding along rows, from some twenty rows on.
    if constexpr (N > 20) {
      solve_along_rows(x);
    } else {
      Rows<kLanes> all;
      S* const rows = all.data();
      sweep(std::make_index_sequence<1>(), rows, N, S(1),
            [&](int row, auto) { return Eigen::internal::pset1<Packet>(x(given(row))); });
      for (int i = 0; i < N; ++i) x(given(i)) = rows[i * kLanes];
    }
  }

 private:
  static constexpr int kPadded = (N + kLanes - 1) / kLanes * kLanes;

  template <int value>
  using Constant = std::integral_constant<int, value>;
  /// Rows of a group before they are scaled.
  using Plain = S[kTogether][kPadded];

  /// Where a row stands in what is given.
  static int given(int at) { return kByRows ? at : kOrder.speeds[at]; }
  static bool is_tip(int k) { return kRows.ends[k] == k + 1; }
  S* row(int k) { return rows_.data() + k * kPadded; }
  const S* row(int k) const { return rows_.data() + k * kPadded; }
  template <int count, class Call>
  static EIGEN_ALWAYS_INLINE void each(Call&& call) {
    each(call, std::make_integer_sequence<int, count>());
  }
  template <class Call, int... at>
  static EIGEN_ALWAYS_INLINE void each(Call& call, std::integer_sequence<int, at...>) {
    (call(Constant<at>()), ...);
  }
  template <class Call>
  static void with_width(int width, Call&& call) {
    switch (width) {
      case 1:
        return call(Constant<1>());
      case 2:
        return call(Constant<2>());
      case 3:
        return call(Constant<3>());
      default:
        return call(Constant<kTogether>());
    }
  }

  /// Rows that carry a row, those first that follow each other up to it: from .. to - 1, which may be none.
  struct Carriers {
    explicit Carriers(int carried) : from(kRows.starts[carried]), to(carried) {}
    /// Goes on to what carries those; whether there is anything.
    bool next() {
      to = kRows.parents[from] + 1;
      if (to == 0) return false;
      from = kRows.starts[to - 1];
      return true;
    }
    int from, to;
  };

  /// Takes the rows of A branch by branch. What lies beyond the diagonal is not used.
  template <class Square>
  void take_rows(const Square& A) {
    if constexpr (kRows.in_order) {
      rows_.template topRows<N>() = A;
    } else {
      for (int k = 0; k < N; ++k) {
        const S* const from = &A(0, given(k));
        S* const own = row(k);
        for (int i = 0; i <= k; ++i) own[i] = from[given(i)];
        std::fill(own + k + 1, own + (k / kLanes + 1) * kLanes, S(0));
      }
    }
    rows_.template bottomRows<kPadded - N>().setZero();
  }

  /// Makes row k, which has taken all, one of -L.
  /// \param whole  its pivot as it was in A
  /// \param plain  where it goes as it is now
  [[nodiscard]] Status scale(int k, S whole, S* plain) {
    using namespace Eigen::internal;
    S* const own = row(k);
    const S pivot = own[k];
    if (const Status status = status_of_pivot(pivot, whole, N); status != Status::ok) return status;
    inverse_pivot_[k] = S(1) / pivot;
    const Packet factor = pset1<Packet>(S(-1) / pivot);
    int at = 0;
    do {
      const Packet entries = ploadu<Packet>(own + at);
      pstoreu(plain + at, entries);
      pstoreu(own + at, pmul(factor, entries));
    } while ((at += kLanes) < k);
    return Status::ok;
  }

  /// Adds to row i of A what the rows from `last` down have for it.
  template <int width>
  void add_rows(const Plain& plain, int last, int i) {
    using namespace Eigen::internal;
    const S* const from = row(last);
    S* const own = row(i);
    Packet factors[width];
    each<width>([&](auto constant) {
      constexpr int r = constant;
      factors[r] = same(plain[r][i]);
    });
    // What lies beyond the diagonal is not used.
    for (int at = 0; at <= i; at += kLanes) {
      Packet sum = ploadu<Packet>(own + at);
      each<width>([&](auto constant) {
        constexpr int r = constant;
        sum = add_product(factors[r], ploadu<Packet>(from + at - r * kPadded), sum);
      });
      pstoreu(own + at, sum);
    }
  }

  // Looked up here once, not in each lambda.
  static EIGEN_ALWAYS_INLINE Packet same(S entry) { return Eigen::internal::pset1<Packet>(entry); }
  static EIGEN_ALWAYS_INLINE Packet add_product(const Packet& a, const Packet& b, const Packet& sum) {
    return Eigen::internal::pmadd(a, b, sum);
  }
  /// A packet that compilers are to load once, not with each operation on it.
  static Packet in_register(const S* from) {
    Packet out = Eigen::internal::pload<Packet>(from);
    if constexpr (kLanes > 1) ALEMBERT_AS_ROUNDED(out);
    return out;
  }

  /// x = A^-1 x, adding along whole rows of L up to a group: between branches L is zero, and from the group on the
  /// solution is still zero.
  void solve_along_rows(Eigen::Matrix<S, N, 1>& x) const {
    using namespace Eigen::internal;
    alignas(64) S sums[kPadded], scaled[kPadded], solution[kPadded] = {};
    for (int k = 0; k < kPadded; ++k) sums[k] = k < N ? x(given(k)) : S(0);
    for (int at = kRows.group_count; at-- > 0;) {
      const auto& group = kRows.groups[at];
      with_width(group.width, [&](auto width) {
        const S* const l = row(group.first);
        S* const own = sums + group.first;
        for (int done = width - 1; done >= 0; --done) {
          for (int r = 0; r < done; ++r) own[r] += l[done * kPadded + group.first + r] * own[done];
          scaled[group.first + done] = own[done] * inverse_pivot_[group.first + done];
        }
        Packet factors[width];
        each<width>([&](auto constant) {
          constexpr int r = constant;
          factors[r] = same(own[r]);
        });
        // What is added to the group itself is not used.
        for (int i = 0; i < group.first; i += kLanes) {
          Packet sum = pload<Packet>(sums + i);
          each<width>([&](auto constant) {
            constexpr int r = constant;
            sum = add_product(factors[r], ploadu<Packet>(l + r * kPadded + i), sum);
          });
          pstore(sums + i, sum);
        }
      });
    }
    for (int at = 0; at < kRows.group_count; ++at) {
      const auto& group = kRows.groups[at];
      with_width(group.width, [&](auto width) {
        const S* const l = row(group.first);
        Packet sum[width];
        each<width>([&](auto constant) {
          constexpr int r = constant;
          sum[r] = same(S(0));
        });
        for (int i = 0; i < group.first; i += kLanes) {
          const Packet z = pload<Packet>(solution + i);
          each<width>([&](auto constant) {
            constexpr int r = constant;
            sum[r] = add_product(z, ploadu<Packet>(l + r * kPadded + i), sum[r]);
          });
        }
        S* const own = solution + group.first;
        each<width>([&](auto constant) {
          constexpr int r = constant;
          own[r] = scaled[group.first + r] + predux(sum[r]);
          for (int done = 0; done < r; ++done) own[r] += l[r * kPadded + group.first + done] * own[done];
        });
      });
    }
    for (int i = 0; i < N; ++i) x(given(i)) = solution[i];
  }

  /// As of ColumnSolver.
  template <std::size_t... p, class Given>
  void sweep(std::index_sequence<p...> packets, S* rows, int end, S factor, Given&& given) const {
    for (int at = kRows.group_count; at-- > 0;) {
      const auto& group = kRows.groups[at];
      if (group.first >= end) continue;
      with_width(group.width, [&](auto width) { add<width, true>(packets, group.first, end, rows, given); });
    }
    const auto scaled = [&](int row, auto at) {
      using namespace Eigen::internal;
      return pmul(same(factor * inverse_pivot_[row]),
                  pload<Packet>(rows + (row * static_cast<int>(sizeof...(p)) + at) * kLanes));
    };
    for (int at = 0; at < kRows.group_count; ++at) {
      const auto& group = kRows.groups[at];
      if (group.first >= end) break;
      with_width(group.width,
                 [&](auto width) { add<width, false>(packets, group.first, end, rows, scaled); });
    }
  }

  /// Rows from `first` on of some packets: what is `given`, and entries of -L times other rows, of those that they
  /// carry before `end`, or of those that carry them.
  template <int width, bool carrying, std::size_t... p, class Given>
  void add(std::index_sequence<p...>, int first, int end, S* rows, Given&& given) const {
    using namespace Eigen::internal;
    constexpr int kOfRow = static_cast<int>(sizeof...(p)), kApart = kOfRow * kLanes;
    // Where entries stand in rows_: from one row of the group to the next, from one of the others to the next.
    constexpr int kRowApart = carrying ? 1 : kPadded, kOtherApart = carrying ? kPadded : 1;
    const S* const entries = rows_.data() + first * kRowApart;
    Packet x[width * kOfRow];
    each<width>([&](auto constant) {
      constexpr int r = constant, own = r * kOfRow;
      ((x[own + p] = given(first + r, Constant<static_cast<int>(p)>())), ...);
    });
    Carriers others(first);
    if (carrying) {
      others.from = first + width;
      others.to = std::min(kRows.ends[first], end);
    }
    do {
      const S* const past = rows + others.to * kApart;
      const S* l = entries + others.from * kOtherApart;
      for (const S* other = rows + others.from * kApart; other < past; other += kApart, l += kOtherApart) {
        const Packet z[] = {in_register(other + p * kLanes)...};
        each<width>([&](auto constant) {
          constexpr int r = constant, own = r * kOfRow;
          const Packet factor = same(l[r * kRowApart]);
          ((x[own + p] = add_product(factor, z[p], x[own + p])), ...);
        });
      }
    } while (!carrying && others.next());
    // Then rows of the group, each when it has taken all.
    each<width>([&](auto turn) {
      constexpr int done = carrying ? width - 1 - turn : turn;
      const S* const l = entries + (first + done) * kOtherApart;
      each<width>([&](auto constant) {
        constexpr int r = constant, own = r * kOfRow;
        if constexpr (carrying ? r < done : r > done) {
          const Packet factor = same(l[r * kRowApart]);
          ((x[own + p] = add_product(factor, x[done * kOfRow + p], x[own + p])), ...);
        }
      });
    });
    S* const to = rows + first * kApart;
    each<width>([&](auto constant) {
      constexpr int own = constant * kOfRow;
      (pstore(to + (own + p) * kLanes, x[own + p]), ...);
    });
  }

  SizedMatrix<S, kPadded, N> rows_;  // row k of A, then of -L, in column k up to the diagonal
  S inverse_pivot_[N];
};

}  // namespace ALEMBERT_INSTRUCTIONS
}  // namespace detail
}  // namespace alembert
