// The formats that `alembert import` reads: one row a format. A new format is a folder beside import/urdf and
// a row in importers.cpp; the command, its help and the choice of the importer come from the row.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "import/common/described.hpp"

namespace alembert {

/// What of DescribeOptions a format has a use for.
enum class ImportOption : unsigned {
  root = 1,
  massless = 2,
  friction = 4,
  snap_angles = 8,
  include = 16,
  name = 32
};

struct Importer {
  std::string_view format;     ///< what people call it
  std::string_view extension;  ///< of its files, with the dot
  unsigned options;            ///< ImportOption, or'ed
  /// Whether a text without that extension, as from standard input, looks like one.
  bool (*recognises)(std::string_view text);
  /// A text in; its description in the language of mechanisms out, every value with its place in the text.
  /// `warnings` gets what is doubtful as it is found, so that it can be told where the rest cannot be read.
  /// Throws InputError.
  DescribedRobot (*describe)(const std::shared_ptr<const SourceText>& source, const DescribeOptions& options,
                             Warnings& warnings);
};

std::span<const Importer> importers();

/// The importer of a source: by its name's extension, or else by its text. Where neither tells, the first of
/// the table, which says what it expected.
const Importer& importer_of(const SourceText& source);

/// The importer of a source that is no description: whose name says so, or that is XML. Null for a description.
const Importer* importer_unless_description(const SourceText& source);

/// A warning where options are given that a format, with these ImportOption, has no use for.
void warn_of_unused(const std::shared_ptr<const SourceText>& source, std::string_view format, unsigned taken,
                    const DescribeOptions& options, Warnings& warnings);

/// Describes a source by its importer. Options that are given and that its format has no use for are a warning.
/// Throws InputError.
DescribedRobot describe_source(const std::shared_ptr<const SourceText>& source,
                               const DescribeOptions& options, Warnings& warnings);

/// What a description has, and what of the file was approximated or left out, in a line.
std::string summary(const DescribedRobot& described);

/// `URDF`, or `A, B or C`.
std::string importable_formats();

}  // namespace alembert
