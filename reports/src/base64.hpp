/// Base64 (RFC 4648) of binary data, as VTK's XML files hold it.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace parapet::reports {

std::string base64(std::span<const std::byte> bytes);

}  // namespace parapet::reports
