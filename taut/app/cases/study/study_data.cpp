#include <fmt/format.h>

#include "taut/app/cases/case_values.hpp"
#include "taut/app/cases/study/study_result.hpp"
#include "taut/base/long_rows.hpp"

namespace taut::app {

tl::expected<StudyData, FileError> read_cases(const Study& study, const StudyFolder& folder) {
  StudyData data;
  const CaseModel& model = study.model;
  data.rows.detail = true;
  data.rows.name = "cases";
  data.rows.title = "Cases; status 0: with an answer";
  data.rows.columns.push_back({.name = "case", .unit = si::one});
  for (const CaseInput& one : model.inputs) data.rows.columns.push_back({.name = one.path, .unit = one.unit});
  for (const CaseOutput& one : model.outputs) data.rows.columns.push_back({.name = one.name, .unit = one.unit});
  data.rows.columns.push_back({.name = "status", .unit = si::one});
  const auto rows = std::make_shared<LongRows>(data.rows.columns.size());
  data.outputs.resize(model.outputs.size());
  for (std::uint64_t part = 0; part < folder.parts().count(); ++part) {
    const auto read = folder.read(part, study);
    if (!read) return tl::unexpected(read.error());
    for (const KeptCase& one : *read) {
      std::vector<double> row = {static_cast<double>(one.index)};
      row.insert(row.end(), one.values.begin(), one.values.end());
      row.insert(row.end(), one.answer.outputs.begin(), one.answer.outputs.end());
      row.push_back(static_cast<double>(one.answer.outcome.status));
      rows->add(row);
      for (std::size_t k = 0; k < data.outputs.size(); ++k) data.outputs[k].push_back(one.answer.outputs[k]);
      if (!one.answer.outcome.ok()) data.failed.push_back({one.index, one.answer.outcome.message});
      for (const CaseFlaw& flaw : one.answer.flaws) data.flawed.push_back({one.index, flaw});
      keep_least(one.answer.weaker, data.weaker);
    }
  }
  data.rows.long_rows = rows;
  return data;
}

}  // namespace taut::app
