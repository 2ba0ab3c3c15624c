#pragma once
// Text → JSON, strictly.

#include <nlohmann/json.hpp>
#include <string>

namespace ropelight {

/// One step of a JSON pointer (RFC 6901), with ~ and / escaped.
std::string pointerToken(const std::string& key);

/// Parses strict JSON. Throws Error with line and column for bad syntax, and with the JSON pointer for a key that an
/// object holds twice and for a number beyond double precision.
nlohmann::json parseJson(const std::string& file, const std::string& text);

}  // namespace ropelight
