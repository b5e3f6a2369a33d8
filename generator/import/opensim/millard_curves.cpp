#include "import/opensim/millard_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "import/common/snapped_angle.hpp"

namespace alembert {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::max();
constexpr double kLeast = 1e-9;  // by which bounds that may be met are passed

struct CurvePoint {
  double x, y;
  bool corner = false;
};

/// Value of the natural cubic spline through the points at x within them, from its second derivatives.
double natural_spline(const std::vector<CurvePoint>& p, const std::vector<double>& bend, double x) {
  std::size_t i = 0;
  while (i + 2 < p.size() && x > p[i + 1].x) ++i;
  const double h = p[i + 1].x - p[i].x, a = (p[i + 1].x - x) / h, b = 1 - a;
  return a * p[i].y + b * p[i + 1].y +
         ((a * a * a - a) * bend[i] + (b * b * b - b) * bend[i + 1]) * h * h / 6;
}

std::vector<double> natural_bends(const std::vector<CurvePoint>& p) {
  std::vector<double> bend(p.size(), 0), rest(p.size(), 0);
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const double before = p[i].x - p[i - 1].x, after = p[i + 1].x - p[i].x, share = before / (before + after);
    const double pivot = share * bend[i - 1] + 2;
    const double turn = (p[i + 1].y - p[i].y) / after - (p[i].y - p[i - 1].y) / before;
    bend[i] = (share - 1) / pivot;
    rest[i] = (6 * turn / (before + after) - share * rest[i - 1]) / pivot;
  }
  bend.back() = 0;
  for (std::size_t i = p.size() - 1; i-- > 1;) bend[i] = bend[i] * bend[i + 1] + rest[i];
  bend.front() = 0;
  return bend;
}

double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

/// Points of the quintic Bezier curves between corners.
template <class Corner>
std::vector<CurvePoint> bezier_curves(const std::vector<Corner>& corners) {
  // The control points of a corner lie on the tangents at its ends.
  constexpr int kSteps = 200;
  std::vector<CurvePoint> curve;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Corner &a = corners[i], &b = corners[i + 1];
    const double meet = std::abs(a.slope - b.slope) < 1e-8
                            ? (a.x + b.x) / 2
                            : (b.y - a.y - b.x * b.slope + a.x * a.slope) / (a.slope - b.slope);
    const double c = 0.1 + 0.8 * a.curviness, up = a.x + c * (meet - a.x), down = b.x + c * (meet - b.x);
    const double xs[] = {a.x, up, up, down, down, b.x};
    const double first = a.y + a.slope * (up - a.x), second = b.y + b.slope * (down - b.x);
    const double ys[] = {a.y, first, first, second, second, b.y};
    for (int k = i == 0 ? 0 : 1; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps, s = 1 - t;
      const double weight[] = {s * s * s * s * s,      5 * s * s * s * s * t, 10 * s * s * s * t * t,
                               10 * s * s * t * t * t, 5 * s * t * t * t * t, t * t * t * t * t};
      CurvePoint point{0, 0, k == 0 || k == kSteps};
      for (std::size_t m = 0; m < 6; ++m) {
        point.x += weight[m] * xs[m];
        point.y += weight[m] * ys[m];
      }
      curve.push_back({rounded(point.x), rounded(point.y), point.corner});
    }
  }
  return curve;
}

}  // namespace

std::string MillardCurves::Spline::text(const std::string& argument) const {
  const std::string within =
      ends == Ends::flat   ? fmt::format("clamp({}, {}, {})", argument, number_text(first), number_text(last))
      : ends == Ends::grow ? fmt::format("max({}, {})", argument, number_text(first))
                           : argument;
  return fmt::format("spline({}; {})", within, points);
}

MillardCurves::Spline MillardCurves::spline(const std::vector<Corner>& corners, Ends ends, bool inverse) {
  std::vector<CurvePoint> knots, curve = bezier_curves(corners);
  if (inverse)
    for (CurvePoint& point : curve) std::swap(point.x, point.y);
  std::ranges::copy_if(curve, std::back_inserter(knots), &CurvePoint::corner);
  // A knot more where the spline is farthest off, until it is near everywhere.
  constexpr std::size_t kMost = 30;
  while (knots.size() < kMost) {
    const std::vector<double> bends = natural_bends(knots);
    const auto off = [&](const CurvePoint& point) {
      return std::abs(natural_spline(knots, bends, point.x) - point.y);
    };
    const auto worst = std::ranges::max_element(curve, {}, off);
    if (off(*worst) <= kTolerance) break;
    const auto next = std::ranges::find_if(knots, [&](const CurvePoint& knot) { return knot.x >= worst->x; });
    if (next != knots.end() && next->x == worst->x) break;
    knots.insert(next, *worst);
  }
  std::vector<std::string> xs, ys;
  for (const CurvePoint& knot : knots) {
    xs.push_back(number_text(knot.x));
    ys.push_back(number_text(knot.y));
  }
  return {fmt::format("[{}]; [{}]", fmt::join(xs, ", "), fmt::join(ys, ", ")), knots.front().x,
          knots.back().x, ends};
}

std::vector<MillardCurves::Hyperbola> MillardCurves::hyperbolas(const std::vector<Corner>& corners) {
  constexpr std::ptrdiff_t kEvery = 4, kTries = 12;
  std::vector<CurvePoint> curve;
  for (std::size_t i = 0; const CurvePoint& point : bezier_curves(corners))
    if (i++ % kEvery == 0) curve.push_back(point);
  // The nearest of the hyperbolas through two points of the curve and one between them, if it is near enough.
  using Place = std::vector<CurvePoint>::const_iterator;
  const auto through = [](Place a, Place b) -> std::optional<Hyperbola> {
    const double width = b->x - a->x, height = b->y - a->y;
    std::optional<Hyperbola> best;
    double least = kTolerance;
    for (std::ptrdiff_t k = 1; k < kTries; ++k) {
      const Place middle = a + (b - a) * k / kTries;
      const double w = middle->x - a->x, rise = middle->y - a->y;
      if (!(rise > 0) || !(rise < height)) continue;
      const double bend = rounded((height * w / width - rise) / (w * (rise - height))),
                   slope = rounded(height * (1 + bend * width) / width);
      if (!(slope > 0) || !(1 + bend * width > 0)) continue;
      double off = 0;
      for (Place at = a; at <= b; ++at) {
        const double x = at->x - a->x;
        off = std::max(off, std::abs(a->y + slope * x / (1 + bend * x) - at->y));
      }
      if (off <= least) {
        least = off;
        best = Hyperbola{a->x, a->y, slope, bend};
      }
    }
    return best;
  };
  // Each as wide as it may be.
  std::vector<Hyperbola> found;
  for (Place a = curve.begin(); a + 1 < curve.end();) {
    Place near = a + 1, far = curve.end();  // what does, and what does not
    Hyperbola best{a->x, a->y, rounded((near->y - a->y) / (near->x - a->x)), 0};
    while (far - near > 1) {
      const Place b = near + (far - near) / 2;
      const std::optional<Hyperbola> wider = through(a, b);
      (wider ? near : far) = b;
      if (wider) best = *wider;
    }
    found.push_back(best);
    a = near;
  }
  found.push_back({curve.back().x, curve.back().y, 0, 0});
  return found;
}

// With load = active y + damping v, a load of d more than where a hyperbola begins leads w further:
// damping bend w^2 + (active slope + damping - bend d) w - d = 0.
std::string MillardCurves::speed(const std::string& load, const std::string& active, double damping) const {
  const auto added = [](double value) {  // small dampings have their digits, too
    return fmt::format("{} {}", value < 0 ? "-" : "+",
                       number_text(std::round(std::abs(value) * 1e12) / 1e12));
  };
  const auto sum_of = [&](double forces, double speeds) {
    return fmt::format("{}*{} {}", number_text(rounded(forces)), active, added(damping * speeds));
  };
  const Hyperbola &first = speeds_.front(), &last = speeds_.back();
  std::string speed = fmt::format("{} + min({} - ({}), 0)/{}", number_text(first.x), load,
                                  sum_of(first.y, first.x), number_text(damping));
  for (std::size_t k = 0; k + 1 < speeds_.size(); ++k) {
    const Hyperbola &h = speeds_[k], &next = speeds_[k + 1];
    const std::string more =
        fmt::format("clamp({} - ({}), 0, {})", load, sum_of(h.y, h.x), sum_of(next.y - h.y, next.x - h.x));
    const std::string b = fmt::format("({} {}*{})", sum_of(h.slope, 1), added(-h.bend), more);
    speed += fmt::format(" + 2*{0}/({1} + sqrt({1}^2 {2}*{0}))", more, b, added(4 * damping * h.bend));
  }
  return fmt::format("({} + max({} - ({}), 0)/{})", speed, load, sum_of(last.y, last.x),
                     number_text(damping));
}

// With a rigid tendon, as with damped fibres, OpenSim takes 0 for <minimum_value>, <concentric_slope_at_vmax> and
// <eccentric_slope_at_vmax>, whatever the file says; else at least 0.1 and half of the slopes near the largest speed.
MillardCurves::MillardCurves(const OsimXml& xml, pugi::xml_node muscle, bool steep) {
  const pugi::xml_node length = muscle.child("ActiveForceLengthCurve"),
                       fibre = muscle.child("FiberForceLengthCurve"),
                       speed = muscle.child("ForceVelocityCurve"),
                       tendon = muscle.child("TendonForceLengthCurve");
  // Between the bounds that OpenSim sets.
  const auto number = [&](pugi::xml_node curve, const char* property, double otherwise, double above,
                          double below) {
    const pugi::xml_node found = xml.property(curve, property);
    // They are optional: OpenSim writes empty elements for what it works out.
    const double value = text_of_element(found).empty() ? otherwise : xml.number(curve, property, otherwise);
    if (value > above && value < below) return value;
    const std::string least = number_text(rounded(above) + 0.0);  // not -0
    throw InputError(
        xml.where(found ? found : muscle),
        fmt::format("<{}> of {} is {}; expected a number {}", property, OsimXml::title(muscle),
                    number_text(value),
                    below < kNoBound ? fmt::format("between {} and {}", least, number_text(rounded(below)))
                                     : "above " + least));
  };
  {  // Ascending, shallow, plateau at 1, descending.
    const double x0 = number(length, "min_norm_active_fiber_length", 0.4441, -kLeast, 1),
                 x1 = number(length, "transition_norm_fiber_length", 0.73, x0, 1),
                 x3 = number(length, "max_norm_active_fiber_length", 1.8123, 1, kNoBound),
                 slope = number(length, "shallow_ascending_slope", 0.8616, -kLeast, 1 / (1 - x1));
    constexpr double kHalfPlateau = 0.05;
    const double shoulder = 1 - kHalfPlateau, y1 = 1 - slope * (shoulder - x1);
    const double down = (1 + kHalfPlateau + x3) / 2;
    const double least = steep ? std::max(0.1, number(length, "minimum_value", 0.1, -kLeast, 1)) : 0;
    shortest_ = x0;
    active_ = spline({{x0, least, 0, 1},
                      {(x0 + x1) / 2, y1 / 2, 1.25 * y1 / (x1 - x0), 1},
                      {(x1 + shoulder) / 2, (1 + y1) / 2, slope, 1},
                      {1, 1, 0, 1},
                      {down, 0.5, -1 / (x3 - kHalfPlateau - (1 + kHalfPlateau)), 1},
                      {x3, least, 0, 1}},
                     Ends::flat);
  }
  {
    const double none = 1 + number(fibre, "strain_at_zero_force", 0, -1, kNoBound),
                 one = 1 + number(fibre, "strain_at_one_norm_force", 0.7, none - 1, kNoBound),
                 mean = 1 / (one - none), low = number(fibre, "stiffness_at_low_force", 0.2, 0, mean),
                 high = number(fibre, "stiffness_at_one_norm_force", 2 * mean, mean, kNoBound),
                 curviness = number(fibre, "curviness", 0.75, -kLeast, 1 + kLeast),
                 foot = std::min(0.1 / high, 0.1 * (one - none));
    passive_ = spline(
        {{none, 0, 0, curviness}, {none + foot, low * foot / 2, low, curviness}, {one, 1, high, curviness}},
        Ends::grow);
  }
  {
    const double near_c = number(speed, "concentric_slope_near_vmax", 0.25, 0, 1 + kLeast),
                 middle = number(speed, "isometric_slope", 5, 1, kNoBound),
                 most = number(speed, "max_eccentric_velocity_force_multiplier", 1.4, 1, kNoBound),
                 near_e = number(speed, "eccentric_slope_near_vmax", 0.15, 0, most - 1),
                 bend_c = number(speed, "concentric_curviness", 0.6, -kLeast, 1 + kLeast),
                 bend_e = number(speed, "eccentric_curviness", 0.9, -kLeast, 1 + kLeast);
    const double end_c = steep ? std::max(near_c / 2,
                                          number(speed, "concentric_slope_at_vmax", 0, -kLeast, near_c))
                               : 0,
                 end_e = steep ? std::max(near_e / 2, number(speed, "eccentric_slope_at_vmax", 0, -kLeast,
                                                             near_e + kLeast))
                               : 0;
    std::vector<Corner> corners = {{-1, 0, end_c, bend_c},
                                   {-0.9, 0.05 * (near_c + end_c), near_c, bend_c},
                                   {0, 1, middle, bend_e},
                                   {0.9, most - 0.05 * (near_e + end_e), near_e, bend_e},
                                   {1, most, end_e, bend_e}};
    over_speed_ = spline(corners, Ends::flat);
    if (steep) {  // Straight beyond the largest speeds.
      corners.insert(corners.begin(), {-3, -2 * end_c, end_c, bend_c});
      corners.push_back({3, most + 2 * end_e, end_e, bend_e});
      over_load_ = spline(corners, Ends::straight, true);
    } else {
      speeds_ = hyperbolas(corners);
    }
  }
  {  // Over the strain: a toe in two pieces, and a straight line.
    const double one = number(tendon, "strain_at_one_norm_force", 0.049, 0, kNoBound),
                 stiffness = number(tendon, "stiffness_at_one_norm_force", 1.375 / one, 1 / one, kNoBound),
                 toe = number(tendon, "norm_force_at_toe_end", 2.0 / 3, 0, 1),
                 curviness = number(tendon, "curviness", 0.5, -kLeast, 1 + kLeast);
    const double toe_end = (toe - 1) / stiffness + one, foot = toe_end / 10,
                 half = (toe / 2 - 1) / stiffness + one, slope = toe / 2 / (half - foot),
                 meet = (foot + half) / 2, far = 3 * one;
    tendon_ = spline({{0, 0, 0, curviness},
                      {meet, slope * (meet - foot), slope, curviness},
                      {toe_end, toe, stiffness, curviness},
                      {far, 1 + stiffness * (far - one), stiffness, curviness}},
                     Ends::grow);
  }
}

}  // namespace alembert
