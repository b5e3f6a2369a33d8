// Sources of the laws: Thelen, Adjustment of Muscle Mechanics Model Parameters to Simulate Dynamic Contractions in Older
// Adults, Journal of Biomechanical Engineering 125 (2003), 70-77; Millard, Uchida, Seth and Delp, Flexing Computational
// Muscle, Journal of Biomechanical Engineering 135 (2013), 021005; De Groote, Kinney, Rao and Fregly, Evaluation of
// Direct Collocation Optimal Control Problem Formulations for Solving the Muscle Redundancy Problem, Annals of
// Biomedical Engineering 44 (2016), 2922-2936; Schutte, Rodgers, Zajac and Glaser, Improving the Efficacy of Electrical
// Stimulation-Induced Leg Cycle Ergometry, IEEE Transactions on Rehabilitation Engineering 1 (1993), 109-125.
#include "import/opensim/osim_muscles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/millard_curves.hpp"
#include "import/opensim/osim_forces.hpp"
#include "import/opensim/osim_paths.hpp"

namespace alembert {
namespace {

/// The cosine of the largest pennation, unless the file says another one, ...
constexpr double kLeastCosine = 0.1;
/// ... and the shortest fibres where that is no angle, in optimal lengths.
constexpr double kShortestFibre = 0.01;

std::string n(double value) {
  return number_text(value);
}

/// Names and expressions of a muscle on an elastic tendon.
struct ElasticTendon {
  std::string fibre;   ///< the state, in optimal lengths
  std::string cosine;  ///< of the pennation
  std::string strain;
  std::string load;  ///< what the contractile elements carry, of the largest isometric force
  double shortest;   ///< the fibres may get, in optimal lengths
};

/// How an activation follows its excitation.
struct ActivationLaw {
  double rise, fall;     ///< time constants, in seconds
  double initial;        ///< activation
  double steepness = 0;  ///< of the tanh between rise and fall; 0 for a jump
  double least = 0.01;
  bool by_excitation = false;  ///< how quickly it rises depends on the excitation, and not on itself
};

/// One muscle while it is described.
class Muscle {
 public:
  Muscle(OsimDescription& out, pugi::xml_node element, const ActivationLaw& law)
      : out_(out),
        element_(element),
        at_(out.xml.where(element)),
        force_(out.xml.positive_number(element, "max_isometric_force", 1000)),
        fibre_(out.xml.positive_number(element, "optimal_fiber_length", 0.1)),
        slack_(out.xml.positive_number(element, "tendon_slack_length", 0.2, true)),
        speed_(out.xml.positive_number(element, "max_contraction_velocity", 10)),
        law_(law) {
    const char* const angle =
        out.xml.property(element, "pennation_angle") ? "pennation_angle" : "pennation_angle_at_optimal";
    pennation_ = out.xml.number(element, angle, 0);
    least_cosine_ =
        std::max(0.0, std::cos(out.xml.number(element, "maximum_pennation_angle", std::acos(kLeastCosine))));
  }

  /// Its force, with the path; none if there is no path.
  bool begin() {
    YamlNode& force = out_.add_force(OsimXml::name_of(element_), at_);
    if (!add_osim_path(out_, force, element_)) {
      out_.sections["forces"]->items.pop_back();
      return false;
    }
    node_ = &force;
    name_ = OsimDescription::name_of(force);
    add_activation();
    return true;
  }
  void finish(const std::string& tension) { out_.put(*node_, "tension", tension, at_); }

  double number(const char* property, double otherwise) const {
    return out_.xml.number(element_, property, otherwise);
  }
  double positive(const char* property, double otherwise) const {
    return out_.xml.positive_number(element_, property, otherwise);
  }
  bool flag(const char* property) const { return out_.xml.flag(element_, property, false); }
  /// A tendon of length 0 is rigid, too.
  bool has_rigid_tendon() {
    if (flag("ignore_tendon_compliance")) return true;
    if (slack_ == 0)
      out_.approximated(element_, "has a tendon of length 0: its fibres reach from end to end of its path");
    return slack_ == 0;
  }

  /// With a rigid tendon: length of the fibres in optimal lengths, their speed in the largest, and the cosine of the
  /// pennation. The muscle keeps its thickness.
  std::string rigid_length() const {
    if (pennation_ == 0) return fmt::format("(({})/{})", beyond_slack(), n(fibre_));
    return fmt::format("(sqrt({} + ({})^2)/{})", n(std::pow(fibre_ * std::sin(pennation_), 2)),
                       beyond_slack(), n(fibre_));
  }
  std::string rigid_cosine() const {
    if (pennation_ == 0) return "1";
    return fmt::format("({})/{}/{}", beyond_slack(), n(fibre_), rigid_length());
  }
  std::string rigid_speed() const {
    const std::string speed = fmt::format("rate/{}", n(fibre_ * speed_));
    return pennation_ == 0 ? "(" + speed + ")" : fmt::format("({}*{})", speed, rigid_cosine());
  }
  /// force * max(0, of) along the tendon, and 0 where the tendon is slack or the fibres are shorter than pennation and curves
  /// allow; `shortest` is what the curves allow, in optimal lengths.
  std::string rigid_tension(const std::string& of, double shortest) const {
    std::string along = fmt::format("{}*max(0, {})", n(force_), of);
    if (pennation_ != 0) along += "*" + rigid_cosine();
    const double thickness = fibre_ * std::sin(pennation_),
                 widest = std::sqrt(1 - least_cosine_ * least_cosine_);
    const double least =
        std::max(fibre_ * shortest, widest > 0 ? thickness / widest : fibre_ * kShortestFibre);
    const double reach = std::sqrt(std::max(0.0, least * least - thickness * thickness));
    return fmt::format("select({}, {}, 0)", beyond(slack_ + reach), along);
  }

  /// `shortest` is what the curves allow.
  ElasticTendon add_elastic_tendon(double shortest) {
    const std::string fibre = out_.names.add(name_ + "_fibre", at_);
    const double widest = std::sqrt(1 - least_cosine_ * least_cosine_);
    if (pennation_ != 0 && widest > 0) shortest = std::max(shortest, std::sin(pennation_) / widest);
    std::string cosine = "1";
    if (pennation_ != 0)
      cosine = out_.define(name_ + "_cosine",
                           fmt::format("sqrt(max({}, 1 - ({}/{})^2))", n(least_cosine_ * least_cosine_),
                                       n(std::sin(pennation_)), fibre),
                           at_);
    const std::string along = cosine == "1" ? fibre : fmt::format("{}*{}", fibre, cosine);
    const std::string strain = fmt::format("((length - {}*{})/{} - 1)", n(fibre_), along, n(slack_));
    return {fibre, cosine, strain, out_.names.add(name_ + "_load", at_), shortest};
  }
  /// An elastic tendon, and fibres whose length is a state. What the tendon bears beside what is passive is left for the
  /// contractile elements; `speed(load, active)` is how fast they move, in largest speeds, under this load where they pull
  /// `active` at rest. Forces are of the largest isometric one. Where fibres are shortest, the load of those that are
  /// `stopped` is no less than active: they get no shorter.
  template <class Curves, class Speed>
  void finish_elastic(const Curves& curves, double shortest, bool stopped, const Speed& speed) {
    const ElasticTendon tendon = add_elastic_tendon(shortest);
    const std::string active =
        out_.define(name_ + "_active", fmt::format("{}*{}", activation_, curves.active(tendon.fibre)), at_);
    finish(fmt::format("{}*{}", n(force_), curves.tendon(tendon.strain)));
    std::string load =
        fmt::format("tension({})/{}{} - {}", name_, n(force_),
                    tendon.cosine == "1" ? "" : "/" + tendon.cosine, curves.passive(tendon.fibre));
    if (stopped)
      load = fmt::format("select({0} - {1}, {2}, max({2}, {3}))", tendon.fibre, n(tendon.shortest), load,
                         active);
    out_.put(out_.nodes.add_named(*out_.sections["outputs"], tendon.load, at_), "value", load, at_);
    out_.add_state(tendon.fibre, number("default_fiber_length", fibre_) / fibre_,
                   {std::max(0.2, tendon.shortest), 2},
                   fmt::format("{}*{}", n(speed_), speed(tendon.load, active)), at_);
  }

  std::string add_output(const char* what, const std::string& value) {
    const std::string name = out_.names.add(name_ + what, at_);
    out_.put(out_.nodes.add_named(*out_.sections["outputs"], name, at_), "value", value, at_);
    return name;
  }
  /// The fibres of a muscle whose tendon's length is known, in slack lengths.
  struct Fibre {
    std::string length;  ///< in optimal lengths
    std::string cosine;  ///< of the pennation; none if there is none
  };
  Fibre add_fibre_on(const std::string& tendon) {
    const std::string along =
        add_output("_along", fmt::format("(length({}) - {}*{})/{}", name_, n(slack_), tendon, n(fibre_)));
    if (pennation_ == 0) return {along, {}};
    const std::string length =
        add_output("_fibre", fmt::format("sqrt({} + {}^2)", n(std::pow(std::sin(pennation_), 2)), along));
    return {length, fmt::format("({}/{})", along, length)};
  }
  /// The state of an elastic tendon that is told by what it bears, of the largest isometric force.
  std::string name_tendon_force() { return out_.names.add(name_ + "_tendon_force", at_); }
  /// Its rate, by the slope of what a tendon bears over its length in slack lengths, and the speed of the fibres along it,
  /// in largest ones.
  void add_tendon_force(const std::string& name, const std::string& slope, const std::string& speed) {
    constexpr double kMost = 5;
    out_.add_state(
        name, number("default_normalized_tendon_force", 0.5), {0, kMost},
        fmt::format("{}*(rate({}) - {}*{})/{}", slope, name_, n(speed_ * fibre_), speed, n(slack_)), at_);
  }

  OsimDescription& out_;
  pugi::xml_node element_;
  SourceLocation at_;
  double force_, fibre_, slack_, speed_, pennation_ = 0, least_cosine_ = kLeastCosine;
  ActivationLaw law_;
  std::string name_, activation_;
  YamlNode* node_ = nullptr;

 private:
  static std::string beyond(double length) {
    return length == 0 ? "length" : fmt::format("length - {}", n(length));
  }
  std::string beyond_slack() const { return beyond(slack_); }

  /// The input is the excitation, and the activation a state; or the input is the activation.
  void add_activation() {
    const double least = number("minimum_activation", law_.least),
                 initial = number("default_activation", law_.initial);
    std::array<double, 2> limits = osim_control_limits(out_.xml, element_);
    limits = {std::max(limits[0], least), std::min(limits[1], 1.0)};
    const std::string input =
        out_.add_input(name_, std::clamp(initial, limits[0], std::max(limits[0], limits[1])), limits, at_);
    activation_ = input;
    if (flag("ignore_activation_dynamics")) return;
    activation_ = out_.names.add(name_ + "_activation", at_);
    const std::string change = fmt::format("{} - {}", input, activation_);
    const std::string ease = fmt::format("(0.5 + 1.5*{})", activation_),
                      rising = fmt::format("1/({}*{})", n(law_.rise), ease),
                      falling = fmt::format("{}/{}", ease, n(law_.fall));
    std::string quickness = fmt::format("select({}, {}, {})", change, rising, falling);
    if (law_.steepness > 0) {
      const std::string turn = fmt::format("0.5*tanh({}*({}))", n(law_.steepness), change);
      quickness = fmt::format("((0.5 + {0})*{1} + (0.5 - {0})*{2})", turn, rising, falling);
    }
    if (law_.by_excitation)
      quickness = fmt::format("({} + select({}, {}, 0)/{})", n(1 / law_.fall), change, input, n(law_.rise));
    out_.add_state(activation_, initial, {least, 1}, fmt::format("({})*{}", change, quickness), at_);
  }
};

/// Thelen's curves for one muscle.
struct Thelen {
  double gamma, kpe, e0, af, flen, toe, linear, limit;

  explicit Thelen(const Muscle& of)
      : gamma(of.number("KshapeActive", 0.45)),
        kpe(of.number("KshapePassive", 5)),
        e0(of.number("FmaxMuscleStrain", 0.6)),
        af(of.number("Af", 0.25)),
        flen(of.number("Flen", 1.4)),
        limit(of.number("fv_linear_extrap_threshold", 0.95)) {
    // The toe ends where its slope is that of the straight line to 1 at the largest strain.
    const double strain = of.number("FmaxTendonStrain", 0.04), e3 = std::exp(3);
    toe = 99 * strain * e3 / (166 * e3 - 67);
    linear = 0.67 / (strain - toe);
  }
  std::string active(const std::string& length) const {
    return fmt::format("exp(-({} - 1)^2/{})", length, n(gamma));
  }
  std::string passive(const std::string& length) const {
    return fmt::format("max(0, (exp({}*({} - 1)/{}) - 1)/{})", n(kpe), length, n(e0), n(std::exp(kpe) - 1));
  }
  double lengthening() const { return (2 + 2 / af) / (flen - 1); }
  /// Force over speed.
  std::string over_speed(const std::string& a, const std::string& v) const {
    const std::string k = fmt::format("(0.25 + 0.75*{})", a);
    return fmt::format(
        "select({0}, ({1} + {2}*{0})/({1} + {3}*max({0}, 0)), max(0, {1} + {0})/({1} - min({0}, 0)/{4}))", v,
        k, n(lengthening() * flen), n(lengthening()), n(af));
  }
  std::string tendon(const std::string& strain) const {
    return fmt::format("({0}*(exp(3*clamp({1}, 0, {2})/{2}) - 1) + {3}*max(0, {1} - {2}))",
                       n(0.33 / (std::exp(3) - 1)), strain, n(toe), n(linear));
  }
  /// Speed over the load of the contractile element; beyond `limit` of the largest force of lengthening, and below none,
  /// it goes on along the tangent.
  std::string speed(const std::string& a, const std::string& load, const std::string& active) const {
    const std::string most = fmt::format("{}*{}", n(limit * flen), active),
                      within = fmt::format("min({}, {})", load, most);
    const std::string eccentric =
        fmt::format("(({0} - {1})/({2}*{1} - {0}) + {3}/{1}*max(0, {4} - {5}))/{6}", within, active, n(flen),
                    n((flen - 1) / std::pow((1 - limit) * flen, 2)), load, most, n(lengthening()));
    const std::string concentric =
        fmt::format("(max({0}, 0) - {1})/({1} + max({0}, 0)/{2}) + {3}/{1}*min({0}, 0)", load, active, n(af),
                    n(1 + 1 / af));
    return fmt::format("(0.25 + 0.75*{})*select({} - {}, {}, {})", a, load, active, eccentric, concentric);
  }
};

/// The curves of De Groote and others for one muscle.
struct DeGroote {
  static constexpr double kPassive = 4, kShortest = 0.2;           // fibres of 0.2 bear no passive force
  static constexpr double kTendonScale = 0.2, kTendonShift = 0.2;  // a tendon of its slack length bears none
  double width, fibre_strain, stiffness;
  bool has_passive;

  explicit DeGroote(const Muscle& of)
      : width(of.positive("active_force_width_scale", 1)),
        fibre_strain(of.positive("passive_fiber_strain_at_one_norm_force", 0.6)),
        stiffness(std::log((1 + kTendonShift) / kTendonScale) /
                  of.positive("tendon_strain_at_one_norm_force", 0.049)),
        has_passive(!of.flag("ignore_passive_fiber_force")) {}

  std::string active(const std::string& length) const {
    const std::string x = width == 1 ? length : fmt::format("(1 + ({} - 1)/{})", length, n(width));
    return fmt::format(
        "(0.8150671134243542*exp(-0.5*(({0} - 1.055033428970575)/(0.162384573599574 + "
        "0.063303448465465*{0}))^2)"
        " + 0.433004984392647*exp(-0.5*(({0} - 0.71677541339776)/(0.200356847296188*{0} - "
        "0.029947116970696))^2)"
        " + 0.1*exp(-4*({0} - 1)^2))",
        x);
  }
  std::string passive(const std::string& length) const {
    const double least = std::exp(kPassive * (kShortest - 1) / fibre_strain);
    return fmt::format("(exp({}*({} - 1)) - {})/{}", n(kPassive / fibre_strain), length, n(least),
                       n(std::exp(kPassive) - least));
  }
  static std::string over_speed(const std::string& v) {
    const std::string y = fmt::format("(8.149*{} + 0.374)", v);
    return fmt::format("(0.8825327733249912 + 0.3211346127989808*log({0} + sqrt({0}^2 + 1)))", y);
  }
  /// The inverse of the last one.
  static std::string speed(const std::string& force) {
    return fmt::format("(sinh(({} - 0.8825327733249912)/0.3211346127989808) - 0.374)/8.149", force);
  }
  /// Length of the tendon, in slack lengths, that bears so much; and the slope of what it bears over its length.
  std::string tendon_length(const std::string& force) const {
    return fmt::format("(1 + log(1 + {}*{})/{})", n(1 / kTendonScale), force, n(stiffness));
  }
  std::string tendon_slope(const std::string& force) const {
    return fmt::format("{}*({} + {})", n(stiffness), force, n(kTendonShift));
  }
};

/// The curves of Schutte and others for one muscle; speeds in optimal lengths in its scale of time.
struct Schutte {
  // Of force over speed: where it ends, how it is bent, and how it begins to lengthen.
  static constexpr double kStretched = 1.4, kBent = 0.15, kSlope = 0.13 * kBent / (kBent + 1);
  OsimDescription& out;
  pugi::xml_node element;
  double damping;

  Schutte(OsimDescription& description, pugi::xml_node muscle)
      : out(description), element(muscle), damping(out.xml.positive_number(muscle, "damping", 0.1)) {}

  std::string curve(const char* property, const std::string& x, const std::string& otherwise) const {
    const pugi::xml_node given = find_osim_function(element, property);
    return given ? "(" + read_osim_function(out.xml, given, {x}).text + ")" : otherwise;
  }
  std::string active(const std::string& length) const {
    return fmt::format(
        "max(0, {})",
        curve(
            "active_force_length_curve", length,
            fmt::format(
                "simm_spline({}; [-5.307692, -4.307692, -1.923077, -0.884615, -0.269231, 0.230769, 0.461538, "
                "0.52725, 0.62875, 0.71875, 0.86125, 1.045, 1.2175, 1.43875, 1.5, 1.615385, 2, 2.961538, "
                "3.692308, 5.461538, 9.901902]; [0.012188, 0.021899, 0.036466, 0.052493, 0.075312, 0.114158, "
                "0.157859, 0.226667, 0.636667, 0.856667, 0.95, 0.993333, 0.77, 0.246667, 0.193821, 0.133252, "
                "0.072683, 0.044417, 0.036341, 0.021899, 0.007332])",
                length)));
  }
  std::string passive(const std::string& length) const {
    return curve("passive_force_length_curve", length, fmt::format("exp(8*({} - 1) - 4)", length));
  }
  std::string tendon(const std::string& strain) const {
    const std::string otherwise = fmt::format(
        "simm_spline({}; [-10, -0.002, -0.001, 0, 0.00131, 0.00281, 0.00431, 0.00581, 0.00731, 0.00881, "
        "0.0103, 0.0118, 0.0123, 9.2, 9.201, 9.202, 20]; [0, 0, 0, 0, 0.0108, 0.0257, 0.0435, 0.0652, "
        "0.0915, 0.123, "
        "0.161, 0.208, 0.227, 345, 345, 345, 345])",
        strain);
    return fmt::format("select({}, {}, 0)", strain, curve("tendon_force_length_curve", strain, otherwise));
  }
  std::string over_speed(const std::string& v) const {
    return fmt::format(
        "select({0}, ({1}*max({0}, 0) + {2})/(max({0}, 0) + {2}), max(0, 1 + {0})/(1 - min({0}, 0)/{3}))", v,
        n(kStretched), n(kSlope), n(kBent));
  }
  /// The speed at which active*over_speed + damping*speed is the load: a root of a quadratic where the fibres shorten, and of
  /// another one where they lengthen, each in the form that does not cancel.
  std::string speed(const std::string& load, const std::string& active) const {
    const std::string h = fmt::format("({} + {}*{} + {})", load, n(kBent), active, n(kBent * damping)),
                      missing = fmt::format("max(0, {} - {})", active, load);
    const std::string shortening = fmt::format("-{0}*{1}/({2} + sqrt({2}^2 + {3}*{1}))", n(2 * kBent),
                                               missing, h, n(4 * kBent * damping));
    const std::string g = fmt::format("({} - {}*{} - {})", load, n(kStretched), active, n(kSlope * damping)),
                      beyond = fmt::format("max(0, {} - {})", load, active);
    const std::string root = fmt::format("sqrt({}^2 + {}*{})", g, n(4 * kSlope * damping), beyond);
    const std::string lengthening = fmt::format("select({0}, ({0} + {1})/{2}, {3}*{4}/({1} - {0}))", g, root,
                                                n(2 * damping), n(2 * kSlope), beyond);
    return fmt::format("select({} - {}, {}, {})", load, active, lengthening, shortening);
  }
};

}  // namespace

bool add_thelen_muscle(OsimDescription& out, pugi::xml_node element) {
  Muscle muscle(out, element,
                {out.xml.number(element, "activation_time_constant", 0.015),
                 out.xml.number(element, "deactivation_time_constant", 0.05), 0.05});
  if (!muscle.begin()) return false;
  const Thelen curves(muscle);
  const std::string& a = muscle.activation_;
  if (muscle.has_rigid_tendon()) {
    const std::string length = muscle.rigid_length();
    muscle.finish(
        muscle.rigid_tension(fmt::format("{}*{}*{} + {}", a, curves.active(length),
                                         curves.over_speed(a, muscle.rigid_speed()), curves.passive(length)),
                             0));
    return true;
  }
  muscle.finish_elastic(curves, 0, false, [&](const std::string& load, const std::string& active) {
    return curves.speed(a, load, active);
  });
  return true;
}

bool add_millard_muscle(OsimDescription& out, pugi::xml_node element) {
  Muscle muscle(out, element,
                {out.xml.number(element, "activation_time_constant", 0.01),
                 out.xml.number(element, "deactivation_time_constant", 0.04), 0.05});
  if (!muscle.begin()) return false;
  constexpr double kLeastDamping = 0.001;  // less is none
  const double damping = muscle.number("fiber_damping", 0.1);
  const bool elastic = !muscle.has_rigid_tendon(), damped = damping >= kLeastDamping;
  const MillardCurves curves(out.xml, element, elastic && !damped);
  if (elastic) {
    muscle.finish_elastic(curves, curves.shortest(), true,
                          [&](const std::string& load, const std::string& active) {
                            return damped ? curves.speed(load, active, damping)
                                          : curves.over_load(fmt::format("{}/{}", load, active));
                          });
    return true;
  }
  const std::string length = muscle.rigid_length(), speed = muscle.rigid_speed();
  std::string sum = fmt::format("{}*{}*{} + {}", muscle.activation_, curves.active(length),
                                curves.over_speed(speed), curves.passive(length));
  if (damping != 0) sum += fmt::format(" + {}*{}", n(damping), speed);
  muscle.finish(muscle.rigid_tension(sum, curves.shortest()));
  return true;
}

bool add_degroote_muscle(OsimDescription& out, pugi::xml_node element) {
  Muscle muscle(out, element,
                {out.xml.positive_number(element, "activation_time_constant", 0.015),
                 out.xml.positive_number(element, "deactivation_time_constant", 0.06), 0.5,
                 out.xml.positive_number(element, "activation_dynamics_smoothing", 0.1)});
  if (!muscle.begin()) return false;
  const DeGroote curves(muscle);
  const double damping = muscle.number("fiber_damping", 0);
  if (muscle.has_rigid_tendon()) {
    const std::string length = muscle.rigid_length(), speed = muscle.rigid_speed();
    std::string sum =
        fmt::format("{}*{}*{}", muscle.activation_, curves.active(length), DeGroote::over_speed(speed));
    if (curves.has_passive) sum += " + " + curves.passive(length);
    if (damping != 0) sum += fmt::format(" + {}*{}", n(damping), speed);
    const std::string cosine = muscle.rigid_cosine();
    muscle.finish(fmt::format("{}*({}){}", n(muscle.force_), sum, cosine == "1" ? "" : "*" + cosine));
    return true;
  }
  if (damping != 0 && OsimXml::text(element, "tendon_compliance_dynamics_mode") == "implicit")
    out.approximated(element,
                     "has damped fibres on an elastic tendon: their damping is left out, as in OpenSim's "
                     "explicit mode");
  const std::string force = muscle.name_tendon_force();
  muscle.finish(fmt::format("{}*{}", n(muscle.force_), force));
  const std::string tendon = curves.tendon_length(force);
  const Muscle::Fibre fibre = muscle.add_fibre_on(tendon);
  const auto over_cosine = [&](const std::string& of) {
    return fibre.cosine.empty() ? of : fmt::format("{}/{}", of, fibre.cosine);
  };
  std::string load = over_cosine(force);
  if (curves.has_passive) load = fmt::format("({} - {})", load, curves.passive(fibre.length));
  const std::string active =
      muscle.add_output("_active", fmt::format("{}*{}", muscle.activation_, curves.active(fibre.length)));
  muscle.add_tendon_force(force, curves.tendon_slope(force),
                          over_cosine(DeGroote::speed(fmt::format("{}/{}", load, active))));
  return true;
}

bool add_schutte_muscle(OsimDescription& out, pugi::xml_node element) {
  const double scale = out.xml.positive_number(element, "time_scale", 0.1);
  Muscle muscle(out, element,
                {scale / out.xml.positive_number(element, "activation1", 7.667),
                 scale / out.xml.positive_number(element, "activation2", 1.459854), 0.05, 0, 0, true});
  if (!muscle.begin()) return false;
  muscle.speed_ = 1 / scale;
  const Schutte curves(out, element);
  const std::string& a = muscle.activation_;
  if (muscle.has_rigid_tendon()) {
    const std::string length = muscle.rigid_length(), speed = muscle.rigid_speed();
    muscle.finish(muscle.rigid_tension(
        fmt::format("{}*{}*{} + {} + {}*{}", a, curves.active(length), curves.over_speed(speed),
                    curves.passive(length), n(curves.damping), speed),
        0));
    return true;
  }
  muscle.finish_elastic(curves, 0, false, [&](const std::string& load, const std::string& active) {
    return curves.speed(fmt::format("max(0, {})", load), active);
  });
  return true;
}

}  // namespace alembert
