#pragma once
#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

namespace taut {

/// A long series: rows of numbers, appended one by one. The latest rows are in memory (about 2 MB), the earlier ones in
/// a temporary file without a name, in the folder that TMPDIR names. Where that file cannot be written, all rows stay
/// in memory. Not thread-safe.
class LongRows {
 public:
  /// `width`: numbers in a row, > 0. Throws ContractViolation otherwise.
  explicit LongRows(std::size_t width);

  /// `row` must have `width` numbers. Throws ContractViolation otherwise.
  void add(const std::vector<double>& row);

  std::size_t size() const { return size_; }
  std::size_t width() const { return width_; }

  /// Calls `see` for each row in order, with a pointer to the `width` numbers of the row.
  void each(const std::function<void(const double*)>& see) const;
  /// The numbers of one column, 0 <= index < width; shape [size].
  std::vector<double> column(std::size_t index) const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void move_to_file();

  std::size_t width_, size_ = 0, in_file_ = 0;  // rows
  std::vector<double> block_;                   // the rows that follow those in the file
  std::unique_ptr<std::FILE, Close> file_;
  bool no_file_ = false;  // the file cannot be made, or takes no more
};

}  // namespace taut
