#include "python/native_result.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <mutex>
#include <stdexcept>

#include "python/file_error.hpp"
#include "taut/app/job.hpp"
#include "taut/base/long_rows.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/io/json.hpp"
#include "taut/io/table.hpp"
#include "taut/report/html.hpp"
#include "taut/report/markdown.hpp"
#include "taut/report/terminal.hpp"

namespace taut::python {
namespace {

namespace py = pybind11;

/// A result's files may hold HDF5, whose library is not made for threads.
std::mutex& files_turn() {
  static std::mutex one;
  return one;
}

using Matrix = py::array_t<double, py::array::f_style>;

/// The columns of a matrix as read-only views that keep it alive.
py::list views_of(const Matrix& matrix) {
  py::list views;
  const auto rows = matrix.shape(0), columns = matrix.shape(1);
  for (py::ssize_t j = 0; j < columns; ++j) {
    // not data(0, j): a table may have no rows
    py::array_t<double> view({rows}, {static_cast<py::ssize_t>(sizeof(double))}, matrix.data() + j * rows, matrix);
    view.attr("flags").attr("writeable") = false;
    views.append(view);
  }
  return views;
}

py::list data_of(const LongRows& rows) {
  Matrix matrix({static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(rows.width())});
  auto at = matrix.mutable_unchecked<2>();
  py::ssize_t i = 0;
  rows.each([&](const double* row) {
    for (py::ssize_t j = 0; j < at.shape(1); ++j) at(i, j) = row[j];
    ++i;
  });
  return views_of(matrix);
}

bool has_numbers_alone(const Table& t, std::size_t column) {
  for (const auto& row : t.rows) {
    if (column >= row.size() || !std::holds_alternative<double>(row[column])) return false;
  }
  return true;
}

py::list data_of(const Table& t) {
  Matrix matrix({static_cast<py::ssize_t>(t.rows.size()), static_cast<py::ssize_t>(t.columns.size())});
  auto at = matrix.mutable_unchecked<2>();
  std::vector<bool> numbers(t.columns.size());
  for (std::size_t j = 0; j < t.columns.size(); ++j) {
    numbers[j] = has_numbers_alone(t, j);
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      const double* number = j < t.rows[i].size() ? std::get_if<double>(&t.rows[i][j]) : nullptr;
      at(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(j)) = number != nullptr ? *number : std::nan("");
    }
  }
  py::list data = views_of(matrix);
  for (std::size_t j = 0; j < t.columns.size(); ++j) {
    if (numbers[j]) continue;
    py::list cells;
    for (const auto& row : t.rows) cells.append(j < row.size() ? py::cast(row[j]) : py::cast(std::nan("")));
    data[j] = cells;
  }
  return data;
}

py::list values_of(const NativeResult& r) {
  py::list all;
  for (const Value& v : r->values) {
    all.append(py::make_tuple(v.name, v.value, v.unit.symbol, v.unit.shown, v.symbol, v.label, v.source, v.detail));
  }
  return all;
}

py::list tables_of(const NativeResult& r) {
  py::list all;
  for (const Table& t : r->tables) all.append(table_of(t));
  return all;
}

/// Long tables, then plots and profiles that have a name: what the program writes as NAME.csv.
py::list series_of(const NativeResult& r) {
  py::list all;
  for (const Table& t : r->series) all.append(table_of(t));
  for (const Figure& f : r->figures) {
    const auto* plot = std::get_if<Plot>(&f);
    const auto* profile = std::get_if<Profile>(&f);
    if (plot != nullptr && !plot->name.empty()) all.append(table_of(io::series_table(*plot)));
    if (profile != nullptr && !profile->name.empty()) all.append(table_of(io::series_table(*profile)));
  }
  return all;
}

py::list checks_of(const NativeResult& r) {
  py::list all;
  for (const Check& c : r->checks) {
    py::dict one;
    one["name"] = c.name;
    one["value"] = c.value;
    one["limit"] = c.limit;
    one["unit"] = c.unit.symbol;
    one["sense"] = c.sense == Sense::at_most ? "at_most" : "at_least";
    one["utilisation"] = c.utilisation;
    one["passes"] = c.passes;
    one["rule"] = c.rule;
    one["trust"] = c.trust;
    one["part"] = c.part;
    one["where"] = c.where;
    one["limits"] = c.limits;
    one["covers"] = py::cast(c.covers);
    one["refused"] = c.refused;
    all.append(one);
  }
  return all;
}

py::list steps_of(const NativeResult& r) {
  py::list all;
  for (const Step& s : r->steps) {
    if (s.kind != Step::Kind::equation && s.kind != Step::Kind::root && s.kind != Step::Kind::given) continue;
    py::dict one;
    one["eq"] = s.eq;
    one["symbol"] = s.symbol;
    one["value"] = s.value;
    one["unit"] = s.unit.symbol;
    one["source"] = s.source;
    one["words"] = s.words;
    all.append(one);
  }
  return all;
}

py::list given_of(const NativeResult& r) {
  py::list all;
  for (const Given& g : r->given) {
    py::dict one;
    one["key"] = g.key;
    one["symbol"] = g.symbol;
    one["words"] = g.words;
    one["unit"] = g.unit.symbol;
    one["numbers"] = g.numbers;
    one["text"] = g.text;
    one["is_default"] = g.is_default;
    one["chosen"] = g.chosen;
    all.append(one);
  }
  return all;
}

py::list comparisons_of(const NativeResult& r) {
  py::list all;
  for (const Comparison& c : r->comparisons) {
    py::dict one;
    one["quantity"] = c.quantity;
    one["symbol"] = c.symbol;
    one["unit"] = c.unit.symbol;
    one["printed"] = c.printed;
    one["corrected"] = c.corrected;
    one["exact"] = c.exact;
    one["build_by"] = c.build_by;
    one["printed_unsafe"] = c.printed_unsafe;
    all.append(one);
  }
  return all;
}

py::list errors_of(const NativeResult& r) {
  py::list all;
  for (const Diagnostic& d : r->errors) {
    all.append(py::make_tuple(d.file, d.place.line, d.place.column, d.message, d.source_line, d.width, to_text(d),
                              d.unreadable_file));
  }
  return all;
}

py::dict head_of(const NativeResult& r) {
  const auto verdict = verdict_of(*r);
  py::dict head;
  head["title"] = r->title;
  head["method"] = r->method;
  head["method_title"] = r->method_title;
  head["source"] = r->source;
  head["status"] = to_text(r->status);
  head["message"] = r->message;
  head["verdict"] = verdict ? std::string(to_text(verdict->kind)) : std::string{};
  head["verdict_class"] = verdict ? verdict->verdict_class : std::string{};
  head["verdict_reason"] = verdict ? verdict->reason : std::string{};
  head["verdict_words"] = verdict ? std::string(headline(verdict->kind)) : std::string{};
  head["exit_code"] = exit_code(*r);
  head["headline"] = r->headline;
  head["warnings"] = r->warnings;
  head["unsafe"] = r->unsafe;
  head["assumptions"] = r->assumptions;
  head["interrupted"] = r->interrupted;
  head["deck_name"] = r->deck_name;
  head["deck_hash"] = r->deck_hash;
  head["overrides"] = r->overrides;
  head["display"] = r->display;
  head["key_figure"] = r->key_figure;
  py::list answers;
  for (const Answer& a : r->answers) answers.append(py::make_tuple(a.label, a.text));
  head["answers"] = answers;
  py::dict attachments;
  for (const Attachment& a : r->attachments) attachments[py::str(a.name)] = a.text;
  head["attachments"] = attachments;
  return head;
}

py::list figures_of(const NativeResult& r) {
  py::list all;
  for (const Figure& f : r->figures) all.append(figure_of(f));
  return all;
}

std::vector<std::string> write(const NativeResult& r, const std::string& folder, bool si, bool appendix) {
  const auto written = [&] {
    const py::gil_scoped_release released;
    const std::lock_guard turn(files_turn());
    return app::write_files(*r, folder,
                            {.units = si ? app::FileUnits::si : app::FileUnits::display, .appendix = appendix});
  }();
  if (!written) throw FileTrouble(written.error().message);
  return *written;
}

}  // namespace

py::tuple unit_of(const Unit& unit) { return py::make_tuple(unit.symbol, unit.shown); }

py::dict table_of(const Table& t) {
  py::list columns;
  for (const Column& c : t.columns) columns.append(py::make_tuple(c.name, c.unit.symbol, c.unit.shown));
  py::dict table;
  table["name"] = t.name;
  table["title"] = t.title;
  table["columns"] = columns;
  table["data"] = t.long_rows ? data_of(*t.long_rows) : data_of(t);
  return table;
}

void bind_result(py::module_& m) {
  using Released = py::call_guard<py::gil_scoped_release>;
  py::class_<Result, std::shared_ptr<Result>>(m, "NativeResult")
      .def("head", [](const std::shared_ptr<Result>& r) { return head_of(r); })
      .def("errors", [](const std::shared_ptr<Result>& r) { return errors_of(r); })
      .def("values", [](const std::shared_ptr<Result>& r) { return values_of(r); })
      .def("tables", [](const std::shared_ptr<Result>& r) { return tables_of(r); })
      .def("series", [](const std::shared_ptr<Result>& r) { return series_of(r); })
      .def("checks", [](const std::shared_ptr<Result>& r) { return checks_of(r); })
      .def("steps", [](const std::shared_ptr<Result>& r) { return steps_of(r); })
      .def("given", [](const std::shared_ptr<Result>& r) { return given_of(r); })
      .def("comparisons", [](const std::shared_ptr<Result>& r) { return comparisons_of(r); })
      .def("figures", [](const std::shared_ptr<Result>& r) { return figures_of(r); })
      .def(
          "html", [](const std::shared_ptr<Result>& r) { return report::to_html(*r); }, Released())
      .def(
          "markdown", [](const std::shared_ptr<Result>& r) { return report::to_markdown(*r); }, Released())
      .def(
          "json", [](const std::shared_ptr<Result>& r) { return io::to_json(*r); }, Released())
      .def(
          "text", [](const std::shared_ptr<Result>& r, bool all) { return report::to_terminal(*r, {.all = all}); },
          Released())
      .def("write", [](const std::shared_ptr<Result>& r, const std::string& folder, bool si, bool appendix) {
        return write(r, folder, si, appendix);
      });
}

}  // namespace taut::python
