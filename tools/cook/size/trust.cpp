#include "cook/size/evidence.h"

#include "base/words.h"
#include "cook/recipe/hair_recipe.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace coif::cook {
namespace {

// How much less likely than the file's another unit or axis is, by the kind of file.
constexpr double kHumanoid = 5.5;  ///< VRM: its exporters demand a person of some height.
constexpr double kByDefinition = 4;
constexpr double kByChoice = 3.5;
constexpr double kByHabit = 2.5;
constexpr double kByConverter = 2.5;
constexpr double kByRecipe = 4;  ///< Added where the recipe has lengths that somebody read off the present model.

constexpr double kMetresPerInch = 0.0254, kMetresPerFoot = 0.3048;
constexpr double kImperial = 1.5;      ///< Inches and feet are rarer than powers of ten.
constexpr double kRarePower = 1;       ///< Beyond a factor of 100.
constexpr double kOfItsOwn = 2.5;      ///< For a unit with which the scalp has the usual size.
constexpr double kUsualScalp = 0.095;  ///< Radius of a usual scalp, metres.

bool is_converter(const std::string& generator) {
  static const std::vector<std::string> names{"*assimp*", "*open asset import*", "*trimesh*", "*obj2gltf*", "*meshlab*",
                                              "*open3d*", "*cloudcompare*"};
  return matches_any(generator, names);
}

double trust_in(importer::Statement statement) {
  switch (statement) {
    case importer::Statement::kGiven: return kHumanoid;
    case importer::Statement::kDeclared: return kByDefinition;
    case importer::Statement::kUsual: return kByHabit;
    case importer::Statement::kUnsaid: break;
  }
  return 0;
}

/// For files without a unit: the units that modellers use, and rarely one of their own.
std::vector<UnitPrior> customs(double scalp_radius) {
  std::vector<UnitPrior> units{
      {1, 0},   {0.01, 0}, {0.1, -0.3}, {0.001, -0.5}, {kMetresPerInch, -2}, {kMetresPerFoot, -3},
      {10, -3}, {100, -4}, {0.0001, -4}};
  if (scalp_radius > 0) {
    const double factor = kUsualScalp / scalp_radius, digits = std::pow(10.0, std::floor(std::log10(factor)) - 1);
    units.push_back({std::round(factor / digits) * digits, -kOfItsOwn});
  }
  return units;
}

}  // namespace

std::vector<UnitPrior> unit_priors(const importer::SourceModel& model, const HairRecipe& recipe, double scalp_radius) {
  const importer::SourceSpace& space = model.space;
  if (space.unit == importer::Statement::kUnsaid) return customs(scalp_radius);
  double trust = trust_in(space.unit);
  if (model.head_node != importer::kNoIndex) trust = kHumanoid;
  if (is_converter(space.generator)) trust = std::min(trust, kByConverter);
  if (recipe.head_center && recipe.head_radii) trust += kByRecipe;
  std::vector<UnitPrior> priors{{1, 0}};
  for (const double factor : {0.1, 10.0, 0.01, 100.0}) priors.push_back({factor, -trust});
  for (const double factor : {0.001, 1000.0}) priors.push_back({factor, -trust - kRarePower});
  for (const double unit : {kMetresPerInch, kMetresPerFoot}) {
    priors.push_back({unit / space.metres_per_unit, -trust - kImperial});
  }
  return priors;
}

std::array<double, kUps> up_priors(const importer::SourceModel& model) {
  const importer::SourceSpace& space = model.space;
  double trust = space.up == importer::Statement::kUnsaid ? 1.5 : kByChoice;
  if (model.head_node != importer::kNoIndex) trust = kHumanoid;
  if (is_converter(space.generator) && space.up != importer::Statement::kUnsaid) trust = kByConverter;
  // Y and Z may be exchanged. A model that was turned once is turned back; else the file's own Z becomes up.
  constexpr double kUnlikely = 2, kStrange = 3;
  const bool turned = space.up_axis != 'y';
  const double z = turned ? kUnlikely : 0, minus_z = turned ? 0 : kUnlikely;
  return {0, -trust - z, -trust - minus_z, -trust - kUnlikely, -trust - kStrange, -trust - kStrange};
}

}  // namespace coif::cook
