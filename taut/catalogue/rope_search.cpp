#include "taut/catalogue/rope_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

#include "taut/catalogue/construction.hpp"

namespace taut::catalogue {
namespace {

constexpr double same_diameter = 1e-6;  // m: far below the step of any table
constexpr double same_grade = 0.5e6;    // Pa

using Rows = std::vector<const RopeRow*>;

Rows kept(const Rows& rows, const std::function<bool(const RopeRow&)>& condition) {
  Rows out;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(out), [&](const RopeRow* row) { return condition(*row); });
  return out;
}

/// The texts of all rows, each once, in the rows' order.
std::vector<std::string> distinct(const Rows& rows, const std::function<std::string(const RopeRow&)>& text) {
  std::vector<std::string> out;
  for (const RopeRow* row : rows) {
    std::string one = text(*row);
    if (!one.empty() && std::find(out.begin(), out.end(), one) == out.end()) out.push_back(std::move(one));
  }
  return out;
}

std::vector<std::string> ids(const Rows& rows, std::size_t count) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < std::min(count, rows.size()); ++i) out.push_back(rows[i]->id);
  return out;
}

std::string millimetres(double metres) { return fmt::format("{} mm", short_number(metres * 1e3)); }
std::string grade_text(const std::optional<double>& grade) {
  return grade ? fmt::format("{} MPa", short_number(*grade / 1e6)) : std::string("none");
}
std::string name_of(const RopeDescription& wanted) {
  return wanted.core.empty() ? wanted.construction : fmt::format("{} {}", wanted.construction, wanted.core);
}

Rows nearest_diameters(Rows rows, double diameter) {
  std::stable_sort(rows.begin(), rows.end(), [&](const RopeRow* a, const RopeRow* b) {
    return std::abs(a->diameter - diameter) < std::abs(b->diameter - diameter);
  });
  return rows;
}

/// Why no row has the construction, core and standard asked for.
LookupError no_such_construction(const RopeDescription& wanted, const Rows& all) {
  const auto constructions = distinct(all, [](const RopeRow& r) { return r.construction; });
  RopeFilter filter;
  filter.construction = wanted.construction;
  const Rows built = kept(all, [&](const RopeRow& r) { return matches(r, filter); });
  if (built.empty()) {
    return {.message = fmt::format("no rope of construction {}; there are {}", in_quotes(wanted.construction),
                                   listed(constructions, 20)),
            .candidates = nearest_names(wanted.construction, constructions, suggested)};
  }
  filter.standard = wanted.standard;
  const Rows standardised = kept(built, [&](const RopeRow& r) { return matches(r, filter); });
  if (standardised.empty()) {
    const auto standards = distinct(built, [](const RopeRow& r) { return r.standard; });
    return {.message = fmt::format("no {} rope to {}; {} is listed to {}", wanted.construction,
                                   in_quotes(wanted.standard), wanted.construction, listed(standards)),
            .candidates = {}};
  }
  const auto cores = distinct(standardised, [](const RopeRow& r) { return r.core; });
  return {.message = fmt::format("no {} rope with core {}; the cores listed are {}", wanted.construction,
                                 in_quotes(wanted.core), listed(cores)),
          .candidates = {}};
}

std::string ambiguity(const RopeDescription& wanted, const Rows& rows) {
  const auto grades = distinct(rows, [](const RopeRow& r) { return grade_text(r.grade); });
  const auto cores = distinct(rows, [](const RopeRow& r) { return r.core; });
  const auto standards = distinct(rows, [](const RopeRow& r) { return r.standard; });
  std::vector<std::string> hints;
  if (standards.size() > 1) hints.push_back(fmt::format("standard ({})", listed(standards)));
  if (cores.size() > 1) hints.push_back(fmt::format("core ({})", listed(cores)));
  if (grades.size() > 1) hints.push_back(fmt::format("grade ({})", listed(grades)));
  if (hints.empty()) hints.emplace_back("id");
  return fmt::format("{} ropes are {} of {}: give the {}", rows.size(), name_of(wanted), millimetres(wanted.diameter),
                     fmt::join(hints, ", "));
}

}  // namespace

bool matches(const RopeRow& row, const RopeFilter& filter) {
  if (!filter.construction.empty()) {
    if (!matches_construction(filter.construction, row.construction)) return false;
    const auto parts = parse_construction(filter.construction);
    if (parts && !parts->core.empty() && parts->core != row.core) return false;
  }
  if (!filter.core.empty() && parse_core(filter.core).value_or(filter.core) != row.core) return false;
  if (!filter.standard.empty() && !normalised(row.standard).starts_with(normalised(filter.standard))) return false;
  if (filter.grade && (!row.grade || std::abs(*row.grade - *filter.grade) >= same_grade)) return false;
  if (filter.min_breaking_force && row.breaking_force < *filter.min_breaking_force) return false;
  if (filter.min_diameter && row.diameter < *filter.min_diameter - same_diameter) return false;
  if (filter.max_diameter && row.diameter > *filter.max_diameter + same_diameter) return false;
  if (filter.min_area && row.area < *filter.min_area) return false;
  return at_least(row.trust, filter.min_trust);
}

std::vector<RopeRow> select_ropes(const RopeFilter& filter, const std::vector<RopeRow>& table) {
  std::vector<RopeRow> out;
  std::copy_if(table.begin(), table.end(), std::back_inserter(out),
               [&](const RopeRow& row) { return matches(row, filter); });
  return out;
}

std::vector<RopeRow> ropes_by(RopeOrder order, const RopeFilter& filter, const std::vector<RopeRow>& table) {
  const auto key = [order](const RopeRow& row) {
    switch (order) {
      case RopeOrder::breaking_force:
        return row.breaking_force;
      case RopeOrder::diameter:
        return row.diameter;
      case RopeOrder::area:
        return row.area;
      case RopeOrder::mass:
        break;
    }
    return row.mass_per_length;
  };
  std::vector<RopeRow> out = select_ropes(filter, table);
  std::sort(out.begin(), out.end(), [&](const RopeRow& a, const RopeRow& b) {
    return std::forward_as_tuple(key(a), a.diameter, a.area, a.breaking_force, a.trust, a.id) <
           std::forward_as_tuple(key(b), b.diameter, b.area, b.breaking_force, b.trust, b.id);
  });
  return out;
}

const RopeRow* rope_of_id(std::string_view id, const std::vector<RopeRow>& table) {
  // as the catalogue writes it: a design asks for thousands of rows, each by its own name
  auto found = std::find_if(table.begin(), table.end(), [&](const RopeRow& row) { return row.id == id; });
  if (found == table.end()) {
    const std::string wanted = normalised(id);
    found = std::find_if(table.begin(), table.end(), [&](const RopeRow& row) { return is_named(row.id, wanted); });
  }
  return found == table.end() ? nullptr : &*found;
}

Found<RopeRow> find_rope(std::string_view id, const std::vector<RopeRow>& table) {
  if (const RopeRow* row = rope_of_id(id, table)) return *row;
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const RopeRow& row : table) names.push_back(row.id);
  return failure(fmt::format("no rope {}", in_quotes(id)), nearest_names(id, names, suggested));
}

Found<RopeRow> find_rope(const RopeDescription& wanted, const std::vector<RopeRow>& table) {
  Rows all;
  all.reserve(table.size());
  for (const RopeRow& row : table) all.push_back(&row);
  if (wanted.construction.empty()) return failure("a rope needs its construction", {});

  RopeFilter filter;
  filter.construction = wanted.construction;
  filter.core = wanted.core;
  filter.standard = wanted.standard;
  const Rows built = kept(all, [&](const RopeRow& row) { return matches(row, filter); });
  if (built.empty()) return tl::unexpected(no_such_construction(wanted, all));

  const Rows sized =
      kept(built, [&](const RopeRow& row) { return std::abs(row.diameter - wanted.diameter) < same_diameter; });
  if (sized.empty()) {
    const Rows near = nearest_diameters(built, wanted.diameter);
    const auto sizes = distinct(near, [](const RopeRow& row) { return millimetres(row.diameter); });
    return failure(fmt::format("no {} rope of {}; the nearest are {}", name_of(wanted), millimetres(wanted.diameter),
                               listed({sizes.begin(), sizes.begin() + std::min<std::ptrdiff_t>(4, std::ssize(sizes))})),
                   {});
  }
  Rows graded = sized;
  if (wanted.grade) {
    graded = kept(sized, [&](const RopeRow& r) { return r.grade && std::abs(*r.grade - *wanted.grade) < same_grade; });
  }
  if (graded.empty()) {
    const auto grades = distinct(sized, [](const RopeRow& row) { return grade_text(row.grade); });
    return failure(fmt::format("no {} rope of {} in grade {}; the grades listed are {}", name_of(wanted),
                               millimetres(wanted.diameter), grade_text(wanted.grade), listed(grades)),
                   ids(sized, suggested));
  }
  const std::string exact = normalised(wanted.construction);
  const Rows named = kept(graded, [&](const RopeRow& row) { return normalised(row.construction) == exact; });
  const Rows& left = named.empty() ? graded : named;
  if (left.size() == 1) return *left.front();
  return failure(ambiguity(wanted, left), ids(left, 2 * suggested));
}

}  // namespace taut::catalogue
