#pragma once
// Reading JSON that somebody else wrote: every question has an answer for every kind of value.

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace coif {

/// A member of an object; JSON's null where `value` is no object or has none of that name. Valid as long as `value`.
[[nodiscard]] const nlohmann::json& member(const nlohmann::json& value, const char* name);

/// `value` itself where it is a list, else an empty list.
[[nodiscard]] const nlohmann::json& list_of(const nlohmann::json& value);

/// A finite number.
[[nodiscard]] std::optional<double> number_of(const nlohmann::json& value);

/// A whole number below `count`.
[[nodiscard]] std::optional<std::uint32_t> index_of(const nlohmann::json& value, std::size_t count);

/// Three finite numbers as a list [x, y, z] or as an object with members x, y and z.
[[nodiscard]] std::optional<Eigen::Vector3d> vector_of(const nlohmann::json& value);

/// Printable text; empty where `value` is no text.
[[nodiscard]] std::string printable_text_of(const nlohmann::json& value);

}  // namespace coif
