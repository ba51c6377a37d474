// What the program carries with it: templates, the schema, its citation.
#include "base/require.hpp"
#include "front/embedded.hpp"
#include "front/schema.hpp"
#include "front/templates.hpp"
#include "io/scene.hpp"
#include "support/run_vug.hpp"
#include "unit/case_files.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

TEST(Templates, AreCasesThatCanBeRead) {
  const test::TemporaryFolder folder;
  EXPECT_GE(templates().size(), 3u);
  for (const Template& entry : templates()) {
    const std::string path = new_case(entry.name, folder / (entry.name + ".toml"));
    EXPECT_NO_THROW(read_scene(path)) << entry.name;
    EXPECT_THROW(new_case(entry.name, path), InputError) << "is not written over";
  }
  EXPECT_THROW(new_case("chanel", ""), InputError);
}

// An evaluator of schemas that nobody here has written says what they mean, where it is installed.
TEST(Schema, IsJsonThatHoldsEveryKeyOfTheCases) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "schema.json", case_schema());
  test::write_text(
      folder / "hold.py",
      "import json, sys, tomllib, pathlib\n"
      "schema = json.load(open(sys.argv[1]))\n"
      "def walk(value, schema, path):\n"
      "    if isinstance(value, (dict, list)) and 'anyOf' in schema and 'properties' in schema['anyOf'][0]:\n"
      "        schema = schema['anyOf'][isinstance(value, list)]\n"
      "    if isinstance(value, dict):\n"
      "        for key, inner in value.items():\n"
      "            known = schema['properties'].get(key) or schema['additionalProperties']\n"
      "            assert known, f'{path}.{key} is not in the schema'\n"
      "            walk(inner, known, f'{path}.{key}')\n"
      "    elif isinstance(value, list) and value and isinstance(value[0], dict):\n"
      "        for inner in value: walk(inner, schema['items'], path)\n"
      "try:\n"
      "    import jsonschema\n"
      "except ImportError:\n"
      "    jsonschema = None\n"
      "for case in sys.argv[2:]:\n"
      "    case = tomllib.load(open(case, 'rb'))\n"
      "    walk(case, schema, '')\n"
      "    if jsonschema: jsonschema.validate(case, schema)\n"
      "assert schema['properties']['lattice']['properties']['size']['minItems'] == 2\n"
      "assert 'exclusiveMinimum' in json.dumps(schema['properties']['flow']['properties']['viscosity'])\n");
  const test::Outcome outcome = test::run_command(
      VUG_PYTHON " " + (folder / "hold.py") + " " + (folder / "schema.json") +
      " " VUG_SOURCE_DIR "/tests/cases/complete/*.toml " VUG_SOURCE_DIR "/cases/*.toml " VUG_SOURCE_DIR
      "/cases/rock/*.toml " VUG_SOURCE_DIR "/cases/laboratory/*.toml");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
}

/// An override is one word: what follows it is the case, or a mistake.
TEST(CommandLine, TakesOneWordForEveryOverride) {
  const std::string two =
      "check --set flow.viscosity=2e-6 --set time.steps=4000 " VUG_SOURCE_DIR "/cases/poiseuille.toml";
  EXPECT_NE(test::run_vug(two).output.find("\n4000 steps of "), std::string::npos);
  const test::Outcome mistaken = test::run_vug(two + " --set time.steps=4000 case.name=two");
  EXPECT_EQ(mistaken.exit_code, 2);
  EXPECT_NE(mistaken.output.find("not expected: case.name=two"), std::string::npos) << mistaken.output;
  const test::TemporaryFolder folder;
  EXPECT_EQ(test::run_vug("watch --columns a,b " + folder.path()).output,
            "vug: " + folder.path() + ": holds no run (it has no run.json)\n");
}

/// A mistyped command or option is told with what was probably meant; who looks for pictures is told where they are.
TEST(CommandLine, SaysWhatWasProbablyMeant) {
  const std::string end = " (vug --help lists what there is)\n", run = "run " VUG_SOURCE_DIR "/cases/poiseuille.toml ";
  for (const auto& [words, told] : std::vector<std::pair<std::string, std::string>>{
           {"runn case.toml", "there is no command \"runn\"; did you mean \"run\"?"},
           {"plot runs/a",
            "there is no command \"plot\"; scripts/plot DIR draws the pictures of a run (installed: vug-plot DIR)"},
           {"xyzzy", "there is no command \"xyzzy\""},
           {run + "--error-bar", "not expected: --error-bar; did you mean \"--error-bars\"?"},
           {run + "--step=5", "not expected: --step=5; did you mean \"--steps\"?"},
           {run + "--xyzzy more", "not expected: --xyzzy"},
           {run + "more", "not expected: more"},
           {run + "--set flow.viscosity=1 mm2/s",
            "not expected: mm2/s; --set takes one word, in quotes where it has blanks: 'table.key=20 MPa'"},
           {run + "--set flow.viscosity = 1",
            "not expected: =; --set takes one word, in quotes where it has blanks: 'table.key=20 MPa'"}}) {
    const test::Outcome outcome = test::run_vug(words);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    EXPECT_EQ(outcome.output, "vug: " + told + end);
  }
}

/// The cases that have every key are cases that could run: also the one whose holes, notches and materials cross.
TEST(CommandLine, ChecksTheCasesWithEveryKey) {
  for (const auto& path : testing_cases::cases_in("tests/cases/complete")) {
    const test::Outcome outcome = test::run_vug("check " + path.string());
    EXPECT_EQ(outcome.exit_code, 0) << path << ": " << outcome.output;
  }
}

TEST(CommandLine, SaysItsVersion) {
  const test::Outcome outcome = test::run_vug("--version");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(std::regex_match(outcome.output, std::regex("vug \\d+\\.\\d+\\.\\d+ \\(commit [^ ]+, \\w+\\)\n")))
      << outcome.output;
}

TEST(CommandLine, OffersCompletionACitationAndAManualPage) {
  EXPECT_NE(test::run_vug("--cite").output.find("cff-version"), std::string::npos);
  const test::TemporaryFolder folder;
  test::write_text(folder / "completion", test::run_vug("completion bash").output);
  const test::Outcome offered =
      test::run_command("bash -c 'source " + (folder / "completion") +
                        "; COMP_WORDS=(vug run --res); COMP_CWORD=2; _vug; echo ${COMPREPLY[@]}'");
  EXPECT_EQ(offered.output, "--resume\n");
  test::write_text(folder / "my case.toml", "");
  test::write_text(folder / "my case.txt", "");
  const test::Outcome files = test::run_command(
      "cd " + folder.path() + " && bash -c 'source completion; COMP_WORDS=(vug run my); COMP_CWORD=2; _vug; " +
      "printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
  EXPECT_EQ(files.output, "my case.toml\n");
  EXPECT_TRUE(test::run_vug("completion zsh").output.starts_with("autoload -U +X bashcompinit && bashcompinit\n"));
  const std::string page = test::run_vug("man").output;
  EXPECT_NE(page.find(".It --fit-cohesion"), std::string::npos) << page;
  EXPECT_EQ(test::run_vug("completion tcsh").exit_code, 2);
}

}  // namespace
}  // namespace vug
