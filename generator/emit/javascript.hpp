// JavaScript: an ES module of a mechanism's functions, for browsers and node. In: functions as statements of
// JavaScript (javascript_syntax). Out: text. It imports nothing.
#pragma once

#include <span>
#include <string>

#include "emit/c99.hpp"
#include "emit/text_template.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// NAME.mjs. Its last statement is the list of its exports.
std::string javascript_module(const Mechanism& mechanism, std::span<const WrittenFunction> functions,
                              const Slots& common);

}  // namespace alembert
