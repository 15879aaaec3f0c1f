#pragma once
#include <vector>

#include "taut/calc/field.hpp"

namespace taut {

/// Where a struct breaks its own description, each mistake with its place ("ropes.hoist.mass", "path[2].parts"):
/// numbers that are none, infinite or out of their range; texts and lists that are required and empty; texts that are
/// no choice; names that are empty or stand twice in one list; of keys that exclude each other none or several. Structs
/// inside are looked at too. A deck has passed the same rules when it was read (io/deck/read.hpp); this is for structs
/// filled in a program. `object` is of the struct that `description` describes, and is not changed.
std::vector<Complaint> broken_fields(const Description& description, const void* object);

}  // namespace taut
