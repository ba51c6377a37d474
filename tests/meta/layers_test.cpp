// Dependencies point down only, and nothing below main.cpp prints, exits or asks for the back end.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

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

using Allowed = std::map<std::string, std::set<std::string>>;

/// That what lies under `root` of src includes no other of its folders than those allowed; how many includes there are.
int check_includes(const std::string& root, const Allowed& allowed) {
  const std::regex include("#include \"" + root + "([a-z]+)/");
  int checked = 0;
  for (const auto& [file, text] : sources()) {
    const auto slash = file.find('/', root.size());
    if (file.rfind(root, 0) != 0 || slash == std::string::npos) continue;  // elsewhere, or the program's own
    const std::string folder = file.substr(root.size(), slash - root.size());
    const auto layer = allowed.find(folder);
    if (layer == allowed.end()) {
      ADD_FAILURE() << file << " lies in a folder whose layer nobody has named";
      continue;
    }
    for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match, ++checked)
      EXPECT_TRUE(layer->second.count((*match)[1]) || (*match)[1] == folder) << file << " includes " << (*match)[0];
  }
  return checked;
}

TEST(Layers, IncludeOnlyWhatLiesBelow) {
  const int includes = check_includes("", {{"base", {}},
                                           {"kernels", {"base"}},
                                           {"host", {"base"}},
                                           {"ranks", {"base", "host", "kernels"}},
                                           {"dem", {"base", "ranks", "host", "kernels"}},
                                           {"io", {"base", "dem", "host"}},
                                           {"study", {"base", "io", "host"}},
                                           {"front", {"base", "io", "host"}},
                                           {"coupling", {"base", "io", "dem", "ranks", "host", "kernels"}}});
  EXPECT_GT(includes, 150);
}

TEST(Layers, OfTheKernelsIncludeOnlyWhatLiesBelow) {
  const int includes = check_includes("kernels/", {{"launch", {}},
                                                   {"packs", {}},
                                                   {"nodes", {"launch", "packs"}},
                                                   {"flow", {"launch", "packs", "nodes"}},
                                                   {"scalar", {"launch", "packs", "nodes"}},
                                                   {"heat", {"launch", "packs", "nodes", "scalar"}},
                                                   {"solute", {"launch", "packs", "nodes", "scalar"}},
                                                   {"reaction", {"launch", "packs", "nodes", "scalar", "solute"}}});
  EXPECT_GT(includes, 100);
}

/// What a file of src and the files that it includes take from outside, one after the other.
void collect_outer(const std::map<std::string, std::string>& files, const std::string& file,
                   std::set<std::string>& seen, std::vector<std::string>& outer) {
  if (!seen.insert(file).second) return;
  const std::string& text = files.at(file);
  const std::regex include("#include (?:\"([^\"]+)\"|<([^>]+)>)");
  for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
    if (files.count((*match)[1]))
      collect_outer(files, (*match)[1], seen, outer);
    else
      outer.push_back(file + " includes " + (*match)[1].str() + (*match)[2].str());
  }
}

/// In a build for a GPU the host's compiler compiles them, which does not know its headers.
TEST(Sources, OfTheHostReachNoKokkos) {
  int checked = 0;
  const std::map<std::string, std::string> files = sources();
  for (const std::string folder : {"io", "study"}) {
    std::ostringstream list;
    list << std::ifstream(VUG_SOURCE_DIR "/src/" + folder + "/CMakeLists.txt").rdbuf();
    const std::string text = list.str();
    const auto begin = text.find("set(host_sources"), end = text.find(')', begin);
    ASSERT_NE(begin, std::string::npos) << folder;
    std::istringstream names(text.substr(begin + 16, end - begin - 16));
    for (std::string name; names >> name; ++checked) {
      std::set<std::string> seen;
      std::vector<std::string> outer;
      collect_outer(files, folder + "/" + name, seen, outer);
      for (const std::string& include : outer)
        EXPECT_EQ(include.find("Kokkos"), std::string::npos) << name << ": " << include;
    }
  }
  EXPECT_GT(checked, 60);
}

/// In backticks, as `flow_module`.
TEST(Readme, OfTheCouplingNamesEveryFile) {
  std::ostringstream readme;
  readme << std::ifstream(VUG_SOURCE_DIR "/src/coupling/README.md").rdbuf();
  const std::string text = readme.str();
  int files = 0;
  for (const auto& [file, source] : sources()) {
    const std::filesystem::path path(file);
    if (path.parent_path() != "coupling") continue;
    EXPECT_NE(text.find('`' + path.stem().string() + '`'), std::string::npos) << file;
    ++files;
  }
  EXPECT_GT(files, 100);
}

TEST(Sources, NeitherExitNorPrintNorAskForTheBackEnd) {
  // by _exit: in a signal, between fork and exec, without memory
  const std::set<std::string> ends = {"process.cpp", "study/pool.cpp", "host/memory_reserve.cpp"};
  // whether Kokkos has Serial beside its back end is no question for the back end
  const std::regex forbidden(
      "\\b(?:quick_)?exit\\(|\\babort\\(|std::terminate\\(|std::c(?:out|err|log)|\\bstd(?:out|err)\\b|"
      "\\bv?f?printf\\(|fmt::print\\(|\\bf?put[sc]\\(|\\bputchar\\(|KOKKOS_ENABLE_(?!SERIAL)|atomic_add"),
      ends_at_once("\\b_[Ee]xit\\(");
  const std::regex comments("//[^\n]*");
  int files = 0;
  for (const auto& [file, whole] : sources()) {
    if (file == "main.cpp") continue;
    ++files;
    const std::string text = std::regex_replace(whole, comments, "");
    std::smatch match;
    EXPECT_FALSE(std::regex_search(text, match, forbidden)) << file << ": " << match[0];
    EXPECT_EQ(std::regex_search(text, ends_at_once), ends.count(file) == 1) << file << ": _exit";
  }
  EXPECT_GT(files, 300);
}

}  // namespace
}  // namespace vug
