#include "taut/report/figure/figure.hpp"

#include <string_view>
#include <type_traits>

#include "taut/report/figure/animation.hpp"
#include "taut/report/figure/svg_drawing.hpp"
#include "taut/report/figure/svg_plot.hpp"

namespace taut::report {
namespace {

/// The <svg> of a figure with controls, without the id by which its script finds it.
std::string picture_alone(const std::string& html) {
  constexpr std::string_view end = "</svg>", id = " id=\"";
  const std::size_t from = html.find("<svg"), to = html.find(end);
  if (from == std::string::npos || to == std::string::npos) return {};
  std::string svg = html.substr(from, to + end.size() - from);
  const std::size_t at = svg.find(id);
  if (at < svg.find('>')) svg.erase(at, svg.find('"', at + id.size()) + 1 - at);
  return svg;
}

}  // namespace

std::string still_figure(const Figure& figure, const Display& display) {
  return std::visit(
      [&](const auto& f) -> std::string {
        using F = std::decay_t<decltype(f)>;
        if constexpr (std::is_same_v<F, Drawing>) return drawing_svg(f, display);
        if constexpr (std::is_same_v<F, Plot>) return plot_svg(f, display);
        if constexpr (std::is_same_v<F, Animation>) {
          return picture_alone(animation_html(f, display, 0));
        }
      },
      figure);
}

std::string live_figure(const Figure& figure, const Display& display, int& number) {
  const auto* moving = std::get_if<Animation>(&figure);
  return moving == nullptr ? still_figure(figure, display) : animation_html(*moving, display, number++);
}

FigureWords words_of(const Figure& figure) {
  return std::visit(
      [](const auto& f) {
        FigureWords w{.name = f.name, .title = f.title, .caption = f.caption, .scale = {}, .csv = {}};
        if constexpr (std::is_same_v<std::decay_t<decltype(f)>, Drawing>) w.scale = scale_words(f);
        if constexpr (std::is_same_v<std::decay_t<decltype(f)>, Plot>) w.csv = f.name.empty() ? "" : f.name + ".csv";
        return w;
      },
      figure);
}

}  // namespace taut::report
