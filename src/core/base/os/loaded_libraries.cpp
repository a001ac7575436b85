#include "core/base/os/loaded_libraries.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>

namespace taxel::os {
namespace {

int add_name(dl_phdr_info* info, std::size_t, void* names) {
  if (info->dlpi_name != nullptr) static_cast<std::vector<std::string>*>(names)->emplace_back(info->dlpi_name);
  return 0;
}

}  // namespace

std::vector<LoadedLibrary> loaded_libraries(const std::string& prefix) {
  std::vector<std::string> names;
  ::dl_iterate_phdr(add_name, &names);
  std::vector<LoadedLibrary> found;
  for (const std::string& name : names) {
    if (name.compare(name.rfind('/') + 1, prefix.size(), prefix) != 0) continue;  // npos + 1 is 0
    void* handle = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD);
    const bool known = std::any_of(found.begin(), found.end(), [&](const auto& l) { return l.handle == handle; });
    if (handle != nullptr && !known) found.push_back({name, handle});
  }
  return found;
}

void* find_function(const LoadedLibrary& library, const char* name) {
  return ::dlsym(library.handle, name);
}

std::string file_of_function(void* address) {
  Dl_info info{};
  return ::dladdr(address, &info) != 0 && info.dli_fname != nullptr ? info.dli_fname : "";
}

}  // namespace taxel::os
