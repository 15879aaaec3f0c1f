#pragma once
#include <string>

namespace taut::cli {

struct ServeVerbOptions {
  std::string folder = ".";
  int port = 0;
  std::string page;
};

/// Prints the address of the page on standard output and answers it until it is interrupted. Returns the exit code.
int serve(const ServeVerbOptions& options);

}  // namespace taut::cli
