#pragma once
#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

namespace taut {

/// Rows of numbers, added one after the other: a long series. The last ones are in memory (2 MB at most), those before
/// them in a temporary file without a name, in the folder that TMPDIR names. Where no file can be written all of them
/// stay in memory. Not for several threads at a time.
class LongRows {
 public:
  /// `width`: numbers in a row, above 0.
  explicit LongRows(std::size_t width);

  /// `row` has as many numbers as the width.
  void add(const std::vector<double>& row);

  std::size_t size() const { return size_; }
  std::size_t width() const { return width_; }

  /// Shows all rows in their order: the first of `width` numbers.
  void each(const std::function<void(const double*)>& see) const;
  /// One column, from 0.
  std::vector<double> column(std::size_t index) const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void move_to_file();

  std::size_t width_, size_ = 0, in_file_ = 0;  // rows
  std::vector<double> block_;                   // the rows behind those in the file
  std::unique_ptr<std::FILE, Close> file_;
  bool no_file_ = false;  // none can be made, or no more written
};

}  // namespace taut
