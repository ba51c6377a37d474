#pragma once
// The part of HDF5 that snapshots need, with every call checked. The library's headers are included in hdf5_file.cpp
// only.
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

/// Calls visit(first row, rows) for the pieces in which an array of this shape is written, in order: as many rows as
/// its chunks have, so that each chunk is compressed once.
void visit_pieces(const std::vector<std::size_t>& shape, const std::function<void(std::size_t, std::size_t)>& visit);

/// Number of values in a row: the product of all dimensions but the first.
std::size_t row_size(const std::vector<std::size_t>& shape);

/// A new file that takes its name when it is complete (detail/files.hpp), or an existing one to be read. No file is
/// ever changed, because HDF5 does that in several places at once, and a kill in between makes the whole file
/// unreadable.
class Hdf5File {
 public:
  /// Creates a file under a temporary name beside `path` until commit(); if destroyed before that, it leaves nothing.
  static Hdf5File create(const std::string& path);
  /// Opens an existing file to read it.
  static Hdf5File open(const std::string& path);
  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  ~Hdf5File();

  /// Writes an attribute of the root.
  void write(const Attribute& attribute);
  /// Writes a data set with its attributes and makes the groups in its name ("bonds/d_m"). `read` fills in a piece of
  /// its values, the rows from `first` on.
  void write(const std::string& name, const std::vector<std::size_t>& shape,
             const std::function<void(std::size_t first, std::span<double> values)>& read, StoredAs type, bool compress,
             const std::vector<Attribute>& attributes);
  /// Links the root of `file`, a path relative to this file, under a name in this file.
  void link(const std::string& name, const std::string& file);
  /// Writes what is still in memory and takes the name; with `sync` all of it has reached the disk before it returns.
  void commit(bool sync);

  /// Names and shapes of the data sets of a group ("" is the root), sorted.
  std::vector<std::pair<std::string, std::vector<std::size_t>>> datasets(const std::string& group) const;
  /// A number that is stored as an attribute of the root.
  double attribute(const std::string& name) const;

 private:
  Hdf5File(std::string path, Hdf5Id file, std::unique_ptr<NewFile> unfinished);
  std::string path_;
  std::unique_ptr<NewFile> unfinished_;
  Hdf5Id file_;
};

}  // namespace vug::detail
