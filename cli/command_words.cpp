#include "cli/command_words.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "cli/completion.hpp"
#include "taut/app/explain/explain_machine.hpp"
#include "taut/app/explain/listing.hpp"
#include "taut/app/explain/starters.hpp"
#include "taut/app/methods.hpp"
#include "taut/catalogue/rope.hpp"

namespace taut::cli {
namespace {

using Names = std::vector<std::string>;

Names starter_choices() {
  Names names = app::method_names();
  const Names machines = app::starter_names();
  names.insert(names.end(), machines.begin(), machines.end());
  return names;
}

Names topic_choices() {
  Names names = app::method_names();
  const Names topics = app::machine_topics();
  names.insert(names.end(), topics.begin(), topics.end());
  return names;
}

Names construction_choices() {
  std::set<std::string> names;
  for (const auto& row : catalogue::ropes()) names.insert(row.construction);
  return {names.begin(), names.end()};
}

/// The list of CLI::IsMember in the name of a type, as "PAPER:{a4,a3}".
Names members_in(const std::string& type) {
  const std::size_t from = type.find('{');
  const std::size_t to = type.find('}', from);
  if (from == std::string::npos || to == std::string::npos) return {};
  return CLI::detail::split(type.substr(from + 1, to - from - 1), ',');
}

OptionWords option_words(const CLI::Option& option) {
  OptionWords found;
  for (const std::string& name : option.get_snames()) found.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) found.names.push_back("--" + name);
  found.words = option.get_description();
  found.required = option.get_required();
  const bool flag = option.get_items_expected_max() == 0;
  if (flag) return found;
  const std::string type = option.get_type_name();
  found.value = type.substr(0, type.find(':'));
  found.repeated = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll && !option.get_positional();
  const Names members = members_in(type);
  found.choices = members.empty() ? choices_of(found.value) : Choices{.kind = Choices::Kind::names, .names = members};
  return found;
}

/// The options of a command line, and its operands.
void add_options(const CLI::App& app, std::vector<OptionWords>& options, std::vector<OptionWords>& operands) {
  for (const CLI::Option* option : app.get_options()) {
    OptionWords words = option_words(*option);
    if (option->get_positional()) {
      operands.push_back(std::move(words));
    } else {
      options.push_back(std::move(words));
    }
  }
}

}  // namespace

Choices choices_of(const std::string& value) {
  using Kind = Choices::Kind;
  static const std::map<std::string, std::function<Names()>> known = {
      {"STARTER", starter_choices},
      {"TOPIC", topic_choices},
      {"LIST", app::list_names},
      {"SHELL", shells},
      {"FORMAT", [] { return Names{"vtk"}; }},
      {"CONSTRUCTION", construction_choices},
      {"CORE",
       [] {
         return Names{"FC", "IWRC", "WSC"};
       }},
      {"SHAPE",
       [] {
         return Names{"CHS", "SHS", "RHS"};
       }},
      {"FORMING",
       [] {
         return Names{"hot", "cold", "seamless", "welded"};
       }},
  };
  if (value == "DECK" || value == "SET") return {.kind = Kind::deck, .names = {}};
  if (value == "DIR") return {.kind = Kind::folder, .names = {}};
  const auto at = known.find(value);
  if (at == known.end()) return {};
  return {.kind = Kind::names, .names = at->second()};
}

CommandWords words_of(const CLI::App& app) {
  CommandWords all{.name = app.get_name(), .words = app.get_description(), .options = {}, .verbs = {}};
  std::vector<OptionWords> none;
  add_options(app, all.options, none);
  for (const CLI::App* verb : app.get_subcommands({})) {
    VerbWords& words = all.verbs.emplace_back();
    words.name = verb->get_name();
    words.words = verb->get_description();
    add_options(*verb, words.options, words.operands);
  }
  Names verbs;
  for (const VerbWords& verb : all.verbs) verbs.push_back(verb.name);
  for (VerbWords& verb : all.verbs) {
    for (OptionWords& operand : verb.operands) {
      if (operand.value == "VERB") operand.choices = {.kind = Choices::Kind::names, .names = verbs};
    }
  }
  return all;
}

}  // namespace taut::cli
