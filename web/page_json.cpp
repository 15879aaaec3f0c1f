#include "web/page_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/calc/shown.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/report/embedded/figure_css.hpp"
#include "taut/report/figure/any_figure.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/verdict.hpp"

namespace taut::web {
namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json numbers(const std::vector<double>& all, const ShownUnit& unit) {
  Json list = Json::array();
  for (const double x : all) list.push_back(number(unit.of(x)));
  return list;
}

/// A picture's place to 0.1 mm, and a tension to 1 N: a motion of a minute has a million of them, so they are written
/// as text at once, by their whole number of steps.
class PictureNumbers {
 public:
  explicit PictureNumbers(std::string& text) : text_(text) {}

  void place(double metres) { in_steps(metres, 4); }
  void tension(double newtons) { in_steps(newtons, 0); }
  void text(std::string_view piece) { text_ += piece; }

  /// [a,b,..]: `one` writes each.
  template <class Range, class One>
  void list(const Range& all, const One& one) {
    text_ += '[';
    for (const auto& each : all) {
      one(each);
      text_ += ',';
    }
    close();
  }
  /// [x,y,z,x,y,z,..]
  template <class Places>
  void flat(const Places& places) {
    text_ += '[';
    for (const auto& at : places) {
      for (const double x : at) {
        place(x);
        text_ += ',';
      }
    }
    close();
  }

 private:
  std::string& text_;

  void close() {
    if (text_.back() == ',') text_.pop_back();
    text_ += ']';
  }

  void in_steps(double x, int decimals) {
    constexpr double most_steps = 1e15;  // whole numbers up to here are doubles
    const double steps = std::floor(x * (decimals == 0 ? 1 : 1e4) + 0.5);
    if (!(std::abs(steps) < most_steps)) {
      text_ += std::isfinite(x) ? fmt::format("{}", x) : "null";
      return;
    }
    std::array<char, 24> digits;
    char* const end = digits.data() + digits.size();
    char* at = end;
    auto left = static_cast<std::uint64_t>(std::abs(steps));
    bool written = false;  // zeros at the end of a fraction are left out
    for (int i = 0; i < decimals; ++i, left /= 10) {
      const auto digit = static_cast<char>('0' + left % 10);
      written = written || digit != '0';
      if (written) *--at = digit;
    }
    if (written) *--at = '.';
    do {
      *--at = static_cast<char>('0' + left % 10);
      left /= 10;
    } while (left > 0);
    if (steps < 0) *--at = '-';
    text_.append(at, end);
  }
};

Json verdict(const Result& r) {
  const std::optional<Verdict> v = verdict_of(r);
  if (!v) return nullptr;
  return {{"kind", to_text(v->kind)}, {"words", headline(v->kind)}, {"reason", v->reason}};
}

/// Column of a mistake, from 1, in UTF-16 units, as an editor in a browser counts; where its line is not known in
/// bytes.
int units_before(const Diagnostic& d) {
  const auto bytes = static_cast<std::size_t>(std::max(d.place.column - 1, 0));
  if (d.source_line.size() < bytes) return d.place.column;
  int units = 1;
  for (const char c : d.source_line.substr(0, bytes)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80U) units += byte >= 0xF0U ? 2 : 1;
  }
  return units;
}

Json errors(const Result& r) {
  Json list = Json::array();
  for (const Diagnostic& d : r.errors) {
    list.push_back({{"file", d.file},
                    {"line", d.place.line},
                    {"column", units_before(d)},
                    {"width", d.width},
                    {"message", d.message}});
  }
  return list;
}

Json warnings(const Result& r) {
  Json list = Json::array();
  for (const std::string& w : r.warnings) {
    const bool unsafe = std::find(r.unsafe.begin(), r.unsafe.end(), w) != r.unsafe.end();
    list.push_back({{"text", w}, {"unsafe", unsafe}});
  }
  return list;
}

Json values(const Result& r, const Display& display) {
  Json list = Json::array();
  for (const Value& v : r.values) {
    list.push_back({{"name", v.name},
                    {"label", v.label},
                    {"text", report::value_shown(v.value, v.unit, display)},
                    {"heading", v.heading},
                    {"detail", v.detail}});
  }
  return list;
}

Json checks(const Result& r, const Display& display) {
  Json list = Json::array();
  for (const Check& c : grouped(r.checks)) {
    list.push_back({{"name", c.name},
                    {"part", c.part},
                    {"value", report::value_shown(c.value, c.unit, display)},
                    {"limit", report::value_shown(c.limit, c.unit, display)},
                    {"sense", c.sense == Sense::at_most ? "at most" : "at least"},
                    {"utilisation", number(c.utilisation)},
                    {"share", fmt::format("{} %", report::number_shown(100 * c.utilisation, 3))},
                    {"outcome", report::outcome_text(c)},
                    {"rule", c.rule},
                    {"trust", c.trust},
                    {"where", c.where}});
  }
  return list;
}

Json axis(const Axis& a, const ShownUnit& unit) { return {{"label", a.label}, {"unit", report::unit_text(unit)}}; }

Json plot(const Plot& p, const Display& display) {
  const ShownUnit x = shown_unit(p.x.unit, display);
  const ShownUnit y = shown_unit(p.y.unit, display);
  Json curves = Json::array();
  for (const Curve& c : p.curves) {
    curves.push_back({{"label", c.label},
                      {"x", numbers(c.x, x)},
                      {"y", numbers(c.y, y)},
                      {"dashed", c.dashed},
                      {"points", c.points_only}});
  }
  Json marks = Json::array();
  for (const Mark& m : p.marks) {
    marks.push_back({{"x", number(x.of(m.x))},
                     {"y", number(y.of(m.y))},
                     {"label", m.label},
                     {"level", m.whole_line},
                     {"upright", m.upright}});
  }
  // what x shows of a second: its unit may be the minute
  const Json over = p.scene.empty() ? Json(nullptr) : Json{{"scene", p.scene}, {"second", x.of(1)}};
  return {{"name", p.name},
          {"title", p.title},
          {"caption", p.caption},
          {"x", axis(p.x, x)},
          {"y", axis(p.y, y)},
          {"curves", std::move(curves)},
          {"marks", std::move(marks)},
          {"over", over}};
}

/// The style of a figure as on paper: the page shows its image on white, in its own dark theme, too.
std::string style_on_paper() {
  constexpr std::string_view dark = "@media screen and (prefers-color-scheme: dark)";
  std::string css(report::embedded::figure_css);
  for (std::size_t at = css.find(dark); at != std::string::npos; at = css.find(dark)) {
    css.replace(at, dark.size(), "@media not all");
  }
  return css;
}

/// A figure that stands alone in a file, with its own style: shown as an image nothing in it can run or load.
Json picture(const Figure& f, const Display& display) {
  const report::FigureWords words = report::words_of(f);
  std::string svg = report::figure_svg(f, display);
  const std::size_t open = svg.find("<svg");
  const std::size_t end = open == std::string::npos ? open : svg.find('>', open);
  if (end == std::string::npos) return nullptr;
  const bool named = svg.find("xmlns=") != std::string::npos;
  svg.insert(end + 1, fmt::format("<style>{}</style>", style_on_paper()));
  if (!named) svg.insert(open + 4, " xmlns=\"http://www.w3.org/2000/svg\"");
  return {{"title", words.title}, {"caption", words.caption}, {"scale", words.scale}, {"svg", std::move(svg)}};
}

/// The least and the largest tension of all times, for the scale of colours; null without ropes.
Json tension_range(const Scene& s, const Display& display) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const SceneLine& line : s.lines) {
    for (const auto& frame : line.tension) {
      for (const double t : frame) {
        if (!std::isfinite(t)) continue;
        least = std::min(least, t);
        most = std::max(most, t);
      }
    }
  }
  if (most < least) return nullptr;
  return {{"least", least},
          {"most", most},
          {"least_text", report::value_shown(least, si::N, display)},
          {"most_text", report::value_shown(most, si::N, display)}};
}

/// A deck may hold any bytes in a text; what is no UTF-8 is shown as such.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// `json`, an object, with a last entry that is text of JSON already.
void add_entry(std::string& json, std::string_view key, std::string_view value) {
  json.pop_back();
  json += fmt::format(",\"{}\":{}}}", key, value);
}

std::string scene_lines(const Scene& s) {
  std::string text;
  PictureNumbers out(text);
  out.list(s.lines, [&](const SceneLine& line) {
    out.text(fmt::format("{{\"name\":{},\"points\":", dumped(line.name)));
    out.list(line.points, [&](const auto& frame) { out.flat(frame); });
    out.text(",\"tension\":");
    out.list(line.tension, [&](const auto& frame) { out.list(frame, [&](double T) { out.tension(T); }); });
    out.text("}");
  });
  return text;
}

std::string scene_points(const Scene& s) {
  std::string text;
  PictureNumbers out(text);
  out.list(s.points, [&](const ScenePoint& p) {
    out.text(fmt::format("{{\"name\":{},\"radius\":{},\"at\":", dumped(p.name), dumped(number(p.radius))));
    out.list(p.at, [&](const auto& place) { out.list(place, [&](double x) { out.place(x); }); });
    out.text("}");
  });
  return text;
}

/// What happens in the motion that a scene shows; a motion drawn in several views has it in each of them.
Json events_of(const Scene& s, const std::vector<Figure>& figures) {
  Json events = Json::array();
  for (const Figure& f : figures) {
    const auto* motion = std::get_if<Animation>(&f);
    if (motion == nullptr || motion->scene != s.name) continue;
    for (const auto& [t, text] : motion->events) events.push_back({{"t", t}, {"text", text}});
    break;
  }
  return events;
}

std::string scene(const Scene& s, Json events, const Display& display) {
  Json t = Json::array(), times = Json::array();
  for (const double moment : s.t) {
    t.push_back(number(moment));
    times.push_back(report::value_shown(moment, si::s, display));
  }
  std::string text = dumped({{"name", s.name},
                             {"t", std::move(t)},
                             {"times", std::move(times)},
                             {"events", std::move(events)},
                             {"tension", tension_range(s, display)}});
  add_entry(text, "lines", scene_lines(s));
  add_entry(text, "points", scene_points(s));
  return text;
}

/// The line of the ground that a profile draws, for the page's own drawing.
std::string ground(const Profile& p) {
  std::string text;
  PictureNumbers out(text);
  std::vector<std::array<double, 2>> flat;
  flat.reserve(p.ground.size());
  for (const Point& at : p.ground) flat.push_back({at.x, at.y});
  out.flat(flat);
  return text;
}

}  // namespace

std::string to_page(const Result& r) {
  const Display display = display_of(r);
  Json answers = Json::array();
  for (const Answer& a : r.answers) answers.push_back({{"label", a.label}, {"text", a.text}});
  Json plots = Json::array();
  std::string ground_line = "[]", scenes;
  std::size_t pictures = 0;
  for (const Figure& f : r.figures) {
    if (const auto* p = std::get_if<Plot>(&f)) {
      plots.push_back(plot(*p, display));
      continue;
    }
    if (const auto* profile = std::get_if<Profile>(&f)) ground_line = ground(*profile);
    ++pictures;
  }
  PictureNumbers(scenes).list(r.scenes, [&](const Scene& s) { scenes += scene(s, events_of(s, r.figures), display); });
  std::string page = dumped({{"title", r.title},
                             {"method", r.method},
                             {"status", to_text(r.status)},
                             {"message", r.message},
                             {"verdict", verdict(r)},
                             {"headline", r.headline},
                             {"answers", std::move(answers)},
                             {"warnings", warnings(r)},
                             {"errors", errors(r)},
                             {"values", values(r, display)},
                             {"checks", checks(r, display)},
                             {"plots", std::move(plots)},
                             {"pictures", pictures},
                             {"interrupted", r.interrupted}});
  add_entry(page, "scenes", scenes);
  add_entry(page, "ground", ground_line);
  return page;
}

std::string pictures_of(const Result& r) {
  const Display display = display_of(r);
  Json pictures = Json::array();
  for (const Figure& f : r.figures) {
    if (std::holds_alternative<Plot>(f)) continue;
    Json one = picture(f, display);
    if (!one.is_null()) pictures.push_back(std::move(one));
  }
  return dumped(pictures);
}

}  // namespace taut::web
