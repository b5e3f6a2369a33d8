#include "import/opensim/osim_paths.hpp"

#include <fmt/format.h>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_sockets.hpp"
#include "import/opensim/osim_wraps.hpp"

namespace alembert {
namespace {

/// OpenSim's own tolerance at the ends of a range.
constexpr double kRangeTolerance = 1e-5;

class PathReader {
 public:
  PathReader(OsimDescription& out, pugi::xml_node force)
      : out_(out), force_(force), path_(force.child("GeometryPath")), owner_(OsimXml::name_of(force)) {}

  /// Names of frames, {frame, when}, or what the path leads around.
  const YamlNode& read() {
    for (const pugi::xml_node element : out_.xml.objects(path_, "PathPointSet")) read_point(element);
    for (const std::size_t end : {std::size_t{0}, points_.size() - 1}) {
      if (points_.empty() || !points_[end].conditional) continue;
      out_.approximated(points_[end].element, "ends a path and is taken for one that is always there");
      points_[end].conditional = false;
    }
    YamlNode& list = out_.nodes.sequence(out_.xml.where(path_));
    if (points_.size() < 2) return list;
    const OsimWraps wraps(out_, force_, points_);
    for (std::size_t i = 0; i < points_.size(); ++i)
      add(list, points_[i], i > 0 ? wraps.after(i - 1) : nullptr);
    return list;
  }

 private:
  void read_point(pugi::xml_node element) {
    const SourceLocation at = out_.xml.where(element);
    const std::string what = OsimXml::title(element);
    const std::string_view type = element.name();
    OsimPathPoint point{element, 0, {}, type == "ConditionalPathPoint"};
    point.on =
        resolve_osim_frame(out_.model, OsimXml::text(element, {"socket_parent_frame", "socket_body", "body"}),
                           "/forceset/" + owner_, at, what);
    if (type != "MovingPathPoint") point.location = out_.xml.vector<3>(element, "location", {});
    if (!point.conditional && type != "PathPoint" && type != "MovingPathPoint")
      out_.approximated(element, "is of an unknown type; its <location> is taken");
    points_.push_back(point);
  }

  /// \param around  what stands between the point before and this one, or null
  void add(YamlNode& list, const OsimPathPoint& of, YamlNode* around) {
    const pugi::xml_node point = of.element;
    const SourceLocation at = out_.xml.where(point);
    const std::string what = OsimXml::title(point);
    std::array<std::string, 3> location;
    for (std::size_t i = 0; i < 3; ++i)
      location[i] = of.location ? number_text((*of.location)[i]) : moving(point, i, at);
    const std::string frame = out_.add_frame(OsimXml::name_of(point), of.on, location, at);
    // The same point again has no direction.
    if (!list.items.empty() && list.items.back()->text == frame && !of.conditional) return;
    if (around != nullptr) list.items.push_back(around);
    if (!of.conditional) {
      list.items.push_back(&out_.nodes.text(frame, at));
      return;
    }
    const std::string coordinate = out_.text_of(resolve_osim_coordinate(
        out_.model, OsimXml::text(point, {"socket_coordinate", "coordinate"}), at, what));
    const auto [low, high] = out_.xml.vector<2>(point, "range", {0, 0});
    YamlNode& node = out_.nodes.mapping(at);
    out_.put(node, "frame", frame, at);
    out_.put(node, "when",
             fmt::format("min({}, {})", sum_text({coordinate, number_text(-(low - kRangeTolerance))}),
                         sum_text({number_text(high + kRangeTolerance), "-" + coordinate})),
             at);
    list.items.push_back(&node);
  }

  /// A component of a moving point's location.
  std::string moving(pugi::xml_node point, std::size_t i, const SourceLocation& at) {
    const char letter = static_cast<char>('x' + i);
    const std::string name = fmt::format("{}_location", letter);
    const pugi::xml_node element = find_osim_function(point, name.c_str());
    if (!element) throw InputError(at, fmt::format("no <{}> in {}", name, OsimXml::title(point)));
    const std::string socket = OsimXml::text(point, {fmt::format("socket_{}_coordinate", letter).c_str(),
                                                     fmt::format("{}_coordinate", letter).c_str()});
    std::vector<std::string> arguments;
    if (!socket.empty())
      arguments.push_back(
          out_.text_of(resolve_osim_coordinate(out_.model, socket, at, OsimXml::title(point))));
    const OsimFunction function = read_osim_function(out_.xml, element, arguments);
    if (!function.smooth)
      throw InputError(at, "a point moves by a function that is not twice differentiable");
    return function.simple()
               ? function.text
               : out_.define(fmt::format("{}_{}", OsimXml::name_of(point), letter), function.text, at);
  }

  OsimDescription& out_;
  pugi::xml_node force_, path_;
  std::string owner_;
  std::vector<OsimPathPoint> points_;
};

}  // namespace

bool add_osim_path(OsimDescription& out, YamlNode& force, pugi::xml_node element) {
  if (!element.child("GeometryPath")) return false;
  const YamlNode& points = PathReader(out, element).read();
  if (points.items.size() < 2) return false;
  out.nodes.put(force, "path", points);
  return true;
}

}  // namespace alembert
