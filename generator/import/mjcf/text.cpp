#include "import/mjcf/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/common/mesh_names.hpp"
#include "mechanism/source.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

/// Elements and attributes that the equations are made of.
constexpr std::string_view kVitalMjcf[] = {
    "body",        "joint",     "freejoint", "inertial",     "geom",       "site",      "frame",
    "worldbody",   "default",   "include",   "compiler",     "option",     "pos",       "quat",
    "euler",       "axisangle", "xyaxes",    "zaxis",        "mass",       "density",   "diaginertia",
    "fullinertia", "axis",      "type",      "size",         "fromto",     "armature",  "damping",
    "stiffness",   "springref", "ref",       "class",        "childclass", "gravity",   "angle",
    "equality",    "connect",   "weld",      "tendon",       "actuator",   "replicate", "frictionloss",
    "gravcomp",    "polycoef",  "eulerseq",  "gear",         "gainprm",    "biasprm",   "kp",
    "kv",          "coef",      "anchor",    "springlength", "mesh",       "scale",     "refpos",
    "refquat",     "vertex",    "face",      "attach",       "prefix",     "model"};
constexpr XmlFormat kMjcf{"mujoco", kVitalMjcf};

constexpr std::size_t kMaximumFiles = 1000;
constexpr std::size_t kMaximumBytes = std::size_t{64} << 20;  // of all files together
constexpr int kMaximumDepth = 200;

void check_depth(const XmlText& text) {
  int depth = 0;
  for (pugi::xml_node at = text.root(); at;) {
    if (depth > kMaximumDepth)
      throw InputError(text.where(at), fmt::format("elements are nested more than {} deep", kMaximumDepth));
    if (at.first_child()) {
      at = at.first_child();
      ++depth;
      continue;
    }
    while (at && !at.next_sibling()) {
      if (at == text.root()) return;
      at = at.parent();
      --depth;
    }
    if (at) at = at.next_sibling();
    if (depth <= 0) return;
  }
}

/// MuJoCo takes Windows' names of files everywhere.
std::string with_slashes(std::string file) {
  std::ranges::replace(file, '\\', '/');
  return file;
}

}  // namespace

MjcfText::MjcfText(std::shared_ptr<const SourceText> source, std::vector<std::string> folders,
                   Warnings& warnings)
    : folders_(std::move(folders)) {
  if (source->name != "<stdin>") files_.insert(fs::weakly_canonical(source->name));
  texts_.push_back(std::make_unique<XmlText>(std::move(source), warnings, kMjcf));
  include_all(0, warnings);
}

void MjcfText::include_all(std::size_t text, Warnings& warnings) {
  const XmlText& from = *texts_[text];
  check_depth(from);
  // Without recursion over elements, of which there may be many below each other.
  std::vector<pugi::xml_node> open{from.root()};
  while (!open.empty()) {
    const pugi::xml_node at = open.back();
    open.pop_back();
    for (const pugi::xml_node child : at.children()) {
      if (child.type() != pugi::node_element) continue;
      if (std::string_view(child.name()) == "include")
        include(child, from, warnings);
      else
        open.push_back(child);
    }
  }
}

void MjcfText::include(pugi::xml_node element, const XmlText& from, Warnings& warnings) {
  const pugi::xml_attribute file = from.require_attribute(element, "file", "an include");
  const SourceLocation where = from.where(file);
  // Names are meant beside the model, or beside the file that includes.
  const std::string name = with_slashes(file.value());
  const fs::path beside = fs::path(from.source()->name).parent_path() / name;
  const bool is_beside = !fs::exists(beside_model(name)) && fs::exists(beside);
  const fs::path path = below(is_beside ? fs::absolute(beside).string() : name, where);
  if (!files_.insert(fs::weakly_canonical(path)).second)
    throw InputError(where, fmt::format("'{}' is included already", printable(file.value())));
  if (files_.size() > kMaximumFiles) throw InputError(where, "too many files are included");
  std::shared_ptr<const SourceText> source;
  try {
    source = read_source(path.string());
  } catch (const InputError& error) {
    throw InputError(where, fmt::format("'{}' {}", printable(file.value()), error.message()));
  }
  std::size_t bytes = source->text.size();
  for (const auto& text : texts_) bytes += text->source()->text.size();
  if (bytes > kMaximumBytes) throw InputError(where, "the included files have more than 64 MiB");
  places_.emplace(source.get(), own_place(from.where(element)));
  texts_.push_back(std::make_unique<XmlText>(std::move(source), warnings, kMjcf));
  const std::size_t index = texts_.size() - 1;
  included_.emplace(element, index);
  include_all(index, warnings);
}

std::vector<pugi::xml_node> MjcfText::children(pugi::xml_node parent, std::string_view name) const {
  std::vector<pugi::xml_node> out;
  for (const pugi::xml_node child : parent.children()) {
    if (child.type() != pugi::node_element) continue;
    if (const auto found = included_.find(child); found != included_.end()) {
      std::ranges::copy(children(texts_[found->second]->root(), name), std::back_inserter(out));
    } else if (name.empty() || name == child.name()) {
      out.push_back(child);
    }
  }
  return out;
}

bool MjcfText::holds(pugi::xml_node element) const {
  return std::ranges::any_of(texts_, [&](const auto& text) { return text->holds(element.name()); });
}

const XmlText& MjcfText::holding(const char* name) const {
  for (const auto& text : texts_)
    if (text->holds(name)) return *text;
  return *texts_.front();
}

SourceLocation MjcfText::own_place(const SourceLocation& where) const {
  const auto found = places_.find(where.source.get());
  return found == places_.end() ? where : found->second;
}

fs::path MjcfText::beside_model(const std::string& name) const {
  return fs::path(texts_.front()->source()->name).parent_path() / name;
}

fs::path MjcfText::below(const std::string& file, const SourceLocation& where) const {
  const std::string& model = texts_.front()->source()->name;
  if (model == "<stdin>")
    throw InputError(where,
                     fmt::format("'{}' is beside a model that came from standard input", printable(file)),
                     "give the model as a file");
  const fs::path folder = fs::weakly_canonical(fs::absolute(model).parent_path());
  const std::string name = with_slashes(file);
  // A link may lead elsewhere before `..` is taken, and after.
  const fs::path found = beside_model(name).lexically_normal();
  const auto is_below = [&](const fs::path& path) {
    const fs::path real = fs::weakly_canonical(path);
    return lies_below(real, folder) || std::ranges::any_of(folders_, [&](const std::string& given) {
             return lies_below(real, fs::weakly_canonical(given));
           });
  };
  if (!is_below(folder / name) || !is_below(fs::absolute(found)))
    throw InputError(where, fmt::format("'{}' lies outside the folder of the model", printable(file)),
                     "files are read below that folder, and below those that --include gives");
  if (fs::exists(found)) named_files_.insert(found.string());
  return found;
}

}  // namespace alembert
