// Conversion between NumPy arrays and vectors of the core, and paths as texts. All arrays that leave the module are
// read-only.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace taxel::python {

namespace nb = nanobind;

// Read-only arrays; -1 is any length.
using Vector = nb::ndarray<nb::numpy, const double, nb::shape<-1>>;
using Vectors3 = nb::ndarray<nb::numpy, const double, nb::shape<-1, 3>>;
using Vectors4 = nb::ndarray<nb::numpy, const double, nb::shape<-1, 4>>;
using Matrix = nb::ndarray<nb::numpy, const double, nb::shape<-1, -1>>;
using Integers = nb::ndarray<nb::numpy, const std::int32_t, nb::shape<-1>>;
using Integers3 = nb::ndarray<nb::numpy, const std::int32_t, nb::shape<-1, 3>>;

/// Object that keeps the memory of an array alive.
using Owner = std::shared_ptr<const void>;

/// Returns a Python object that owns `owner`.
nb::capsule capsule_of(Owner owner);

/// Returns a view of one member of `count` structs that are `stride` bytes apart, from the member of the first struct
/// on. The member has `columns` numbers in a row. `owner` keeps the structs alive.
template <class Array, class Number, std::size_t N>
Array strided_view(const Number* first, std::size_t count, std::size_t stride, const std::size_t (&shape)[N],
                   const Owner& owner) {
  static_assert(N == 1 || N == 2);
  const std::int64_t step = static_cast<std::int64_t>(stride / sizeof(Number));
  const std::int64_t strides[2] = {step, 1};
  static const Number none{};
  return Array(count > 0 ? first : &none, N, shape, capsule_of(owner), strides);
}

/// Returns a view of vectors in a vector that `owner` keeps alive.
Vectors3 view_of(const std::vector<dvec3>& vectors, const Owner& owner);
/// Returns a view of triples of integers.
Integers3 view_of(const std::vector<ivec3>& vectors, const Owner& owner);
/// Returns a view of numbers.
Vector view_of(const std::vector<double>& numbers, const Owner& owner);
Integers view_of(const std::vector<int>& numbers, const Owner& owner);

/// Returns an array that takes over `numbers`, in rows of `columns` numbers.
template <class Array>
Array array_of(std::vector<double> numbers, std::size_t columns) {
  const auto owner = std::make_shared<const std::vector<double>>(std::move(numbers));
  const std::size_t shape[2] = {columns == 0 ? 0 : owner->size() / columns, columns};
  static const double none = 0;
  return Array(owner->empty() ? &none : owner->data(), 2, shape, capsule_of(owner));
}
/// Returns an array with one dimension that takes over `numbers`.
Vector array_of(std::vector<double> numbers);
Integers array_of(std::vector<int> numbers);
/// Returns one vector as an array of three numbers.
Vector array_of(const dvec3& v);

/// Returns the numbers of an array-like object in rows. `shape` is the required shape; a length of -1 is any length. A
/// single number is repeated if the shape has one dimension and a known length. Throws TypeError for elements that are
/// not real numbers, and ValueError for another shape, and for numbers that are not finite. `name` is the argument in
/// messages.
std::vector<double> read_numbers(nb::handle object, const char* name, std::initializer_list<std::int64_t> shape);
/// Reads vectors of three numbers. `count` is the required number of vectors; -1 is any number.
std::vector<dvec3> read_vectors(nb::handle object, const char* name, std::int64_t count = -1);
/// Reads one vector of three numbers.
dvec3 read_vector(nb::handle object, const char* name);
/// Reads whole numbers: one number, or an array-like object with one dimension. Throws TypeError for anything else.
std::vector<int> read_integers(nb::handle object, const char* name);

/// Returns a path, which need not be UTF-8, as os.fsdecode() does.
inline nanobind::str path_text(const std::string& path) {
  return nanobind::steal<nanobind::str>(
      PyUnicode_DecodeFSDefaultAndSize(path.data(), static_cast<Py_ssize_t>(path.size())));
}

}  // namespace taxel::python
