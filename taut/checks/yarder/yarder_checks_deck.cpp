#include "taut/checks/yarder/yarder_checks_deck.hpp"

namespace taut::checks {

const Description& YarderCheckRequest::describe() {
  using R = YarderCheckRequest;
  static const Description d =
      Describe<R>()
          .field(&R::yarder, "yarder", "the yarder by its name in the catalogue: taut list yarders")
          .required()
          .field(&R::catalogue, "catalogue", "a file of yarders (CSV) in place of the built-in ones, beside the deck")
          .field(&R::skyline, "skyline", "the reeving on its skyline drum")
          .field(&R::mainline, "mainline", "the reeving on its mainline drum")
          .field(&R::haulback, "haulback", "the reeving on its haulback drum")
          .field(&R::spare, "spare", "", si::m,
                 "length of each line that is not in use: wraps that stay on the drum, fastening at the other end")
          .at_least(0)
          .at_most(1000)
          .field(&R::lateral, "lateral", "", si::m,
                 "length of the mainline that is pulled out of the carriage to the side of the line")
          .at_least(0)
          .at_most(1000);
  return d;
}

std::vector<YarderLineRequest> lines_of(const YarderCheckRequest& request) {
  std::vector<YarderLineRequest> all;
  const auto add = [&](const char* line, const std::optional<std::string>& reeving) {
    if (reeving) all.push_back({line, *reeving});
  };
  add("skyline", request.skyline);
  add("mainline", request.mainline);
  add("haulback", request.haulback);
  return all;
}

}  // namespace taut::checks
