#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <utility>

#include "python/native_result.hpp"

namespace taut::python {
namespace {

namespace py = pybind11;

std::string_view text_of(Role role) {
  switch (role) {
    case Role::rope:
      return "rope";
    case Role::second_rope:
      return "second_rope";
    case Role::structure:
      return "structure";
    case Role::body:
      return "body";
    case Role::ground:
      return "ground";
    case Role::hidden:
      return "hidden";
    case Role::force:
      return "force";
    case Role::second_force:
      return "second_force";
    case Role::axis:
      return "axis";
    case Role::highlight:
      return "highlight";
  }
  return "structure";
}

py::tuple pair_of(const Point& p) { return py::make_tuple(p.x, p.y); }

/// Shape (points, 2).
py::array_t<double> array_of(const std::vector<Point>& points) {
  py::array_t<double> all({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  auto at = all.mutable_unchecked<2>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    at(static_cast<py::ssize_t>(i), 0) = points[i].x;
    at(static_cast<py::ssize_t>(i), 1) = points[i].y;
  }
  return all;
}

py::array_t<double> array_of(const std::vector<double>& numbers) {
  return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::dict axis_of(const Axis& axis) {
  py::dict d;
  d["label"] = axis.label;
  d["unit"] = unit_of(axis.unit);
  return d;
}

struct ShapeData {
  py::dict operator()(const Polyline& p) const {
    py::dict d = kind("line", p.role);
    d["points"] = array_of(p.points);
    d["closed"] = p.closed;
    d["filled"] = p.filled;
    return d;
  }
  py::dict operator()(const Circle& c) const {
    py::dict d = kind("circle", c.role);
    d["centre"] = pair_of(c.center);
    d["radius"] = c.radius;
    d["from"] = c.from;
    d["to"] = c.to;
    d["filled"] = c.filled;
    return d;
  }
  py::dict operator()(const ForceArrow& a) const {
    py::dict d = kind("arrow", a.role);
    d["at"] = pair_of(a.at);
    d["force"] = py::make_tuple(a.fx, a.fy);
    d["whole"] = a.whole.value_or(std::hypot(a.fx, a.fy));
    d["label"] = a.label;
    d["towards"] = a.towards;
    return d;
  }
  py::dict operator()(const DimensionLine& l) const {
    py::dict d = kind("dimension", Role::axis);
    d["from"] = pair_of(l.from);
    d["to"] = pair_of(l.to);
    d["offset"] = l.offset;
    d["text"] = l.text;
    d["with_length"] = l.with_length;
    return d;
  }
  py::dict operator()(const AngleMark& a) const {
    py::dict d = kind("angle", Role::axis);
    d["centre"] = pair_of(a.center);
    d["radius"] = a.radius;
    d["from"] = a.from;
    d["to"] = a.to;
    d["text"] = a.text;
    return d;
  }
  py::dict operator()(const Label& l) const {
    py::dict d = kind("label", Role::axis);
    d["at"] = pair_of(l.at);
    d["text"] = l.text;
    d["force"] = l.force;
    return d;
  }

 private:
  static py::dict kind(const char* name, Role role) {
    py::dict d;
    d["shape"] = name;
    d["role"] = text_of(role);
    return d;
  }
};

template <class F>
py::dict begun(const char* kind, const F& f) {
  py::dict d;
  d["kind"] = kind;
  d["name"] = f.name;
  d["title"] = f.title;
  d["caption"] = f.caption;
  return d;
}

py::list lines_of(const Animation& a) {
  py::list lines;
  for (const Animation::Line& line : a.lines) {
    py::dict one;
    one["role"] = text_of(line.role);
    py::list frames;
    for (const auto& points : line.points) frames.append(array_of(points));
    one["points"] = frames;
    one["tension"] = array_of(line.tension);
    lines.append(one);
  }
  return lines;
}

struct FigureData {
  py::dict operator()(const Drawing& f) const {
    py::dict d = begun("drawing", f);
    py::list shapes, legend;
    for (const Shape& s : f.shapes) shapes.append(std::visit(ShapeData(), s));
    for (const auto& [role, words] : f.legend) legend.append(py::make_tuple(text_of(role), words));
    d["shapes"] = shapes;
    d["legend"] = legend;
    d["unit"] = unit_of(f.unit);
    d["vertical_scale"] = f.vertical_scale;
    d["across"] = f.across;
    d["upward"] = f.upward;
    return d;
  }
  py::dict operator()(const Plot& f) const {
    py::dict d = begun("plot", f);
    py::list curves, marks;
    for (const Curve& c : f.curves) {
      py::dict one;
      one["label"] = c.label;
      one["x"] = array_of(c.x);
      one["y"] = array_of(c.y);
      one["dashed"] = c.dashed;
      one["points_only"] = c.points_only;
      curves.append(one);
    }
    for (const Mark& m : f.marks) {
      py::dict one;
      one["x"] = m.x;
      one["y"] = m.y;
      one["label"] = m.label;
      one["whole_line"] = m.whole_line;
      one["upright"] = m.upright;
      marks.append(one);
    }
    d["curves"] = curves;
    d["marks"] = marks;
    d["x"] = axis_of(f.x);
    d["y"] = axis_of(f.y);
    return d;
  }
  py::dict operator()(const Animation& f) const {
    py::dict d = begun("animation", f);
    py::list rounds, readouts;
    for (const Animation::Round& round : f.rounds) {
      py::dict one;
      one["label"] = round.label;
      one["role"] = text_of(round.role);
      one["radius"] = round.radius;
      one["at"] = array_of(round.at);
      one["angle"] = array_of(round.angle);
      rounds.append(one);
    }
    for (const Animation::Readout& readout : f.readouts) {
      py::dict one;
      one["label"] = readout.label;
      one["unit"] = unit_of(readout.unit);
      one["value"] = array_of(readout.value);
      readouts.append(one);
    }
    d["t"] = array_of(f.t);
    d["lines"] = lines_of(f);
    d["rounds"] = rounds;
    d["readouts"] = readouts;
    d["events"] = f.events;
    return d;
  }
  py::dict operator()(const Profile& f) const {
    py::dict d = begun("profile", f);
    py::list supports, ropes;
    for (const Profile::Support& s : f.supports) {
      supports.append(py::make_tuple(s.name, s.top.x, s.top.y, s.ground));
    }
    for (const Profile::Rope& rope : f.ropes) {
      ropes.append(py::make_tuple(rope.name, text_of(rope.role), array_of(rope.points)));
    }
    d["ground"] = array_of(f.ground);
    d["supports"] = supports;
    d["ropes"] = ropes;
    d["carriage"] = f.carriage;
    d["carriage_at"] = pair_of(f.carriage_at);
    py::list places;
    for (const Profile::Place& p : f.places) places.append(py::make_tuple(p.x, p.z, p.ground, p.value, p.governs));
    d["places"] = places;
    d["value"] = axis_of(f.value);
    d["limit"] = f.limit;
    d["decisive"] = f.decisive;
    return d;
  }
  py::dict operator()(const Bars& f) const {
    py::dict d = begun("bars", f);
    py::list rows;
    for (const Bars::Row& row : f.rows) {
      py::list bars;
      for (const Bars::Bar& bar : row.bars) bars.append(py::make_tuple(bar.from, bar.to, bar.low, bar.high));
      rows.append(py::make_tuple(row.label, bars));
    }
    d["value"] = axis_of(f.value);
    d["series"] = f.series;
    d["rows"] = rows;
    d["base"] = f.base;
    d["in_line"] = f.in_line;
    return d;
  }
};

}  // namespace

py::dict figure_of(const Figure& f) { return std::visit(FigureData(), f); }

}  // namespace taut::python
