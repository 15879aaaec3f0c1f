#include "cli/cli.hpp"

int main(int argc, char** argv) { return taut::cli::main(argc, argv); }
