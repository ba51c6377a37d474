#pragma once
// The words of a Gmsh file, each with the number of its line.
#include <cstdint>
#include <string>
#include <string_view>

namespace vug::detail {

class MeshText {
 public:
  MeshText(std::string_view text, std::string path) : rest_(text), path_(std::move(path)) {}

  bool at_end();
  std::string_view word();  ///< the next word; an error at the end of the file
  std::int64_t integer();   ///< the next word as a whole number
  double number();          ///< the next word as a finite number
  std::string quoted();     ///< the next "text in quotation marks"
  std::int64_t count();  ///< a number of items, refused if the rest of the text is too short for them (two bytes each)
  void skip(std::int64_t words);
  void expect(std::string_view wanted);
  void skip_past(std::string_view end);  ///< skips everything up to and with the word `end`
  /// Throws InputError: `path:line: message`.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  void skip_blanks();
  template <class Value>
  Value parsed(const char* expected);
  std::string_view rest_;
  std::string path_;
  int line_ = 1;
};

}  // namespace vug::detail
