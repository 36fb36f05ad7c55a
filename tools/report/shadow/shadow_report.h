#pragma once

// The results of `coif report shadows`: records, measured by measure_shadows(), and the columns that show them.
//
// A light's transmittance at a point is the share of it that head and hair let through to there, 0..1. An error is a
// technique's transmittance minus the exact one, the product of 1 - alpha of everything in between.

#include "report/page/report_columns.h"

#include <cstdint>
#include <string>
#include <vector>

namespace coif::report {

/// The error of a technique's transmittance over many points.
struct ShadowError {
  double rmse = kNoNumber;  ///< NaN: there are no such points.
  double bias = kNoNumber;  ///< Mean; positive: too much light comes through.
  double most = kNoNumber;  ///< The largest, either way.
};

/// "deep, 4 layers, 512".
[[nodiscard]] std::string technique_text(const std::string& technique, std::uint32_t layers, std::uint32_t size);

/// The technique's columns of a record.
template <typename Row>
[[nodiscard]] Columns<Row> technique_columns() {
  return {{"technique", &Row::technique},
          {"layers", &Row::layers},
          {"size", &Row::size},
          {"kind", [](const Row& row) { return technique_text(row.technique, row.layers, 0); }},
          {"name",
           [](const Row& row) { return technique_text(row.technique, row.layers, row.size); },
           {"technique"},
           {"technique", -29}}};
}

/// The columns of a record's `hair` and `head`.
template <typename Row>
[[nodiscard]] Columns<Row> shadow_error_columns() {
  return {{"rmse", [](const Row& row) { return row.hair.rmse; }, {"RMS, hair"}, {"hair rms", 9}},
          {"bias", [](const Row& row) { return row.hair.bias; }, {"bias, hair"}, {"bias", 10}},
          {"max", [](const Row& row) { return row.hair.most; }, {"maximum, hair"}, {"max", 8}},
          {"head_rmse", [](const Row& row) { return row.head.rmse; }, {"RMS, head"}, {"head rms", 11}},
          {"head_bias", [](const Row& row) { return row.head.bias; }, {"bias, head"}, {"bias", 11}}};
}

/// Bytes in units of 1024.
[[nodiscard]] inline Format kibibytes() { return {"{:.0f}", "-", 1.0 / 1024}; }

/// One technique under one light in one pose.
struct ShadowRow {
  /// The name on the command line; "deep-shadow-cpu": deep shadow maps that the processor makes and evaluates,
  /// compressed to a bound; "none": all light reaches everything.
  std::string technique;
  std::uint32_t layers = 0;  ///< 0: it has none.
  std::uint32_t size = 0;    ///< Texels of the map each way.
  std::string light;         ///< ShadowLight::name.
  std::string pose{};        ///< "rest" or a motion.
  ShadowError hair{};        ///< Over the hair that the head leaves in the light, each point counted by its alpha.
  ShadowError head{};        ///< Over the side of the head that is turned to the light.
  double ms = 0;             ///< Wall time of making the map, until the device has finished, median.
  double read_ns = 0;        ///< Wall time of asking it, for one point, with the answers' way back.
  std::uint64_t bytes = 0;   ///< All memory of the map.
};

[[nodiscard]] inline Columns<ShadowRow> shadow_columns() {
  using Row = ShadowRow;
  Columns<Row> columns = technique_columns<Row>();
  columns.append({{"light", &Row::light, {"light"}}, {"pose", &Row::pose, {"pose"}}});
  columns.append(shadow_error_columns<Row>());
  columns.append({{"ms", &Row::ms, {"ms"}},
                  {"read_ns", &Row::read_ns, {"ns to ask"}},
                  {"bytes", &Row::bytes, {"KiB", kibibytes()}}});
  return columns;
}

/// One technique over all lights and poses.
struct ShadowTotal {
  std::string technique;
  std::uint32_t layers = 0;
  std::uint32_t size = 0;
  ShadowError hair{}, head{};
  std::string worst_light{};  ///< The light with the largest error over hair.
  std::string worst_pose{};
  double worst_rmse = 0;    ///< That error.
  double ms = 0;            ///< Median over lights and poses.
  double read_ns = 0;       ///< Median, too.
  std::uint64_t bytes = 0;  ///< Largest over them.
};

[[nodiscard]] inline Columns<ShadowTotal> shadow_total_columns() {
  using Total = ShadowTotal;
  // A technique without a map takes neither time nor memory.
  const auto kib_of_map = [](const Total& total) { return total.size > 0 ? double(total.bytes / 1024) : kNoNumber; };
  const auto worst = [](const Total& total) {
    return "   " + number_text(total.worst_rmse) + " (" + total.worst_light + ", " + total.worst_pose + ")";
  };
  Columns<Total> columns = technique_columns<Total>();
  columns.append(shadow_error_columns<Total>());
  columns.append(
      {{"worst_light", &Total::worst_light, {"worst light"}},
       {"worst_pose", &Total::worst_pose, {"in the pose"}},
       {"worst_rmse", &Total::worst_rmse, {"its RMS"}},
       {kNoKey, worst, {}, {"   worst light of hair", -27}},
       {"ms", &Total::ms, {"ms"}},
       {"read_ns", &Total::read_ns, {"ns to ask"}},
       {"bytes", &Total::bytes, {"KiB", kibibytes()}},
       {kNoKey, [](const Total& total) { return total.size > 0 ? total.ms : kNoNumber; }, {}, {"ms", 8}},
       {kNoKey, [](const Total& total) { return total.size > 0 ? total.read_ns : kNoNumber; }, {}, {"ns", 8}},
       {kNoKey, kib_of_map, {}, {"KiB", 8, "{:.0f}"}}});
  return columns;
}

/// The direction towards a light, in degrees like a camera's: yaw 0 is before the face, positive to the model's left.
struct ShadowLight {
  std::string name;
  double yaw_degrees = 0, pitch_degrees = 0;
};

[[nodiscard]] inline Columns<ShadowLight> light_columns() {
  return {{"light", &ShadowLight::name, {"light"}},
          {"yaw", &ShadowLight::yaw_degrees, {"yaw, degrees", "{:.0f}"}},
          {"pitch", &ShadowLight::pitch_degrees, {"pitch, degrees", "{:.0f}"}}};
}

struct ShadowReport {
  std::string device;                              ///< GL_RENDERER.
  double spacing = 0;                              ///< Metres between the exact reference's lines.
  std::uint64_t hair_points = 0, head_points = 0;  ///< All lights and poses together.
  double aside = 0;           ///< Metres across the light, over which the reference is compared with itself:
  double truth_rmse = 0;      ///< The reference's difference from itself over hair.
  double truth_compared = 0;  ///< Share of the hair, 0..1, that extends so far.
  std::vector<ShadowLight> lights;
  std::vector<ShadowRow> rows;
  std::vector<ShadowTotal> totals;  ///< In the order in which they first occur in `rows`.
};

/// `coif report shadows`: the heading, then `device`, `spacing` (metres between the lines of the
/// exact reference), `hair_points`, `head_points`, and `lights`, `rows` and `totals` with the keys of their columns.
[[nodiscard]] nlohmann::ordered_json shadow_json(const ReportHeading& heading, const ShadowReport& report);

/// `coif report shadows` for a terminal: each technique over all lights and poses, and the summary.
[[nodiscard]] std::string shadow_text(const ReportHeading& heading, const ShadowReport& report);

/// The layout of the page: shadows_page.json.
extern "C" const char coif_shadows_page[];

/// The technique nearest to the truth, and the cheapest one with at most 1.5 times that error, in a sentence.
[[nodiscard]] std::string shadow_summary(const ShadowReport& report);

/// The method of the comparison, in a sentence.
[[nodiscard]] std::string shadow_method(const ShadowReport& report);

}  // namespace coif::report
