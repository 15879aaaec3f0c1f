#include "taut/io/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/long_rows.hpp"
#include "taut/units/display.hpp"

#ifdef __EMSCRIPTEN__
// A browser's engine writes no files, and HDF5 is not compiled for it.
namespace taut::io {

tl::expected<void, std::string> write_hdf5(const std::vector<Table>&, const std::string&) {
  return tl::unexpected(std::string("this build of taut has no HDF5"));
}

tl::expected<std::vector<Table>, std::string> read_hdf5(const std::string&) {
  return tl::unexpected(std::string("this build of taut has no HDF5"));
}

}  // namespace taut::io
#else
#include <hdf5.h>

namespace taut::io {
namespace {

/// Owns one of HDF5's objects.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  hid_t get() const { return id_; }
  bool ok() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// HDF5 prints its errors unless asked not to.
class Silence {
 public:
  Silence() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

Handle text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose};
}

/// Without times in it, so that the same data give the same bytes.
Handle untimed(hid_t kind) {
  const hid_t list = H5Pcreate(kind);
  H5Pset_obj_track_times(list, false);
  return {list, H5Pclose};
}

/// How texts are written and read. HDF5 clears the whole of its buffer for them, 1 MiB unless told otherwise, at each
/// column: many small files would cost little else.
Handle small_transfer() {
  constexpr std::size_t bytes = std::size_t{1} << 14U;
  const hid_t list = H5Pcreate(H5P_DATASET_XFER);
  H5Pset_buffer(list, bytes, nullptr, nullptr);
  return {list, H5Pclose};
}

bool write_attribute(hid_t object, const char* name, hid_t type, const void* data) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.ok() && H5Awrite(attribute.get(), type, data) >= 0;
}

bool write_text(hid_t object, const char* name, const std::string& text) {
  const char* data = text.c_str();
  const Handle type = text_type();
  return write_attribute(object, name, type.get(), static_cast<const void*>(&data));
}

/// '/' parts the names of a path, a lone '.' is the group itself.
std::string link_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name.empty() || name == "." ? "_" : name;
}

/// The same, of a name that the group has not yet; what it stands for is in its attribute.
std::string new_link(hid_t group, const std::string& name) {
  std::string link = link_name(name);
  while (H5Lexists(group, link.c_str(), H5P_DEFAULT) > 0) link += '_';
  return link;
}

bool write_column(hid_t group, const Table& t, std::size_t column) {
  const auto rows = static_cast<hsize_t>(t.long_rows ? t.long_rows->size() : t.rows.size());
  const bool texts = std::any_of(t.rows.begin(), t.rows.end(),
                                 [&](const auto& row) { return std::holds_alternative<std::string>(row[column]); });
  const Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose);
  const Handle type = texts ? text_type() : Handle(H5Tcopy(H5T_IEEE_F64LE), H5Tclose);
  const Handle list = untimed(H5P_DATASET_CREATE);
  const Handle set(H5Dcreate2(group, new_link(group, t.columns[column].name).c_str(), type.get(), space.get(),
                              H5P_DEFAULT, list.get(), H5P_DEFAULT),
                   H5Dclose);
  if (!set.ok()) return false;
  herr_t written = 0;
  if (texts) {
    std::vector<std::string> words;
    for (const auto& row : t.rows) {
      const auto* text = std::get_if<std::string>(&row[column]);
      words.push_back(text != nullptr ? *text : fmt::format("{}", std::get<double>(row[column])));
    }
    std::vector<const char*> pointers;
    pointers.reserve(words.size());
    for (const std::string& word : words) pointers.push_back(word.c_str());
    const Handle transfer = small_transfer();
    written =
        H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, transfer.get(), static_cast<const void*>(pointers.data()));
  } else {
    std::vector<double> numbers;
    if (t.long_rows) numbers = t.long_rows->column(column);
    for (const auto& row : t.rows) numbers.push_back(std::get<double>(row[column]));
    written = H5Dwrite(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
  }
  const int index = static_cast<int>(column);
  return written >= 0 && write_text(set.get(), "unit", std::string(t.columns[column].unit.symbol)) &&
         write_text(set.get(), "name", t.columns[column].name) &&
         write_attribute(set.get(), "index", H5T_NATIVE_INT, &index);
}

std::string read_text(hid_t object, const char* name) {
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Handle type = text_type();
  char* text = nullptr;
  if (!attribute.ok() || H5Aread(attribute.get(), type.get(), static_cast<void*>(&text)) < 0 || text == nullptr)
    return {};
  std::string copy = text;
  H5free_memory(text);
  return copy;
}

Unit unit_of(const std::string& symbol) {
  const auto& all = display_kinds();
  const auto at = std::find_if(all.begin(), all.end(), [&](const Unit& u) { return u.symbol == symbol; });
  return at == all.end() ? si::one : *at;
}

std::vector<std::string> names_in(hid_t group) {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* all) -> herr_t {
    static_cast<std::vector<std::string>*>(all)->emplace_back(name);
    return 0;
  };
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
  return names;
}

/// One dataset of `count` as a column of a table, put where its index says.
bool read_column(hid_t group, const std::string& name, std::size_t count, Table& t) {
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle space(set.ok() ? H5Dget_space(set.get()) : -1, H5Sclose);
  const Handle type(set.ok() ? H5Dget_type(set.get()) : -1, H5Tclose);
  const Handle attribute(set.ok() ? H5Aopen(set.get(), "index", H5P_DEFAULT) : -1, H5Aclose);
  int index = 0;
  if (!space.ok() || !type.ok() || !attribute.ok() || H5Aread(attribute.get(), H5T_NATIVE_INT, &index) < 0)
    return false;
  const auto rows = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
  const auto column = static_cast<std::size_t>(index);
  if (column >= count) return false;  // of a damaged file
  if (t.columns.size() <= column) t.columns.resize(column + 1);
  t.columns[column] = {.name = read_text(set.get(), "name"), .unit = unit_of(read_text(set.get(), "unit"))};
  if (t.rows.size() < rows) t.rows.resize(rows);
  for (auto& row : t.rows) row.resize(std::max(row.size(), column + 1), Cell(std::nan("")));
  if (H5Tget_class(type.get()) == H5T_STRING) {
    std::vector<char*> words(rows, nullptr);
    const Handle own = text_type(), transfer = small_transfer();
    if (H5Dread(set.get(), own.get(), H5S_ALL, H5S_ALL, transfer.get(), static_cast<void*>(words.data())) < 0)
      return false;
    for (std::size_t i = 0; i < rows; ++i) t.rows[i][column] = std::string(words[i] == nullptr ? "" : words[i]);
    for (char* word : words) H5free_memory(word);
    return true;
  }
  std::vector<double> numbers(rows);
  if (H5Dread(set.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0) return false;
  for (std::size_t i = 0; i < rows; ++i) t.rows[i][column] = numbers[i];
  return true;
}

}  // namespace

tl::expected<void, std::string> write_hdf5(const std::vector<Table>& series, const std::string& path) {
  const Silence silence;
  const Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  if (!file.ok()) return tl::unexpected(std::string("the file can't be made"));
  for (const Table& t : series) {
    const Handle list = untimed(H5P_GROUP_CREATE);
    const Handle group(H5Gcreate2(file.get(), link_name(t.name).c_str(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
                       H5Gclose);
    bool good = group.ok() && write_text(group.get(), "title", t.title);
    for (std::size_t i = 0; good && i < t.columns.size(); ++i) good = write_column(group.get(), t, i);
    if (!good) return tl::unexpected(fmt::format("'{}' can't be written into it", t.name));
  }
  if (H5Fflush(file.get(), H5F_SCOPE_LOCAL) < 0) return tl::unexpected(std::string("the disk may be full"));
  return {};
}

tl::expected<std::vector<Table>, std::string> read_hdf5(const std::string& path) {
  const Silence silence;
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.ok()) return tl::unexpected(std::string("it is no HDF5 file"));
  std::vector<Table> all;
  for (const std::string& name : names_in(file.get())) {
    const Handle group(H5Gopen2(file.get(), name.c_str(), H5P_DEFAULT), H5Gclose);
    if (!group.ok()) return tl::unexpected(fmt::format("'{}' is no group", name));
    Table t;
    t.name = name;
    t.title = read_text(group.get(), "title");
    const std::vector<std::string> columns = names_in(group.get());
    for (const std::string& column : columns) {
      if (!read_column(group.get(), column, columns.size(), t))
        return tl::unexpected(fmt::format("'{}/{}' can't be read", name, column));
    }
    all.push_back(std::move(t));
  }
  return all;
}

}  // namespace taut::io
#endif
