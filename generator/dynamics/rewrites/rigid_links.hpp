// The tree of motions as rigid links: one link for each motion that moves, with the constant poses between
// them, which are numbers, and pseudo-inertias. Frame placement and inertia regrouping work on it;
// `link_tree` turns the result back into a tree of motions. A constant motion that depends on a runtime
// parameter is a link of its own, which does not move: frames before and after it are placed without regard
// to each other, and it hands nothing to its parent.
//
// Placement: a rotation about an axis commutes with turns about and slides along that axis, so frames are
// turned and slid until the constant pose between two rotations is a twist alpha, a length a and an offset d
// (Denavit and Hartenberg), with the offset before the rotation it belongs to: both shifts happen in one
// frame.
//
// Axes that are nearly parallel have the feet of their common normal far away: frames there would multiply
// all rounding errors. Where the feet are farther than a few lengths of the links, frames stay near: the
// parent's slides only to where the next origin is beside it.
//
// All numbers have 50 digits, and are compared with what they are sums of: what the data say is kept, however
// small, and no unit of length or mass is preferred.
//
// Regrouping: a symmetric 4x4 part d of a link's pseudo-inertia may move to its parent, S_parent += X d X^T,
// exactly when (dA/dq) d = 0, that is when its range lies in the points and directions that the motion leaves
// still, and when no part becomes much larger than the inertia that it is of, since what cancels leaves only
// rounding. What an inertia has of runtime parameters (link_inertia.hpp) moves with the numbers or stays.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "dynamics/rewrites/link_inertia.hpp"
#include "dynamics/rewrites/written_tree.hpp"
#include "dynamics/tree/motion_tree.hpp"

namespace alembert {

/// Where on a link its mass is written down: the frame after its motion, or, towards its main child, after
/// the twist, the length, the offset.
enum class MassFrame { joint, twist, length, offset };
inline constexpr std::array kMassFrames{MassFrame::joint, MassFrame::twist, MassFrame::length,
                                        MassFrame::offset};

/// How a link's inertia is written: entries made zero by moving what the motion allows to the parent (and
/// into point masses at the other frames), bit i for kInertiaEntries[i].
struct Regrouping {
  MassFrame frame = MassFrame::joint;
  unsigned zeros = 0;
  unsigned points = 0;  ///< bit k: a point mass at the origin of kMassFrames[k]
  bool moves_terms =
      false;  ///< runtime terms move like the numbers, without point masses; otherwise they stay in the link
  MomentForms forms{};
  /// Whether an inertia is split alike: `forms` has no part in it.
  bool splits_like(const Regrouping& other) const {
    return frame == other.frame && zeros == other.zeros && points == other.points &&
           moves_terms == other.moves_terms;
  }
};

struct RigidLink {
  int node = -1;        ///< the node of the tree it was made from: a moving one, or one of runtime parameters
  int parent = -1;      ///< link, or -1: world
  int main_child = -1;  ///< the child, turning about an axis, towards which the frames are placed
  bool turns = false;   ///< rotation about a coordinate axis: from here on the z axis
  bool moves = true;    ///< false: a constant that depends on a runtime parameter
  bool grounded = false;  ///< does not move, and nothing before it does
  Extended angle_offset = 0;
  Extended twist = 0, length = 0, offset = 0;  ///< from the parent, if this is its main child
  bool twisted = false;                        ///< by more than what only renames axes
  Matrix4e before = Matrix4e::Identity();  ///< parent's frame to this one before its motion, offset included
  LinkInertia inertia;                     ///< in the frame after the motion
  Matrix4e adjusted = Matrix4e::Identity();  ///< node's frame after its motion to this link's frame
  Extended size = 0;  ///< length: as far as it, or a link beyond it, reaches from its joint
};

/// The inverse of a pose [R p; 0 1].
Matrix4e rigid_inverse(const Matrix4e& pose);
inline const Extended kRightAngle = acos(Extended(0));

/// Links of one mechanism; the tree must outlive it.
class RigidLinks {
 public:
  /// Links with placed frames.
  RigidLinks(const Mechanism& mechanism, const MotionTree& tree, ExprGraph& graph);

  const std::vector<RigidLink>& links() const { return links_; }
  /// Whether an inertia depends on a runtime parameter.
  bool has_terms() const { return !terms_.empty(); }
  /// Whether link i turns about an axis that stands still.
  bool turns_about_fixed_axis(std::size_t i) const;

  /// Pseudo-inertia of link i in `frame`, given the one in the joint's frame.
  LinkInertia in_frame(std::size_t i, MassFrame frame, const LinkInertia& inertia) const;
  /// Whether the frame exists: all but `joint` need a main child.
  bool has_frame(std::size_t i, MassFrame frame) const;

  /// How many independent parts of its inertia link i can hand to its parent: r (r + 1) / 2 with r still
  /// points and directions.
  int movable_count(std::size_t i) const { return static_cast<int>(movable_[i].size()); }

  /// `remaining` is in the chosen frame, `moved` in the frame after the motion (zero if nothing moves),
  /// `points` are masses at the frames.
  struct Split {
    LinkInertia remaining, moved;
    std::array<Extended, 4> points{};
  };
  /// Splits of one inertia that differ in the entries that become zero only.
  class Splits {
   public:
    /// `how.zeros` is not read.
    Splits(const RigidLinks& links, std::size_t i, const Regrouping& how, const LinkInertia& inertia);
    /// Solves for what leaves the link so that these entries become zero. Nothing if they cannot be zeroed,
    /// or if a part would become much larger than the whole is.
    std::optional<Split> zeroing(unsigned zeros) const;

   private:
    friend class RigidLinks;
    using Solvers =
        std::map<unsigned, Eigen::FullPivLU<Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>>>;
    const Solvers::mapped_type& solver(const std::vector<std::pair<int, int>>& entries, unsigned zeros) const;
    bool take(Matrix4e& remaining, const Solvers::mapped_type& lu,
              const std::vector<std::pair<int, int>>& zeros, Matrix4e& moved,
              std::array<Extended, 4>* points) const;

    /// An entry of an inertia as a mass, so that entries can be compared.
    Extended as_mass(int row, int column, const Extended& entry) const;

    const Extended& length_;
    Solvers& solvers_;  ///< by the entries that become zero
    bool moves_terms_, possible_;
    LinkInertia inertia_;                 ///< in the frame
    const std::vector<Matrix4e>& basis_;  ///< what can move, in the joint's frame
    std::vector<Matrix4e> columns_;       ///< the same and the point masses, in the frame
    std::vector<std::size_t> points_;
    unsigned reached_ = 0;  ///< entries that a column has something in, by bits
  };
  std::optional<Split> split(std::size_t i, const Regrouping& how, const LinkInertia& inertia) const {
    return Splits(*this, i, how, inertia).zeroing(how.zeros);
  }

  /// Inertias flowing from the tips to the root: what each link has once its children have handed over their
  /// parts, and how it splits that. A link whose entries cannot be zeroed keeps everything.
  struct Flow {
    std::vector<LinkInertia> inertias;
    std::vector<Split> splits;
  };
  /// Valid until the next call, which computes anew only what differs.
  const Flow& flow(const std::vector<Regrouping>& regroupings) const;

  /// What the parent receives of a part moved by link i: X d X^T.
  LinkInertia to_parent(std::size_t i, const LinkInertia& moved) const;

  /// The tree of motions of the links, inertias written as asked for (one Regrouping a link).
  WrittenTree link_tree(const std::vector<Regrouping>& regroupings, ExprGraph& graph) const;

 private:
  void measure();  ///< sizes of the links
  void place();    ///< turns and slides the frames about the axes
  std::vector<Matrix4e> movable(std::size_t i) const;
  void keep_frames();  ///< fills frames_ and movable_

  /// A frame of a link that its mass may be written down in.
  struct Frame {
    Matrix4e pose, back;            ///< from the joint's frame and to it
    std::vector<Matrix4e> movable;  ///< what can move, in this frame
  };
  const Frame& frame(std::size_t i, MassFrame which) const {
    return frames_[i][static_cast<std::size_t>(which)];
  }
  /// The nodes of a tree of these links, without masses, and those of each MassFrame of a link.
  struct Skeleton {
    MotionTree tree;
    std::vector<std::array<int, 4>> frames;
  };
  Skeleton skeleton(ExprGraph& graph) const;
  std::vector<BodyPlace> places(const Skeleton& skeleton, ExprGraph& graph) const;

  const MotionTree* tree_ = nullptr;
  RuntimeTerms terms_;
  std::vector<RigidLink> links_;
  std::vector<int> link_of_node_;           ///< link that a node moves with; -1: world
  std::vector<Matrix4e> pose_of_node_;      ///< of a node in its link's original frame
  Extended length_ = 0;                     ///< of the whole
  std::vector<std::vector<Frame>> frames_;  ///< of each link those that exist
  std::vector<std::vector<Matrix4e>> movable_;
  // Trees of the same links are asked for again and again, and inertias that flow nearly alike.
  struct KnownFlow {
    std::vector<Regrouping> regroupings;
    Flow flow;
    std::vector<LinkInertia> handed;  ///< to the parent
  };
  mutable KnownFlow known_;
  mutable std::map<std::tuple<std::size_t, MassFrame, unsigned>, Splits::Solvers>
      solvers_;  ///< link, frame and points
  mutable std::optional<Skeleton> skeleton_;
};

}  // namespace alembert
