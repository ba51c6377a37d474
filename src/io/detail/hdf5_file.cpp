#include "io/detail/hdf5_file.hpp"

#include "base/require.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <numeric>

namespace vug::detail {

static_assert(sizeof(hid_t) == sizeof(Hdf5Id));

namespace {

struct Reason {
  std::string words = "unknown reason";
  bool of_system = false;
};

// Takes the reason of an error from the library's messages: that of the operating system where there is one.
herr_t collect_reason(unsigned, const H5E_error2_t* error, void* out) {
  auto& reason = *static_cast<Reason*>(out);
  if (!error->desc) return 0;
  const std::string_view text(error->desc);
  const std::string_view mark = "error message = '";
  if (const auto at = text.find(mark); at != std::string_view::npos) {
    const auto from = at + mark.size();
    reason = {std::string(text.substr(from, text.find('\'', from) - from)), true};
    return 1;
  }
  reason.words = text;  // the innermost error comes last
  return 0;
}

// Whether there is more memory than the library asks for at once in our files, apart from what it writes.
bool has_room() {
  constexpr std::size_t enough = 2 << 20;     // it takes 132 KiB when it starts
  void* volatile room = std::malloc(enough);  // volatile, because a compiler may leave out both calls
  std::free(room);
  return room != nullptr;
}

// Throws FileError, or std::bad_alloc where the library has run out of memory, which it does not always say.
[[noreturn]] void fail(const std::string& path, const char* action) {
  Reason reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, collect_reason, &reason);
  H5Eclear2(H5E_DEFAULT);
  if (!reason.of_system && (!has_room() || reason.words.find("memory allocation failed") != std::string::npos))
    throw std::bad_alloc();
  throw FileError(path + ": cannot " + action + ": " + reason.words);
}

template <class Result>
Result check(Result result, const std::string& path, const char* action) {
  if (result < 0) fail(path, action);
  return result;
}

/// An identifier that is closed when it goes out of scope.
struct Handle {
  hid_t id;
  herr_t (*close)(hid_t);
  Handle(hid_t id_, herr_t (*close_)(hid_t), const std::string& path, const char* action)
      : id(check(id_, path, action)), close(close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id >= 0) close(id);
  }
  /// Closes it now and throws where that fails, for instance when the last chunks of a data set do not fit on the disk.
  void done(const std::string& path, const char* action) { check(close(std::exchange(id, -1)), path, action); }
};

// Where memory runs out while the library starts, it follows a null pointer. It is therefore started only when more
// memory than it needs is free; otherwise std::bad_alloc is thrown, which the run reports.
bool require_room() {
  if (!has_room()) throw std::bad_alloc();
  return true;
}

// Makes the library quiet (errors become exceptions), without file locks (a viewer may hold the file open during the
// run) and without its own clean-up at exit, which never ends after a full disk.
hid_t access_properties(const std::string& path) {
  static const bool quiet = require_room() && H5dont_atexit() >= 0 && H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  if (!quiet) throw FileError(path + ": the HDF5 library does not start");
  const hid_t properties = check(H5Pcreate(H5P_FILE_ACCESS), path, "open");
#if H5_VERSION_GE(1, 12, 1) || (H5_VERSION_GE(1, 10, 7) && !H5_VERSION_GE(1, 11, 0))  // 1.12.0 has no such function
  check(H5Pset_file_locking(properties, false, true), path, "open");
#endif
  check(H5Pset_fclose_degree(properties, H5F_CLOSE_STRONG), path, "open");
  return properties;
}

void write_attribute(hid_t object, const Attribute& attribute, const std::string& path) {
  const char* action = "write an attribute";
  const auto put = [&](hid_t type, hid_t space, const void* data) {
    const Handle handle(H5Acreate2(object, attribute.name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                        path, action);
    check(H5Awrite(handle.id, type, data), path, action);
  };
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, path, action);
  if (const auto* text = std::get_if<std::string>(&attribute.value)) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, path, action);
    check(H5Tset_size(type.id, std::max<std::size_t>(1, text->size())), path, action);
    check(H5Tset_cset(type.id, H5T_CSET_UTF8), path, action);
    put(type.id, scalar.id, text->c_str());
  } else if (const auto* whole = std::get_if<std::int64_t>(&attribute.value)) {
    put(H5T_NATIVE_INT64, scalar.id, whole);
  } else if (const auto* number = std::get_if<double>(&attribute.value)) {
    put(H5T_NATIVE_DOUBLE, scalar.id, number);
  } else {
    const auto& numbers = std::get<std::vector<double>>(attribute.value);
    const hsize_t extent = numbers.size();
    const Handle simple(H5Screate_simple(1, &extent, nullptr), H5Sclose, path, action);
    put(H5T_NATIVE_DOUBLE, simple.id, numbers.data());
  }
}

hid_t file_type(StoredAs type) {
  return type == StoredAs::float32 ? H5T_IEEE_F32LE : H5T_STD_I32LE;
}

// Chunks of at most 64 k values: small arrays as a whole, large ones in tiles.
std::vector<hsize_t> chunk_of(const std::vector<hsize_t>& extent) {
  auto chunk = extent;
  const hsize_t limit = extent.size() > 1 && extent[1] > 3 ? 256 : 65536;
  for (hsize_t& side : chunk) side = std::clamp<hsize_t>(side, 1, limit);
  return chunk;
}

template <class Visit>
void for_each_link(hid_t group, const std::string& path, Visit visit) {
  H5G_info_t info;
  check(H5Gget_info(group, &info), path, "list");
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto length =
        check(H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT), path, "list");
    std::string name(static_cast<std::size_t>(length), '\0');
    check(H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size() + 1, H5P_DEFAULT),
          path, "list");
    visit(name);
  }
}

}  // namespace

void visit_pieces(const std::vector<std::size_t>& shape, const std::function<void(std::size_t, std::size_t)>& visit) {
  if (row_size(shape) == 0) return;
  const std::size_t rows = chunk_of({shape.begin(), shape.end()})[0];
  for (std::size_t first = 0; first < shape[0]; first += rows) visit(first, std::min(rows, shape[0] - first));
}

std::size_t row_size(const std::vector<std::size_t>& shape) {
  return std::accumulate(shape.begin() + 1, shape.end(), std::size_t{1}, std::multiplies<>());
}

Hdf5File::Hdf5File(std::string path, Hdf5Id file, std::unique_ptr<NewFile> unfinished)
    : path_(std::move(path)), unfinished_(std::move(unfinished)), file_(file) {}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : path_(std::move(other.path_)), unfinished_(std::move(other.unfinished_)), file_(std::exchange(other.file_, -1)) {}

Hdf5File::~Hdf5File() {
  if (file_ >= 0) H5Fclose(file_);
}

Hdf5File Hdf5File::create(const std::string& path) {
  auto unfinished = std::make_unique<NewFile>(path);
  const Handle access(access_properties(path), H5Pclose, path, "open");
  const hid_t file = H5Fcreate(unfinished->temporary().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id);
  return {path, check(file, path, "write"), std::move(unfinished)};
}

Hdf5File Hdf5File::open(const std::string& path) {
  const Handle access(access_properties(path), H5Pclose, path, "open");
  return {path, check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id), path, "open"), nullptr};
}

void Hdf5File::commit(bool sync) {
  check(H5Fflush(file_, H5F_SCOPE_LOCAL), path_, "write");
  check(H5Fclose(std::exchange(file_, -1)), path_, "write");
  unfinished_->commit(sync);
}

void Hdf5File::write(const Attribute& attribute) {
  const Handle root(H5Gopen2(file_, "/", H5P_DEFAULT), H5Gclose, path_, "write");
  write_attribute(root.id, attribute, path_);
}

void Hdf5File::write(const std::string& name, const std::vector<std::size_t>& shape,
                     const std::function<void(std::size_t first, std::span<double> values)>& read, StoredAs type,
                     bool compress, const std::vector<Attribute>& attributes) {
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const int rank = static_cast<int>(extent.size());
  const Handle space(H5Screate_simple(rank, extent.data(), nullptr), H5Sclose, path_, "write");
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path_, "write");
  check(H5Pset_obj_track_times(layout.id, false), path_, "write");  // so that equal results are equal bytes
  if (compress && shape[0] * row_size(shape) > 0) {
    check(H5Pset_chunk(layout.id, rank, chunk_of(extent).data()), path_, "write");
    check(H5Pset_shuffle(layout.id), path_, "write");
    check(H5Pset_deflate(layout.id, 4), path_, "write");
  }
  const Handle link(H5Pcreate(H5P_LINK_CREATE), H5Pclose, path_, "write");
  check(H5Pset_create_intermediate_group(link.id, 1), path_, "write");
  Handle data(H5Dcreate2(file_, name.c_str(), file_type(type), space.id, link.id, layout.id, H5P_DEFAULT), H5Dclose,
              path_, "write");
  std::vector<hsize_t> from(extent.size(), 0), piece = extent;
  std::vector<double> values;
  visit_pieces(shape, [&](std::size_t first, std::size_t rows) {
    from[0] = first;
    piece[0] = rows;
    values.resize(rows * row_size(shape));
    read(first, values);
    const Handle part(H5Screate_simple(rank, piece.data(), nullptr), H5Sclose, path_, "write");
    check(H5Sselect_hyperslab(space.id, H5S_SELECT_SET, from.data(), nullptr, piece.data(), nullptr), path_, "write");
    check(H5Dwrite(data.id, H5T_NATIVE_DOUBLE, part.id, space.id, H5P_DEFAULT, values.data()), path_, "write");
  });
  for (const auto& attribute : attributes) write_attribute(data.id, attribute, path_);
  data.done(path_, "write");
}

void Hdf5File::link(const std::string& name, const std::string& file) {
  check(H5Lcreate_external(file.c_str(), "/", file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT), path_, "write");
}

std::vector<std::pair<std::string, std::vector<std::size_t>>> Hdf5File::datasets(const std::string& group) const {
  std::vector<std::pair<std::string, std::vector<std::size_t>>> found;
  const Handle parent(H5Gopen2(file_, ("/" + group).c_str(), H5P_DEFAULT), H5Gclose, path_, "read");
  for_each_link(parent.id, path_, [&](const std::string& name) {
    const Handle data(H5Dopen2(parent.id, name.c_str(), H5P_DEFAULT), H5Dclose, path_, "read");
    const Handle space(H5Dget_space(data.id), H5Sclose, path_, "read");
    std::vector<hsize_t> extent(static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space.id), path_, "read")));
    check(H5Sget_simple_extent_dims(space.id, extent.data(), nullptr), path_, "read");
    found.emplace_back(name, std::vector<std::size_t>(extent.begin(), extent.end()));
  });
  return found;
}

double Hdf5File::attribute(const std::string& name) const {
  const Handle handle(H5Aopen_by_name(file_, "/", name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, path_, "read");
  double value = 0;
  check(H5Aread(handle.id, H5T_NATIVE_DOUBLE, &value), path_, "read");
  return value;
}

}  // namespace vug::detail
