#include "taut/machine/links/measures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/machine/links/motion_links.hpp"
#include "taut/machine/links/observable.hpp"
#include "taut/units/parse.hpp"

namespace taut::machine::description {

const Description& MeanWindow::describe() {
  static const Description d =
      Describe<MeanWindow>()
          .field(&MeanWindow::of, "of", "the quantity that lies between 'from' and 'to'; default: the time")
          .field(&MeanWindow::from, "from", "lower bound of the time or value, with its unit")
          .required()
          .field(&MeanWindow::to, "to", "upper bound of the time or value, with its unit")
          .required();
  return d;
}

const Description& Measure::describe() {
  static const Description d =
      Describe<Measure>()
          .field(&Measure::of, "of", "observed quantity: s3.x, ext[2].T, a signal")
          .required()
          .field(&Measure::seen_from, "seen_from",
                 "a body: places, velocities and rotations are relative to its origin and axes")
          .field(&Measure::factor, "factor", "", si::one, "factor on the quantity")
          .field(&Measure::offset, "offset", "value added after the factor, with its unit")
          .field(&Measure::since, "since", "t", si::s, "earlier values do not count")
          .at_least(0)
          .at_most(3.2e7)
          .choice(&Measure::relative, "relative",
                  {{"none", Relative::none}, {"difference", Relative::difference}, {"ratio", Relative::ratio}},
                  "difference from, or ratio to, the value at 'since'")
          .record(&Measure::mean, "mean", "interval of its mean")
          .choice(&Measure::value, "value",
                  {{"automatic", Taken::automatic},
                   {"mean", Taken::mean},
                   {"end", Taken::end},
                   {"min", Taken::min},
                   {"max", Taken::max}},
                  "result value of this name: the mean where it has one, else the value at the end");
  return d;
}

}  // namespace taut::machine::description

namespace taut::machine {
namespace {

using description::Measure;
using description::Relative;
using description::Taken;

class MeasureReader {
 public:
  MeasureReader(const Measure& given, Model& model, Complaints& complaints)
      : given_(given), model_(model), path_(fmt::format("measures.{}", given.name)), complaints_(complaints) {}

  void read() {
    auto found = observable(given_.of, model_, path_ + ".of", complaints_);
    if (!found) return;
    Observable o = std::move(*found);
    o.name = given_.name;
    o.factor = given_.factor;
    o.since = given_.since;
    o.relative = given_.relative;
    o.taken = given_.value != Taken::automatic ? given_.value : given_.mean ? Taken::mean : Taken::end;
    if (given_.relative == Relative::ratio) o.unit = si::one;
    if (given_.seen_from) seen_from(o);
    if (given_.offset) {
      if (const auto x = quantity(*given_.offset, o.unit, ".offset")) o.offset = *x;
    }
    if (given_.mean) window(o);
    if (o.taken == Taken::mean && !given_.mean) complain(".value", "a mean needs 'mean', where it is taken");
    check_name();
    model_.measures.push_back(std::move(o));
  }

 private:
  void complain(const std::string& key, std::string message) {
    complaints_.push_back({path_ + key, std::move(message)});
  }

  std::optional<double> quantity(const std::string& text, const Unit& unit, const std::string& key) {
    const auto x = parse_quantity(text, unit);
    if (x) return *x;
    complain(key, x.error().message);
    return std::nullopt;
  }

  void seen_from(Observable& o) {
    o.seen_from = named(model_.bodies, *given_.seen_from, "body", path_ + ".seen_from", complaints_).value_or(ground);
    if (o.quantity > Observed::wz) complain(".seen_from", "belongs to a place, a speed or a rotation of a body");
  }

  void window(Observable& o) {
    Unit unit = si::s;
    if (given_.mean->of) {
      const auto found = observable(*given_.mean->of, model_, path_ + ".mean.of", complaints_);
      if (!found) return;
      unit = found->unit;
      o.mean_of = static_cast<int>(model_.mean_windows.size());
      model_.mean_windows.push_back(*found);
    }
    const auto from = quantity(given_.mean->from, unit, ".mean.from");
    const auto to = quantity(given_.mean->to, unit, ".mean.to");
    if (!from || !to) return;
    if (*from > *to) complain(".mean.to", "must not be below 'from'");
    o.mean_from = *from;
    o.mean_to = *to;
    o.has_mean = true;
  }

  /// What a path could mean besides.
  void check_name() {
    if (given_.name.find_first_of(".[]<>= ") != std::string::npos) {
      complain("", "a name without blanks, dots and brackets is expected");
    } else if (given_.name == time_name) {
      complain("", time_name_taken);
    } else if (index_of(model_.signals, given_.name)) {
      complain("", "there is a signal of this name already");
    }
  }

  const Measure& given_;
  Model& model_;
  std::string path_;
  Complaints& complaints_;
};

}  // namespace

void add_measures(const Machine& machine, Model& model, Complaints& complaints) {
  for (const Measure& given : machine.measures) MeasureReader(given, model, complaints).read();
}

void observe_measures(Model& model) {
  for (Observable& measure : model.measures) {
    measure.slot = index_of(model.observed, measure.name);
    if (!measure.slot) {
      measure.slot = static_cast<int>(model.observed.size());
      model.observed.push_back(measure);
    }
    model.observed[*measure.slot].slot = measure.slot;
  }
  // a mean may be taken by another measure
  for (Observable& of : model.mean_windows) {
    if (index_of(model.measures, of.name)) of.slot = index_of(model.observed, of.name);
  }
}

}  // namespace taut::machine
