#include "cli/completion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace taut::cli {
namespace {

using Kind = Choices::Kind;

bool takes_value(const OptionWords& option) { return !option.value.empty(); }

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

std::vector<std::string> option_names(const std::vector<OptionWords>& options) {
  std::vector<std::string> all;
  for (const OptionWords& o : options) all.insert(all.end(), o.names.begin(), o.names.end());
  return all;
}

std::vector<std::string> verb_names(const CommandWords& command) {
  std::vector<std::string> all;
  for (const VerbWords& v : command.verbs) all.push_back(v.name);
  return all;
}

/// Text in single quotes for a shell; `quote`: how a single quote inside is written.
std::string quoted(const std::string& text, const char* quote, const char* backslash) {
  std::string all = "'";
  for (const char c : text) {
    if (c == '\'') {
      all += quote;
    } else if (c == '\\') {
      all += backslash;
    } else {
      all += c;
    }
  }
  return all + "'";
}

/// Names that bash and fish offer as one word each. They would split others at their blanks and expand what they
/// contain.
std::vector<std::string> plain(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names) {
    const bool as_is = std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || std::string_view("_-+.,/@%").find(static_cast<char>(c)) != std::string_view::npos;
    });
    if (as_is) all.push_back(name);
  }
  return all;
}

// ---- bash

/// For bash and POSIX shells.
std::string sh_quoted(const std::string& text) { return quoted(text, "'\\''", "\\"); }

/// The command that fills COMPREPLY; empty where nothing can be offered.
std::string bash_offer(const Choices& choices) {
  switch (choices.kind) {
    case Kind::deck:
      return "_taut_decks";
    case Kind::folder:
      return "_taut_folders";
    case Kind::names:
      return fmt::format("words={}", sh_quoted(joined(plain(choices.names))));
    case Kind::anything:
      break;
  }
  return {};
}

/// The lines "'run -o' | 'run --output')  OFFER ;;" of all places of a verb that take a value.
std::string bash_places(const VerbWords& verb) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& places, const Choices& choices) {
    const std::string offer = bash_offer(choices);
    if (offer.empty()) return;
    std::vector<std::string> patterns;
    for (const std::string& place : places) patterns.push_back(fmt::format("'{} {}'", verb.name, place));
    text += fmt::format("    {}) {} ;;\n", fmt::join(patterns, " | "), offer);
  };
  for (const OptionWords& o : verb.options) {
    if (takes_value(o)) add(o.names, o.choices);
  }
  for (std::size_t i = 0; i < verb.operands.size(); ++i) add({fmt::format("{}", i)}, verb.operands[i].choices);
  return text;
}

constexpr const char* bash_head = R"(# bash completion of taut: verbs, options, decks, folders and names.
# Made by 'taut completion bash'. Try it: source <(taut completion bash)

_taut_decks() {
  compopt -o filenames -o default 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -f -X '!*.yaml' -- "$cur"; compgen -f -X '!*.yml' -- "$cur"; compgen -d -- "$cur")
}

_taut_folders() {
  compopt -o filenames -o default 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$cur")
}

_taut() {
  local cur=${COMP_WORDS[COMP_CWORD]} verb=${COMP_WORDS[1]} words='' valued='' options='' wanted='' place=0 word i
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
)";

constexpr const char* bash_walk =
    R"(  # What stands at the cursor: the value of an option (wanted), or the operand of that place. bash splits at '='.
  for ((i = 2; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ $word == '=' ]]; then
      [[ -n $wanted ]] || wanted='='
    elif [[ -n $wanted ]]; then
      wanted=''
    elif [[ " $valued " == *" $word "* ]]; then
      wanted=$word
    elif [[ $word != -?* ]]; then
      place=$((place + 1))
    fi
  done
  [[ $cur == '=' ]] && cur=''
  if [[ -z $wanted && $cur == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
    return
  fi
  case "$verb ${wanted:-$place}" in
)";

constexpr const char* bash_end = R"(  esac
  [[ -z $words ]] || mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
}
complete -F _taut taut
)";

std::string bash_script(const CommandWords& command) {
  std::string text = bash_head;
  text += fmt::format("    mapfile -t COMPREPLY < <(compgen -W {} -- \"$cur\")\n    return\n  fi\n  case $verb in\n",
                      sh_quoted(joined(verb_names(command)) + " " + joined(option_names(command.options))));
  for (const VerbWords& verb : command.verbs) {
    std::vector<std::string> valued;
    for (const OptionWords& o : verb.options) {
      if (takes_value(o)) valued.insert(valued.end(), o.names.begin(), o.names.end());
    }
    text += fmt::format("    {})\n      options={}\n      valued={}\n      ;;\n", verb.name,
                        sh_quoted(joined(option_names(verb.options))), sh_quoted(joined(valued)));
  }
  text += "    *) return ;;\n  esac\n";
  text += bash_walk;
  for (const VerbWords& verb : command.verbs) text += bash_places(verb);
  return text + bash_end;
}

// ---- zsh

/// A part of a specification of _arguments or _describe: what separates its fields stands behind a backslash.
std::string zsh_field(const std::string& text, std::string_view separators) {
  std::string all;
  for (const char c : text) {
    if (c == '\\' || separators.find(c) != std::string_view::npos) all += '\\';
    all += c;
  }
  return all;
}

std::string zsh_action(const Choices& choices) {
  switch (choices.kind) {
    case Kind::deck:
      return "_files -g \"*.(yaml|yml)\"";
    case Kind::folder:
      return "_files -/";
    case Kind::names: {
      std::string all = "(";
      for (const std::string& name : choices.names) all += zsh_field(name, " ()|:;<>&$`\"'*?[]{}~#") + " ";
      all.back() = ')';
      return all;
    }
    case Kind::anything:
      break;
  }
  return " ";
}

/// "'(-o --output)'{-o,--output}'[words]:DIR:_files -/'": one option as _arguments takes it.
std::string zsh_option(const OptionWords& o) {
  std::string rest = fmt::format("[{}]", zsh_field(o.words, "[]:"));
  if (takes_value(o)) rest += fmt::format(":{}:{}", zsh_field(o.value, ":"), zsh_action(o.choices));
  std::vector<std::string> names;
  for (const std::string& name : o.names) {
    const bool joins = takes_value(o) && name.starts_with("--");
    names.push_back(joins ? name + "=" : name);
  }
  std::string before = "'*'";
  if (!o.repeated) before = names.size() > 1 ? sh_quoted("(" + joined(o.names) + ")") : std::string();
  const std::string spelled =
      names.size() > 1 ? fmt::format("{{{}}}", fmt::join(names, ",")) : sh_quoted(names.front());
  return before + spelled + sh_quoted(rest);
}

std::string zsh_script(const CommandWords& command) {
  std::string text =
      "#compdef taut\n"
      "# zsh completion of taut: verbs, options, decks, folders and names.\n"
      "# Made by 'taut completion zsh'. Try it: source <(taut completion zsh)\n\n"
      "_taut() {\n"
      "  local curcontext=$curcontext state line\n"
      "  typeset -A opt_args\n"
      "  local -a verbs=(\n";
  for (const VerbWords& verb : command.verbs) {
    text += fmt::format("    {}\n", sh_quoted(zsh_field(verb.name, ":") + ":" + verb.words));
  }
  text += "  )\n  _arguments -C \\\n";
  for (const OptionWords& o : command.options) text += fmt::format("    {} \\\n", zsh_option(o));
  text +=
      "    '1:verb:->verb' '*::operand:->operands'\n"
      "  case $state in\n"
      "    verb) _describe -t verbs verb verbs ;;\n"
      "    operands)\n"
      "      case $words[1] in\n";
  for (const VerbWords& verb : command.verbs) {
    std::vector<std::string> specs;
    for (const OptionWords& o : verb.options) specs.push_back(zsh_option(o));
    for (std::size_t i = 0; i < verb.operands.size(); ++i) {
      const OptionWords& o = verb.operands[i];
      specs.push_back(sh_quoted(fmt::format("{}:{}:{}", i + 1, zsh_field(o.value, ":"), zsh_action(o.choices))));
    }
    text += fmt::format("        {})\n          _arguments \\\n            {}\n          ;;\n", verb.name,
                        fmt::join(specs, " \\\n            "));
  }
  return text +
         "      esac\n"
         "      ;;\n"
         "  esac\n"
         "}\n\n"
         "if [[ $funcstack[1] == _taut ]]; then\n"
         "  _taut \"$@\"\n"
         "elif (( $+functions[compdef] )); then\n"
         "  compdef _taut taut\n"
         "fi\n";
}

// ---- fish

std::string fish_quoted(const std::string& text) { return quoted(text, "\\'", "\\\\"); }

/// The part of a `complete` command that says what the value can be.
std::string fish_values(const Choices& choices) {
  switch (choices.kind) {
    case Kind::deck:
      return " -k -a '(__fish_complete_suffix .yaml)'";
    case Kind::folder:
      return " -a '(__fish_complete_directories (commandline -ct))'";
    case Kind::names:
      return " -a " + fish_quoted(joined(choices.names));
    case Kind::anything:
      break;
  }
  return {};
}

std::string fish_option(const OptionWords& o) {
  std::string text;
  for (const std::string& name : o.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (takes_value(o)) text += " -x" + fish_values(o.choices);
  return text + " -d " + fish_quoted(o.words);
}

std::string fish_script(const CommandWords& command) {
  std::string text =
      "# fish completion of taut: verbs, options, decks, folders and names.\n"
      "# Made by 'taut completion fish'. Try it: taut completion fish | source\n\n"
      "complete -c taut -f\n";
  for (const OptionWords& o : command.options) {
    text += fmt::format("complete -c taut -n __fish_use_subcommand{}\n", fish_option(o));
  }
  for (const VerbWords& verb : command.verbs) {
    text += fmt::format("complete -c taut -n __fish_use_subcommand -a {} -d {}\n", verb.name, fish_quoted(verb.words));
  }
  for (const VerbWords& verb : command.verbs) {
    const std::string seen = fmt::format("complete -c taut -n '__fish_seen_subcommand_from {}'", verb.name);
    text += "\n";
    for (const OptionWords& o : verb.operands) {
      if (const std::string values = fish_values(o.choices); !values.empty()) text += seen + values + "\n";
    }
    for (const OptionWords& o : verb.options) text += seen + fish_option(o) + "\n";
  }
  return text;
}

}  // namespace

std::vector<std::string> shells() { return {"bash", "fish", "zsh"}; }

std::string completion_script(const CommandWords& command, const std::string& shell) {
  if (shell == "bash") return bash_script(command);
  if (shell == "fish") return fish_script(command);
  if (shell == "zsh") return zsh_script(command);
  return {};
}

}  // namespace taut::cli
