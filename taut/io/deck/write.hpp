#pragma once
#include <string>

#include "taut/io/deck/node.hpp"

namespace taut::io {

/// A node as YAML that parse() reads as the same values: maps as blocks, lists of texts on one line. Comments and
/// places are not kept. It ends with a line end.
std::string to_yaml(const Node& node);

}  // namespace taut::io
