#pragma once
#include <optional>
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

/// What a line represents; the report chooses colour, width and dashes.
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
/// A force of (fx, fy), N, drawn as an arrow that starts at `at`, to the force scale of the drawing. `label` names it;
/// the report adds the value: `whole`, where the force does not lie in the plane of the drawing. With `towards` the
/// arrow ends at `at`.
struct ForceArrow {
  Point at;
  double fx = 0;
  double fy = 0;
  std::string label;
  Role role = Role::force;
  bool towards = false;
  std::optional<double> whole = std::nullopt;  ///< N; none: the force that is drawn
};
/// A dimension line with its text ("l", "200 m"; empty: the length), to which the report adds the length where
/// `with_length` says so ("span 200 m"). `offset`, m: how far the line is moved to the left of the direction from ->
/// to.
struct DimensionLine {
  Point from;
  Point to;
  double offset = 0;
  std::string text;
  bool with_length = false;
};
/// An angle at `center` between two directions (rad), with its text.
struct AngleMark {
  Point center;
  double radius = 0;
  double from = 0;
  double to = 0;
  std::string text;
};
/// A text at a point, with the force (N) that the report adds to it ("T skyline 42.8 kN"). A symbol with an underscore
/// gets a subscript, a Greek name becomes its letter, as everywhere in the report.
struct Label {
  Point at;
  std::string text;
  /// Other places that the text may stand at, along a rope for example.
  // NOLINTNEXTLINE(readability-redundant-member-init): keeps it optional in a list of initial values
  std::vector<Point> or_at = {};
  std::optional<double> force = std::nullopt;
};
using Shape = std::variant<Polyline, Circle, ForceArrow, DimensionLine, AngleMark, Label>;

/// A drawing to scale, or, with `unit` si::N, a force polygon whose coordinates are newtons.
struct Drawing {
  std::string name;  ///< "mast", a file name without ending
  std::string title;
  std::string caption;
  std::vector<Shape> shapes;
  Unit unit = si::m;          ///< unit of the coordinates
  double vertical_scale = 1;  ///< factor on y for legibility; the report states it when it is not 1
  /// Meaning of a role in this drawing ("skyline", "resultant"); replaces the general word in the legend.
  // NOLINTNEXTLINE(readability-redundant-member-init): keeps it optional in a list of initial values
  std::vector<std::pair<Role, std::string>> legend = {};
  /// Names of the coordinates ("x", "z"): the report draws a ruler along the lower and the left side. Empty: none, but
  /// a bar of a round length.
  std::string across = {};  // NOLINT(readability-redundant-member-init)
  std::string upward = {};  // NOLINT(readability-redundant-member-init)
};

struct Axis {
  std::string label;  ///< in words
  Unit unit;
};
struct Curve {
  std::string label;
  std::vector<double> x;  ///< SI
  std::vector<double> y;  ///< SI; the curve is interrupted at NaN
  bool dashed = false;
  bool points_only = false;
};
/// A marked point ("governs"). With `whole_line` a horizontal line at y, a limit; with `upright` a vertical line at x,
/// an event.
struct Mark {
  double x = 0;
  double y = 0;
  std::string label;
  bool whole_line = false;
  bool upright = false;
};
/// A plot of curves, SI. Its data are written to `name`.csv as a series; without a name they are not written.
struct Plot {
  std::string name;
  std::string title;
  std::string caption;
  Axis x;
  Axis y;
  std::vector<Curve> curves;
  std::vector<Mark> marks;
  /// Name of the Scene over whose times x runs; empty: x is no time of one.
  std::string scene = {};  // NOLINT(readability-redundant-member-init): keeps it optional in a list of initial values
};

/// A drawing over time, which the report plays. Coordinates as in a Drawing, one set for each time.
struct Animation {
  struct Line {
    Role role = Role::rope;
    std::vector<std::vector<Point>> points;  ///< [time][point]; the number of points may differ from time to time
    /// [time], N, the largest tension along the line, shown as its colour; 0: slack, NaN: broken. Empty: no rope.
    std::vector<double> tension = {};  // NOLINT(readability-redundant-member-init)
  };
  struct Round {
    std::string label;
    Role role = Role::body;
    double radius = 0;          ///< 0: a dot
    std::vector<Point> at;      ///< by time
    std::vector<double> angle;  ///< [time], rad, of the spoke that shows the rotation; empty: it does not turn
  };
  struct Readout {
    std::string label;
    Unit unit;
    std::vector<double> value;  ///< [time], SI; NaN: no value
  };
  std::string name;
  std::string title;
  std::string caption;
  std::vector<double> t;  ///< s
  std::vector<Line> lines;
  std::vector<Round> rounds;
  std::vector<Readout> readouts;
  std::vector<std::pair<double, std::string>> events;  ///< time in s, description
  std::string scene = {};  ///< name of the Scene of the same motion  NOLINT(readability-redundant-member-init)
};

/// A line over the ground, seen from its side, and below it over the same x what it bears at each place of the
/// carriage, coloured by what governs there. SI. Its places are written to `name`.csv as a series.
struct Profile {
  struct Support {
    std::string name;
    Point top;          ///< where it holds the ropes, m
    double ground = 0;  ///< height of the ground below it, m; NaN: not known
  };
  struct Rope {
    std::string name;
    Role role = Role::rope;
    std::vector<Point> points;  ///< m; interrupted at NaN
  };
  /// One place of the carriage.
  struct Place {
    double x = 0;         ///< m
    double z = 0;         ///< of the carriage, m; NaN: no state
    double ground = 0;    ///< height of the ground below it, m; NaN: not known
    double value = 0;     ///< what is shown below the line; NaN: no answer
    std::string governs;  ///< what governs there, "tension of 'skyline'"; empty without an answer
  };
  std::string name;
  std::string title;
  std::string caption;
  std::vector<Point> ground;      ///< m; empty: no terrain
  std::vector<Support> supports;  ///< what holds the ropes, from the left to the right
  std::vector<Rope> ropes;        ///< in the state that is drawn
  std::string carriage;           ///< its name
  Point carriage_at;              ///< in the state that is drawn, m
  double clearance = 0;           ///< of the carriage that is asked for, m; NaN: none
  std::vector<Place> places;      ///< in the order of x
  Axis value;                     ///< of Place::value
  double limit = 0;               ///< of that value, drawn across; NaN: none
  std::size_t decisive = 0;       ///< index of the place that the answer names
};

/// Horizontal bars, one row for each name: shares, or how far a value goes to both sides. SI.
struct Bars {
  struct Bar {
    double from = 0;
    double to = 0;
    double low = 0, high = 0;  ///< ends of a confidence interval; NaN: none
  };
  struct Row {
    std::string label;
    std::vector<Bar> bars;  ///< one for each series
  };
  std::string name;
  std::string title;
  std::string caption;
  Axis value;
  std::vector<std::string> series;  ///< names of a row's bars
  std::vector<Row> rows;            ///< from the top to the bottom
  double base = 0;                  ///< a line across all rows, from which the bars go
  bool in_line = false;             ///< the bars of a row lie on one line, else below each other
};

using Figure = std::variant<Drawing, Plot, Animation, Profile, Bars>;

}  // namespace taut
