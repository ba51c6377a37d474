#include "front/schema.hpp"

#include "io/case_keys.hpp"
#include "io/json_text.hpp"

#include <fmt/format.h>

#include <sstream>
#include <vector>

namespace vug {

namespace {

/// A key or a table, with its keys.
struct Node {
  std::string name;
  const KeyDescription* key = nullptr;
  std::vector<Node> children;
  bool repeats = false;  ///< a table of which there may be several

  Node& child(const std::string& wanted) {
    for (Node& node : children)
      if (node.name == wanted) return node;
    children.push_back({wanted, nullptr, {}, false});
    return children.back();
  }
};

/// Limits of a number, from the text of the documentation: "> 0, <= 1", "0 ... 10".
std::string limits_of(const std::string& range) {
  if (range.find("...") != std::string::npos) {
    std::istringstream text(range);
    std::string low, dots, high;
    text >> low >> dots >> high;
    return fmt::format(", \"minimum\": {}, \"maximum\": {}", low, high);
  }
  constexpr std::pair<const char*, const char*> signs[] = {
      {">=", "minimum"}, {">", "exclusiveMinimum"}, {"<=", "maximum"}, {"<", "exclusiveMaximum"}};
  std::string out;
  std::istringstream text(range);
  for (std::string sign, number; text >> sign;)
    for (const auto& [known, name] : signs)
      if (sign == known && text >> number) out += fmt::format(", \"{}\": {}", name, number.substr(0, number.find(',')));
  return out;
}

/// Schema of a number or, where it has a unit, also of text with this unit.
std::string number_schema(const KeyDescription& key) {
  const std::string number = fmt::format("{{\"type\": \"number\"{}}}", limits_of(key.range));
  if (key.unit == "1") return number;
  return fmt::format("{{\"anyOf\": [{}, {{\"type\": \"string\"}}]}}", number);
}

std::string value_schema(const KeyDescription& key) {
  const auto several = [](int n, const std::string& of) {
    return fmt::format("{{\"type\": \"array\", \"items\": {}, \"minItems\": {}, \"maxItems\": {}}}", of, n, n);
  };
  const auto pair = [&](const std::string& of) { return several(2, of); };
  const auto list = [](const std::string& of) { return fmt::format("{{\"type\": \"array\", \"items\": {}}}", of); };
  const std::string whole = fmt::format("{{\"type\": \"integer\"{}}}", limits_of(key.range));
  if (key.type == "number") return number_schema(key);
  if (key.type == "whole number") return whole;
  if (key.type == "two numbers") return pair(number_schema(key));
  if (key.type == "three numbers") return several(3, number_schema(key));
  if (key.type == "two whole numbers") return pair(whole);
  const auto or_table = [](const std::string& value) {
    return fmt::format("{{\"anyOf\": [{}, {{\"type\": \"array\", \"items\": {{\"type\": \"array\"}}}}]}}", value);
  };
  if (key.type == "table") return list("{\"type\": \"array\"}");
  if (key.type == "number or table") return or_table(number_schema(key));
  if (key.type == "two numbers or table") return or_table(pair(number_schema(key)));
  if (key.type == "list of points") return list(pair(number_schema(key)));
  if (key.type == "list of whole numbers") return list(whole);
  if (key.type == "list of text") return list("{\"type\": \"string\"}");
  if (key.type == "true or false") return "{\"type\": \"boolean\"}";
  if (key.type != "word") return "{\"type\": \"string\"}";
  std::string words;
  std::istringstream text(key.range);
  for (std::string word; std::getline(text, word, ',');)
    words += (words.empty() ? "" : ", ") + json_string(word.substr(word.find_first_not_of(' ')));
  return fmt::format("{{\"enum\": [{}]}}", words);
}

/// What an editor shows beside a key.
std::string description_of(const KeyDescription& key) {
  std::string text = key.type;
  if (!key.unit.empty() && key.unit != "1") text += ", " + key.unit;
  if (!key.range.empty() && key.range != "any") text += ", " + key.range;
  if (key.fallback == "required") return text + "; required";
  return key.fallback == "-" ? text : text + "; default " + key.fallback;
}

std::string schema_of(const Node& node, const std::string& indent);

std::string properties_of(const Node& node, const std::string& indent) {
  std::string properties, others = "false";
  const auto add = [&](const std::string& name, const Node& child) {
    properties += fmt::format("{}\n{}  {}: {}", properties.empty() ? "" : ",", indent, json_string(name),
                              schema_of(child, indent + "  "));
  };
  for (const Node& child : node.children) {
    if (child.name == "<side>")
      for (const char* side : {"left", "right", "bottom", "top"}) add(side, child);
    else if (child.name.starts_with('<'))
      others = schema_of(child, indent + "  ");
    else
      add(child.name, child);
  }
  return fmt::format("\"type\": \"object\", \"additionalProperties\": {}, \"properties\": {{{}}}", others, properties);
}

std::string schema_of(const Node& node, const std::string& indent) {
  if (node.key != nullptr) {
    const std::string value = value_schema(*node.key);
    return fmt::format("{}, \"description\": {}}}", value.substr(0, value.size() - 1),
                       json_string(description_of(*node.key)));
  }
  if (node.children.size() == 1 && node.children[0].name == "N")
    return fmt::format("{{\"type\": \"array\", \"items\": {}}}", schema_of(node.children[0], indent));
  const std::string one = "{" + properties_of(node, indent) + "}";
  return node.repeats ? fmt::format("{{\"anyOf\": [{}, {{\"type\": \"array\", \"items\": {}}}]}}", one, one) : one;
}

}  // namespace

std::string case_schema() {
  Node root;
  for (const KeyDescription& key : case_keys()) {
    Node* node = &root;
    std::istringstream path(key.key);
    std::string table;
    for (std::string name; std::getline(path, name, '.');) {
      node = &node->child(name);
      table += (table.empty() ? "" : ".") + name;
      node->repeats = may_repeat(table);
    }
    node->key = &key;
  }
  return fmt::format(
      "{{\"$schema\": \"http://json-schema.org/draft-07/schema#\", \"title\": \"case file of vug\", {}}}\n",
      properties_of(root, ""));
}

}  // namespace vug
