#include "import/sdf/sdf_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "import/common/mesh_names.hpp"
#include "mechanism/source.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kVitalSdf[] = {"world",
                                          "model",
                                          "link",
                                          "joint",
                                          "frame",
                                          "pose",
                                          "include",
                                          "inertial",
                                          "mass",
                                          "inertia",
                                          "ixx",
                                          "iyy",
                                          "izz",
                                          "ixy",
                                          "ixz",
                                          "iyz",
                                          "axis",
                                          "axis2",
                                          "xyz",
                                          "parent",
                                          "child",
                                          "dynamics",
                                          "damping",
                                          "friction",
                                          "spring_stiffness",
                                          "spring_reference",
                                          "mimic",
                                          "multiplier",
                                          "offset",
                                          "reference",
                                          "gravity",
                                          "static",
                                          "thread_pitch",
                                          "screw_thread_pitch",
                                          "gearbox_ratio",
                                          "gearbox_reference_body",
                                          "use_parent_model_frame",
                                          "relative_to",
                                          "attached_to",
                                          "expressed_in",
                                          "placement_frame",
                                          "degrees",
                                          "rotation_format",
                                          "canonical_link",
                                          "type",
                                          "uri",
                                          "merge",
                                          "auto",
                                          "density"};
constexpr XmlFormat kSdf{"sdf", kVitalSdf};

constexpr std::size_t kMaximumSdfIncludes = 1000;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  return text;
}

}  // namespace

std::string sdf_title(pugi::xml_node element) {
  const char* name = element.attribute("name").value();
  return *name == '\0' ? fmt::format("the <{}>", printable(element.name()))
                       : fmt::format("{} '{}'", printable(element.name()), printable(name));
}

SdfFiles::SdfFiles(std::shared_ptr<const SourceText> source, std::vector<std::string> folders,
                   Warnings& warnings)
    : warnings_(&warnings), folders_(std::move(folders)) {
  open_.push_back(source->name == "<stdin>" ? fs::path() : fs::weakly_canonical(source->name));
  texts_.push_back(std::make_unique<XmlText>(std::move(source), warnings, kSdf));
}

const XmlText& SdfFiles::of(pugi::xml_node element) const {
  for (const auto& text : texts_)
    if (text->holds(element.name())) return *text;
  return *texts_.front();
}

SourceLocation SdfFiles::where(pugi::xml_node element, const char* attribute) const {
  const pugi::xml_attribute found = element.attribute(attribute);
  return found ? of(element).where(found) : where(element);
}

fs::path SdfFiles::resolve(pugi::xml_node uri, std::string_view kind) const {
  const std::string name = text(uri);
  const SourceLocation place = where_text(uri);
  std::string rest = name;
  bool by_model = false;
  if (const std::size_t colon = name.find("://"); colon != std::string::npos) {
    const std::string scheme = lower(name.substr(0, colon));
    by_model = scheme == "model" || scheme == "package";
    if (!by_model && scheme != "file")
      throw InputError(place, fmt::format("'{}' is not on this machine: nothing is fetched", printable(name)),
                       "give model://NAME, package://NAME or a path beside the file");
    rest = name.substr(colon + 3);
  }
  if (rest.empty()) throw InputError(place, fmt::format("the uri of {} is empty", kind));
  const std::string& from = of(uri).source()->name;
  const std::string& first = texts_.front()->source()->name;
  std::vector<fs::path> roots(folders_.begin(), folders_.end());
  if (first != "<stdin>") roots.insert(roots.begin(), fs::absolute(first).parent_path());
  std::vector<fs::path> candidates;
  if (!by_model && from != "<stdin>") candidates.push_back(fs::absolute(from).parent_path() / rest);
  for (const fs::path& root : roots) candidates.push_back(root / rest);
  // A folder that is the model or package itself.
  if (const fs::path path = rest; by_model)
    for (const fs::path& root : roots)
      if (const fs::path whole = fs::weakly_canonical(root); whole.filename() == *path.begin())
        candidates.push_back(whole.parent_path() / path);
  // Models that lie beside that of the file, where they are within a folder that was given.
  if (by_model && from != "<stdin>")
    candidates.push_back(fs::absolute(from).parent_path().parent_path() / rest);
  bool any_allowed = false;
  for (const fs::path& candidate : candidates) {
    const auto allowed_at = [&](const fs::path& path) {
      return std::ranges::any_of(roots, [&](const fs::path& root) {
        return lies_below(fs::weakly_canonical(path), fs::weakly_canonical(root));
      });
    };
    // A link may lead elsewhere before `..` is taken, and after.
    const fs::path normal = candidate.lexically_normal();
    const bool allowed = allowed_at(candidate) && allowed_at(normal);
    any_allowed = any_allowed || allowed;
    if (allowed && fs::exists(normal)) return normal;
  }
  if (!any_allowed && !candidates.empty())
    throw InputError(place, fmt::format("'{}' lies outside the folder of the file", printable(name)),
                     "files are read below that folder, and below those that --include gives");
  if (first == "<stdin>" && folders_.empty())
    throw InputError(place,
                     fmt::format("'{}' is beside a file that came from standard input", printable(name)),
                     "give it as a file, or its folder as --include");
  throw InputError(place, fmt::format("'{}' of {} is not found", printable(name), kind),
                   "it is looked for beside the file and in the folders that --include gives");
}

/// The newest file that a model's folder names.
fs::path SdfFiles::model_file(const fs::path& folder, pugi::xml_node uri) const {
  // Nothing in the folder may be a link that leads out of it.
  const auto inside = [&](const fs::path& file) {
    if (!lies_below(fs::weakly_canonical(folder / file), fs::weakly_canonical(folder)))
      throw InputError(where_text(uri), fmt::format("the '{}' of '{}' lies outside its folder",
                                                    printable(file.generic_string()), printable(text(uri))));
    return folder / file;
  };
  const fs::path config = inside("model.config");
  if (!fs::exists(config)) return inside("model.sdf");
  pugi::xml_document document;
  named_files_.insert(config.string());
  if (!document.load_file(config.c_str()))
    throw InputError(where_text(uri),
                     fmt::format("'{}' has a model.config that is no XML", printable(text(uri))));
  std::string best;
  double newest = -1;
  for (const pugi::xml_node sdf : document.document_element().children("sdf")) {
    // 1.10 is after 1.9.
    const std::string version = sdf.attribute("version").value();
    const std::size_t point = version.find('.');
    const double number = point == std::string::npos ? 0 : std::strtod(version.c_str() + point + 1, nullptr);
    if (number > newest) {
      newest = number;
      best = text(sdf);
    }
  }
  return inside(best.empty() ? "model.sdf" : best);
}

bool SdfFiles::is_scenery(pugi::xml_node include) {
  const std::string uri = lower(text(include.child("uri")));
  const std::string name = uri.substr(uri.find_last_of('/') + 1);
  return uri.find("://") != std::string::npos &&
         (name == "sun" || name == "ground_plane" || name == "ground plane");
}

pugi::xml_node SdfFiles::include(pugi::xml_node element) {
  const pugi::xml_node uri = of(element).require(element, "uri", "an include");
  const SourceLocation place = where_text(uri);
  if (++includes_ > kMaximumSdfIncludes) throw InputError(place, "too many models are included");
  fs::path path = resolve(uri, "an include");
  if (fs::is_directory(path)) path = model_file(path, uri);
  named_files_.insert(path.string());
  const fs::path canonical = fs::weakly_canonical(path);
  if (std::ranges::find(open_, canonical) != open_.end())
    throw InputError(place, fmt::format("'{}' includes itself", printable(text(uri))));
  open_.push_back(canonical);
  if (const auto found = by_path_.find(canonical); found != by_path_.end())
    return texts_[found->second]->root();
  std::shared_ptr<const SourceText> source;
  try {
    // As short as the name of the first file is.
    const fs::path shown =
        path.lexically_proximate(fs::absolute(texts_.front()->source()->name).parent_path());
    const fs::path beside = fs::path(texts_.front()->source()->name).parent_path() / shown;
    source = read_source(fs::exists(beside) ? beside.string() : path.string());
  } catch (const InputError& error) {
    throw InputError(place, fmt::format("'{}' {}", printable(text(uri)), error.message()));
  }
  const SourceLocation from = where(element);
  const auto outer = places_.find(from.source.get());
  places_.emplace(source.get(), outer == places_.end() ? from : outer->second);
  texts_.push_back(std::make_unique<XmlText>(std::move(source), *warnings_, kSdf));
  by_path_.emplace(canonical, texts_.size() - 1);
  return texts_.back()->root();
}

fs::path SdfFiles::file_of(pugi::xml_node uri) const {
  const fs::path file = resolve(uri, "a mesh");
  named_files_.insert(file.string());
  return file;
}

std::optional<fs::path> SdfFiles::drawn_file(pugi::xml_node uri) const {
  try {
    return resolve(uri, "a mesh");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string SdfFiles::text(pugi::xml_node element) {
  return text_of_element(element);
}

double SdfFiles::number(pugi::xml_node element, const char* child, double otherwise) const {
  const pugi::xml_node found = element.child(child);
  if (!found) return otherwise;
  if (text(found).empty()) {
    warn({where(found),
          fmt::format("<{}> of {} is empty; {} is taken", child, sdf_title(element), otherwise),
          {},
          "empty"});
    return otherwise;
  }
  return of(found).number_list(found, fmt::format("<{}> of {}", child, sdf_title(element)), 1, 1)[0];
}

double SdfFiles::number_or_infinite(pugi::xml_node element, const char* child, double otherwise) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::string value = lower(text(element.child(child)));
  if (value == "inf" || value == "+inf" || value == "infinity") return kInfinity;
  if (value == "-inf" || value == "-infinity") return -kInfinity;
  return number(element, child, otherwise);
}

bool SdfFiles::flag(pugi::xml_node element, const char* child, bool otherwise) const {
  const pugi::xml_node found = element.child(child);
  const std::string value = lower(text(found));
  if (value.empty()) return otherwise;
  if (value == "true" || value == "1") return true;
  if (value == "false" || value == "0") return false;
  throw InputError(where_text(found),
                   fmt::format("expected true or false as <{}>, found '{}'", child, printable(value)));
}

bool SdfFiles::flag(pugi::xml_attribute attribute, pugi::xml_node element, bool otherwise) const {
  const std::string value = lower(attribute.value());
  if (value.empty()) return otherwise;
  if (value == "true" || value == "1") return true;
  if (value == "false" || value == "0") return false;
  throw InputError(of(element).where(attribute), fmt::format("expected true or false as '{}', found '{}'",
                                                             attribute.name(), printable(value)));
}

Eigen::Vector3d SdfFiles::vector(pugi::xml_node element, const char* child,
                                 const Eigen::Vector3d& otherwise) const {
  const pugi::xml_node found = element.child(child);
  if (text(found).empty()) return otherwise;
  const std::vector<double> v =
      of(found).number_list(found, fmt::format("<{}> of {}", child, sdf_title(element)), 3, 3);
  return {v[0], v[1], v[2]};
}

RigidPose SdfFiles::pose(pugi::xml_node element) const {
  if (text(element).empty()) return {};
  const std::string format = element.attribute("rotation_format").value();
  const bool quaternion = format == "quat_xyzw";
  if (!quaternion && !format.empty() && format != "euler_rpy")
    throw InputError(
        where(element, "rotation_format"),
        fmt::format("the rotation_format of a pose is euler_rpy or quat_xyzw, not '{}'", printable(format)));
  const std::string what = "the pose of " + sdf_title(element.parent());
  const std::size_t count = quaternion ? 7 : 6;
  const std::vector<double> v = of(element).number_list(element, what, count, count);
  RigidPose out;
  out.shift = {v[0], v[1], v[2]};
  const bool degrees = flag(element.attribute("degrees"), element, false);
  if (quaternion) {
    if (degrees) throw InputError(where(element, "degrees"), "a quaternion is not in degrees");
    const Eigen::Quaterniond turn(v[6], v[3], v[4], v[5]);
    if (!(turn.norm() > 1e-6))
      throw InputError(where_text(element), fmt::format("the quaternion of {} is zero", what));
    out.turn = turn.normalized();
    return out;
  }
  const double unit = degrees ? std::numbers::pi / 180 : 1;
  out.turn = Eigen::AngleAxisd(v[5] * unit, Eigen::Vector3d::UnitZ()) *
             Eigen::AngleAxisd(v[4] * unit, Eigen::Vector3d::UnitY()) *
             Eigen::AngleAxisd(v[3] * unit, Eigen::Vector3d::UnitX());
  return out;
}

}  // namespace alembert
