// The equations of motion of a tree of rigid bodies, each speed of which turns or slides one of its frames about or
// along an axis that is fixed in the frame, and their derivatives: in world axes, where what bodies add up is
// added without being turned, and several speeds are done by one instruction. In: frames of the speeds, which the
// generator writes, and tables. Out: mass matrix, generalized forces and their derivatives, row by row.
//
// Letters as in generator/dynamics/README.md, 7. Rows that follow each other along a branch make a run; vectors are in
// world axes and about a point O of the run, the origin of its last frame: about one point of all, what is small and far
// from it would lose its digits.
//
//   s = (xi, d)               twist of a speed: turn, and velocity of what is at O
//   V' = V + s u,  A' = A + s du/dt + Psi u,  Psi = V x s       of what a speed moves; V and A are of what carries it
//   E = 2 Psi,  Psi2 = A x s + V x Psi                          A with -g at the world
//   h, J, p, P                integrals of r, of inertia, of dr/dt, of r (dr/dt)^T dm over all that a speed moves
//   (n, f) = (h x d + J xi, m d + xi x h),  g = 2 (p x d + (tr P - P) xi)
//
// A twist (a, b) makes the velocity b + a x r. Where i stands further out than j, or is j,
//
//   M_ij = xi_j . n_i + d_j . f_i,      D_j Q_i = (n, f)_i . Psi2_j + g_i . a(Psi_j),
//   dQ_i/du_j = (n, f)_i . E_j + g_i . xi_j,
//   D_i Q_j = s_j . (F(a(Psi_i), Psi2_i) + s_i x* F_i),      dQ_j/du_i = s_j . F(xi_i, E_i),
//   F(e1, (e2, z)) = (h x z + J e2 + 2 (tr P - P^T) e1,  m z + e2 x h + 2 e1 x p)
//
// with F_i the moment and the force on all that speed i moves. Of a rotation by a quaternion, three speeds at once,
// V and A are of what carries the three, and E = Psi + V' x s with what they give together.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "alembert/matrix.hpp"

namespace alembert {
namespace detail {
inline namespace ALEMBERT_INSTRUCTIONS {

/// As many numbers as an instruction takes, of AVX-512 half as many: measured, longer vectors are filled less.
template <class S>
struct NumberLanes {
#if defined(__GNUC__)
#if defined(__AVX__)
  static constexpr int kBytes = 32;
#else
  static constexpr int kBytes = 16;
#endif
  static constexpr int kLanes = kBytes / static_cast<int>(sizeof(S));
  using Bits = std::conditional_t<sizeof(S) == 8, std::int64_t, std::int32_t>;
  typedef S Vector __attribute__((vector_size(kBytes)));
  typedef Bits Mask __attribute__((vector_size(kBytes)));
  typedef S Stored __attribute__((vector_size(kBytes), aligned(sizeof(S)), may_alias));
#else
  static constexpr int kLanes = 1;
  using Vector = S;
  using Stored = S;
#endif
  static Vector load(const S* from) {
    return *reinterpret_cast<const Stored*>(from);
  }
  static void store(S* to, const Vector& x) {
    *reinterpret_cast<Stored*>(to) = x;
  }
  /// x in the lanes whose bits are set, 0 in the others.
  static Vector chosen(const Vector& x, unsigned lanes) {
#if defined(__GNUC__)
    static constexpr auto kOfLanes = [] {
      struct {
        alignas(kBytes) Bits bits[static_cast<std::size_t>(kLanes)]{};
      } out;
      for (int i = 0; i < kLanes; ++i) out.bits[i] = Bits(1) << i;
      return out;
    }();
    const Mask own = *reinterpret_cast<const Mask*>(kOfLanes.bits);
    return reinterpret_cast<Vector>(reinterpret_cast<Mask>(x) & ((own & static_cast<Bits>(lanes)) != 0));
#else
    return lanes != 0 ? x : S(0);
#endif
  }
};

/// Component c of a x b.
template <class S>
S crossed(const S* a, const S* b, int c) {
  const int y = (c + 1) % 3, z = (c + 2) % 3;
  return a[y] * b[z] - a[z] * b[y];
}

/// What the generator knows of a tree of N speeds, ready for vectors. Rows stand branch by branch; each has the
/// frame that follows the motion of its speed.
template <class S, int N>
struct AxisTables {
  static constexpr int kLanes = NumberLanes<S>::kLanes;
  static constexpr int kBlocks = (N + kLanes - 1) / kLanes, kPadded = kBlocks * kLanes;
  template <class T>
  using PerRow = std::array<T, static_cast<std::size_t>(N)>;
  using Row = std::array<S, static_cast<std::size_t>(kPadded)>;
  using LanesOfBlocks = std::array<std::uint16_t, static_cast<std::size_t>(kBlocks)>;

  int count = N;                              ///< speeds, which may be fewer
  PerRow<int> parents{}, ends{};              ///< rows up to `ends` are carried by one
  PerRow<int> starts{}, poles{};              ///< the first and the last row of the run of each
  alignas(64) std::array<Row, 3> axes{};      ///< x y z in the frame
  alignas(64) Row turns{};                    ///< 1 where a speed turns, 0 where it slides
  alignas(64) Row masses{}, totals{};         ///< of the body in the frame, and of all that a speed moves
  alignas(64) std::array<Row, 3> centers{};   ///< of mass, in the frame
  alignas(64) std::array<Row, 6> inertias{};  ///< about it, in the frame's axes: xx yy zz xy xz yz
  Row armatures{};
  PerRow<bool> first_of_three{};
  std::array<S, 3> gravity{};
  /// By rows and blocks of columns: the lanes of those that carry the row, itself among them, and of those that
  /// it carries.
  PerRow<LanesOfBlocks> carriers{}, carried{};

  /// \param data  as M::Axes of a generated M
  template <class Data>
  constexpr explicit AxisTables(const Data& data, int rows = N) : count(rows) {
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      parents[i] = data.kParents[i];
      for (std::size_t c = 0; c < 3; ++c) axes[c][i] = S(data.kDirections[c][i]);
      for (std::size_t c = 0; c < 3; ++c) centers[c][i] = S(data.kCenters[c][i]);
      for (std::size_t c = 0; c < 6; ++c) inertias[c][i] = S(data.kInertias[c][i]);
      turns[i] = S(data.kTurns[i] ? 1 : 0);
      masses[i] = S(data.kMasses[i]);
      armatures[i] = S(data.kArmatures[i]);
      first_of_three[i] = data.kFirstOfThree[i];
      ends[i] = k + 1;
    }
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const bool goes_on =
          k > 0 && parents[i] == k - 1 && (is_within_three(k) || fits_run(k - starts[i - 1], k));
      starts[i] = goes_on ? starts[i - 1] : k;
    }
    for (int k = count; k-- > 0;) {
      const auto i = static_cast<std::size_t>(k);
      poles[i] = k + 1 < count && starts[i + 1] == starts[i] ? poles[i + 1] : k;
    }
    for (std::size_t c = 0; c < 3; ++c) gravity[c] = S(data.kGravity[c]);
    PerRow<double> sums{};
    for (int k = 0; k < count; ++k)
      sums[static_cast<std::size_t>(k)] = data.kMasses[static_cast<std::size_t>(k)];
    for (int k = count; k-- > 0;) {
      const auto i = static_cast<std::size_t>(k);
      totals[i] = S(sums[i]);
      if (parents[i] < 0) continue;
      const auto by = static_cast<std::size_t>(parents[i]);
      sums[by] += sums[i];
      ends[by] = std::max(ends[by], ends[i]);
    }
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (parents[i] >= 0) carriers[i] = carriers[static_cast<std::size_t>(parents[i])];
      add(carriers[i], k, k + 1);
      add(carried[i], k + 1, ends[i]);
    }
  }

  /// Whether a row is the second or the third of a quaternion.
  constexpr bool is_within_three(int k) const {
    const auto i = static_cast<std::size_t>(k);
    return k > 0 && (first_of_three[i - 1] || (k > 1 && first_of_three[i - 2]));
  }

 private:
  /// Longer ones take fewer operations and lose more digits.
  static constexpr int kLongestRun = 8;

  constexpr bool fits_run(int length, int k) const {
    return length + (first_of_three[static_cast<std::size_t>(k)] ? 3 : 1) <= kLongestRun;
  }
  /// Columns from `first` to `end` - 1. In few steps: of constants compilers count them.
  static constexpr void add(LanesOfBlocks& lanes, int first, int end) {
    for (int at = first / kLanes * kLanes; at < end; at += kLanes) {
      const unsigned up_to_end = (1U << std::min(end - at, kLanes)) - 1;
      const unsigned before = (1U << std::max(first - at, 0)) - 1;
      auto& own = lanes[static_cast<std::size_t>(at / kLanes)];
      own = static_cast<std::uint16_t>(own | (up_to_end & ~before));
    }
  }
};

/// One state of such a tree. Call positions and speeds, then accelerations, then what they give; accelerations may be
/// given anew.
/// \tparam N  speeds, or more
template <class S, int N>
class AxisTree {
  using Lanes = NumberLanes<S>;
  using Vector = typename Lanes::Vector;
  using Tables = AxisTables<S, N>;
  static constexpr int kLanes = Lanes::kLanes, kPadded = Tables::kPadded;

  struct Three {
    Vector x, y, z;
    friend Three operator+(const Three& a, const Three& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Three operator*(const Vector& k, const Three& a) { return {k * a.x, k * a.y, k * a.z}; }
  };
  static Three cross(const Three& a, const Three& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  static Vector dot(const Three& a, const Three& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static Three plus_scaled(const Three& a, const Vector& k, const Three& b) {
    return {a.x + k * b.x, a.y + k * b.y, a.z + k * b.z};
  }
  static Three scaled_less(const Vector& k, const Three& a, const Three& b) {
    return {k * a.x - b.x, k * a.y - b.y, k * a.z - b.z};
  }
  struct Symmetric {
    Vector xx, yy, zz, xy, xz, yz;
    Three operator*(const Three& a) const {
      return {xx * a.x + xy * a.y + xz * a.z, xy * a.x + yy * a.y + yz * a.z, xz * a.x + yz * a.y + zz * a.z};
    }
  };
  struct Square {
    Three rows[3];
    Vector trace() const { return rows[0].x + rows[1].y + rows[2].z; }
    Three operator*(const Three& a) const { return {dot(rows[0], a), dot(rows[1], a), dot(rows[2], a)}; }
    Three transposed_times(const Three& a) const {
      return {rows[0].x * a.x + rows[1].x * a.y + rows[2].x * a.z,
              rows[0].y * a.x + rows[1].y * a.y + rows[2].y * a.z,
              rows[0].z * a.x + rows[1].z * a.y + rows[2].z * a.z};
    }
  };

  /// Quantities, so many numbers of each speed.
  enum At {
    kPole = 0,  // O of the row's run
    kTwist = kPole + 3,
    kVelocity = kTwist + 6,  // of what carries a speed
    kMoved = kVelocity + 6,  // of what it moves
    kPsi = kMoved + 6,
    kPsiRate = kPsi + 6,           // E
    kAcceleration = kPsiRate + 6,  // of what carries a speed
    kMovedAcceleration = kAcceleration + 6,
    kPsi2 = kMovedAcceleration + 6,
    kBodyMoment = kPsi2 + 6,          // h of the body of each speed
    kBodyInertia = kBodyMoment + 3,   // J
    kBodyTurning = kBodyInertia + 6,  // omega x p and what omega alone gives of the moment
    kMoments = kBodyTurning + 6,      // of all that a speed moves: h, J, p, P
    kInertia = kMoments + 3,
    kMomentum = kInertia + 6,
    kSpread = kMomentum + 3,
    kLoad = kSpread + 9,     // moment and force on it
    kUnit = kLoad + 6,       // (n, f)
    kUnitRate = kUnit + 6,   // g
    kAlong = kUnitRate + 3,  // what speeds further in take from D_i, from d/du_i
    kBySpeed = kAlong + 6,
    // About O of another run: of E and Psi2 what slides, or d; of kAlong and kBySpeed the moments.
    kSeen = kBySpeed + 6,
    kQuantities = kSeen + 12
  };

 public:
  explicit AxisTree(const Tables& tables) : tables_(tables) {}

  /// \param frames  12 x count: for each row the matrix [R p] row by row, p from any point that is common to all; and
  ///                room for kLanes more
  /// \param qd      speeds by rows
  void set_state(const S* frames, const S* qd) {
    for (int k = 0; k < padded(); ++k)
      for (int c = 0; c < 3; ++c)
        entry(kPole + c, k) =
            k < tables_.count ? frames[(4 * c + 3) * tables_.count + tables_.poles[index(k)]] : S(0);
    for (int at = 0; at < padded(); at += kLanes) place_bodies(frames + at, at);
    spread(
        kVelocity, kMoved, [](int) { return S(0); },
        [&](int k, int c) { return entry(kTwist + c, k) * qd[k]; });
    for (int at = 0; at < padded(); at += kLanes) take_velocities(at);
    correct_triples();
    add_up<9>(kMoments, [&](S* sum, const S* way, int k) {
      S *const h = sum, *const J = sum + 3;
      const S mass = tables_.totals[index(k)];
      // Integrals of (r + way)_i (r + way)_j less those of r_i r_j.
      const auto more = [&](int i, int j) { return h[i] * way[j] + way[i] * (h[j] + mass * way[j]); };
      const S xx = more(0, 0), yy = more(1, 1), zz = more(2, 2);
      J[0] += yy + zz;
      J[1] += xx + zz;
      J[2] += xx + yy;
      J[3] -= more(0, 1);
      J[4] -= more(0, 2);
      J[5] -= more(1, 2);
      for (int c = 0; c < 3; ++c) h[c] += mass * way[c];
    });
    add_up<12>(kMomentum, [](S* sum, const S* way, int) {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum[3 + 3 * i + j] += way[i] * sum[j];
    });
    for (int at = 0; at < padded(); at += kLanes) move_by_units(at);
  }

  /// What a row adds to what carries it, about O of its run.
  struct Joint {
    S twist[6], mass, moment[3], inertia[6];  ///< of its body m, h, J: xx yy zz xy xz yz
    S armature, inertia_of_all;               ///< M_kk: of the speed, with all that it moves
  };
  Joint joint(int k) const {
    Joint out;
    for (int c = 0; c < 6; ++c) out.twist[c] = entry(kTwist + c, k);
    out.mass = tables_.masses[index(k)];
    for (int c = 0; c < 3; ++c) out.moment[c] = entry(kBodyMoment + c, k);
    for (int c = 0; c < 6; ++c) out.inertia[c] = entry(kBodyInertia + c, k);
    out.armature = out.inertia_of_all = tables_.armatures[index(k)];
    for (int c = 0; c < 6; ++c) out.inertia_of_all += out.twist[c] * entry(kUnit + c, k);
    return out;
  }
  /// From O of one row's run to that of another's.
  std::array<S, 3> way(int from, int to) const {
    std::array<S, 3> out;
    for (int c = 0; c < 3; ++c) out[index(c)] = entry(kPole + c, to) - entry(kPole + c, from);
    return out;
  }

  /// Rows of M up to the diagonal; what stands after it is left open.
  /// \param M  count x count, and room for kLanes more
  void mass_matrix(S* M) {
    for (int row = 0; row < tables_.count; ++row) {
      if (row == tables_.starts[index(row)])
        see(row, true, [&](int at, const Three& way) {
          store(kSeen, at, three(kTwist + 3, at) + cross(way, three(kTwist, at)));
        });
      S* const to = M + row * tables_.count;
      const Known moment(*this, kUnit, row), force(*this, kUnit + 3, row);
      each_block(
          0, row + 1, tables_.carriers[index(row)], [&](int at) { Lanes::store(to + at, Vector{}); },
          [&](int at, auto&& chosen) {
            Lanes::store(to + at, chosen(force.times(*this, kSeen, at, moment.times(*this, kTwist, at))));
          });
      to[row] += tables_.armatures[index(row)];
    }
  }

  /// \param qdd  rates of the speeds by rows, or null: zeros
  void set_accelerations(const S* qd, const S* qdd) {
    const auto gravity = [&](int c) { return c < 3 ? S(0) : -tables_.gravity[index(c - 3)]; };
    if (qdd == nullptr)
      spread(kAcceleration, kMovedAcceleration, gravity,
             [&](int k, int c) { return entry(kPsi + c, k) * qd[k]; });
    else
      spread(kAcceleration, kMovedAcceleration, gravity,
             [&](int k, int c) { return entry(kPsi + c, k) * qd[k] + entry(kTwist + c, k) * qdd[k]; });
    for (int at = 0; at < padded(); at += kLanes) load_bodies(at);
    add_up<6>(kLoad, [](S* sum, const S* way, int) {
      for (int c = 0; c < 3; ++c) sum[c] += crossed(way, sum + 3, c);
    });
  }

  /// Generalized forces by rows, but for what armatures take.
  /// \param tau  count, and room for kLanes more
  void forces(S* tau) const {
    for (int at = 0; at < padded(); at += kLanes) {
      Vector x = load(kTwist, at) * load(kLoad, at);
      for (int c = 1; c < 6; ++c) x = x + load(kTwist + c, at) * load(kLoad + c, at);
      Lanes::store(tau + at, x);
    }
  }

  /// Derivatives of the generalized forces along the speeds and by the speeds.
  /// \param tau_q, tau_qd  count x count, row by row, and room for kLanes more
  void derivatives(S* tau_q, S* tau_qd) {
    for (int at = 0; at < padded(); at += kLanes) change(at);
    for (int row = 0; row < tables_.count; ++row) {
      if (row == tables_.starts[index(row)]) {
        see(row, true, [&](int at, const Three& way) {
          store(kSeen, at, three(kPsiRate + 3, at) + cross(way, three(kPsiRate, at)));
          store(kSeen + 3, at, three(kPsi2 + 3, at) + cross(way, three(kPsi2, at)));
        });
        see(row, false, [&](int at, const Three& way) {
          store(kSeen + 6, at, three(kAlong, at) + cross(way, three(kAlong + 3, at)));
          store(kSeen + 9, at, three(kBySpeed, at) + cross(way, three(kBySpeed + 3, at)));
        });
      }
      S *const along = tau_q + row * tables_.count, *const by_speed = tau_qd + row * tables_.count;
      const auto none = [&](int at) {
        Lanes::store(along + at, Vector{});
        Lanes::store(by_speed + at, Vector{});
      };
      {
        const Known moment(*this, kUnit, row), force(*this, kUnit + 3, row), rate(*this, kUnitRate, row);
        each_block(0, row + 1, tables_.carriers[index(row)], none, [&](int at, auto&& chosen) {
          const auto sum = [&](int turn, int slide, int velocity) {
            return rate.times(*this, velocity, at,
                              force.times(*this, slide, at, moment.times(*this, turn, at)));
          };
          Lanes::store(along + at, chosen(sum(kPsi2, kSeen + 3, kPsi)));
          Lanes::store(by_speed + at, chosen(sum(kPsiRate, kSeen, kTwist)));
        });
      }
      const Known turn(*this, kTwist, row), slide(*this, kTwist + 3, row);
      const auto power = [&](int moment, int force, int at) {
        return slide.times(*this, force, at, turn.times(*this, moment, at));
      };
      const auto& carried = tables_.carried[index(row)];
      const int own = row / kLanes * kLanes;
      if (const unsigned lanes = carried[index(own / kLanes)]; lanes != 0) {
        const auto add = [&](S* to, const Vector& more) {
          Lanes::store(to, Lanes::load(to) + Lanes::chosen(more, lanes));
        };
        add(along + own, power(kSeen + 6, kAlong + 3, own));
        add(by_speed + own, power(kSeen + 9, kBySpeed + 3, own));
      }
      each_block(own + kLanes, tables_.count, carried, none, [&](int at, auto&& chosen) {
        Lanes::store(along + at, chosen(power(kSeen + 6, kAlong + 3, at)));
        Lanes::store(by_speed + at, chosen(power(kSeen + 9, kBySpeed + 3, at)));
      });
    }
    // Speeds of one quaternion carry each other: forces turn along.
    for (int first = 0; first < tables_.count; ++first) {
      if (!tables_.first_of_three[index(first)]) continue;
      for (int i = first; i < first + 3; ++i)
        for (int j = i + 1; j < first + 3; ++j) {
          S sum = 0;
          for (int c = 0; c < 6; ++c) sum += entry(kUnit + c, i) * entry(kPsi2 + c, j);
          for (int c = 0; c < 3; ++c) sum += entry(kUnitRate + c, i) * entry(kPsi + c, j);
          tau_q[i * tables_.count + j] = sum;
        }
    }
  }

 private:
  static constexpr unsigned kAll = (1U << kLanes) - 1;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int padded() const { return (tables_.count + kLanes - 1) / kLanes * kLanes; }
  S* row(int quantity) { return values_.data() + quantity * kPadded; }
  const S* row(int quantity) const { return values_.data() + quantity * kPadded; }
  S& entry(int quantity, int k) { return row(quantity)[k]; }
  const S& entry(int quantity, int k) const { return row(quantity)[k]; }
  Vector load(int quantity, int at) const { return Lanes::load(row(quantity) + at); }
  Three three(int quantity, int at) const {
    return {load(quantity, at), load(quantity + 1, at), load(quantity + 2, at)};
  }
  Symmetric symmetric(int quantity, int at) const {
    return {load(quantity, at),     load(quantity + 1, at), load(quantity + 2, at),
            load(quantity + 3, at), load(quantity + 4, at), load(quantity + 5, at)};
  }
  Square square(int quantity, int at) const {
    return {{three(quantity, at), three(quantity + 3, at), three(quantity + 6, at)}};
  }
  void store(int quantity, int at, const Vector& x) { Lanes::store(row(quantity) + at, x); }
  void store(int quantity, int at, const Three& x) {
    store(quantity, at, x.x);
    store(quantity + 1, at, x.y);
    store(quantity + 2, at, x.z);
  }
  static Vector of(const typename Tables::Row& values, int at) { return Lanes::load(values.data() + at); }
  static Three of(const std::array<typename Tables::Row, 3>& values, int at) {
    return {of(values[0], at), of(values[1], at), of(values[2], at)};
  }

  /// Twists, and h and J of the bodies.
  void place_bodies(const S* frames, int at) {
    const auto frame = [&](int entry) { return Lanes::load(frames + entry * tables_.count); };
    const Square R{
        {{frame(0), frame(1), frame(2)}, {frame(4), frame(5), frame(6)}, {frame(8), frame(9), frame(10)}}};
    const auto from_pole = [&](int c) { return frame(4 * c + 3) - load(kPole + c, at); };
    const Three origin{from_pole(0), from_pole(1), from_pole(2)};
    const Three axis = R * of(tables_.axes, at);
    const Vector turns = of(tables_.turns, at), slides = S(1) - turns;
    store(kTwist, at, turns * axis);
    store(kTwist + 3, at, plus_scaled(turns * cross(origin, axis), slides, axis));
    const Three c = R * of(tables_.centers, at) + origin;
    const Three h = of(tables_.masses, at) * c;
    const auto& J = tables_.inertias;
    const Symmetric own{of(J[0], at), of(J[1], at), of(J[2], at), of(J[3], at), of(J[4], at), of(J[5], at)};
    const Three Q[3] = {own * R.rows[0], own * R.rows[1], own * R.rows[2]};
    store(kBodyMoment, at, h);
    store(kBodyInertia, at, dot(Q[0], R.rows[0]) + h.y * c.y + h.z * c.z);
    store(kBodyInertia + 1, at, dot(Q[1], R.rows[1]) + h.x * c.x + h.z * c.z);
    store(kBodyInertia + 2, at, dot(Q[2], R.rows[2]) + h.x * c.x + h.y * c.y);
    store(kBodyInertia + 3, at, dot(Q[0], R.rows[1]) - h.x * c.y);
    store(kBodyInertia + 4, at, dot(Q[0], R.rows[2]) - h.x * c.z);
    store(kBodyInertia + 5, at, dot(Q[1], R.rows[2]) - h.y * c.z);
  }

  /// Psi, E, and what each body has of the sums.
  void take_velocities(int at) {
    const Three V = three(kVelocity, at), v = three(kVelocity + 3, at);
    const Three xi = three(kTwist, at), d = three(kTwist + 3, at);
    const Three turn = cross(V, xi), slide = cross(V, d) + cross(v, xi);
    store(kPsi, at, turn);
    store(kPsi + 3, at, slide);
    store(kPsiRate, at, turn + turn);
    store(kPsiRate + 3, at, slide + slide);
    const Three om = three(kMoved, at), u = three(kMoved + 3, at), h = three(kBodyMoment, at);
    const Symmetric J = symmetric(kBodyInertia, at);
    const Three p = plus_scaled(cross(om, h), of(tables_.masses, at), u);
    const Vector half = S(0.5) * (J.xx + J.yy + J.zz);
    const Square P{{plus_scaled(cross(om, {half - J.xx, -J.xy, -J.xz}), h.x, u),
                    plus_scaled(cross(om, {-J.xy, half - J.yy, -J.yz}), h.y, u),
                    plus_scaled(cross(om, {-J.xz, -J.yz, half - J.zz}), h.z, u)}};
    store(kBodyTurning, at, scaled_less(P.trace(), om, P.transposed_times(om)));
    store(kBodyTurning + 3, at, cross(om, p));
    store(kMoments, at, h);
    for (int c = 0; c < 6; ++c) store(kInertia + c, at, load(kBodyInertia + c, at));
    store(kMomentum, at, p);
    for (int c = 0; c < 3; ++c) store(kSpread + 3 * c, at, P.rows[c]);
  }

  /// E of the speeds of quaternions.
  void correct_triples() {
    for (int first = 0; first < tables_.count; ++first) {
      if (!tables_.first_of_three[index(first)]) continue;
      const int last = first + 2;
      for (int k = first; k <= last; ++k)
        for (int c = 0; c < 3; ++c) {
          const int y = (c + 1) % 3, z = (c + 2) % 3;
          const auto crossed = [&](int a, int b) {
            return entry(a + y, last) * entry(b + z, k) - entry(a + z, last) * entry(b + y, k);
          };
          entry(kPsiRate + c, k) = entry(kPsi + c, k) + crossed(kMoved, kTwist);
          entry(kPsiRate + 3 + c, k) =
              entry(kPsi + 3 + c, k) + crossed(kMoved, kTwist + 3) + crossed(kMoved + 3, kTwist);
        }
    }
  }

  /// Momentum of unit motions, of all that a speed moves.
  void move_by_units(int at) {
    const Three xi = three(kTwist, at), d = three(kTwist + 3, at), h = three(kMoments, at);
    const Square P = square(kSpread, at);
    store(kUnit, at, cross(h, d) + symmetric(kInertia, at) * xi);
    store(kUnit + 3, at, plus_scaled(cross(xi, h), of(tables_.totals, at), d));
    const Three g = cross(three(kMomentum, at), d) + scaled_less(P.trace(), xi, P * xi);
    store(kUnitRate, at, g + g);
  }

  /// Moment and force that accelerate each body.
  void load_bodies(int at) {
    const Three alpha = three(kMovedAcceleration, at), a = three(kMovedAcceleration + 3, at);
    const Three h = three(kBodyMoment, at);
    store(kLoad, at, cross(h, a) + symmetric(kBodyInertia, at) * alpha + three(kBodyTurning, at));
    store(kLoad + 3, at,
          plus_scaled(cross(alpha, h) + three(kBodyTurning + 3, at), of(tables_.masses, at), a));
  }

  /// Psi2, and what a change by each speed takes of the forces further in.
  void change(int at) {
    const Three V = three(kVelocity, at), v = three(kVelocity + 3, at);
    const Three A = three(kAcceleration, at), a = three(kAcceleration + 3, at);
    const Three xi = three(kTwist, at), d = three(kTwist + 3, at);
    const Three turn = three(kPsi, at), slide = three(kPsi + 3, at);
    const Three e2 = cross(A, xi) + cross(V, turn);
    const Three z = cross(A, d) + cross(a, xi) + (cross(V, slide) + cross(v, turn));
    store(kPsi2, at, e2);
    store(kPsi2 + 3, at, z);
    const Three h = three(kMoments, at), p = three(kMomentum, at), n = three(kLoad, at),
                f = three(kLoad + 3, at);
    const Symmetric J = symmetric(kInertia, at);
    const Square P = square(kSpread, at);
    const Vector mass = of(tables_.totals, at), trace = P.trace();
    const auto store_change = [&](int to, const Three& e1, const Three& angular, const Three& linear,
                                  const Three& moment, const Three& force) {
      const Three twice = cross(e1, p), more = scaled_less(trace, e1, P.transposed_times(e1));
      store(to, at, cross(h, linear) + J * angular + (more + more) + moment);
      store(to + 3, at, plus_scaled(cross(angular, h) + (twice + twice) + force, mass, linear));
    };
    store_change(kAlong, turn, e2, z, cross(xi, n) + cross(d, f), cross(xi, f));
    const Three none{};
    store_change(kBySpeed, xi, three(kPsiRate, at), three(kPsiRate + 3, at), none, none);
  }

  /// Three numbers of one row, to be multiplied with those of others.
  struct Known {
    Known(const AxisTree& tree, int quantity, int row)
        : x(tree.entry(quantity, row)), y(tree.entry(quantity + 1, row)), z(tree.entry(quantity + 2, row)) {}
    Vector times(const AxisTree& tree, int quantity, int at) const {
      return x * tree.load(quantity, at) + y * tree.load(quantity + 1, at) + z * tree.load(quantity + 2, at);
    }
    Vector times(const AxisTree& tree, int quantity, int at, const Vector& sum) const {
      return z * tree.load(quantity + 2, at) +
             (y * tree.load(quantity + 1, at) + (x * tree.load(quantity, at) + sum));
    }
    S x, y, z;
  };

  /// Before the rows of a run: call(at, way) for blocks of what carries one of them, or of what one carries, with the
  /// way from O of the run to that of each of the others.
  template <class Call>
  void see(int row, bool carriers, Call&& call) {
    const auto& lanes =
        carriers ? tables_.carriers[index(tables_.poles[index(row)])] : tables_.carried[index(row)];
    const Known own(*this, kPole, row);
    for (int at = 0; at < tables_.count; at += kLanes)
      if (lanes[index(at / kLanes)] != 0)
        call(at, {load(kPole, at) - own.x, load(kPole + 1, at) - own.y, load(kPole + 2, at) - own.z});
  }

  /// Blocks of columns from `at` on that start before `end`: of those without lanes none(at), of the others
  /// some(at, chosen), where chosen(x) is x in their lanes and 0 elsewhere.
  template <class Row, class None, class Some>
  static void each_block(int at, int end, const Row& lanes, None&& none, Some&& some) {
    for (; at < end; at += kLanes) {
      const unsigned own = lanes[index(at / kLanes)];
      if (own == kAll)
        some(at, [](const Vector& x) { return x; });
      else if (own != 0)
        some(at, [&](const Vector& x) { return Lanes::chosen(x, own); });
      else
        none(at);
    }
  }

  /// Twists from the root on: `before` is what carries a row has, `after` that and what the row adds.
  template <class Root, class Added>
  void spread(int before, int after, Root&& root, Added&& added) {
    S sum[6] = {};
    for (int k = 0; k < tables_.count; ++k) {
      const int parent = tables_.parents[index(k)];
      if (parent < 0)
        for (int c = 0; c < 6; ++c) sum[c] = root(c);
      else if (parent != k - 1)
        for (int c = 0; c < 6; ++c) sum[c] = entry(after + c, parent);
      if (parent >= 0 && k == tables_.starts[index(k)]) {
        const std::array<S, 3> r = way(parent, k);
        for (int c = 0; c < 3; ++c) sum[3 + c] += crossed(sum, r.data(), c);
      }
      // Three speeds of a quaternion have what carries them all.
      const bool within = tables_.is_within_three(k);
      for (int c = 0; c < 6; ++c) {
        entry(before + c, k) = within ? entry(before + c, k - 1) : sum[c];
        sum[c] += added(k, c);
        entry(after + c, k) = sum[c];
      }
    }
    for (int k = tables_.count; k < padded(); ++k)
      for (int c = 0; c < 6; ++c) entry(before + c, k) = entry(after + c, k) = S(0);
  }

  /// Adds to each row what those have that it carries.
  /// \param shift  shift(sum, way, row) makes what a row has, about a point, into the same about another, from where the
  ///               way leads to the first
  template <int entries, class Shift>
  void add_up(int quantity, Shift&& shift) {
    S sum[static_cast<std::size_t>(entries)] = {};
    for (int k = tables_.count; k-- > 0;) {
      const int parent = tables_.parents[index(k)];
      for (int c = 0; c < entries; ++c) {
        sum[c] += entry(quantity + c, k);
        entry(quantity + c, k) = sum[c];
      }
      if (parent >= 0 && k == tables_.starts[index(k)]) shift(sum, way(parent, k).data(), k);
      if (parent == k - 1 && parent >= 0) continue;
      if (parent >= 0)
        for (int c = 0; c < entries; ++c) entry(quantity + c, parent) += sum[c];
      for (int c = 0; c < entries; ++c) sum[c] = S(0);
    }
  }

  const Tables& tables_;
  Scratch<S, N, kPadded * kQuantities> values_;
};

}  // namespace ALEMBERT_INSTRUCTIONS
}  // namespace detail
}  // namespace alembert
