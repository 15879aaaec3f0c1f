#include "taut/io/deck/write.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace taut::io {
namespace {

/// In double quotes, with what YAML would take for something else escaped.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
      case '\\':
        out += '\\';
        out += c;
        break;
      case '\n':
        out += "\\n";
        break;
      case '\t':
        out += "\\t";
        break;
      case '\r':
        out += "\\r";
        break;
      default:
        out += c;
    }
  }
  return out + '"';
}

/// Whether a text can stand without quotes in a list on one line: the texts that quantities and names are made of.
bool is_plain(const std::string& text) {
  const auto harmless = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '.' ||
           c == '_' || c == '-' || c == '+' || c == '/' || c == '%' || c == '^' || c == '*';
  };
  const bool ends = !text.empty() && text.front() != ' ' && text.back() != ' ';
  const bool begins = ends && (text.front() != '-' || text.size() > 1) && text.front() != '*' && text.front() != '%';
  return begins && text.find("- ") != 0 && std::all_of(text.begin(), text.end(), harmless);
}

std::string scalar(const Node& n) {
  if (n.kind == Node::Kind::null) return "null";
  return !n.quoted && is_plain(n.text) ? n.text : n.quoted || !n.text.empty() ? quoted(n.text) : "\"\"";
}

std::string key_text(const std::string& key) {
  return is_plain(key) || key.find_first_of("\":#{}[],&*!|>'%@`\n") == std::string::npos ? key : quoted(key);
}

bool is_flat(const Node& n) {
  return std::all_of(n.items.begin(), n.items.end(), [](const Node& one) {
    return one.kind == Node::Kind::scalar || (one.kind == Node::Kind::sequence && is_flat(one));
  });
}

std::string one_line(const Node& n) {
  if (n.kind != Node::Kind::sequence) return scalar(n);
  std::string text = "[";
  for (std::size_t i = 0; i < n.items.size(); ++i) text += (i > 0 ? ", " : "") + one_line(n.items[i]);
  return text + "]";
}

void write(const Node& n, std::size_t indent, std::string& out);

/// Behind "key:" or "-": on the same line, or as a block below.
void write_value(const Node& n, std::size_t indent, std::string& out) {
  const bool block = (n.kind == Node::Kind::map && !n.entries.empty()) ||
                     (n.kind == Node::Kind::sequence && !n.items.empty() && !is_flat(n));
  if (block) {
    out += '\n';
    write(n, indent, out);
  } else if (n.kind == Node::Kind::map) {
    out += " {}\n";
  } else {
    out += fmt::format(" {}\n", one_line(n));
  }
}

void write(const Node& n, std::size_t indent, std::string& out) {
  const std::string margin(indent, ' ');
  if (n.kind == Node::Kind::map) {
    for (const Entry& e : n.entries) {
      out += margin + key_text(e.key) + ':';
      write_value(e.value, indent + 2, out);
    }
  } else if (n.kind == Node::Kind::sequence) {
    for (const Node& item : n.items) {
      if (item.kind == Node::Kind::map && !item.entries.empty()) {
        std::string map;
        write(item, indent + 2, map);
        out += margin + "- " + map.substr(indent + 2);
        continue;
      }
      out += margin + '-';
      write_value(item, indent + 2, out);
    }
  }
}

}  // namespace

std::string to_yaml(const Node& node) {
  if (node.kind != Node::Kind::map && (node.kind != Node::Kind::sequence || is_flat(node)))
    return one_line(node) + "\n";
  std::string out;
  write(node, 0, out);
  return out;
}

}  // namespace taut::io
