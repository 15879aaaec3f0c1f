#include "taut/app/design/method_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/base/gravity.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/methods/mast_section/mast_section.hpp"

/// A design's choice in the input of each published method.
namespace taut::app::method_parts_test {

using testing::HasSubstr;

catalogue::RopeRow built_in() { return *catalogue::find_rope("EN 12385-4|6x36-IWRC|16|1960"); }

/// One whose number of the catalogue says too little.
catalogue::RopeRow own() {
  catalogue::RopeRow row = built_in();
  row.mass_per_length = 1.25;
  return row;
}

TEST(MethodParts, ARopeOfTheCatalogueGoesIntoALoopByItsIdAnotherByItsWeight) {
  const MethodDesign design = design_of_loop();
  auto in = MethodInput::of<closed_loop::Input>();
  in.as<closed_loop::Input>().traction_stiffness = 1e6;
  const auto put = [&](const std::string& name, const catalogue::RopeRow& row) {
    design.put_rope(in, name, row, design.modulus(in, name, row));
  };
  put("return", built_in());
  put("traction", own());
  const auto& loop = in.as<closed_loop::Input>();
  EXPECT_EQ(loop.return_rope, built_in().id);
  EXPECT_FALSE(loop.return_weight);
  EXPECT_TRUE(std::isinf(loop.return_stiffness)) << "a rope that does not stretch stays one";
  EXPECT_FALSE(loop.traction_rope);
  EXPECT_EQ(loop.traction_weight, 1.25 * standard_gravity);
  EXPECT_EQ(loop.traction_stiffness, 100e9 * built_in().area);
}

// A loop of a given length stretches as a rope of the catalogue does, at a modulus that is given by that one; it did
// not with a rope of one's own.
TEST(MethodParts, ALoopCalculatesWithTheModulusThatIsPrinted) {
  const MethodDesign design = design_of_loop();
  auto in = MethodInput::of<closed_loop::Input>();
  auto& loop = in.as<closed_loop::Input>();
  design.put_rope(in, "return", built_in(), 200e9);
  EXPECT_EQ(loop.return_stiffness, 200e9 * built_in().area) << "at a given sag too";
  loop.mode = closed_loop::Mode::loop_length;
  const double by_construction = design.modulus(in, "return", built_in());
  EXPECT_EQ(by_construction, 107.5e9);
  design.put_rope(in, "return", built_in(), by_construction);
  EXPECT_TRUE(std::isinf(loop.return_stiffness)) << "the method takes it from the catalogue, with its trust";
  design.put_rope(in, "traction", built_in(), 50e9);
  EXPECT_EQ(loop.traction_stiffness, 50e9 * built_in().area);
  design.put_rope(in, "traction", own(), design.modulus(in, "traction", own()));
  EXPECT_EQ(loop.traction_stiffness, 107.5e9 * built_in().area);
  catalogue::RopeRow unknown = own();
  unknown.construction = "braided";
  EXPECT_EQ(design.modulus(in, "traction", unknown), 100e9);
}

TEST(MethodParts, AReturnRopeRunsToTheTailAndBack) {
  auto in = MethodInput::of<closed_loop::Input>();
  in.as<closed_loop::Input>().span = 300;
  in.as<closed_loop::Input>().height_difference = 40;
  const MethodDesign design = design_of_loop();
  EXPECT_NEAR(design.rope_length(in, "traction"), std::hypot(300, 40), 1e-12 * 300);
  EXPECT_NEAR(design.rope_length(in, "return"), 2 * std::hypot(300, 40), 1e-12 * 600);
}

TEST(MethodParts, CuttersStayOnTheRopeThatIsChosen) {
  auto in = MethodInput::of<friction_drive::Input>();
  auto& drive = in.as<friction_drive::Input>();
  drive.rope = built_in().id;
  drive.rope_mass = built_in().mass_per_length + 0.3;
  drive.rope_stiffness = 1e6;
  design_of_drive().put_rope(in, "rope", own(), 80e9);
  EXPECT_NEAR(drive.rope_mass, 1.55, 1e-12);
  EXPECT_FALSE(drive.rope);
  EXPECT_EQ(*drive.rope_stiffness, 80e9 * built_in().area);
  drive.rope_stiffness.reset();
  design_of_drive().put_rope(in, "rope", built_in(), 80e9);
  EXPECT_EQ(drive.rope_stiffness, 80e9 * built_in().area) << "that the deck does not give";
}

TEST(MethodParts, ADriveIsOneLoopAndItsTakeUpIsBuiltToo) {
  auto in = MethodInput::of<friction_drive::Input>();
  auto& drive = in.as<friction_drive::Input>();
  const MethodDesign design = design_of_drive();
  EXPECT_EQ(design.rope_length(in, "rope"), 1) << "no centre distance: by the metre";
  EXPECT_EQ(design.mass(in), 0);
  drive.centre_distance = 5;
  drive.sheave_radius = 0.4;
  drive.take_up.emplace();
  drive.take_up->weight = 981;
  EXPECT_NEAR(design.rope_length(in, "rope"), 10 + 0.8 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(design.mass(in), 981 / standard_gravity, 1e-12);
  drive.take_up->mass = 120;
  EXPECT_EQ(design.mass(in), 120);
}

TEST(MethodParts, ABoomTakesTheStiffnessOfTheRopesLength) {
  const MethodDesign design = design_of_boom();
  auto in = MethodInput::of<boom_ropes::Input>();
  EXPECT_THAT(design.refuse(in), HasSubstr("give 'sliding' with the lengths"));
  auto& boom = in.as<boom_ropes::Input>();
  boom.sliding.emplace();
  boom.sliding->extension_length = 8;
  boom.sliding->retraction_length = 12;
  EXPECT_EQ(design.refuse(in), "");
  design.put_rope(in, "extension", built_in(), 100e9);
  design.put_rope(in, "retraction", built_in(), 100e9);
  EXPECT_EQ(boom.extension_stiffness, 100e9 * built_in().area / 8);
  EXPECT_EQ(boom.sliding->retraction_stiffness, 100e9 * built_in().area / 12);
  EXPECT_EQ(design.rope_length(in, "extension"), 16) << "two halves";
  EXPECT_EQ(design.rope_length(in, "retraction"), 12);
}

TEST(MethodParts, AMastTakesASectionAndIsAsHighAsItsHighestBlock) {
  const MethodDesign design = design_of_mast();
  auto in = MethodInput::of<mast_section::Input>();
  auto& mast = in.as<mast_section::Input>();
  mast.skyline_block_height = 9;
  EXPECT_EQ(design.height(in), 9);
  mast.mainline_block_height = 11;
  EXPECT_EQ(design.height(in), 11);
  design.put_section(in, "CHS 323.9x10");
  EXPECT_EQ(mast.section, "CHS 323.9x10");
  EXPECT_EQ(design.refuse(in), "");
  mast.choose_section.emplace();
  EXPECT_THAT(design.refuse(in), HasSubstr("'choose_section' of the input"));
}

}  // namespace taut::app::method_parts_test
