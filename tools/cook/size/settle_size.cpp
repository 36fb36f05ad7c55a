#include "cook/size/settle_size.h"

#include "base/text.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/size/evidence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::cook {
namespace {

// In sums of logarithms of likelihoods.
constexpr double kFits = -2;        ///< Another unit or axis has to fit the model at least this well.
constexpr double kSaysLittle = -1;  ///< The file's own must fit at most this well, or nothing is reported.
constexpr double kNarrow = 1.7;     ///< A lead below this is worth a warning.
constexpr double kAbsurd = 4;       ///< The caller's unit or axis must be worse by this much.

struct Vote {
  double factor = 1;
  double prior = 0;
  double evidence = 0;
  [[nodiscard]] double sum() const { return prior + evidence; }
};

/// The probability of one of all that are possible.
template <class AnyVote>
double share_of(const AnyVote& one, const std::vector<AnyVote>& all) {
  double sum = 0;
  for (const AnyVote& other : all) sum += std::exp(other.sum() - one.sum());
  return 1 / sum;
}

std::string length_text(double metres) {
  if (metres < 0.01) return fmt::format("{:.2g} mm", 1000 * metres);
  return metres < 1 ? fmt::format("{:.3g} cm", 100 * metres) : fmt::format("{:.3g} m", metres);
}

/// "the head's radius 0.94 m instead of 7.5 cm to 17 cm", the strongest evidence first.
std::string lengths_text(std::vector<SizeEvidence> evidence, double factor) {
  const auto likelihood = [&](const SizeEvidence& item) { return size_likelihood(std::span(&item, 1), factor); };
  std::ranges::stable_sort(evidence, {}, likelihood);
  std::vector<std::string> parts;
  for (const SizeEvidence& item : evidence) {
    if (parts.size() == 3 || (!parts.empty() && likelihood(item) > -0.05)) break;
    parts.push_back(fmt::format("{} {}, usually {} to {}", item.what, length_text(item.metres * factor),
                                length_text(item.low), length_text(item.high)));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

/// A unit as a recipe has it.
std::string unit_text(const importer::SourceSpace& space, double factor) {
  return fmt::format("{:.4g}", space.metres_per_unit * factor);
}

void say_other_unit(const importer::SourceSpace& space, const std::vector<SizeEvidence>& evidence, double factor,
                    JudgedSize& judged) {
  const std::string before = lengths_text(evidence, 1), after = lengths_text(evidence, factor);
  judged.factor = factor;
  judged.doubts.push_back(
      {SizeDoubt::Of::kOtherUnit,
       space.unit == importer::Statement::kUnsaid
           ? fmt::format("{}; one metre would make {}; taken as {} m per unit, which makes {}: set "
                         "\"source.metres_per_unit\" in the recipe if that is wrong",
                         space.unit_words, before, unit_text(space, factor), after)
           : fmt::format("the file's unit ({}) would make {}; taken as {} m per unit instead, with {}: set "
                         "\"source.metres_per_unit\": {} in the recipe if the file is right",
                         space.unit_words, before, unit_text(space, factor), after, unit_text(space, 1))});
}

void say_doubtful_unit(const importer::SourceSpace& space, const std::vector<SizeEvidence>& evidence, double other,
                       JudgedSize& judged) {
  const std::string now = lengths_text(evidence, 1), then = lengths_text(evidence, other);
  judged.doubts.push_back(
      {SizeDoubt::Of::kDoubtfulUnit,
       space.unit == importer::Statement::kGiven
           ? fmt::format("the recipe's \"source.metres_per_unit\": {} makes {}; {} would make {}: check it",
                         unit_text(space, 1), now, unit_text(space, other), then)
           : fmt::format("the unit is doubtful: {} m per unit ({}) makes {}; {} would make {}: set "
                         "\"source.metres_per_unit\" in "
                         "the recipe to the right one",
                         unit_text(space, 1), space.unit_words, now, unit_text(space, other), then)});
}

void judge_unit(const KnownModel& known, const HairRecipe& recipe, JudgedSize& judged) {
  const importer::SourceSpace& space = known.model.space;
  const std::vector<SizeEvidence> evidence = measure_model(known, recipe);
  if (evidence.empty()) return;
  std::vector<Vote> votes;
  for (const UnitPrior& prior : unit_priors(known.model, recipe, known.model.scalp_radius / known.scale)) {
    votes.push_back({prior.factor, prior.likelihood, size_likelihood(evidence, prior.factor)});
  }
  const Vote& own = votes.front();  // the file's, or metres
  const auto best = std::ranges::max_element(votes, {}, &Vote::sum);
  const Vote& rival = *std::ranges::max_element(votes.begin() + 1, votes.end(), {}, &Vote::sum);
  if (space.unit == importer::Statement::kGiven) {
    if (rival.evidence - own.evidence > kAbsurd && rival.evidence > kFits)
      say_doubtful_unit(space, evidence, rival.factor, judged);
    return;
  }
  const Vote& taken = best->evidence > kFits ? *best : own;
  judged.decisions.push_back({"size",
                              unit_text(space, taken.factor) + " m per unit",
                              fmt::format("{}; {}", space.unit_words, lengths_text(evidence, taken.factor)),
                              share_of(taken, votes),
                              "\"source.metres_per_unit\"",
                              {}});
  if (taken.factor != 1) return say_other_unit(space, evidence, taken.factor, judged);
  const bool nearly_loses = own.sum() - rival.sum() < kNarrow && rival.evidence > kFits;
  if (own.evidence < kSaysLittle && (nearly_loses || own.evidence < -kAbsurd))
    say_doubtful_unit(space, evidence, rival.factor, judged);
}

struct UpVote {
  std::size_t up = 0;
  double prior = 0;
  double evidence = 0;
  [[nodiscard]] double sum() const { return prior + evidence; }
};

std::string against_text(const std::vector<UpEvidence>& evidence, std::size_t own, std::size_t rival) {
  std::vector<std::string> parts;
  for (const UpEvidence& item : evidence) {
    if (item.likelihood[rival] > item.likelihood[own] + 0.3) parts.push_back(item.what);
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

/// "; the head is above the hips": what speaks for one direction against another.
std::string support_text(const std::vector<UpEvidence>& evidence, std::size_t one, std::size_t other) {
  const std::string text = against_text(evidence, other, one);
  return text.empty() ? "" : "; " + text;
}

/// A direction of the model as the file has it, before it was turned.
std::string axis_text(const importer::SourceSpace& space, std::size_t up) {
  Eigen::Vector3d direction = up_direction(up);
  if (space.up_axis == 'z') direction = Eigen::Vector3d(direction.x(), -direction.z(), direction.y());
  if (space.up_axis == 'x') direction = Eigen::Vector3d(direction.y(), -direction.x(), direction.z());
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return fmt::format("{}{}", direction[axis] < 0 ? '-' : '+', char('X' + axis));
}

void judge_up(const KnownModel& known, JudgedSize& judged) {
  const importer::SourceSpace& space = known.model.space;
  const std::vector<UpEvidence> evidence = weigh_ups(known);
  if (evidence.empty()) return;
  std::vector<UpVote> votes;
  const auto priors = up_priors(known.model);
  for (std::size_t up = 0; up < kUps; ++up) {
    UpVote vote{up, priors[up], 0};
    for (const UpEvidence& item : evidence) vote.evidence += item.likelihood[up];
    votes.push_back(vote);
  }
  const UpVote& own = votes.front();
  const UpVote& rival = *std::ranges::max_element(votes.begin() + 1, votes.end(), {}, &UpVote::sum);
  const std::string why = against_text(evidence, own.up, rival.up), axis = axis_text(space, rival.up);
  const double lead = own.sum() - rival.sum();
  if (space.up == importer::Statement::kGiven) {
    if (rival.evidence - own.evidence > kAbsurd) {
      judged.doubts.push_back(
          {SizeDoubt::Of::kDoubtfulUp,
           fmt::format("the recipe's \"source.up_axis\": \"{}\" is doubtful: with the file's {} up {}: check it",
                       space.up_axis, axis, why)});
    }
    return;
  }
  const UpVote& taken = lead < 0 ? rival : own;
  judged.decisions.push_back({"up",
                              "the file's " + axis_text(space, taken.up),
                              space.up_words + support_text(evidence, taken.up, lead < 0 ? own.up : rival.up),
                              share_of(taken, votes),
                              "\"source.up_axis\"",
                              {}});
  if (lead < 0) {
    judged.rotation = y_up_from_direction(rival.up);
    judged.doubts.push_back(
        {SizeDoubt::Of::kOtherUp,
         fmt::format("up is the file's {} and not what it says ({}): with that, {}; the model was turned: set "
                     "\"source.up_axis\": \"{}\" in the recipe if the file is right",
                     axis, space.up_words, why, space.up_axis)});
  } else if (lead < kNarrow && own.evidence < kSaysLittle && !why.empty()) {
    judged.doubts.push_back(
        {SizeDoubt::Of::kDoubtfulUp,
         fmt::format("up is doubtful: it is as the file says ({}), though with the file's {} up {}: set "
                     "\"source.up_axis\" in the recipe, to \"{}\" if the file is right",
                     space.up_words, axis, why, space.up_axis)});
  }
}

}  // namespace

JudgedSize judge_size(const importer::SourceModel& source, const HairRecipe& recipe) {
  JudgedSize judged;
  KnownModel known = know_model(source, recipe);
  judge_up(known, judged);
  if (!judged.rotation.isIdentity()) {
    transform_model(known.model, 1, judged.rotation);
    turn_hair(known.hair, judged.rotation);
  }
  judge_unit(known, recipe, judged);
  const bool is_as_it_was = !judged.changes() && known.scale == 1;
  if (is_as_it_was && recipe.hair_parts.empty() && !known.hair.triangles.empty()) {
    judged.hair = SelectedHair{std::move(known.hair), std::move(known.found)};
  }
  return judged;
}

importer::SourceModel settled(importer::SourceModel source, const JudgedSize& size) {
  transform_model(source, size.factor, size.rotation);
  return source;
}

const char* code_of(SizeDoubt::Of of) {
  switch (of) {
    case SizeDoubt::Of::kOtherUnit: return "S207";
    case SizeDoubt::Of::kDoubtfulUnit: return "S208";
    case SizeDoubt::Of::kOtherUp: return "S209";
    case SizeDoubt::Of::kDoubtfulUp: break;
  }
  return "S210";
}

SettledSource settle_size(const importer::SourceModel& source, const HairRecipe& recipe, Findings& findings) {
  JudgedSize size = judge_size(source, recipe);
  for (Decision& decision : size.decisions) {
    if (size.doubts.empty()) {
      findings.decide(std::move(decision));
    } else {
      findings.say(std::move(decision));
    }
  }
  for (const SizeDoubt& doubt : size.doubts) findings.warn(code_of(doubt.of), doubt.text);
  if (!size.changes()) return {std::nullopt, std::move(size.hair)};
  return {settled(source, size), std::nullopt};
}

}  // namespace coif::cook
