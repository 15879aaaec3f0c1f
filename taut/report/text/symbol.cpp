#include "taut/report/text/symbol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 37> greek{{
    {"alpha", "α"},      {"beta", "β"},    {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"}, {"eps", "ε"},
    {"zeta", "ζ"},       {"eta", "η"},     {"theta", "θ"}, {"iota", "ι"},   {"kappa", "κ"},   {"lambda", "λ"},
    {"mu", "μ"},         {"nu", "ν"},      {"xi", "ξ"},    {"pi", "π"},     {"rho", "ρ"},     {"sigma", "σ"},
    {"tau", "τ"},        {"upsilon", "υ"}, {"phi", "φ"},   {"chi", "χ"},    {"psi", "ψ"},     {"omega", "ω"},
    {"Gamma", "Γ"},      {"Delta", "Δ"},   {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Xi", "Ξ"},      {"Pi", "Π"},
    {"Sigma", "Σ"},      {"Phi", "Φ"},     {"Psi", "Ψ"},   {"Omega", "Ω"},  {"varphi", "φ"},  {"vartheta", "ϑ"},
    {"varepsilon", "ε"},
}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_high(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// Letters, then digits: "S1" -> {"S", "1"}. Anything else stays in one piece.
std::pair<std::string_view, std::string_view> split_digits(std::string_view s) {
  std::size_t n = s.size();
  while (n > 0 && is_digit(s[n - 1])) --n;
  if (n == 0 || n == s.size()) return {s, {}};
  return {s.substr(0, n), s.substr(n)};
}

std::string letter_or_self(std::string_view name) {
  const std::string_view g = greek_letter(name);
  return std::string(g.empty() ? name : g);
}

/// Names short enough to be letters of a formula: "T", "EA", "φ" itself, or a Greek name.
bool is_letters(std::string_view base) {
  if (!greek_letter(base).empty()) return true;
  if (base.empty()) return false;
  if (std::all_of(base.begin(), base.end(), is_high)) return length(base) == 1;
  if (!std::all_of(base.begin(), base.end(), is_letter)) return false;
  return base.size() == 1 || (base.size() == 2 && std::isupper(static_cast<unsigned char>(base[0])) != 0);
}

std::vector<std::string_view> split_at_underscores(std::string_view s) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = s.find('_');
    parts.push_back(s.substr(0, at));
    if (at == std::string_view::npos) return parts;
    s.remove_prefix(at + 1);
  }
}

bool is_word_char(char c) { return is_letter(c) || is_digit(c) || c == '_' || is_high(c); }

std::string join(const std::vector<std::string>& parts) {
  std::string all;
  for (const std::string& p : parts) {
    if (!all.empty()) all += ",";
    all += p;
  }
  return all;
}

/// One letter of a subscript is a variable (T_s), a word is not (T_max).
bool is_variable(std::string_view shown) { return length(shown) == 1 && !is_digit(shown[0]); }

std::string identifier(std::string_view shown) {
  if (!shown.empty() && std::all_of(shown.begin(), shown.end(), is_digit)) return fmt::format("<mn>{}</mn>", shown);
  return fmt::format("<mi>{}</mi>", escape(shown));
}

std::string base_mathml(const Symbol& s) {
  // Two letters (EA, Fh) are each a letter; a word stays upright, as MathML does by itself.
  const bool two = !s.is_word && length(s.base) == 2 && s.base.size() == 2;
  return two ? fmt::format("<mrow><mi>{}</mi><mi>{}</mi></mrow>", s.base[0], s.base[1]) : identifier(s.base);
}

}  // namespace

std::string_view greek_letter(std::string_view name) {
  const auto* at = std::find_if(greek.begin(), greek.end(), [&](const auto& g) { return g.first == name; });
  return at == greek.end() ? std::string_view{} : at->second;
}

Symbol split_symbol(std::string_view name) {
  Symbol s;
  if (name.size() > 2 && name.front() == '[' && name.back() == ']') {
    s = split_symbol(name.substr(1, name.size() - 2));
    s.bracketed = true;
    return s;
  }
  while (name.size() > 1 && (name.back() == '\'' || name.back() == '*')) {
    s.after.insert(0, name.back() == '*' ? "*" : "′");
    name.remove_suffix(1);
  }
  const auto parts = split_at_underscores(name);
  const auto [letters, digits] = split_digits(parts[0]);
  const bool empty_part = std::any_of(parts.begin(), parts.end(), [](auto p) { return p.empty(); });
  const bool one_word = std::all_of(name.begin(), name.end(), is_word_char);
  if (empty_part || !one_word || !is_letters(letters)) {
    s.base = clean(name);
    s.is_word = true;
    return s;
  }
  s.base = letter_or_self(letters);
  if (!digits.empty()) s.subscripts.emplace_back(digits);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto [sub, number] = split_digits(parts[i]);
    s.subscripts.push_back(
        clean(greek_letter(sub).empty() ? std::string(parts[i]) : letter_or_self(sub) + std::string(number)));
  }
  return s;
}

bool looks_like_symbol(std::string_view word) {
  if (!greek_letter(word).empty()) return true;
  const auto parts = split_at_underscores(word);
  const auto [letters, digits] = split_digits(parts[0]);
  if (!is_letters(letters)) return false;
  if (parts.size() == 1) return !greek_letter(letters).empty();
  return std::none_of(parts.begin(), parts.end(), [](auto p) { return p.empty(); });
}

Runs symbol_runs(std::string_view symbol) {
  const Symbol s = split_symbol(symbol);
  Runs runs;
  if (s.bracketed) runs.push_back({"[", Run::Style::plain});
  runs.push_back({s.base, s.is_word ? Run::Style::plain : Run::Style::variable});
  if (!s.after.empty()) runs.push_back({s.after, Run::Style::plain});
  if (!s.subscripts.empty()) {
    const std::string all = join(s.subscripts);
    runs.push_back({all, is_variable(all) ? Run::Style::subscript_variable : Run::Style::subscript});
  }
  if (s.bracketed) runs.push_back({"]", Run::Style::plain});
  return runs;
}

Runs prose_runs(std::string_view text) {
  const std::string clean_text = clean(text);
  const std::string_view t = clean_text;
  Runs runs;
  std::string plain;
  for (std::size_t i = 0; i < t.size();) {
    std::size_t end = i;
    while (end < t.size() && is_word_char(t[end])) ++end;
    if (end == i) {
      plain += t[i++];
      continue;
    }
    const std::string_view word = t.substr(i, end - i);
    if (looks_like_symbol(word)) {
      if (!plain.empty()) runs.push_back({std::exchange(plain, {}), Run::Style::plain});
      for (Run& r : symbol_runs(word)) runs.push_back(std::move(r));
    } else {
      plain += word;
    }
    i = end;
  }
  if (!plain.empty()) runs.push_back({std::move(plain), Run::Style::plain});
  return runs;
}

Runs label_runs(std::string_view text) {
  const std::size_t end = std::min(text.find(" = "), text.size());
  const std::string_view head = text.substr(0, end);
  const bool one_name = !head.empty() && !split_symbol(head).is_word;
  if (!one_name) return prose_runs(text);
  Runs runs = symbol_runs(head);
  for (Run& r : prose_runs(text.substr(end))) runs.push_back(std::move(r));
  return runs;
}

std::string symbol_mathml(std::string_view symbol) {
  const Symbol s = split_symbol(symbol);
  std::string base = base_mathml(s);
  std::string sub;
  for (std::size_t i = 0; i < s.subscripts.size(); ++i) {
    if (i > 0) sub += "<mo separator=\"true\">,</mo>";
    sub += identifier(s.subscripts[i]);
  }
  if (s.subscripts.size() > 1) sub = fmt::format("<mrow>{}</mrow>", sub);
  const std::string sup = s.after.empty() ? "" : fmt::format("<mo>{}</mo>", s.after);
  if (!sub.empty() && !sup.empty()) {
    base = fmt::format("<msubsup>{}{}{}</msubsup>", base, sub, sup);
  } else if (!sub.empty()) {
    base = fmt::format("<msub>{}{}</msub>", base, sub);
  } else if (!sup.empty()) {
    base = fmt::format("<msup>{}{}</msup>", base, sup);
  }
  return s.bracketed
             ? fmt::format(
                   "<mrow><mo stretchy=\"false\" lspace=\"0\" rspace=\"0\">[</mo>{}<mo stretchy=\"false\" lspace=\"0\" "
                   "rspace=\"0\">]</mo></mrow>",
                   base)
             : base;
}

std::string symbol_html(std::string_view symbol) {
  if (symbol.empty()) return {};
  if (split_symbol(symbol).is_word) return fmt::format("<span class=\"word\">{}</span>", escape(symbol));
  return fmt::format("<math>{}</math>", symbol_mathml(symbol));
}

std::string to_html(const Runs& runs) {
  std::string out;
  for (const Run& r : runs) {
    const std::string text = escape(r.text);
    switch (r.style) {
      case Run::Style::plain:
        out += text;
        break;
      case Run::Style::variable:
        out += fmt::format("<i>{}</i>", text);
        break;
      case Run::Style::subscript:
        out += fmt::format("<sub>{}</sub>", text);
        break;
      case Run::Style::subscript_variable:
        out += fmt::format("<sub><i>{}</i></sub>", text);
        break;
    }
  }
  return out;
}

std::string to_svg(const Runs& runs) {
  std::string out;
  bool lowered = false;
  for (const Run& r : runs) {
    const bool sub = r.style == Run::Style::subscript || r.style == Run::Style::subscript_variable;
    const bool variable = r.style == Run::Style::variable || r.style == Run::Style::subscript_variable;
    const std::string shift = sub == lowered ? "" : sub ? " dy=\".28em\"" : " dy=\"-.2em\"";
    const char* kind = sub ? (variable ? "sv" : "s") : (variable ? "v" : "t");
    out += fmt::format("<tspan class=\"{}\"{}>{}</tspan>", kind, shift, escape(r.text));
    lowered = sub;
  }
  return out;
}

std::string prose_html(std::string_view text) { return to_html(prose_runs(text)); }

}  // namespace taut::report
