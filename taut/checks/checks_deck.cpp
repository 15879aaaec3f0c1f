#include "taut/checks/checks_deck.hpp"

namespace taut::checks {

const Description& ChecksRequest::describe() {
  static const Description d =
      Describe<ChecksRequest>()
          .named_records(&ChecksRequest::ropes, "ropes",
                         "by the name of a reeving, a guy, or a rope with all its reevings")
          .named_records(&ChecksRequest::masts, "masts",
                         "by the name of a beam, or of a mast that is described here with its section and loads")
          .named_records(&ChecksRequest::guys, "guys", "by the name of a guy, or of a rope with all guys of it")
          .named_records(&ChecksRequest::anchors, "anchors",
                         "by the name of a point at which ropes end or beams stand, or of a body that turns on a joint "
                         "in the ground")
          .named_records(&ChecksRequest::lines, "lines", "by the name of a reeving over supports")
          .named_records(&ChecksRequest::supports, "supports",
                         "trees that carry a line, by the name of the support or sheave on them")
          .named_records(&ChecksRequest::yarders, "yarders",
                         "drums of a yarder of the catalogue against the lines on them; the name is yours")
          .field(
              &ChecksRequest::confirmed, "confirmed",
              "sources that you have compared, such as 'EN 1993-1-1' or 'ISO 4309': numbers whose source contains the "
              "text are no longer unverified, and a check with no other doubts has the trust 'user'; the name of a "
              "check, or its last part, confirms all of it")
          .field(&ChecksRequest::exempt, "exempt",
                 "parts that do not count for the verdict, by name: a reeving, guy, beam, carriage, anchor, support or "
                 "drum, with its kind where several have the name ('rope winch'); page 1 names them")
          .field(&ChecksRequest::refuse_unverified, "refuse_unverified",
                 "true: checks with an unverified limit are refused, and the verdict is 'not judged'");
  return d;
}

}  // namespace taut::checks
