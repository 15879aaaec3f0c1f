#include "taut/app/checks_deck.hpp"

namespace taut::app {

const Description& ChecksRequest::describe() {
  static const Description d =
      Describe<ChecksRequest>()
          .named_records(&ChecksRequest::ropes, "ropes",
                         "by the name of a reeving, a guy, or a rope with all that is reeved of it")
          .field(&ChecksRequest::refuse_unverified, "refuse_unverified",
                 "a check that rests on an unverified number does not pass");
  return d;
}

}  // namespace taut::app
