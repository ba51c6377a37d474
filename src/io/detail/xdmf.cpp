#include "io/detail/xdmf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vug::detail {

std::string xdmf_item(const XdmfArray& array) {
  return fmt::format("<DataItem Dimensions=\"{}\" NumberType=\"{}\" Precision=\"4\" Format=\"HDF\">{}</DataItem>\n",
                     fmt::join(array.shape, " "), array.integer ? "Int" : "Float", array.location);
}

std::string xdmf_attribute(const std::string& name, XdmfArray array, XdmfCentre centre) {
  const bool vector = array.shape.size() > 1 && array.shape.back() == 3;
  if (centre == XdmfCentre::node) array.shape.insert(array.shape.begin(), 1);
  return fmt::format("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">\n{}</Attribute>\n", name,
                     vector ? "Vector" : "Scalar", centre == XdmfCentre::node ? "Node" : "Cell", xdmf_item(array));
}

std::string xdmf_document(const std::vector<std::string>& grids) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
      "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n{}</Grid>\n</Domain>\n</Xdmf>\n",
      fmt::join(grids, ""));
}

}  // namespace vug::detail
