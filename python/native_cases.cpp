#include "python/native_cases.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "python/file_error.hpp"
#include "python/watched.hpp"
#include "taut/app/cases/evaluate.hpp"
#include "taut/app/cases/read_cases.hpp"
#include "taut/app/cases/study/calibrate.hpp"
#include "taut/app/cases/study/study.hpp"
#include "taut/app/cases/study/study_folder.hpp"
#include "taut/app/cases/study/study_result.hpp"
#include "taut/app/cases/study/study_run.hpp"

namespace taut::python {
namespace {

namespace py = pybind11;
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A deck that was read for one question. It is never changed, so that any thread may ask it.
struct NativeCases {
  app::CaseModel model;
};

/// (cases, result, complaints, message): the cases, or the result that tells the deck's mistakes, or what is wrong with
/// the question, or why the deck has no answer. Without outputs those of the deck's study.
py::tuple make_cases(const std::string& text, const std::string& name, const std::vector<std::string>& set,
                     const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  tl::expected<NativeCases, app::NoCases> made = tl::unexpected(app::NoCases{});
  std::shared_ptr<Result> bad;
  {
    const py::gil_scoped_release released;
    const auto read = app::read_cases({.text = text, .name = name, .set = set});
    if (read) {
      app::CaseQuestion question;
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        question.inputs.push_back({.name = inputs[i], .place = fmt::format("paths[{}]", i)});
      }
      const std::vector<std::string>& wanted = outputs.empty() && read->study ? read->study->of : outputs;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        question.outputs.push_back({.name = wanted[i], .place = fmt::format("of[{}]", i)});
      }
      if (inputs.empty()) made.error().complaints.push_back({"paths", "name at least one number that changes"});
      if (wanted.empty()) made.error().complaints.push_back({"of", "name the values that are wanted"});
      if (made.error().complaints.empty()) {
        auto model = read->cases(question);
        if (model) {
          made = NativeCases{.model = std::move(*model)};
        } else {
          made = tl::unexpected(std::move(model.error()));
        }
      }
    } else {
      bad = std::make_shared<Result>(read.error());
    }
  }
  if (made) return py::make_tuple(std::make_shared<NativeCases>(std::move(*made)), py::none(), py::list(), "");
  py::list complaints;
  for (const Complaint& c : made.error().complaints) complaints.append(py::make_tuple(c.path, c.message));
  const py::object result = bad ? py::cast(bad) : py::none();
  return py::make_tuple(py::none(), result, complaints, made.error().outcome.message);
}

py::list inputs_of(const NativeCases& cases) {
  py::list all;
  for (const app::CaseInput& in : cases.model.inputs) {
    all.append(py::make_tuple(in.path, in.unit.symbol, in.unit.shown, in.base));
  }
  return all;
}

/// The SI value of a text as that input has it.
double number_of(const NativeCases& cases, std::size_t input, const std::string& text) {
  const auto value = parse_quantity(text, cases.model.inputs.at(input).unit);
  if (!value) throw std::invalid_argument(value.error().message);
  return *value;
}

py::list outputs_of(const NativeCases& cases) {
  py::list all;
  for (const app::CaseOutput& out : cases.model.outputs) {
    all.append(py::make_tuple(out.name, out.unit.symbol, out.unit.shown, out.base, out.label));
  }
  return all;
}

/// (outputs (rows, outputs), [(row, reason)], interrupted, exception or None)
py::tuple evaluated(const std::shared_ptr<NativeCases>& cases, const Rows& values, int threads,
                    const py::object& progress) {
  const auto in = static_cast<py::ssize_t>(cases->model.inputs.size());
  if (values.ndim() != 2 || values.shape(1) != in) throw std::invalid_argument(fmt::format("shape (n, {})", in));
  const py::ssize_t rows = values.shape(0);
  Rows outputs({rows, static_cast<py::ssize_t>(cases->model.outputs.size())});
  // a copy: the array may be changed by another thread of Python meanwhile
  const std::vector<double> numbers(values.data(), values.data() + values.size());
  const std::span<double> into(outputs.mutable_data(), static_cast<std::size_t>(outputs.size()));
  app::Evaluated end;
  const py::object raised = watched(
      [&](const Ask& ask) {
        app::EvaluateOptions options{.threads = threads};
        options.go_on = [&](std::size_t done) {
          const double share = static_cast<double>(done) / static_cast<double>(rows);
          return ask({.what = "evaluate", .done = share, .words = fmt::format("{} of {} rows", done, rows)});
        };
        end = app::evaluate(cases->model, numbers, into, options);
      },
      progress);
  py::list without;
  for (const app::RowWithout& one : end.without) without.append(py::make_tuple(one.row, one.reason));
  return py::make_tuple(outputs, without, end.interrupted, raised);
}

/// (result or None, cases done, cases, exception or None); throws FileTrouble where a file can't be written.
py::tuple study(const std::string& text, const std::string& name, const std::vector<std::string>& set,
                const std::string& folder, int threads, const py::object& progress) {
  const app::Job job{.text = text, .name = name, .set = set};
  std::shared_ptr<Result> result;
  app::StudyState state;
  std::optional<app::FileError> trouble;
  const auto work = [&](const Ask& ask) -> tl::expected<void, app::FileError> {
    const auto study = app::read_study(job);
    if (!study) {
      result = std::make_shared<Result>(study.error());
      return {};
    }
    const auto place = app::StudyFolder::make(folder, job, *study);
    if (!place) return tl::unexpected(place.error());
    const auto run = app::run_cases(*study, *place, {.threads = threads, .progress = ask});
    if (!run) return tl::unexpected(run.error());
    state = *run;
    if (state.interrupted || !state.whole()) return {};
    const auto data = app::read_cases(*study, *place);
    if (!data) return tl::unexpected(data.error());
    result = std::make_shared<Result>(app::study_result(*study, *data, {.threads = threads, .progress = ask}));
    return {};
  };
  const py::object raised = watched(
      [&](const Ask& ask) {
        const auto done = work(ask);
        if (!done) trouble = done.error();
      },
      progress);
  if (trouble) throw FileTrouble(trouble->message);
  return py::make_tuple(result ? py::cast(result) : py::none(), state.cases_done, state.cases, raised);
}

/// (result, exception or None)
py::tuple calibrate(const std::string& text, const std::string& name, const std::vector<std::string>& set, int threads,
                    const py::object& progress) {
  std::shared_ptr<Result> result;
  const py::object raised = watched(
      [&](const Ask& ask) {
        result = std::make_shared<Result>(
            app::calibrate({.text = text, .name = name, .set = set, .progress = ask}, threads));
      },
      progress);
  return py::make_tuple(result, raised);
}

}  // namespace

void bind_cases(py::module_& m) {
  py::class_<NativeCases, std::shared_ptr<NativeCases>>(m, "NativeCases")
      .def("inputs", inputs_of)
      .def("number", number_of)
      .def("outputs", outputs_of)
      .def("evaluate", evaluated);
  m.def("make_cases", make_cases);
  m.def("study", study);
  m.def("calibrate", calibrate);
}

}  // namespace taut::python
