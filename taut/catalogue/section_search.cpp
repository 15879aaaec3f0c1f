#include "taut/catalogue/section_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "taut/base/number.hpp"

namespace taut::catalogue {
namespace {

constexpr double same_size = 1e-6;  // m

/// What a section's name says.
struct SectionName {
  std::optional<SectionShape> shape;
  bool cold = false;
  std::vector<double> sizes;  // m, as written
  std::string standard;       // normalised
};

/// "rhs-c200x100x8gost30245" taken apart; nothing when it has no dimensions or a part that is not understood.
std::optional<SectionName> parse_section_name(std::string_view normal) {
  SectionName out;
  for (const SectionShape shape : {SectionShape::chs, SectionShape::shs, SectionShape::rhs}) {
    if (!normal.starts_with(normalised(to_text(shape)))) continue;
    out.shape = shape;
    normal.remove_prefix(to_text(shape).size());
  }
  if (normal.starts_with("-c")) {
    out.cold = true;
    normal.remove_prefix(2);
  }
  while (true) {
    const NumberAtFront size = number_at_front(normal);
    if (size.length == 0 || !size.in_range) return std::nullopt;
    out.sizes.push_back(size.value / 1e3);
    normal.remove_prefix(size.length);
    if (!normal.starts_with('x')) break;
    normal.remove_prefix(1);
  }
  out.standard = std::string(normal);
  return out;
}

bool same(double a, double b) { return std::abs(a - b) < same_size; }

bool same_sizes(const SectionRow& row, const std::vector<double>& sizes) {
  if (sizes.size() == 2) {
    return row.shape != SectionShape::rhs && same(sizes[0], row.height) && same(sizes[1], row.thickness);
  }
  return sizes.size() == 3 && row.shape != SectionShape::chs && same(std::max(sizes[0], sizes[1]), row.height) &&
         same(std::min(sizes[0], sizes[1]), row.width) && same(sizes[2], row.thickness);
}

bool means(const SectionName& name, const SectionRow& row) {
  if (name.shape && *name.shape != row.shape) return false;
  if (name.cold && row.forming != Forming::cold) return false;
  return same_sizes(row, name.sizes) && normalised(row.standard).starts_with(name.standard);
}

/// The name as the tables write it, for a shape that is given: "CHS508x16.0" is "chs508x16", "SHS 100x5"
/// "shs100x100x5", "RHS 100x200x8" "rhs200x100x8".
std::string table_name(const SectionName& name) {
  if (!name.shape) return {};
  std::vector<double> sizes = name.sizes;
  if (sizes.size() == 2 && name.shape != SectionShape::chs) sizes.insert(sizes.begin(), sizes.front());
  if (sizes.size() == 3 && sizes[0] < sizes[1]) std::swap(sizes[0], sizes[1]);
  std::vector<std::string> texts;
  texts.reserve(sizes.size());
  for (const double size : sizes) texts.push_back(short_number(size * 1e3));
  return normalised(
      fmt::format("{}{}{}{}", to_text(*name.shape), name.cold ? "-c" : "", fmt::join(texts, "x"), name.standard));
}

/// Names of the sections of the shape asked for whose sizes are nearest.
std::vector<std::string> nearest_sections(const SectionName& name, const std::vector<SectionRow>& table) {
  if (name.sizes.size() < 2) return {};
  const double height = *std::max_element(name.sizes.begin(), name.sizes.end() - 1);
  const double width = *std::min_element(name.sizes.begin(), name.sizes.end() - 1);
  std::vector<std::pair<double, std::string>> ranking;
  for (const SectionRow& row : table) {
    if (name.shape && *name.shape != row.shape) continue;
    if (name.cold && row.forming != Forming::cold) continue;
    if (!normalised(row.standard).starts_with(name.standard)) continue;
    const double off = std::abs(row.height - height) + std::abs(row.width - width);
    ranking.emplace_back(off + std::abs(row.thickness - name.sizes.back()), row.name);
  }
  std::stable_sort(ranking.begin(), ranking.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> out;
  for (std::size_t i = 0; i < std::min(suggested, ranking.size()); ++i) out.push_back(ranking[i].second);
  return out;
}

}  // namespace

bool matches(const SectionRow& row, const SectionFilter& filter) {
  if (filter.shape && *filter.shape != row.shape) return false;
  if (filter.forming && *filter.forming != row.forming) return false;
  if (!filter.standard.empty() && !normalised(row.standard).starts_with(normalised(filter.standard))) return false;
  if (filter.min_area && row.area < *filter.min_area) return false;
  if (filter.min_I_y && row.I_y < *filter.min_I_y) return false;
  if (filter.min_W_el_y && row.W_el_y < *filter.min_W_el_y) return false;
  if (filter.min_W_pl_y && row.W_pl_y < *filter.min_W_pl_y) return false;
  if (filter.min_thickness && row.thickness < *filter.min_thickness - same_size) return false;
  if (filter.min_height && row.height < *filter.min_height - same_size) return false;
  if (filter.max_height && row.height > *filter.max_height + same_size) return false;
  return at_least(row.trust, filter.min_trust);
}

std::vector<SectionRow> select_sections(const SectionFilter& filter, const std::vector<SectionRow>& table) {
  std::vector<SectionRow> out;
  std::copy_if(table.begin(), table.end(), std::back_inserter(out),
               [&](const SectionRow& row) { return matches(row, filter); });
  return out;
}

std::vector<SectionRow> sections_by_mass(const SectionFilter& filter, const std::vector<SectionRow>& table) {
  std::vector<SectionRow> out = select_sections(filter, table);
  std::sort(out.begin(), out.end(), [](const SectionRow& a, const SectionRow& b) {
    return std::tie(a.mass_per_length, a.height, a.trust, a.name) <
           std::tie(b.mass_per_length, b.height, b.trust, b.name);
  });
  return out;
}

Found<SectionRow> find_section(std::string_view name, const std::vector<SectionRow>& table) {
  const std::string wanted = normalised(name);
  for (const SectionRow& row : table) {
    if (is_named(row.name, wanted)) return row;
  }
  const auto parts = parse_section_name(wanted);
  if (!parts || parts->sizes.size() < 2 || parts->sizes.size() > 3) {
    return failure(fmt::format("no section {}; write it as CHS 508x16, SHS 100x100x5 or RHS 200x100x8 (millimetres)",
                               in_quotes(name)),
                   {});
  }
  const std::string proper = table_name(*parts);
  std::vector<const SectionRow*> found;
  for (const SectionRow& row : table) {
    if (is_named(row.name, proper)) return row;
    if (means(*parts, row)) found.push_back(&row);
  }
  if (found.size() == 1) return *found.front();
  if (found.empty()) return failure(fmt::format("no section {}", in_quotes(name)), nearest_sections(*parts, table));
  std::vector<std::string> names;
  names.reserve(found.size());
  for (const SectionRow* row : found) names.push_back(row->name);
  const std::string message = fmt::format("{} may be any of {} sections", in_quotes(name), names.size());
  return failure(message, std::move(names));
}

}  // namespace taut::catalogue
