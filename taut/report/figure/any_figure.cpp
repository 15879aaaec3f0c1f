#include "taut/report/figure/any_figure.hpp"

#include <type_traits>

#include "taut/report/figure/motion/animation.hpp"
#include "taut/report/figure/motion/motion_strip.hpp"
#include "taut/report/figure/svg_bars.hpp"
#include "taut/report/figure/svg_drawing.hpp"
#include "taut/report/figure/svg_plot.hpp"
#include "taut/report/figure/svg_profile.hpp"

namespace taut::report {
namespace {

struct StaticFigure {
  const Display& display;

  std::string operator()(const Drawing& d) const { return drawing_svg(d, display); }
  std::string operator()(const Plot& p) const { return plot_svg(p, display); }
  std::string operator()(const Animation& a) const { return strip_svg(a, display); }
  std::string operator()(const Profile& p) const { return profile_svg(p, display); }
  std::string operator()(const Bars& b) const { return bars_svg(b, display); }
};

}  // namespace

std::string figure_svg(const Figure& figure, const Display& display) {
  return std::visit(StaticFigure{display}, figure);
}

std::string live_figure(const Figure& figure, const Display& display, FiguresAbove& above) {
  if (const auto* moving = std::get_if<Animation>(&figure)) return animation_html(*moving, display, above.animations++);
  if (const auto* plot = std::get_if<Plot>(&figure)) return plot_svg(*plot, display, above.listed);
  if (const auto* profile = std::get_if<Profile>(&figure)) return profile_svg(*profile, display, turned_width);
  return figure_svg(figure, display);
}

bool is_turned(const Figure& figure) { return std::holds_alternative<Profile>(figure); }

FigureWords words_of(const Figure& figure) {
  return std::visit(
      [](const auto& f) {
        using F = std::decay_t<decltype(f)>;
        FigureWords w{.name = f.name, .title = f.title, .caption = f.caption, .scale = {}, .csv = {}};
        if constexpr (std::is_same_v<F, Drawing>) w.scale = scale_words(f);
        if constexpr (std::is_same_v<F, Profile>) w.scale = profile_scale_words(f);
        if constexpr (std::is_same_v<F, Plot> || std::is_same_v<F, Profile>)
          w.csv = f.name.empty() ? "" : f.name + ".csv";
        return w;
      },
      figure);
}

}  // namespace taut::report
