#pragma once
// Text for other formats, and how long it is.

#include <cstddef>
#include <string>

namespace ropelight {

/// For the text and the quoted attributes of XML and HTML; control characters are left out.
std::string escapeMarkup(const std::string& text);

/// In quotation marks, those inside doubled (RFC 4180).
std::string quoteCsv(const std::string& text);

/// Characters, not bytes, of UTF-8.
std::size_t letterCount(const std::string& text);

}  // namespace ropelight
