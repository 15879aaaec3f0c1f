#pragma once
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "taut/units/unit.hpp"

namespace taut {

/// A point of a drawing, in metres of the real machine, x to the right, y up.
struct Point {
  double x = 0;
  double y = 0;
};

/// What a line stands for; the report chooses colour, width and dashes.
enum class Role { rope, second_rope, structure, body, ground, hidden, force, second_force, axis, highlight };

/// A chain of straight lines; `closed` joins the ends, `filled` paints the inside.
struct Polyline {
  std::vector<Point> points;
  Role role = Role::structure;
  bool closed = false;
  bool filled = false;
};
/// A circle, or the arc of it from angle `from` to `to` (rad, counter-clockwise from +x) when they differ.
struct Circle {
  Point center;
  double radius = 0;
  Role role = Role::body;
  double from = 0;
  double to = 0;
  bool filled = false;
};
/// A force: drawn from `at` along (fx, fy) newtons, at the drawing's force scale. `label` names it; the report adds the
/// value. `towards` draws the arrow ending at the point instead of starting there.
struct ForceArrow {
  Point at;
  double fx = 0;
  double fy = 0;
  std::string label;
  Role role = Role::force;
  bool towards = false;
};
/// A measured distance with its text ("l", "200 m"); `offset` moves the dimension line to the left of from->to, in
/// metres.
struct DimensionLine {
  Point from;
  Point to;
  double offset = 0;
  std::string text;
};
/// An angle at `center` between two directions (rad), with its text.
struct AngleMark {
  Point center;
  double radius = 0;
  double from = 0;
  double to = 0;
  std::string text;
};
/// A word at a place. Symbols with an underscore are set with a subscript, Greek names as letters, as everywhere.
struct Label {
  Point at;
  std::string text;
};
using Shape = std::variant<Polyline, Circle, ForceArrow, DimensionLine, AngleMark, Label>;

/// A drawing to scale, or a force polygon (`unit` si::N: points are then newtons).
struct Drawing {
  std::string name;  ///< "mast", a file name without ending
  std::string title;
  std::string caption;
  std::vector<Shape> shapes;
  Unit unit = si::m;          ///< what the coordinates are
  double vertical_scale = 1;  ///< y stretched by this for legibility; said under the drawing when it is not 1
  /// What a role means here ("skyline", "resultant"), in place of the legend's general word for it.
  // NOLINTNEXTLINE(readability-redundant-member-init): keeps it optional in a list of initial values
  std::vector<std::pair<Role, std::string>> legend = {};
};

struct Axis {
  std::string label;  ///< in words
  Unit unit;
};
struct Curve {
  std::string label;
  std::vector<double> x;  ///< SI
  std::vector<double> y;  ///< SI, NaN where there is no value: the curve is broken there
  bool dashed = false;
  bool points_only = false;
};
/// A marked point ("governs"), with `whole_line` a horizontal limit at y, with `upright` something that happens at x.
struct Mark {
  double x = 0;
  double y = 0;
  std::string label;
  bool whole_line = false;
  bool upright = false;
};
/// A plot: curves over axes, SI numbers. The data goes to `name`.csv as a series; without a name it goes nowhere.
struct Plot {
  std::string name;
  std::string title;
  std::string caption;
  Axis x;
  Axis y;
  std::vector<Curve> curves;
  std::vector<Mark> marks;
};

/// A drawing that moves: the report plays it. Coordinates as in a Drawing, one set for each time.
struct Animation {
  struct Line {
    Role role = Role::rope;
    std::vector<std::vector<Point>> points;  ///< [time][point]; the number of points may change
  };
  struct Round {
    std::string label;
    Role role = Role::body;
    double radius = 0;          ///< 0: a dot
    std::vector<Point> at;      ///< by time
    std::vector<double> angle;  ///< by time, rad, of its spoke; empty: it does not turn
  };
  struct Readout {
    std::string label;
    Unit unit;
    std::vector<double> value;  ///< by time, SI; NaN: none
  };
  std::string name;
  std::string title;
  std::string caption;
  std::vector<double> t;  ///< s
  std::vector<Line> lines;
  std::vector<Round> rounds;
  std::vector<Readout> readouts;
  std::vector<std::pair<double, std::string>> events;  ///< s, in words
};

using Figure = std::variant<Drawing, Plot, Animation>;

}  // namespace taut
