#pragma once
// The little of HDF5 that snapshots need, every call checked. No header of the library is seen outside hdf5_file.cpp.
#include <cstdint>
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

enum class StoredAs { float32, float64, int32 };

/// The end and the superblock (the first bytes, which say where the end is) of a file as they are now. After a failure
/// between opening the file and publishing a group, `restore` makes the file what it was: until then nothing else of it
/// has been overwritten. A full disk would otherwise leave an end that lies beyond the file, and nothing could be read.
class Hdf5Rollback {
 public:
  explicit Hdf5Rollback(const std::string& path);
  void restore() const noexcept;

 private:
  std::string path_;
  std::string superblock_;
  std::uint64_t size_ = 0;
};

/// An open file that grows by groups. A group is filled without a name and *published* when it is complete, by one
/// small write: whoever reads the file, also after a kill, finds whole groups only.
class Hdf5File {
 public:
  static Hdf5File create(const std::string& path);
  static Hdf5File open(const std::string& path);
  Hdf5File(Hdf5File&& other) noexcept : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  ~Hdf5File();
  /// Writes what is still in memory; throws FileError when that fails.
  void close();

  /// A group without a name, and the step that gives it one.
  class Group {
   public:
    Group(Hdf5File& file, std::string name, const std::vector<Attribute>& attributes);
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;
    ~Group();
    void write(const std::string& name, const std::vector<std::size_t>& shape, std::span<const double> values,
               StoredAs type, bool compress, const std::vector<Attribute>& attributes);
    /// Brings everything written so far to the file, where nothing refers to it yet.
    void flush();
    void publish();

   private:
    Hdf5File& file_;
    std::string name_;
    Hdf5Id group_;
  };

  /// Names of the groups in the root, sorted.
  std::vector<std::string> groups() const;
  /// Names and shapes of the data sets of a group, sorted.
  std::vector<std::pair<std::string, std::vector<std::size_t>>> datasets(const std::string& group) const;
  double attribute(const std::string& object, const std::string& name) const;
  void remove(const std::string& group);

 private:
  void make_room() const;
  Hdf5File(std::string path, Hdf5Id file) : path_(std::move(path)), file_(file) {}
  std::string path_;
  Hdf5Id file_;
};

}  // namespace vug::detail
