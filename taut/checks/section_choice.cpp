#include "taut/checks/section_choice.hpp"

#include "taut/catalogue/section_search.hpp"

namespace taut::checks {

using catalogue::Forming;
using catalogue::SectionShape;
using catalogue::Trust;

const Description& SectionChoice::describe() {
  using R = SectionChoice;
  static const Description d =
      Describe<R>()
          .choice(&R::shape, "shape",
                  {{"any", std::nullopt},
                   {"chs", SectionShape::chs},
                   {"shs", SectionShape::shs},
                   {"rhs", SectionShape::rhs}},
                  "tube, square, rectangular")
          .choice(&R::forming, "forming",
                  {{"any", std::nullopt},
                   {"hot", Forming::hot},
                   {"cold", Forming::cold},
                   {"seamless", Forming::seamless},
                   {"welded", Forming::welded}},
                  "forming of the section")
          .field(&R::standard, "standard", "the beginning of its name: EN 10210")
          .field(&R::least_height, "least_height", "h", si::m.in("mm"), "smallest outer height")
          .above(0)
          .field(&R::most_height, "most_height", "h", si::m.in("mm"), "largest outer height")
          .above(0)
          .choice(&R::least_trust, "least_trust",
                  {{"verified", Trust::verified}, {"derived", Trust::derived}, {"unverified", Trust::unverified}},
                  "least trust of a row that may be chosen");
  return d;
}

catalogue::SectionFilter filter_of(const SectionChoice& choice) {
  catalogue::SectionFilter filter;
  filter.shape = choice.shape;
  filter.forming = choice.forming;
  filter.standard = choice.standard.value_or("");
  filter.min_height = choice.least_height;
  filter.max_height = choice.most_height;
  filter.min_trust = choice.least_trust;
  return filter;
}

}  // namespace taut::checks
