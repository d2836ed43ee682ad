// Begins from what the search for one piece came to, and tells every choice with what it costs.
#include "app/cli_pieces.h"

#include <cmath>

#include "core/base/counted.h"

namespace netwright {
namespace {

constexpr double kToldHeight = 100;  ///< mm, where the size depends on the paper

bool allows_pieces(const UnfoldCommand& command) { return command.fewest_pieces || command.most_pieces > 1; }

std::string in_mm(double length) { return grouped(static_cast<std::int64_t>(std::lround(length))) + " mm"; }

}  // namespace

std::optional<PiecesResult> look_for_pieces(const UnfoldCommand& command, const SolveResult& result,
                                            const SolveOptions& options, const Interrupts& interrupts) {
  if (result.is_proved || !allows_pieces(command)) return std::nullopt;
  PiecesOptions wanted;
  wanted.seed = options.seed;
  wanted.pins = options.pins;
  wanted.from = std::make_shared<const UnfoldTree>(result.net.tree);
  PiecesResult pieces;
  const auto limit = command.time_limit_s > 0 ? std::optional(command.time_limit_s) : std::nullopt;
  const Watched watched = run_watched(
      interrupts, [&](Progress& progress) { pieces = fewest_pieces(result.net.dual, wanted, progress); },
      limit);
  if (watched.was_interrupted) return std::nullopt;
  return pieces;
}

bool take_pieces(const UnfoldCommand& command, const PiecesResult& pieces, SolveResult& result) {
  if (pieces.choices.empty()) return false;
  const Net& net = pieces.choices.front().net;
  if (!command.fewest_pieces && net.n_pieces > command.most_pieces) return false;
  result.net = net;
  result.overlaps.clear();
  result.proof = verify(to_flat_net(net, 1), net.n_pieces);
  result.is_proved = result.proof.is_net;
  return result.is_proved;
}

std::vector<std::string> pieces_lines(const UnfoldCommand& command, const PiecesResult& pieces) {
  std::vector<std::string> lines;
  for (const PiecesChoice& choice : pieces.choices) {
    const Mesh& mesh = choice.net.mesh();
    const double tall = mesh.height() > 0 ? mesh.height() : mesh.box().diagonal();
    const double scale = scale_of(mesh, command.size).value_or(kToldHeight / tall);
    lines.push_back(counted(choice.net.n_pieces, "piece", "pieces") + ": " +
                    in_mm(choice.cut_length * scale) + " of cuts on a model " + in_mm(tall * scale) +
                    " high");
  }
  if (!lines.empty() && pieces.at_least == pieces.choices.front().net.n_pieces)
    lines.front() += "; fewer are impossible";
  return lines;
}

Json pieces_json(const PiecesResult& pieces) {
  Json list{Json::Array{}};
  for (const PiecesChoice& choice : pieces.choices) {
    Json one;
    one.set("pieces", choice.net.n_pieces);
    one.set("cut_length", choice.cut_length);
    list.add(std::move(one));
  }
  Json json;
  json.set("at_least", pieces.at_least);
  json.set("found", list);
  return json;
}

}  // namespace netwright
