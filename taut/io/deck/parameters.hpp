#pragma once
#include <string>
#include <vector>

#include "taut/io/deck/document.hpp"

namespace taut::io {

/// Puts the values of `parameters:` into the deck. Below that key stand names with a quantity, a text or an expression;
/// any text of the deck that begins with '=' is an expression over them (expression.hpp) and is replaced by its value,
/// or by the text that its one name stands for. Parameters may use each other in any order.
/// Mistakes, each at its place: a name that is none (a unit's, with a blank), an unknown one (with did-you-mean), a
/// circle, what an expression's parts don't allow, a parameter of the deck itself or of `--set` that nothing uses (one
/// that an included deck defines may stay unused). The key itself stays where it is.
void resolve_parameters(Document& document, Diagnostics& mistakes);

/// Names below `parameters:` that no expression of the deck uses, nor another parameter; in their order. Wherever they
/// were defined: those of included decks too. The document is one whose parameters are not resolved.
std::vector<std::string> unused_parameters(Document document);

}  // namespace taut::io
