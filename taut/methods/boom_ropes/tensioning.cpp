#include "taut/methods/boom_ropes/boom_ropes.hpp"

namespace taut::boom_ropes {
namespace {

struct Pair {
  double S10 = 0;
  double S20 = 0;
};

void pull(Rope rope, double friction, Pair& p) {
  if (rope == Rope::extension) {
    p.S10 = (p.S20 + friction) / 2;
  } else {
    p.S20 = 2 * p.S10 + friction;
  }
}

}  // namespace

std::vector<TensioningStep> tensioning(double friction, int steps) {
  std::vector<TensioningStep> rows;
  Pair extension_first;
  Pair retraction_first;
  for (int i = 0; i < steps; ++i) {
    pull(i % 2 == 0 ? Rope::extension : Rope::retraction, friction, extension_first);
    pull(i % 2 == 0 ? Rope::retraction : Rope::extension, friction, retraction_first);
    rows.push_back({extension_first.S10, extension_first.S20, retraction_first.S10, retraction_first.S20});
  }
  return rows;
}

}  // namespace taut::boom_ropes
