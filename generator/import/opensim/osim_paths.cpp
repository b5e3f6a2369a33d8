#include "import/opensim/osim_paths.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "import/common/snapped_angle.hpp"
#include "import/opensim/osim_sockets.hpp"

namespace alembert {
namespace {

/// OpenSim's own tolerance at the ends of a range.
constexpr double kRangeTolerance = 1e-5;

class PathReader {
 public:
  PathReader(OsimDescription& out, pugi::xml_node path, std::string owner)
      : out_(out), path_(path), owner_(std::move(owner)) {}

  /// Names of frames, or {frame, when}.
  const YamlNode& read() {
    const std::vector<pugi::xml_node> points = out_.xml.objects(path_, "PathPointSet");
    YamlNode& list = out_.nodes.sequence(out_.xml.where(path_));
    for (std::size_t i = 0; i < points.size(); ++i) add(list, points[i], i == 0 || i + 1 == points.size());
    return list;
  }

 private:
  void add(YamlNode& list, pugi::xml_node point, bool end) {
    const SourceLocation at = out_.xml.where(point);
    const std::string what = OsimXml::title(point), type = point.name();
    const std::size_t on =
        resolve_osim_frame(out_.model, OsimXml::text(point, {"socket_parent_frame", "socket_body", "body"}),
                           "/forceset/" + owner_, at, what);
    std::array<std::string, 3> location;
    if (type == "MovingPathPoint") {
      for (std::size_t i = 0; i < 3; ++i) location[i] = moving(point, i, at);
    } else {
      const std::array<double, 3> fixed = out_.xml.vector<3>(point, "location", {});
      for (std::size_t i = 0; i < 3; ++i) location[i] = number_text(fixed[i]);
    }
    const std::string frame = out_.add_frame(OsimXml::name_of(point), on, location, at);
    const bool conditional = type == "ConditionalPathPoint";
    if (!conditional && type != "PathPoint" && type != "MovingPathPoint")
      out_.approximated(point, "is of an unknown type; its <location> is taken");
    // The same point again has no direction.
    if (!list.items.empty() && list.items.back()->text == frame && !conditional) return;
    if (conditional && end) out_.approximated(point, "ends a path and is taken for one that is always there");
    if (!conditional || end) {
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
  pugi::xml_node path_;
  std::string owner_;
};

}  // namespace

bool add_osim_path(OsimDescription& out, YamlNode& force, pugi::xml_node element) {
  const pugi::xml_node path = element.child("GeometryPath");
  const std::string name = OsimXml::name_of(element);
  if (!path) return false;
  const YamlNode& points = PathReader(out, path, name).read();
  if (points.items.size() < 2) return false;
  std::vector<std::string> wraps;
  for (const pugi::xml_node wrap : out.xml.objects(path, "PathWrapSet")) {
    const std::string object = OsimXml::text(wrap, "wrap_object");
    wraps.push_back(printable(object.empty() ? OsimXml::name_of(wrap) : object));
  }
  if (!wraps.empty())
    out.approximated(element,
                     fmt::format("wraps over {}; its path is drawn straight", fmt::join(wraps, ", ")),
                     "points of the path that are there under a condition (`when`) can lead it round");
  out.nodes.put(force, "path", points);
  return true;
}

}  // namespace alembert
