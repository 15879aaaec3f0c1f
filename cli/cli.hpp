#pragma once

namespace taut::cli {

/// The program: parses the command line, calls the library, prints. Returns an ExitCode (cli/exit_code.hpp).
int main(int argc, char** argv);

}  // namespace taut::cli
