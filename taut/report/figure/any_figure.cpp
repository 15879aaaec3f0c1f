#include "taut/report/figure/any_figure.hpp"

#include "taut/report/figure/motion_strip.hpp"
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
};

}  // namespace

std::string figure_svg(const Figure& figure, const Display& display) {
  return std::visit(StaticFigure{display}, figure);
}

}  // namespace taut::report
