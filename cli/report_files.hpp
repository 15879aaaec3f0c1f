#pragma once
#include "cli/verbs.hpp"
#include "taut/calc/result.hpp"

namespace taut::cli {

/// Before a calculation: says that --pdf finds no Chromium, so that nobody waits for it in vain.
void warn_without_chromium(const RunOptions& options);

/// Writes a result into its folder, prints its PDF with --pdf, opens its report with --open, and says what it wrote.
/// The exit code: file_trouble where the folder or the PDF is not written (the folder is whole without its PDF),
/// interrupted where an interrupt ended Chromium. A report that cannot be opened is said and is no failure.
int write_report(const Result& result, const RunOptions& options);

}  // namespace taut::cli
