#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace taut::catalogue {

/// A rope construction as it is written, taken apart: "6x36WS-IWRC", "6 × 19 (1+6+6/6)", "6x19(1+9+9)+7x7".
struct Construction {
  int strands = 0;
  int wires = 0;    ///< wires of one strand: the number in the name, a class in EN 12385-4
  std::string lay;  ///< "s" Seale, "w" Warrington, "f" filler, "ws" Warrington-Seale, "m" cross lay, "k..." compacted;
                    ///< empty when the name does not tell
  std::string layers;  ///< wires of the layers as written: "1+6+6/6"; empty when the name does not tell
  std::string core;    ///< "FC", "IWRC", "WSC" when the name tells; empty otherwise
};

/// Takes a name apart; nothing when it does not begin with "STRANDSxWIRES" or has a tail that is not understood.
/// Spaces, case and the sign between the numbers do not count. A strand's lay is read from its letters or, failing
/// that, from its layers where these are well known (1+9+9 is Seale).
std::optional<Construction> parse_construction(std::string_view name);

/// The core's name as the tables have it: "FC" for FC, NFC, SFC, fibre, "o.c."; "IWRC"; "WSC". Nothing for other texts.
std::optional<std::string> parse_core(std::string_view name);

/// The class by which handbooks group ropes: "6x7" (up to 9 wires in a strand), "6x19" (15 to 26), "6x36" (27 to 49),
/// the same of 8 strands, "18x7" (10 strands and more, which do not turn). Empty for other names.
std::string construction_class(std::string_view name);

/// Whether a rope listed as `listed` may be called `asked`.
///
/// "6x36" asks for the class: it is met by 6x36, 6x36WS, 6x36(1+7+7/7+14). A lay or layers that are asked for must not
/// contradict those listed; a listed class that does not tell its lay ("6x36") meets "6x36WS" too. Cross-lay ("6x19M")
/// and compacted ("6x36K") ropes have other strengths and meet only a question that names them. A name without numbers
/// ("compacted") is met when `listed` begins with it. A core within `asked` is not looked at: see RopeFilter.
bool matches_construction(std::string_view asked, std::string_view listed);

}  // namespace taut::catalogue
