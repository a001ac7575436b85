#include "app/studio/app/requests.h"

namespace taxel::ui {

Request::Request(const Request&) = default;
Request& Request::operator=(const Request&) = default;
Request::Request(Request&&) noexcept = default;
Request& Request::operator=(Request&&) noexcept = default;
Request::~Request() = default;

}  // namespace taxel::ui
