#pragma once
// XDMF 2 (ParaView's and VTK's "Xdmf Reader"): a small XML file that describes the data in an HDF5 file.
#include <string>
#include <vector>

namespace vug::detail {

/// A data set as XDMF refers to it.
struct XdmfArray {
  std::string location;  ///< file.h5:/group/name, relative to the XDMF file
  std::vector<std::size_t> shape;
  bool integer = false;  ///< integer or float, always of four bytes
};

/// Where values are: in the cells of a grid, or at the nodes of a flat three-dimensional grid, (1, rows, columns).
enum class XdmfCentre { cell, node };

std::string xdmf_item(const XdmfArray& array);
/// Vectors have three components.
std::string xdmf_attribute(const std::string& name, XdmfArray array, XdmfCentre centre);
/// A whole document: `grids` as one collection over time.
std::string xdmf_document(const std::vector<std::string>& grids);

}  // namespace vug::detail
