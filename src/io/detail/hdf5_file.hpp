#pragma once
// The little of HDF5 that snapshots need, every call checked. No header of the library is seen outside hdf5_file.cpp.
#include "io/detail/files.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vug::detail {

using Hdf5Id = std::int64_t;  ///< hid_t of HDF5 1.10 and later

/// A name with a text, a whole number or numbers.
struct Attribute {
  std::string name;
  std::variant<std::string, std::int64_t, double, std::vector<double>> value;
};

enum class StoredAs { float32, int32 };

/// visit(first row, rows) of the pieces of an array of this shape that are written at once, in order: as many rows as
/// its chunks have, each of which is compressed once.
void visit_pieces(const std::vector<std::size_t>& shape, const std::function<void(std::size_t, std::size_t)>& visit);

/// Numbers in a row: those of all dimensions but the first.
std::size_t row_size(const std::vector<std::size_t>& shape);

/// A new file that takes its name when it is complete (detail/files.hpp), or one that is read. HDF5 changes a file in
/// several places at once, and a kill in between makes all of it unreadable: so no file is ever changed.
class Hdf5File {
 public:
  /// A new file, written under a temporary name beside `path` until commit(); dropped before that, it leaves nothing.
  static Hdf5File create(const std::string& path);
  /// An existing one, to be read.
  static Hdf5File open(const std::string& path);
  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  ~Hdf5File();

  /// An attribute of the root.
  void write(const Attribute& attribute);
  /// A data set with the attributes; groups in its name ("bonds/d_m") are made. `read` fills in a piece of its values,
  /// rows from `first` on.
  void write(const std::string& name, const std::vector<std::size_t>& shape,
             const std::function<void(std::size_t first, std::span<double> values)>& read, StoredAs type, bool compress,
             const std::vector<Attribute>& attributes);
  /// The root of `file`, a path relative to this one, under a name in this one.
  void link(const std::string& name, const std::string& file);
  /// Writes what is still in memory and takes the name; with `sync` all of it has reached the disk before it returns.
  void commit(bool sync);

  /// Names and shapes of the data sets of a group ("" is the root), sorted.
  std::vector<std::pair<std::string, std::vector<std::size_t>>> datasets(const std::string& group) const;
  /// A number that is an attribute of the root.
  double attribute(const std::string& name) const;

 private:
  Hdf5File(std::string path, Hdf5Id file, std::unique_ptr<NewFile> unfinished);
  std::string path_;
  std::unique_ptr<NewFile> unfinished_;
  Hdf5Id file_;
};

}  // namespace vug::detail
