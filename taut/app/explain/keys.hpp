#pragma once
#include <functional>
#include <string>

#include "taut/calc/field.hpp"

namespace taut::app {

/// A key of a deck with the description in which it stands.
using KeyVisit = std::function<void(const std::string& path, const Description&, const Field&)>;

/// Visits the fields of a description and of its nested ones, each after the one that holds it. Paths are dotted, with
/// NAME for a name that the deck gives and [] for an entry of a list: "sheaves.NAME.diameter", "loads[].mass".
void walk_keys(const std::string& prefix, const Description& description, const KeyVisit& visit);

/// The unit of a quantity, or what else the key takes: "kN", "[x, y, z], each m", "true or false".
std::string kind_text(const Field& f);

/// "required", the default as a deck writes it, or "-".
std::string default_of(const Description& d, const Field& f);

/// The meaning with the choices and the range.
std::string full_words(const Field& f);

}  // namespace taut::app
