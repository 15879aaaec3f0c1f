#include "cli/serve_verb.hpp"

#include "cli/exit_code.hpp"
#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "cli/verbs.hpp"
#include "web/serve.hpp"

namespace taut::cli {

int serve(const ServeVerbOptions& options) {
  const InterruptHeld held;
  int printed = computed;
  const auto ready = [&](const std::string& address) {
    printed = print_text(address + "\n");
    say("taut serves '{}' to this machine only; open the address in a browser. Ctrl-C ends it.\n", options.folder);
  };
  const auto goes_on = [&] { return printed == computed && InterruptHeld::goes_on(); };
  const auto done = web::serve({.folder = options.folder, .port = options.port, .page = options.page}, ready, goes_on);
  if (done) return printed;
  say("taut: {}\n", done.error().message);
  return done.error().of_files ? file_trouble : usage_or_deck;
}

}  // namespace taut::cli
