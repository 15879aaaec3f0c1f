#include "taut/io/deck/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <tuple>
#include <unordered_map>

#include "taut/base/suggest.hpp"
#include "taut/units/expression.hpp"

namespace taut::io {
namespace {

constexpr int deepest_use = 64;  ///< parameters that use one another in a row

bool is_expression(const Node& n) { return n.kind == Node::Kind::scalar && !n.text.empty() && n.text.front() == '='; }

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

class ParameterResolver {
 public:
  ParameterResolver(const Document& document, Diagnostics& mistakes) : document_(document), mistakes_(mistakes) {}

  void read(const Node& parameters) {
    if (parameters.kind != Node::Kind::map) {
      add(mistakes_, parameters.spot,
          fmt::format("parameters: a map of names and values is expected, such as '{{travel: 6 m}}', not {}",
                      kind_text(parameters)));
      return;
    }
    for (const Entry& e : parameters.entries) {
      if (enough(mistakes_)) return;
      names_.push_back(e.key);
      all_.emplace(e.key, Parameter{.entry = &e});
      if (!is_free_name(e.key)) {
        add(mistakes_, e.key_spot,
            fmt::format("parameters: {} can't be a name: letters, digits and _ without a digit first, and neither a "
                        "unit nor a function",
                        in_quotes(e.key)));
      } else if (e.value.kind != Node::Kind::scalar) {
        add(mistakes_, e.value.spot,
            fmt::format("parameters: {} is {}; a quantity, a text or an expression is expected", in_quotes(e.key),
                        kind_text(e.value)));
      }
    }
    for (const std::string& name : names_) value_of(name);
  }

  void resolve(Node& n) {
    if (enough(mistakes_)) return;
    for (Node& item : n.items) resolve(item);
    for (Entry& e : n.entries) resolve(e.value);
    if (!is_expression(n)) return;
    // a name alone stands for what the deck says of it, letter by letter: a text, "20 %", ".inf"
    if (Parameter* named = find(without_blanks(std::string_view(n.text).substr(1)));
        named != nullptr && is_said(*named)) {
      named->used = true;
      n.quoted = named->entry->value.quoted;
      n.literal = false;
      n.text = named->entry->value.text;
      return;
    }
    const auto value = measure(n);
    n.literal = false;
    if (value) n.text = to_text(*value);
    n.is_difference = value && value->kelvins == Kelvins::difference;
    if (value && n.text.empty()) add(mistakes_, n.spot, "this has a fraction of a dimension");
  }

  /// A deck that uses a parameter still does where `--set` takes the place of that use.
  void use_replaced(const Node& n) {
    for (const Node& item : n.items) use_replaced(item);
    for (const Entry& e : n.entries) use_replaced(e.value);
    if (!is_expression(n)) return;
    std::ignore = evaluate(std::string_view(n.text).substr(1), [this](std::string_view name) { return use(name); });
  }

  std::vector<std::string> unused() const {
    std::vector<std::string> names;
    std::copy_if(names_.begin(), names_.end(), std::back_inserter(names),
                 [&](const std::string& name) { return !all_.at(name).used; });
    return names;
  }

  void note_unused() {
    for (const std::string& name : unused()) {
      const Parameter& p = all_.at(name);
      const SourcePtr& from = p.entry->key_spot.source;
      const bool of_part = from && from != document_.source && from->name != "--set";
      if (of_part || enough(mistakes_)) continue;
      std::vector<std::string> others;
      std::copy_if(names_.begin(), names_.end(), std::back_inserter(others),
                   [&](const std::string& other) { return other != name; });
      add(mistakes_, p.entry->key_spot,
          fmt::format("parameters: nothing in the deck uses {}{}", in_quotes(name), did_you_mean(name, others)));
    }
  }

 private:
  struct Parameter {
    const Entry* entry = nullptr;
    bool used = false;
    enum class Now { unknown, under_way, done } now = Now::unknown;
    std::optional<Measure> value{};
    std::string why{};  ///< there is no value
  };

  Parameter* find(std::string_view name) {
    const auto found = all_.find(std::string(name));
    return found == all_.end() ? nullptr : &found->second;
  }

  static bool is_said(const Parameter& p) {
    return p.entry->value.kind == Node::Kind::scalar && !is_expression(p.entry->value);
  }

  std::optional<Measure> measure(const Node& n) {
    const auto result =
        evaluate(std::string_view(n.text).substr(1), [this](std::string_view name) { return use(name); });
    if (result) return *result;
    const UnitError& e = result.error();
    add(mistakes_, n.inside(static_cast<std::size_t>(e.offset) + 1, static_cast<std::size_t>(e.width)), e.message);
    return std::nullopt;
  }

  tl::expected<Measure, std::string> use(std::string_view name) {
    Parameter* p = find(name);
    if (p == nullptr) {
      const std::string hint = did_you_mean(name, names_);
      return tl::unexpected(fmt::format("there is no parameter {}{}", in_quotes(name),
                                        !hint.empty()    ? hint
                                        : names_.empty() ? std::string("; the deck has no 'parameters'")
                                                         : std::string()));
    }
    p->used = true;
    if (p->now == Parameter::Now::under_way) {
      return tl::unexpected(fmt::format("{} is used in its own value", in_quotes(name)));
    }
    value_of(std::string(name));
    if (p->value) return *p->value;
    return tl::unexpected(
        p->why.empty() ? fmt::format("{} is the text {}, no quantity", in_quotes(name), in_quotes(p->entry->value.text))
                       : p->why);
  }

  void value_of(const std::string& name) {
    Parameter& p = all_.at(name);
    if (p.now != Parameter::Now::unknown) return;
    const Node& n = p.entry->value;
    p.now = Parameter::Now::under_way;
    if (n.kind != Node::Kind::scalar) {
      p.why = fmt::format("{} has no value", in_quotes(name));
    } else if (!is_expression(n)) {
      if (const auto read = parse_any_quantity(n.text)) p.value = measure_of(*read);
    } else if (++depth_ > deepest_use) {
      p.why = fmt::format("more than {} parameters use one another", deepest_use);
    } else {
      p.value = measure(n);
      if (!p.value) p.why = fmt::format("{} has no value", in_quotes(name));
      --depth_;
    }
    p.now = Parameter::Now::done;
  }

  const Document& document_;
  Diagnostics& mistakes_;
  std::unordered_map<std::string, Parameter> all_;
  std::vector<std::string> names_;
  int depth_ = 0;
};

/// A copy, as the deck changes while its parameters are read; null where it has none.
Node parameters_of(const Document& document) {
  const Node* found = document.root.find("parameters");
  return found == nullptr ? Node{} : *found;
}

/// Puts the values of the parameters into the deck.
ParameterResolver resolved(Document& document, const Node& parameters, Diagnostics& mistakes) {
  ParameterResolver resolver(document, mistakes);
  if (document.root.find("parameters") != nullptr) resolver.read(parameters);
  for (Entry& e : document.root.entries) {
    if (e.key != "parameters" && e.key != "title" && e.key != "include") resolver.resolve(e.value);
  }
  return resolver;
}

}  // namespace

void resolve_parameters(Document& document, Diagnostics& mistakes) {
  if (document.root.kind != Node::Kind::map) return;
  const Node parameters = parameters_of(document);
  ParameterResolver resolver = resolved(document, parameters, mistakes);
  for (const Node& n : document.replaced) resolver.use_replaced(n);
  resolver.note_unused();
}

std::vector<std::string> unused_parameters(Document document) {
  if (document.root.kind != Node::Kind::map) return {};
  Diagnostics mistakes;  // not told here: whoever reads the deck tells them
  const Node parameters = parameters_of(document);
  return resolved(document, parameters, mistakes).unused();
}

}  // namespace taut::io
