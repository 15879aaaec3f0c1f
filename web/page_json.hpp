#pragma once
#include <string>

#include "taut/calc/result.hpp"

namespace taut::web {

/// What the page shows of a result, as one JSON object: texts and numbers in the units of the report, so that the page
/// computes nothing.
///   {title, status, message, verdict: {kind, words, reason} | null, answers [{label, text}], warnings [{text,
///   unsafe}],
///    errors [{line, column, width, file, message}], values [{name, label, symbol, text, heading, detail}],
///    checks [{name, part, value, limit, sense, utilisation, share, outcome: passes | fails | refused, rule, trust,
///    where}], plots [{name, title, caption, x, y, curves, marks, over: {scene, second} | null}], pictures: how many
///    pictures_of has, scenes [{name, t, times, events [{t, text}], tension {least, most, ..}, lines [{name, points,
///    tension}], points [{name, radius, at}]}], ground [x, z, ...], interrupted}
/// `over` of a plot: the scene over whose times it runs, and what its x shows of a second.
/// `points` of a line: for each time x, y, z, x, y, z, ... in metres, to 0.1 mm; `tension`: for each time one number at
/// each point, to 1 N.
std::string to_page(const Result& r);

/// The figures that the page does not draw itself, as a list [{title, caption, scale, svg}].
std::string pictures_of(const Result& r);

}  // namespace taut::web
