#include "taut/app/methods.hpp"

#include <algorithm>

#include "taut/app/design/method_parts.hpp"
#include "taut/app/embedded/examples.hpp"
#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/app/exact/friction_drive_exact.hpp"
#include "taut/app/exact/mast_section_exact.hpp"
#include "taut/app/method_checks.hpp"
#include "taut/base/expects.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/tables.hpp"
#include "taut/methods/closed_loop/tables.hpp"
#include "taut/methods/friction_drive/tables.hpp"
#include "taut/methods/mast_section/tables.hpp"

namespace taut::app {
namespace {

std::string_view example_of(const std::string& method) {
  for (const auto& [file, text] : embedded::examples) {
    if (file == method + ".yaml") return text;
  }
  expects(false, "no example for " + method);
  return {};
}

std::vector<TableWords> tables_of_mast() {
  std::vector<TableWords> all = mast_section::table_words();
  for (TableWords& one : mast_section_exact_words()) all.push_back(std::move(one));
  return all;
}

}  // namespace

const std::vector<MethodEntry>& methods() {
  static const std::vector<MethodEntry> all = {
      {
          .about = &mast_section::about(),
          .input_of_defaults = MethodInput::of<mast_section::Input>,
          .input = &mast_section::Input::describe(),
          .output = &mast_section::Output::describe(),
          .exact = &MastSectionExact::describe(),
          .tables = tables_of_mast(),
          .example = example_of("mast_section"),
          .complaints = on(mast_section::complaints),
          .run = on(run_mast_section),
          .answers = on(mast_section::answers),
          .ropes = on(ropes_of_mast),
          .design = design_of_mast(),
      },
      {
          .about = &closed_loop::about(),
          .input_of_defaults = MethodInput::of<closed_loop::Input>,
          .input = &closed_loop::Input::describe(),
          .output = &closed_loop::Output::describe(),
          .tables = closed_loop::table_words(),
          .example = example_of("closed_loop"),
          .complaints = on(closed_loop::complaints),
          .run = on(run_closed_loop),
          .answers = on(closed_loop::answers),
          .ropes = on(ropes_of_loop),
          .design = design_of_loop(),
      },
      {
          .about = &friction_drive::about(),
          .input_of_defaults = MethodInput::of<friction_drive::Input>,
          .input = &friction_drive::Input::describe(),
          .output = &friction_drive::Output::describe(),
          .exact = &FrictionDriveExact::describe(),
          .tables = friction_drive::table_words(),
          .example = example_of("friction_drive"),
          .complaints = on(friction_drive::complaints),
          .run = on(run_friction_drive),
          .answers = on(friction_drive::answers),
          .ropes = on(ropes_of_drive),
          .design = design_of_drive(),
      },
      {
          .about = &boom_ropes::about(),
          .input_of_defaults = MethodInput::of<boom_ropes::Input>,
          .input = &boom_ropes::Input::describe(),
          .output = &boom_ropes::Output::describe(),
          .tables = boom_ropes::table_words(),
          .example = example_of("boom_ropes"),
          .complaints = on(boom_ropes::complaints),
          .run = on<Result, boom_ropes::Input, const Display&>(boom_ropes::run),
          .answers = on(boom_ropes::answers),
          .ropes = on(ropes_of_boom),
          .design = design_of_boom(),
      },
  };
  return all;
}

const MethodEntry* find_method(std::string_view name) {
  const auto& all = methods();
  const auto at = std::find_if(all.begin(), all.end(), [&](const MethodEntry& e) { return e.about->name == name; });
  return at == all.end() ? nullptr : &*at;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodEntry& e : methods()) names.push_back(e.about->name);
  return names;
}

}  // namespace taut::app
