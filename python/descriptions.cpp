#include "python/descriptions.hpp"

#include <pybind11/stl.h>

#include <map>
#include <vector>

#include "taut/app/explain/keys.hpp"
#include "taut/app/machine_deck.hpp"
#include "taut/app/method_deck.hpp"
#include "taut/app/methods.hpp"

namespace taut::python {
namespace {

namespace py = pybind11;

const char* text_of(FieldKind kind) {
  switch (kind) {
    case FieldKind::number:
      return "number";
    case FieldKind::numbers:
      return "numbers";
    case FieldKind::whole_number:
      return "whole_number";
    case FieldKind::flag:
      return "flag";
    case FieldKind::text:
      return "text";
    case FieldKind::choice:
      return "choice";
    case FieldKind::record:
      return "record";
    case FieldKind::records:
      return "records";
    case FieldKind::triple:
      return "triple";
    case FieldKind::texts:
      return "texts";
    case FieldKind::named_records:
      return "named_records";
  }
  return "text";
}

/// Each description once, by its index.
class Tables {
 public:
  std::size_t index_of(const Description& d) {
    const auto known = index_.find(&d);
    if (known != index_.end()) return known->second;
    const std::size_t index = index_.size();
    index_.emplace(&d, index);
    all_.append(py::none());
    py::list fields;
    for (const Field& f : d.fields) fields.append(field_of(d, f));
    py::dict table;
    table["fields"] = fields;
    table["exactly_one"] = d.exactly_one;
    all_[index] = table;
    return index;
  }
  py::list all() const { return all_; }

 private:
  py::dict field_of(const Description& d, const Field& f) {
    py::dict field;
    field["key"] = f.key;
    field["kind"] = text_of(f.kind);
    field["symbol"] = f.symbol;
    field["unit"] = f.unit.symbol;
    field["shown"] = f.unit.shown;
    field["needs_text"] = f.unit.needs_text();
    field["quantity"] = f.unit.kind;
    field["words"] = f.words;
    field["full_words"] = app::full_words(f);
    field["source"] = f.source;
    field["range"] = range_text(f);
    field["required"] = f.required;
    field["default"] = app::default_of(d, f);
    field["choices"] = f.choices;
    field["shorthand"] = f.shorthand;
    field["one_for_all"] = f.one_for_all;
    field["rest"] = f.rest;
    field["record"] = f.record != nullptr ? py::object(py::int_(index_of(*f.record))) : py::none();
    return field;
  }

  std::map<const Description*, std::size_t> index_;
  py::list all_;
};

}  // namespace

py::dict descriptions() {
  Tables tables;
  py::dict all;
  all["machine"] = tables.index_of(app::MachineDeck::describe());
  all["blocks"] = tables.index_of(app::MethodBlocks::describe());
  py::list methods;
  for (const app::MethodEntry& m : app::methods()) {
    py::dict one;
    one["name"] = m.about->name;
    one["title"] = m.about->title;
    one["source"] = m.about->source;
    one["scope"] = m.about->scope;
    one["limits"] = m.about->limits;
    one["input"] = tables.index_of(*m.input);
    one["output"] = tables.index_of(*m.output);
    one["exact"] = m.exact != nullptr ? py::object(py::int_(tables.index_of(*m.exact))) : py::none();
    methods.append(one);
  }
  all["methods"] = methods;
  all["tables"] = tables.all();
  return all;
}

}  // namespace taut::python
