#include "taut/app/explain/schema.hpp"

#include "taut/app/machine_deck.hpp"
#include "taut/app/methods.hpp"
#include "taut/io/deck/schema.hpp"

namespace taut::app {

std::string schema_text() {
  std::vector<io::SchemaMethod> all;
  for (const MethodEntry& m : methods()) all.push_back({m.about->name, m.about->title, m.input});
  return io::deck_schema(all, &MachineDeck::describe());
}

}  // namespace taut::app
