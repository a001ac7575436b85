#include "app/python/arrays.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <limits>
#include <string>

namespace taxel::python {
namespace {

template <class Array, class Row, class Number>
Array rows_of(const std::vector<Row>& rows, const Owner& owner) {
  return strided_view<Array>(rows.empty() ? nullptr : &rows.front()[0], rows.size(), sizeof(Row), {rows.size(), 3},
                             owner);
}

/// Returns "(12, 3)" or "(n, 3)".
std::string shape_text(const std::vector<std::int64_t>& shape) {
  std::vector<std::string> words;
  for (const std::int64_t length : shape) words.push_back(length < 0 ? "n" : std::to_string(length));
  return fmt::format("({}{})", fmt::join(words, ", "), words.size() == 1 ? "," : "");
}

/// Returns the object as an array. Throws ValueError for a masked array with masked elements, whose values below the
/// mask mean nothing.
nb::object unmasked_array(nb::handle object, const char* name) {
  const nb::module_ numpy = nb::module_::import_("numpy");
  if (nb::hasattr(object, "mask") && nb::cast<bool>(numpy.attr("ma").attr("is_masked")(object)))
    throw nb::value_error(fmt::format("{}: must have no masked values; fill them first", name).c_str());
  return numpy.attr("asarray")(object);
}

/// Returns the object as an array whose elements are of one of these kinds (numpy.dtype.kind).
nb::object array_like(nb::handle object, const char* name, std::string_view kinds, const char* expected) {
  const nb::object array = unmasked_array(object, name);
  const auto kind = nb::cast<std::string>(array.attr("dtype").attr("kind"));
  if (kinds.find(kind) == std::string_view::npos) {
    const auto dtype = nb::cast<std::string>(array.attr("dtype").attr("name"));
    throw nb::type_error(fmt::format("{}: must be {}, has the dtype {}", name, expected, dtype).c_str());
  }
  return array;
}

}  // namespace

nb::capsule capsule_of(Owner owner) {
  return {new Owner(std::move(owner)), [](void* p) noexcept { delete static_cast<Owner*>(p); }};
}

Vectors3 view_of(const std::vector<dvec3>& vectors, const Owner& owner) {
  return rows_of<Vectors3, dvec3, double>(vectors, owner);
}
Integers3 view_of(const std::vector<ivec3>& vectors, const Owner& owner) {
  return rows_of<Integers3, ivec3, int>(vectors, owner);
}
Vector view_of(const std::vector<double>& numbers, const Owner& owner) {
  return strided_view<Vector>(numbers.data(), numbers.size(), sizeof(double), {numbers.size()}, owner);
}
Integers view_of(const std::vector<int>& numbers, const Owner& owner) {
  return strided_view<Integers>(numbers.data(), numbers.size(), sizeof(int), {numbers.size()}, owner);
}

Vector array_of(std::vector<double> numbers) {
  const auto owner = std::make_shared<const std::vector<double>>(std::move(numbers));
  return view_of(*owner, owner);
}
Integers array_of(std::vector<int> numbers) {
  const auto owner = std::make_shared<const std::vector<int>>(std::move(numbers));
  return view_of(*owner, owner);
}
Vector array_of(const dvec3& v) {
  return array_of(std::vector<double>{v.x, v.y, v.z});
}

std::vector<double> read_numbers(nb::handle object, const char* name, std::initializer_list<std::int64_t> shape) {
  const nb::module_ numpy = nb::module_::import_("numpy");
  nb::object array = array_like(object, name, "iuf", "real numbers");
  auto found = nb::cast<std::vector<std::int64_t>>(array.attr("shape"));
  if (found.empty() && shape.size() == 1 && *shape.begin() >= 0) {
    array = numpy.attr("broadcast_to")(array, *shape.begin());
    found = {*shape.begin()};
  }
  bool fits = found.size() == shape.size();
  for (std::size_t i = 0; fits && i < found.size(); ++i) fits = shape.begin()[i] < 0 || shape.begin()[i] == found[i];
  if (!fits)
    throw nb::value_error(
        fmt::format("{}: must have the shape {}, has {}", name, shape_text(shape), shape_text(found)).c_str());
  array = numpy.attr("ascontiguousarray")(array, numpy.attr("float64"));
  const auto numbers = nb::cast<nb::ndarray<const double, nb::c_contig, nb::device::cpu>>(array);
  std::vector<double> copy(numbers.data(), numbers.data() + numbers.size());
  const std::size_t columns = found.size() == 2 ? static_cast<std::size_t>(found[1]) : 1;
  for (std::size_t i = 0; i < copy.size(); ++i) {
    if (!std::isfinite(copy[i]))
      throw nb::value_error(fmt::format("{}: must be finite, row {} has {}", name, i / columns, copy[i]).c_str());
  }
  return copy;
}

std::vector<dvec3> read_vectors(nb::handle object, const char* name, std::int64_t count) {
  const std::vector<double> numbers = read_numbers(object, name, {count, 3});
  std::vector<dvec3> vectors;
  for (std::size_t i = 0; i < numbers.size(); i += 3) vectors.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return vectors;
}

dvec3 read_vector(nb::handle object, const char* name) {
  const std::vector<double> numbers = read_numbers(object, name, {3});
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<int> read_integers(nb::handle object, const char* name) {
  if (nb::cast<std::size_t>(unmasked_array(object, name).attr("size")) == 0) return {};
  const nb::object array =
      nb::module_::import_("numpy").attr("atleast_1d")(array_like(object, name, "iu", "whole numbers"));
  const auto found = nb::cast<std::vector<std::int64_t>>(array.attr("shape"));
  if (found.size() != 1)
    throw nb::value_error(fmt::format("{}: must have the shape (n,), has {}", name, shape_text(found)).c_str());
  std::vector<int> integers;
  for (const nb::handle number : nb::list(array.attr("tolist")())) {
    std::int64_t value = -1;  // stays for a number of more than 64 bits
    nb::try_cast(number, value);
    if (value < 0 || value > std::numeric_limits<int>::max())
      throw nb::value_error(
          fmt::format("{}: must be 0 to 2147483647, has {}", name, nb::cast<std::string>(nb::str(number))).c_str());
    integers.push_back(static_cast<int>(value));
  }
  return integers;
}

}  // namespace taxel::python
