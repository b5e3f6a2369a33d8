#include "import/mjcf/model_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mechanism/source.hpp"

namespace alembert {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaximumModels = 1000;

const MjcfText& checked(const MjcfText& text) {
  const pugi::xml_node root = text.root();
  if (std::string_view(root.name()) != "mujoco")
    throw InputError(text.where(root),
                     fmt::format("expected a <mujoco>, found <{}>", printable(root.name())));
  text.of(root).check_spelling(root, "the model",
                               {"compiler", "option", "size", "visual", "statistic", "default", "custom",
                                "asset", "worldbody", "contact", "deformable", "equality", "tendon",
                                "actuator", "sensor", "keyframe", "extension", "include"},
                               {"model"});
  for (const pugi::xml_node section : text.children(root, "deformable"))
    for (const pugi::xml_node flex : text.children(section, "flex"))
      throw InputError(text.where(flex), "a flexible body (<flex>) cannot be expressed");
  return text;
}

}  // namespace

MjcfFile::MjcfFile(std::shared_ptr<const SourceText> source, std::vector<std::string> folders,
                   Warnings& warnings)
    : text(std::move(source), std::move(folders), warnings),
      compiler(read_compiler(checked(text))),
      defaults(text),
      assets(text, defaults, compiler) {}

MjcfFiles::MjcfFiles(std::shared_ptr<const SourceText> source, const std::vector<std::string>& folders,
                     Warnings& warnings)
    : folders_(folders), warnings_(warnings), own_(source, folders, warnings) {
  // What the model attaches may use all that the model may.
  folders_.push_back(fs::absolute(source->name).parent_path().string());
}

const MjcfFile& MjcfFiles::attached(const MjcfFile& to, const MjcfElement& of) {
  const std::string name = of.string("model");
  std::vector<std::string> known;
  std::vector<MjcfElement> unnamed;
  for (const pugi::xml_node section : to.text.children(to.text.root(), "asset"))
    for (const pugi::xml_node node : to.text.children(section, "model")) {
      const MjcfElement asset(to.text, {node}, "a model");
      if (!asset.has("name")) {
        unnamed.push_back(asset);
        continue;
      }
      if (asset.string("name") == name) return read(to, asset);
      known.push_back(asset.string("name"));
    }
  // Without a name of its own, it is called as the model is in its file.
  for (const MjcfElement& asset : unnamed) {
    const MjcfFile& file = read(to, asset);
    known.emplace_back(file.text.root().attribute("model").value());
    if (known.back() == name) return file;
  }
  throw of.error("model", fmt::format("there is no model '{}'{}", printable(name), did_you_mean(name, known)),
                 "models that can be attached are under <asset>");
}

const MjcfFile& MjcfFiles::read(const MjcfFile& from, const MjcfElement& asset) {
  if (!asset.has("file")) throw InputError(asset.where(), "no attribute 'file' of a model");
  const SourceLocation where = asset.where("file");
  const std::string name = asset.string("file");
  const fs::path path = from.text.below(name, where);
  std::unique_ptr<MjcfFile>& file = attached_[fs::weakly_canonical(path)];
  if (file) return *file;
  from.text.of(asset.node()).check_spelling(asset.node(), "a model", {}, {"name", "file", "content_type"});
  if (attached_.size() > kMaximumModels) throw InputError(where, "too many models are attached");
  std::shared_ptr<const SourceText> source;
  try {
    source = read_source(path.string());
  } catch (const InputError& error) {
    throw InputError(where, fmt::format("'{}' {}", printable(name), error.message()));
  }
  const auto known = places();
  const auto outer = known.find(where.source.get());
  const SourceLocation place = outer == known.end() ? where : outer->second;
  places_.emplace(source.get(), place);
  file = std::make_unique<MjcfFile>(std::move(source), folders_, warnings_);
  for (const auto& [text, within] : file->text.places()) places_.emplace(text, place);
  return *file;
}

std::map<const SourceText*, SourceLocation> MjcfFiles::places() const {
  std::map<const SourceText*, SourceLocation> out = own_.text.places();
  out.insert(places_.begin(), places_.end());
  return out;
}

std::vector<std::string> MjcfFiles::names() const {
  std::set<std::string> out = own_.text.named_files();
  for (const auto& [path, file] : attached_)
    if (file) out.insert(file->text.named_files().begin(), file->text.named_files().end());
  return {out.begin(), out.end()};
}

}  // namespace alembert
