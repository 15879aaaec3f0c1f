#include "taut/base/long_rows.hpp"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkstemp is POSIX
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

#include "taut/base/expects.hpp"

namespace taut {
namespace {

constexpr std::size_t most_in_memory = 1 << 18;  // numbers

/// A file that is gone when it is closed; none: nullptr.
std::FILE* nameless_file() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) return nullptr;
  std::string name = (folder / "taut-XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) return nullptr;
  ::unlink(name.c_str());
  std::FILE* const file = ::fdopen(descriptor, "w+b");
  if (file == nullptr) ::close(descriptor);
  return file;
}

}  // namespace

LongRows::LongRows(std::size_t width) : width_(width) { expects(width > 0, "a row has numbers"); }

void LongRows::add(const std::vector<double>& row) {
  expects(row.size() == width_, "all rows are as wide as the first one");
  block_.insert(block_.end(), row.begin(), row.end());
  ++size_;
  if (block_.size() >= most_in_memory && !no_file_) move_to_file();
}

void LongRows::move_to_file() {
  if (!file_) file_.reset(nameless_file());
  // what is written in part (a full disk) is written over or not read: the rows in the file are counted
  const bool written = file_ != nullptr &&
                       ::fseeko(file_.get(), static_cast<off_t>(in_file_ * width_ * sizeof(double)), SEEK_SET) == 0 &&
                       std::fwrite(block_.data(), sizeof(double), block_.size(), file_.get()) == block_.size() &&
                       std::fflush(file_.get()) == 0;
  no_file_ = !written;
  if (!written) return;
  in_file_ += block_.size() / width_;
  block_.clear();
}

void LongRows::each(const std::function<void(const double*)>& see) const {
  const std::size_t most = std::max<std::size_t>(1, most_in_memory / width_);
  std::vector<double> read;
  if (in_file_ > 0) expects(::fseeko(file_.get(), 0, SEEK_SET) == 0, "a file of our own has a beginning");
  for (std::size_t row = 0; row < in_file_;) {
    const std::size_t rows = std::min(most, in_file_ - row);
    read.resize(rows * width_);
    expects(std::fread(read.data(), sizeof(double), read.size(), file_.get()) == read.size(),
            "what was written to a file of our own can be read");
    for (std::size_t i = 0; i < rows; ++i) see(read.data() + i * width_);
    row += rows;
  }
  for (std::size_t i = 0; i < block_.size(); i += width_) see(block_.data() + i);
}

std::vector<double> LongRows::column(std::size_t index) const {
  expects(index < width_, "a column is one of the row's");
  std::vector<double> all;
  all.reserve(size_);
  each([&](const double* row) { all.push_back(row[index]); });
  return all;
}

}  // namespace taut
