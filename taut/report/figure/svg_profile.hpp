#pragma once
#include <string>

#include "taut/calc/figure.hpp"
#include "taut/report/figure/pen.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// A profile as one <svg> of class `profile`: above the line with ground, supports, ropes, way of the carriage and
/// clearance, below it over the same x what it bears, coloured by what governs. Both axes of the picture above in the
/// unit of lengths; heights are stretched where the line is flat, and `profile_scale_words` says by how much.
/// `wide`: pixels, of an upright page or of `turned_width`. Nothing to show: says so.
std::string profile_svg(const Profile& profile, const Display& display, double wide = paper_width);

/// Of a page on its side.
inline constexpr double turned_width = 960;

/// "Heights are drawn 2.5 times as large as lengths."; empty where both have one scale.
std::string profile_scale_words(const Profile& profile, double wide = paper_width);

}  // namespace taut::report
