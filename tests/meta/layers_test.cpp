// Dependencies point down only, and nothing below main.cpp prints, exits or asks for the back end.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace vug {
namespace {

std::map<std::string, std::string> sources() {
  std::map<std::string, std::string> files;
  const std::filesystem::path root = VUG_SOURCE_DIR "/src";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    files[std::filesystem::relative(entry.path(), root).string()] = text.str();
  }
  return files;
}

TEST(Layers, IncludeOnlyWhatLiesBelow) {
  const std::map<std::string, std::set<std::string>> allowed{
      {"kernels", {"kernels"}},
      {"ranks", {"ranks", "kernels"}},
      {"dem", {"dem", "kernels"}},
      {"io", {"io", "dem", "kernels"}},
      {"coupling", {"coupling", "io", "dem", "ranks", "kernels"}}};
  const std::regex include("#include \"(kernels|ranks|dem|io|coupling)/");
  int checked = 0;
  for (const auto& [file, text] : sources()) {
    const auto layer = allowed.find(file.substr(0, file.find('/')));
    if (layer == allowed.end()) continue;
    for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match, ++checked)
      EXPECT_TRUE(layer->second.count((*match)[1])) << file << " includes " << (*match)[0];
  }
  EXPECT_GT(checked, 200);
}

TEST(Sources, NeitherExitNorPrintNorAskForTheBackEnd) {
  // whether Kokkos has Serial beside its back end is no question for the back end
  const std::regex forbidden(
      "\\bstd::exit\\(|\\bexit\\(|std::cout|std::cerr|\\bprintf\\(|KOKKOS_ENABLE_(?!SERIAL)|atomic_add");
  for (const auto& [file, text] : sources()) {
    if (file == "main.cpp") continue;
    std::smatch match;
    EXPECT_FALSE(std::regex_search(text, match, forbidden)) << file << ": " << match[0];
  }
}

}  // namespace
}  // namespace vug
