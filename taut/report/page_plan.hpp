#pragma once
#include <string>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/report/tables/html_table.hpp"

namespace taut::report {

/// Which values, tables and pictures stand among the results, and which in the appendix. Checks, equations and inputs
/// are never moved.
struct PagePlan {
  std::vector<const Value*> values;
  std::vector<const Table*> tables;  ///< shown without their columns of detail
  std::vector<const Figure*> pictures;
  std::vector<const Value*> appendix_values;
  /// Those that are `detail`, do not fit, or are thinned or narrowed among the results.
  std::vector<const Table*> appendix_tables;
  std::vector<const Figure*> appendix_pictures;
  TableLimits limits;           ///< of the tables among the results
  TableLimits appendix_limits;  ///< of those in the appendix
};

/// The plan that keeps the pages of A4 for this kind of result: 8 for a method, 10 for a machine or a motion, 12 for
/// a design, by an estimate of what each section takes in print. A comparison shows all its rows. `shown`: figures of
/// page 1, which are not shown again unless they move.
PagePlan plan_pages(const Result& r, const std::vector<const Figure*>& shown = {});

/// The results under one heading.
struct ResultGroup {
  std::string heading;  ///< of an analysis; empty: of the whole
  std::vector<const Value*> values;
  std::vector<const Table*> tables;
};

/// The results of a plan by their headings: first those without, then each in the order of its first value or table.
std::vector<ResultGroup> groups_of(const PagePlan& plan);

}  // namespace taut::report
