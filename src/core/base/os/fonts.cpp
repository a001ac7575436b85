#include "core/base/os/fonts.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string>

namespace taxel::os {
namespace {

/// The functions of fontconfig that are used. Patterns and sets of characters are opaque. A result of 0 is a success of
/// those that return a value through a pointer.
struct Fontconfig {
  unsigned char* (*config_filename)(const unsigned char*) = nullptr;
  void* (*name_parse)(const unsigned char*) = nullptr;
  int (*config_substitute)(void* config, void* pattern, int kind) = nullptr;
  void (*default_substitute)(void* pattern) = nullptr;
  void* (*font_match)(void* config, void* pattern, int* result) = nullptr;
  int (*get_string)(const void* pattern, const char* object, int n, unsigned char** text) = nullptr;
  int (*get_integer)(const void* pattern, const char* object, int n, int* number) = nullptr;
  int (*get_char_set)(const void* pattern, const char* object, int n, void** set) = nullptr;
  int (*has_char)(const void* set, unsigned character) = nullptr;
  void (*destroy)(void* pattern) = nullptr;
  bool is_complete = true;  ///< all functions were found

  Fontconfig() {
    void* const library = ::dlopen("libfontconfig.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      is_complete = false;
      return;
    }
    find(library, "FcConfigFilename", config_filename);
    find(library, "FcNameParse", name_parse);
    find(library, "FcConfigSubstitute", config_substitute);
    find(library, "FcDefaultSubstitute", default_substitute);
    find(library, "FcFontMatch", font_match);
    find(library, "FcPatternGetString", get_string);
    find(library, "FcPatternGetInteger", get_integer);
    find(library, "FcPatternGetCharSet", get_char_set);
    find(library, "FcCharSetHasChar", has_char);
    find(library, "FcPatternDestroy", destroy);
  }

  /// Without its configuration, fontconfig would complain on the standard error.
  [[nodiscard]] bool is_usable() const {
    if (!is_complete) return false;
    unsigned char* const name = config_filename(nullptr);
    const bool is_configured = name != nullptr;
    std::free(name);  // the caller owns it
    return is_configured;
  }

 private:
  template <class Function>
  void find(void* library, const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(::dlsym(library, name));
    is_complete = is_complete && function != nullptr;
  }
};

const unsigned char* as_bytes(const std::string& text) {
  return reinterpret_cast<const unsigned char*>(text.c_str());
}

}  // namespace

std::optional<FontFile> find_font(const char* language, char32_t character) {
  static const Fontconfig kFontconfig;
  const Fontconfig& fc = kFontconfig;
  if (!fc.is_usable()) return std::nullopt;
  void* const wanted = fc.name_parse(as_bytes(std::string("sans-serif:lang=") + language));
  if (wanted == nullptr) return std::nullopt;
  fc.config_substitute(nullptr, wanted, 0);
  fc.default_substitute(wanted);
  int result = 0, index = 0;
  void* const found = fc.font_match(nullptr, wanted, &result);
  unsigned char* file = nullptr;
  void* characters = nullptr;
  std::optional<FontFile> font;
  if (found != nullptr && fc.get_string(found, "file", 0, &file) == 0 &&
      fc.get_char_set(found, "charset", 0, &characters) == 0 && fc.has_char(characters, character) != 0) {
    if (fc.get_integer(found, "index", 0, &index) != 0) index = 0;
    font = FontFile{reinterpret_cast<const char*>(file), index & 0xFFFF};  // the upper bits number a variation
  }
  if (found != nullptr) fc.destroy(found);
  fc.destroy(wanted);
  return font;
}

}  // namespace taxel::os
