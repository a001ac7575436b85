// The words and numbers of a legacy VTK file, in text or binary (big endian).
#pragma once

#include <string>
#include <string_view>

#include "core/mesh/formats/text_cursor.h"

namespace taxel {

/// Types of numbers in VTK files. `bit` numbers can only be skipped.
enum class VtkNumber { bit, int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Returns true if a word equals a word in lower case, whatever its case is.
bool is_vtk_word(std::string_view word, std::string_view lower);

/// A position in a legacy VTK file. Messages name the line of a text, and the byte of a binary file. Every function
/// throws Error naming file and place if the file is damaged there.
class VtkSource {
 public:
  /// Reads the first three lines and the name of the data set. Throws Error if the file is no legacy VTK file or of a
  /// version after 5; an XML file is refused with the remedy.
  VtkSource(std::string_view bytes, const std::string& file);

  /// Returns the name of the data set, such as POLYDATA.
  [[nodiscard]] std::string_view data_set() const { return data_set_; }
  /// Returns the next word of this line or of a later one, or an empty word at the end of the file.
  std::string_view word_anywhere() { return cursor_.word_anywhere(); }
  /// Returns the next word of this line, or an empty word at its end.
  std::string_view word() { return cursor_.word(); }
  /// Passes over the lines up to an empty line, as a METADATA section ends.
  void skip_paragraph() { cursor_.skip_paragraph(); }
  /// Returns true if the next line begins with a word (in upper case).
  [[nodiscard]] bool next_line_begins_with(std::string_view upper) const;
  /// Reads a number of things from this line. `what` names them in messages.
  std::size_t count(const char* what);
  /// Reads the name of a type of number from this line.
  VtkNumber number_type();

  /// Begins a list of rows * columns numbers. Throws Error if the rest of the file is too short for them: memory for
  /// the numbers may be taken afterwards.
  void begin_numbers(std::size_t rows, std::size_t columns, VtkNumber type, const char* what);
  double finite_number();
  long long integer();
  /// Ends the list of numbers that was begun last.
  void end_numbers();
  /// Passes over rows * columns numbers.
  void skip_numbers(std::size_t rows, std::size_t columns, VtkNumber type, const char* what);

  [[nodiscard]] bool binary() const { return binary_; }
  [[noreturn]] void fail(const std::string& message) const;

 private:
  void read_head();
  std::string_view number_word();
  template <class T>
  T raw();

  std::string_view bytes_;
  std::string file_;
  TextCursor cursor_;
  std::string_view data_set_;
  bool binary_ = false;
  std::size_t at_ = 0;  ///< position in the numbers of a binary file
  VtkNumber type_ = VtkNumber::int32;
  const char* what_ = "";
};

}  // namespace taxel
