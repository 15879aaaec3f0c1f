#pragma once

namespace taut::cli {

/// The program: parses the command line, calls the library, prints. Exit codes: 0 computed; 1 our fault; 2 usage or
/// deck; 3 physics or solver says no; 4 computed, and a check in it fails; 5 a file can't be read or written; 130
/// interrupted.
int main(int argc, char** argv);

}  // namespace taut::cli
