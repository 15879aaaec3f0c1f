#pragma once
#include <string>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/checks/asked_checks.hpp"
#include "taut/checks/checks_deck.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/methods/mast_section/mast_section.hpp"
#include "taut/rope/rope_use.hpp"

/// The block `checks:` beside the `input:` of a published method.
namespace taut::app {

// What methods offer to `checks:`: their ropes by name, with what the deck says of them; with a result also with the
// largest tensions in it.
/// Of mast_section `skyline` and `mainline`.
std::vector<rope::RopeUse> ropes_of_mast(const mast_section::Input& in, const Result* r);
/// Of closed_loop `return` and `traction`, of friction_drive `rope`, of boom_ropes `extension` and `retraction`.
std::vector<rope::RopeUse> ropes_of_loop(const closed_loop::Input& in, const Result* r);
std::vector<rope::RopeUse> ropes_of_drive(const friction_drive::Input& in, const Result* r);
std::vector<rope::RopeUse> ropes_of_boom(const boom_ropes::Input& in, const Result* r);

/// What a method's checks name, with complaints at paths below "checks".
checks::AskedChecks resolve_checks(const checks::ChecksRequest& request, const std::vector<rope::RopeUse>& ropes,
                                   const std::string& method, std::vector<Complaint>& complaints);

/// Adds the checks of the ropes, groups all, and refuses what rests on unverified numbers where the deck says so.
void add_method_checks(const checks::ChecksRequest& request, const checks::AskedChecks& asked,
                       const std::vector<rope::RopeUse>& ropes, const Display& display, Result& r);

}  // namespace taut::app
