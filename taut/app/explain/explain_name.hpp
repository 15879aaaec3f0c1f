#pragma once
#include <string>
#include <tl/expected.hpp>

namespace taut::app {

/// `taut explain NAME`: the text on a method, on the parts and analyses of machines, on a key by its path or its last
/// words ("reevings.length", "break_angle"), on a rule ("safety.skyline.ch", "safety.skyline"), on a value or column of
/// results. Words of the field lead to the deck's: "pulley" to sheaves. A name that several things have gives a list of
/// their paths. The error says that nothing has the name, and which name is near.
tl::expected<std::string, std::string> explain_name(const std::string& name);

}  // namespace taut::app
