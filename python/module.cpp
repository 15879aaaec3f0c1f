#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "python/descriptions.hpp"
#include "python/file_error.hpp"
#include "python/native_cases.hpp"
#include "python/native_result.hpp"
#include "python/watched.hpp"
#include "taut/app/compare.hpp"
#include "taut/app/explain/explain_name.hpp"
#include "taut/app/explain/listing.hpp"
#include "taut/app/explain/schema.hpp"
#include "taut/app/explain/starters.hpp"
#include "taut/app/job.hpp"
#include "taut/app/methods.hpp"
#include "taut/base/suggest.hpp"
#include "taut/base/version.hpp"
#include "taut/units/any_quantity.hpp"
#include "taut/units/display.hpp"

/// The part of the package `taut` in C++: plain data in and out. What a user sees is written in Python beside it.
namespace taut::python {
namespace {

namespace py = pybind11;

/// (result, exception or None)
py::tuple run(const std::string& text, const std::string& name, const std::vector<std::string>& set,
              const py::object& progress) {
  std::shared_ptr<Result> result;
  const py::object raised = watched(
      [&](const Ask& ask) {
        result = std::make_shared<Result>(app::run({.text = text, .name = name, .set = set, .progress = ask}));
      },
      progress);
  return py::make_tuple(result, raised);
}

/// The mistakes of a deck, as a result that has nothing else.
std::shared_ptr<Result> check(const std::string& text, const std::string& name, const std::vector<std::string>& set) {
  auto result = std::make_shared<Result>();
  result->errors = app::check({.text = text, .name = name, .set = set});
  result->status = result->errors.empty() ? Status::ok : Status::bad_deck;
  result->deck_name = name;
  return result;
}

std::vector<std::string> deck_names() {
  std::vector<std::string> names = app::method_names();
  for (std::string& name : app::starter_names()) names.push_back(std::move(name));
  return names;
}

std::string new_deck(const std::string& name) {
  if (const app::MethodEntry* method = app::find_method(name)) return app::starter_deck(method->example);
  if (const app::Starter* starter = app::find_starter(name)) return app::starter_deck(starter->text);
  const std::string hint = did_you_mean(name, deck_names());
  throw std::invalid_argument("there is no deck '" + name + "'" + hint + "; taut.names() lists them");
}

template <class T, class E>
T or_throw(tl::expected<T, E> got) {
  if (got) return std::move(*got);
  if constexpr (std::is_same_v<E, app::FileError>) {
    throw FileTrouble(got.error().message);
  } else if constexpr (std::is_same_v<E, UnitError>) {
    throw std::invalid_argument(got.error().message);
  } else {
    throw std::invalid_argument(got.error());
  }
}

/// (text, name) of a file.
py::tuple read_file(const std::string& path) {
  const app::Job job = or_throw(app::read_job(path));
  return py::make_tuple(job.text, job.name);
}

py::tuple read_set(const std::string& path) {
  const app::Job job = or_throw(app::read_set(path));
  return py::make_tuple(job.text, job.name);
}

std::shared_ptr<Result> compare(const std::string& text, const std::string& name) {
  return std::make_shared<Result>(app::compare({.text = text, .name = name, .set = {}}));
}

/// (SI value, symbol of its unit)
py::tuple quantity(const std::string& text) {
  const AnyQuantity q = or_throw(parse_any_quantity(text));
  return py::make_tuple(q.value, q.unit.symbol);
}

/// The unit of a number by its SI unit and its unit of print.
Unit unit_of(const std::string& symbol, std::string_view shown) {
  if (symbol == si::one.symbol) return si::one.in(shown);
  for (const Unit& unit : display_kinds()) {
    if (unit.symbol == symbol) return unit.in(shown);
  }
  for (const Unit& unit : {si::N_m_s, si::per_K}) {
    if (unit.symbol == symbol) return unit.in(shown);
  }
  return or_throw(parse_any_quantity("1 " + symbol)).unit;
}

/// An SI value in another unit of its kind, as a report with that unit shows it: an angle in % is a slope, a
/// temperature in degC counts from its own zero, a frequency in rad/s turns.
double in_unit(double si, const std::string& symbol, const std::string& shown, const std::string& unit) {
  const Unit own = unit_of(symbol, shown);
  if (!own.needs_text()) return si / or_throw(parse_quantity(unit == "1" ? "1" : "1 " + unit, own));
  const std::string kind(own.kind);
  if (const auto may = check_display(kind, unit); !may) {
    if (!may.error().of_kind) throw std::invalid_argument(may.error().message);
    return si / or_throw(unit_factor(unit, own));
  }
  return Display(std::map<std::string, std::string>{{kind, unit}}).from_si(si, own);
}

std::string explain(const std::string& name) { return or_throw(app::explain_name(name)); }
std::string listing(const std::string& what, const std::string& name) {
  app::ListFilter filter;
  filter.name = name;
  return or_throw(app::list_text(what, filter));
}

}  // namespace
}  // namespace taut::python

PYBIND11_MODULE(_taut, m) {
  using Released = pybind11::call_guard<pybind11::gil_scoped_release>;
  pybind11::register_exception<taut::python::FileTrouble>(m, "FileError", PyExc_OSError);
  m.attr("version") = std::string(taut::version);
  taut::python::bind_result(m);
  taut::python::bind_cases(m);
  m.def("run", taut::python::run);
  m.def("check", taut::python::check, Released());
  m.def("schema", taut::app::schema_text, Released());
  m.def("new", taut::python::new_deck, Released());
  m.def("names", taut::python::deck_names, Released());
  m.def("compare", taut::python::compare, Released());
  m.def("read_file", taut::python::read_file);
  m.def("read_set", taut::python::read_set);
  m.def("quantity", taut::python::quantity);
  m.def("in_unit", taut::python::in_unit, Released());
  m.def("explain", taut::python::explain, Released());
  m.def("listing", taut::python::listing, Released());
  m.def("descriptions", taut::python::descriptions);
}
