#include "taut/app/design/design_method.hpp"

#include <cmath>
#include <utility>

#include "taut/design/design_checks.hpp"
#include "taut/io/deck/read.hpp"

namespace taut::app {
namespace {

constexpr const char* the_mast = "mast";  // of a method that has one section

double tension_of(const MethodCopy& copy, const Result& r, const std::optional<std::string>& of) {
  double most = std::nan("");
  if (!copy.tensions || r.status != Status::ok) return most;
  for (const auto& [name, tension] : copy.tensions(r)) {
    if (!of || *of == name) most = std::fmax(most, tension);
  }
  return most;
}

}  // namespace

design::DesignSpace method_space(const io::Node& block, const design::DesignRequest& design, const MethodCopy& copy,
                                 Diagnostics& mistakes) {
  DesignParts parts;
  parts.owner = "the method";
  parts.tensions = copy.ropes;
  if (copy.put_rope) parts.ropes = copy.ropes;
  if (copy.put_section) parts.sections.push_back({the_mast, {}, copy.refused});
  if (copy.checks != nullptr) add_masts(copy.checks->masts, parts.sections);
  parts.parameter = copy.parameter;
  if (!design.ropes.empty() && !copy.refused.empty()) {
    io::place(block, {{.path = "design.ropes", .message = copy.refused}}, mistakes);
  }
  return design_space(block, design, parts, mistakes);
}

void put_design(MethodCopy& copy, const design::DesignSpace& space, const design::DesignPlace& place,
                const design::DesignCase* load_case) {
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const design::RopeCandidates& free = space.ropes[k];
    copy.put_rope(free.name, free.rows[place.choice[k]], free.modulus);
  }
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    const catalogue::SectionRow& row = space.sections[k].rows[place.choice[space.ropes.size() + k]];
    if (copy.put_section && space.sections[k].name == the_mast) copy.put_section(row.name);
  }
  if (copy.checks != nullptr) put_masts(space, place.choice, copy.checks->masts);
  // behind the ropes: a weight or stiffness that is free goes before that of the rope
  put_values(space, place.values, copy.parameter);
  if (load_case != nullptr) put_case(*load_case, copy.parameter);
}

design::DesignTask method_task(const design::DesignRequest& design, design::DesignSpace space, CopyMethod copy,
                               std::function<bool(const Progress&)> progress) {
  design::DesignTask task;
  task.request = design;
  task.space = std::move(space);
  task.progress = std::move(progress);
  for (std::size_t k = 0; k < task.space.ropes.size(); ++k) task.list_of[task.space.ropes[k].name] = k;
  for (std::size_t k = 0; k < task.space.sections.size(); ++k) {
    const std::string& name = task.space.sections[k].name;
    // a method with one section checks it without naming a part
    task.list_of[name == the_mast && copy()->put_section ? std::string{} : name] = task.space.ropes.size() + k;
  }
  const auto own = std::make_shared<const design::DesignSpace>(task.space);
  task.lengths = [design, own, copy](const std::vector<double>& values) {
    design::DesignLengths lengths = by_the_metre(design, *own, values);
    if (design.seek == design::Seek::smallest) return lengths;
    const auto one = copy();
    design::DesignPlace place = design::first_place(*own);
    place.values = values;
    put_design(*one, *own, place);
    for (std::size_t k = 0; k < own->ropes.size(); ++k) {
      if (one->rope_length) lengths.ropes[k] = one->rope_length(own->ropes[k].name);
    }
    for (std::size_t k = 0; k < own->sections.size(); ++k) {
      const std::string& name = own->sections[k].name;
      if (one->height && name == the_mast) lengths.sections[k] = one->height();
      if (one->checks == nullptr) continue;
      if (const auto height = mast_height(one->checks->masts, name)) lengths.sections[k] = *height;
    }
    if (design.seek == design::Seek::lightest && one->mass) lengths.rest += one->mass();
    return lengths;
  };
  const auto first_case = std::make_shared<std::size_t>(0);
  task.run = [design, own, copy = std::move(copy), first_case](const design::DesignPlace& place, design::Depth depth,
                                                               const std::function<bool(const Progress&)>&) {
    const auto one = [&](const design::DesignCase* load_case, design::Depth) -> design::DesignRun {
      const auto fresh = copy();
      put_design(*fresh, *own, place, load_case);
      design::DesignRun done{.result = fresh->run(), .tension = 0};
      if (depth != design::Depth::report) design::disregard(design.disregard, done.result);
      done.tension = tension_of(*fresh, done.result, design.of);
      return done;
    };
    return run_cases(own->cases, depth, *first_case, one);
  };
  return task;
}

}  // namespace taut::app
