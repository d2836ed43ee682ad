// Our side of reading through the helper program: look at the header, start the helper with limits, and turn
// whatever way it ended into a soup or one sentence.
#include <algorithm>

#include "core/base/subprocess.h"
#include "core/mesh/pictures.h"
#include "core/mesh/readers.h"

namespace netwright::readers {
namespace {

// Ten thousand faces take some ten milliseconds; whoever needs longer than this is not reading any more.
constexpr ChildLimits kReadLimits{
    .seconds = 4, .memory_bytes = std::size_t{900} << 20, .output_bytes = std::size_t{400} << 20};

/// Beside this program as it was built; once installed, where programs that nobody starts by hand belong.
std::filesystem::path helper() {
  const std::filesystem::path folder = program_folder();
  const std::filesystem::path beside = folder / "netwright-read";
  std::error_code error;
  return std::filesystem::exists(beside, error) ? beside
                                                : folder.parent_path() / "libexec/netwright/netwright-read";
}

/// What Assimp said, as the middle of a sentence.
std::string as_clause(std::string_view said) {
  constexpr std::size_t kLongest = 100;
  said = said.substr(0, said.find(" for $$$"));  // its made-up name for bytes in memory
  std::string clause(said.substr(0, std::min(said.find('\n'), kLongest)));
  if (said.size() > kLongest && clause.size() == kLongest) clause += " …";
  while (!clause.empty() && (clause.back() == '.' || clause.back() == '!' || clause.back() == ' ')) {
    clause.pop_back();
  }
  return clause.empty() ? "no reason given" : clause;
}

void add_textures(ParsedModel& model, const CompanionLookup& companions) {
  Pictures pictures(companions);
  std::vector<std::shared_ptr<const Image>> images;
  for (const ParsedModel::Picture& picture : model.pictures) {
    images.push_back(picture.bytes.empty() ? pictures.from_file(picture.name)
                                           : pictures.from_bytes(picture.name, picture.bytes));
  }
  for (std::size_t m = 0; m < model.picture_of.size(); ++m) {
    const int picture = model.picture_of[m];
    if (picture >= 0) model.soup.materials[m].texture = images[static_cast<std::size_t>(picture)];
  }
  model.soup.notices = pictures.notices();
}

}  // namespace

ChildReader usual_child_reader() { return {helper(), kReadLimits}; }

PolygonSoup read_in_child(const std::string& name, std::string_view bytes, const std::string& extension,
                          const CompanionLookup& companions, const ChildReader& reader) {
  check_header(name, bytes, extension);
  if (std::error_code error; !std::filesystem::exists(reader.program, error)) {
    refuse(name,
           "the helper program " + reader.program.string() +
               ", which reads this format, is missing; install Netwright again or export the model as OBJ.");
  }
  const ChildResult result = run_child(reader.program, {extension}, bytes, reader.limits);
  switch (result.end) {
    case ChildResult::End::TimedOut:
    case ChildResult::End::Flooded:
      refuse(name,
             "reading it takes more time or memory than a model should; simplify it or export it as OBJ.");
    case ChildResult::End::Crashed:
      refuse(name,
             "the file is damaged in a way that stops the program reading it; export it again, best as OBJ.");
    case ChildResult::End::Cancelled:
      refuse(name, "reading it was given up.");
    case ChildResult::End::Exited:
      break;
  }
  if (result.output.starts_with('E')) {
    refuse(name, "the file is damaged (" + as_clause(std::string_view(result.output).substr(1)) +
                     "); export it again.");
  }
  ParsedModel parsed = unpack(name, result.output);
  add_textures(parsed, companions);
  PolygonSoup soup = std::move(parsed.soup);
  soup.is_indexed = extension != "stl";
  return soup;
}

}  // namespace netwright::readers
