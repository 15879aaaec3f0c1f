#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/results/machine_beams.hpp"
#include "taut/results/plot_curves.hpp"

namespace taut::results {
namespace {

constexpr double wanted_size = 0.06;  ///< of the drawing: the largest deflection
constexpr double seen = 0.03;         ///< larger ones are seen as they are

/// 1, 2 or 5 times a power of ten, not above x.
double round_number(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double k : {5.0, 2.0}) {
    if (x >= k * power) return k * power;
  }
  return power;
}

template <class Of>
void add_plot(const MachineRun& run, const std::string& name, const std::string& title, const Axis& y, Of&& of,
              Result& r) {
  Plot plot;
  plot.name = name;
  plot.title = title;
  plot.x = {.label = "along the beam from its base", .unit = si::m};
  plot.y = y;
  bool dashed = false;
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    for (const solve::BeamResult& b : one.result.beams) {
      Curve c;
      c.label = one.model.beams[b.beam].name;
      if (run.equilibria.size() > 1) c.label += ", " + one.words;
      c.dashed = dashed;
      for (const solve::BeamPoint& p : b.points) {
        c.x.push_back(p.s);
        c.y.push_back(of(p));
      }
      plot.curves.push_back(std::move(c));
    }
    dashed = true;
  }
  keep_largest(plot, most_shown_curves);
  if (!plot.curves.empty()) r.figures.emplace_back(std::move(plot));
}

}  // namespace

std::vector<std::vector<Vector3>> beam_lines(const solve::EquilibriumResult& e, double times) {
  std::vector<std::vector<Vector3>> all;
  for (const solve::BeamResult& b : e.beams) {
    auto& line = all.emplace_back();
    for (const solve::BeamPoint& p : b.points) line.emplace_back(p.place + (times - 1) * p.deflection);
  }
  return all;
}

std::vector<std::vector<Vector3>> beam_lines(const solve::EquilibriumResult& e) { return beam_lines(e, 1); }

double shown_times(const solve::EquilibriumResult& e, double size) {
  double most = 0;
  for (const solve::BeamResult& b : e.beams) {
    for (const solve::BeamPoint& p : b.points) most = std::max(most, p.w);
  }
  if (!(most > 1e-9 * size) || most > seen * size) return 0;
  return round_number(wanted_size * size / most);
}

namespace {

/// Of the most stressed point; where it bears no shear that counts, of a fibre.
void write_stress(Sheet<Num>& s, const structure::BeamSection& section, const solve::BeamPoint& p, const Num& N,
                  const Num& M) {
  const structure::PointStress at = most_stressed_point(section, {.axial = p.N,
                                                                  .shear_x = p.shear_x,
                                                                  .shear_y = p.shear_y,
                                                                  .bends_to_x = p.bends_to_x,
                                                                  .bends_to_y = p.bends_to_y,
                                                                  .torsion = p.torsion});
  const bool sheared = at.equivalent() > at.sigma, one_way = section.outline != structure::Outline::box;
  const Num A = s.named("A", si::m2, section.area);
  Num sigma;
  if (one_way && !sheared) {
    sigma = s.eq("", "sigma", si::Pa, N / A + M / s.named("W", si::m3, section.W_x),
                 "largest fibre stress, EN 1993-1-1, 6.2.1 (5)");
  } else {
    const Num sigma_M = s.named("sigma_M", si::Pa, at.sigma - std::abs(p.N) / section.area);
    sigma = s.eq("", "sigma", si::Pa, N / A + sigma_M,
                 one_way ? "sigma_M: M/W of the most stressed point; EN 1993-1-1, 6.2.1 (5)"
                         : "|M_x|/W_x + |M_y|/W_y is sigma_M; EN 1993-1-1, 6.2.1 (5)");
  }
  if (!sheared) return;
  const Num tau = s.named("tau", si::Pa, at.tau);
  s.eq("6.1", "sigma_v", si::Pa, sqrt(square(sigma) + 3 * square(tau)),
       "EN 1993-1-1, (6.1); tau: torsion over W_t and shear in that point");
}

}  // namespace

void add_beam_plots(const MachineRun& run, Result& r) {
  add_plot(
      run, "beam_moments", "Bending moment along the beams", {.label = "bending moment", .unit = si::N_m},
      [](const solve::BeamPoint& p) { return p.M; }, r);
  add_plot(
      run, "beam_forces", "Axial force along the beams, tension positive", {.label = "axial force", .unit = si::N},
      [](const solve::BeamPoint& p) { return p.N; }, r);
  add_plot(
      run, "beam_deflections", "Deflection across the beams", {.label = "deflection", .unit = si::m.in("mm")},
      [](const solve::BeamPoint& p) { return p.w; }, r);
}

void write_beams(Sheet<Num>& s, const MachineRun& run) {
  for (std::size_t i = 0; i < run.model.beams.size(); ++i) {
    const solve::BeamResult* worst = nullptr;
    std::string when;
    const auto size = [](const solve::BeamResult& b) {
      const solve::BeamPoint& p = b.points[b.most_stressed];
      return std::isnan(p.stress) ? b.points[b.most_bent].M : p.stress;
    };
    const std::vector<Answer> all = answers_of(run);
    for (const Answer& a : all) {
      if (worst != nullptr && size(a.result->beams[i]) <= size(*worst)) continue;
      worst = &a.result->beams[i];
      when = a.words;
    }
    if (worst == nullptr) continue;
    const auto& section = run.model.beams[i].pieces.front().rod.section;
    const bool stressed = !std::isnan(worst->points[worst->most_stressed].stress);
    const solve::BeamPoint& p = worst->points[stressed ? worst->most_stressed : worst->most_bent];
    s.section(fmt::format("Beam {}: its most {} section, {} from its base ({})", run.model.beams[i].name,
                          stressed ? "stressed" : "bent", run.display.brief(p.s, si::m), when));
    const Num N = s.named("N", si::N, std::abs(p.N)), M = s.named("M", si::N_m, p.M);
    if (stressed) write_stress(s, section, p, N, M);
    if (worst->compression > 0 && std::isfinite(worst->least_factor())) {
      const Num N_Ed = s.named("N_Ed", si::N, worst->compression);
      const Num N_cr = s.named("N_cr", si::N, worst->least_factor() * worst->compression);
      s.eq("", "alpha_cr", si::one, N_cr / N_Ed, "EN 1993-1-1, 5.2.1: critical over present axial force");
    }
  }
}

}  // namespace taut::results
