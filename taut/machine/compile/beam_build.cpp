#include "taut/machine/compile/beam_build.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/machine/rounds.hpp"

namespace taut::machine {
namespace {

constexpr double same_station = 5e-4;  ///< of the length: shorter pieces are stiff beyond what numbers hold
constexpr double strongest = 400e6;    ///< a stress, Pa
constexpr double longest_decay = 5;    ///< of a piece, in lengths sqrt(EI/N) of decay
constexpr int most_cuts = 6;
constexpr int least_steps = 48;  ///< along the whole beam

Matrix3 in_body(const Model& m, int body, const Matrix3& axes) { return turned(m, body).transpose() * axes; }

/// Axes of the section along its chord: x the part of `strong` across it (or of z, or of x, where that vanishes).
Matrix3 chord_axes(const Vector3& direction, const Vector3& strong) {
  Matrix3 axes;
  for (const Vector3& hint : {strong, Vector3(Vector3::UnitZ()), Vector3(Vector3::UnitX())}) {
    const Vector3 across = hint - direction * direction.dot(hint);
    if (across.norm() <= 1e-6 * hint.norm()) continue;
    axes.col(0) = across.normalized();
    break;
  }
  axes.col(2) = direction;
  axes.col(1) = direction.cross(axes.col(0));
  return axes;
}

Freedom freedom(int i) {
  return i < 3 ? Freedom{.along = Vector3::Unit(i), .about = Vector3::Zero()}
               : Freedom{.along = Vector3::Zero(), .about = Vector3::Unit(i - 3)};
}

Body section_body(const std::string& name, const Vector3& at, int beam) {
  Body body;
  body.name = name;
  body.position = at;
  body.beam = beam;
  for (int i = 0; i < 6; ++i) body.free.push_back(freedom(i));
  return body;
}

/// The axis as built: its chord, bow and length.
struct Axis {
  Vector3 start;
  Matrix3 chord;
  structure::Bow bow;
};

Axis axis_of(const Model& m, const StraightBeam& b) {
  Axis a;
  a.start = in_ground(m, b.from);
  const Vector3 way = in_ground(m, b.to) - a.start;
  expects(way.norm() > 0, "a beam has a length");
  Vector3 direction = way.normalized();
  const Vector3 sense = b.sense - direction * direction.dot(b.sense);
  if (b.sway != 0 && b.top == BeamTop::free) {
    expects(sense.norm() > 0, "an imperfection has a sense across the beam");
    direction = (direction + b.sway * sense.normalized()).normalized();
  }
  a.chord = chord_axes(direction, b.strong);
  a.bow.length = way.norm();
  if (b.bow != 0) {
    expects(sense.norm() > 0, "an imperfection has a sense across the beam");
    const Vector3 towards = a.chord.transpose() * sense;
    a.bow.towards = towards.head<2>().normalized();
    a.bow.angle = std::numbers::pi * b.bow;
    a.bow.length = way.norm() / boost::math::cyl_bessel_j(0, std::abs(a.bow.angle));
  }
  return a;
}

}  // namespace

Array<double> cuts_of(const StraightBeam& beam, double length) {
  Array<double> cuts;
  for (const double s : beam.stations) {
    if (s > same_station && s < 1 - same_station) cuts.push_back(s);
  }
  const double EI = std::min(beam.section.EI_x, beam.section.EI_y);
  const double decays = length * std::sqrt(beam.section.area * strongest / EI) / longest_decay;
  const int parts = static_cast<int>(std::clamp(std::ceil(decays), 1.0, most_cuts + 1.0));
  for (int i = 1; i < parts; ++i) cuts.push_back(static_cast<double>(i) / parts);
  std::sort(cuts.begin(), cuts.end());
  const auto same = [](double a, double b) { return b - a < same_station; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
  return cuts;
}

void add_beam(Model& model, const StraightBeam& b) {
  const Axis axis = axis_of(model, b);
  const double length = axis.bow.length;
  Array<double> ends = b.stations;
  ends.push_back(1);
  const int index = static_cast<int>(model.beams.size());
  Beam beam;
  beam.name = b.name;
  beam.length = length;
  structure::RodState section;  // as built, free of stress
  section.place = axis.start;
  section.axes = axis.bow.axes(axis.chord, 0);
  Place start = b.from;
  double from = 0;
  for (const double end : ends) {
    BeamPiece piece;
    piece.rod = {
        .section = b.section, .bow = axis.bow, .order = b.order, .from = from * length, .to = end * length, .steps = 1};
    const double elements = std::ceil(b.elements * (end - from) - 1e-9);
    piece.section_every = static_cast<int>(std::max(2.0, std::ceil(least_steps * (end - from) / elements)));
    piece.rod.steps = piece.section_every * static_cast<int>(elements);
    piece.rod.thermal_strain = b.thermal_strain;
    piece.start = start;
    piece.start_axes = in_body(model, start.body, section.axes);
    piece.reference = b.from.body;
    piece.reference_axes = in_body(model, b.from.body, section.axes);
    piece.start_hold = from == 0 ? b.base : BeamHold::clamped;
    structure::RodPiece bare = piece.rod;
    bare.section.weight = 0;
    bare.thermal_strain = 0;
    bare.order = structure::BeamOrder::second;
    section = along(bare, section);
    section.axes = axis.bow.axes(axis.chord, end * length);
    const bool last = end == 1;
    if (last && b.top != BeamTop::free) {
      piece.end = b.to;
      piece.end_hold = b.top == BeamTop::hinged ? BeamHold::hinged : BeamHold::clamped;
    } else {
      const std::string name = last ? b.name + ".top" : fmt::format("{} at {:.4g} m", b.name, end * length);
      model.bodies.push_back(section_body(name, section.place, index));
      piece.end = {.body = static_cast<int>(model.bodies.size()) - 1, .at = Vector3::Zero()};
    }
    piece.end_axes = in_body(model, piece.end.body, section.axes);
    start = piece.end;
    from = end;
    beam.pieces.push_back(piece);
  }
  model.beams.push_back(std::move(beam));
}

void warm_beams(Model& model) {
  // each beam stands behind the one on which it begins
  Array<Vector3> moved(model.bodies.size(), Vector3(Vector3::Zero()));
  for (std::size_t i = 0; i < model.beams.size(); ++i) {
    const Place& from = model.beams[i].pieces.front().start;
    const Vector3 start = in_ground(model, from);
    for (const BeamPiece& piece : model.beams[i].pieces) {
      const int end = piece.end.body;
      if (end == ground || model.bodies[end].beam != static_cast<int>(i)) continue;
      moved[end] = piece.rod.thermal_strain * (model.bodies[end].position - start);
      if (from.body != ground) moved[end] += moved[from.body];
    }
  }
  for (std::size_t i = 0; i < model.bodies.size(); ++i) model.bodies[i].position += moved[i];
}

}  // namespace taut::machine
