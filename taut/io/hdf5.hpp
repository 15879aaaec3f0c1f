#pragma once
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::io {

/// Series as one HDF5 file: a group for each table with the attribute `title`, in it a dataset for each column, in
/// order, with the attributes `unit` (SI) and `index`. Numbers are doubles bit by bit (NaN: no value), texts UTF-8. The
/// same series give the same bytes. The error is the reason in words.
tl::expected<void, std::string> write_hdf5(const std::vector<Table>& series, const std::string& path);

/// What such a file holds, for tests and for reading a run back: tables with their columns in order. Units that taut
/// does not know come back as plain numbers.
tl::expected<std::vector<Table>, std::string> read_hdf5(const std::string& path);

}  // namespace taut::io
