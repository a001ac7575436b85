// The shared libraries that this process has loaded.
#pragma once

#include <string>
#include <vector>

namespace taxel::os {

/// A shared library in this process. It stays loaded from now on.
struct LoadedLibrary {
  std::string file;        ///< path from which it was loaded
  void* handle = nullptr;  ///< handle for find_function()
};

/// Returns the libraries of this process whose file names begin with `prefix`, in the order of their loading. Loads
/// nothing.
std::vector<LoadedLibrary> loaded_libraries(const std::string& prefix);

/// Returns the address of a function of a library, or null if the library has no function of this name.
void* find_function(const LoadedLibrary& library, const char* name);

/// Returns the file of the library or program that has a function at this address; empty if unknown.
std::string file_of_function(void* address);

}  // namespace taxel::os
