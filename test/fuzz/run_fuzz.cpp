// Any text as a deck, all the way: what can be read is calculated with the real methods and written as JSON. Designs
// and motions are interrupted after a moment: what does not end then is a bug (libFuzzer's time limit), slow ones are
// not.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <string_view>

#include "taut/app/job.hpp"
#include "taut/io/json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // no file is opened: an include would make the outcome depend on the disk
  if (text.find("include") != std::string_view::npos || text.find("file") != std::string_view::npos) return 0;
  const std::clock_t until = std::clock() + CLOCKS_PER_SEC;  // processor time: others may keep the machine busy
  const auto progress = [until](const taut::Progress&) { return std::clock() < until; };
  const taut::Result r =
      taut::app::run({.text = std::string(text), .name = "deck.yaml", .set = {}, .progress = progress});
  if (r.status == taut::Status::bad_deck && r.errors.empty()) std::abort();
  if (r.status != taut::Status::ok && r.message.empty()) std::abort();
  if (taut::io::to_json(r).empty()) std::abort();
  return 0;
}
