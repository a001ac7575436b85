// Numbers, colours and orders in panels.
#include <gtest/gtest.h>

#include "app/studio/nouns/table/table_rows.h"
#include "ui/scene/color_map.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

TEST(Numbers, HaveTheNamedUnit) {
  EXPECT_EQ(in_mm(0.0123, 2), "12.30 mm");
  EXPECT_EQ(in_mm(dvec3(0.001, -0.002, 0.5), 1), "1.0, -2.0, 500.0 mm");
  EXPECT_EQ(in_mm2(12.346e-6), "12.35 mm\u00b2");
  EXPECT_EQ(in_mm2(1234e-6), "1234 mm\u00b2");
  EXPECT_EQ(in_mm2(0.02), "200 cm\u00b2");
  EXPECT_EQ(in_kpa(12345), "12.35 kPa");
  EXPECT_EQ(duration_text(2.5e-4), "250 \u00b5s");
  EXPECT_EQ(duration_text(0.99949e-3), "999 \u00b5s");
  EXPECT_EQ(duration_text(0.9996e-3), "1.00 ms");
  EXPECT_EQ(bytes_text(999), "999 bytes");
  EXPECT_EQ(bytes_text(1e3), "1 kB");
  EXPECT_EQ(bytes_text(2.5e6), "2.5 MB");
  EXPECT_EQ(bytes_text(1e9), "1 GB");
  EXPECT_EQ(grouped(-1234567), "-1 234 567");
  EXPECT_EQ(number_in_unit(8765, ReadingUnit{}), "8.77");
  EXPECT_EQ(number_in_unit(0.5, shown_unit(Aggregate::force)), "0.50");
}

TEST(Numbers, AreRoundedAtTheScaleOfTheirQuantity) {
  const ReadingUnit kpa, newton = shown_unit(Aggregate::force), share = kSlipUnit;
  const auto expect = [](double reading, const ReadingUnit& unit, const char* value, const char* change) {
    EXPECT_EQ(in_unit(reading, unit), value) << reading << " " << unit.text;
    EXPECT_EQ(change_in_unit(reading, unit), change) << reading << " " << unit.text;
  };
  expect(0, kpa, "0.00 kPa", "0 kPa");
  expect(-0.0, kpa, "0.00 kPa", "0 kPa");
  expect(1.54e-14, kpa, "0.00 kPa", "0 kPa");
  expect(-1e-7, kpa, "0.00 kPa", "0 kPa");
  expect(0.3, kpa, "0.3 Pa", "+0.3 Pa");
  expect(45.23, kpa, "45.2 Pa", "+45.2 Pa");
  expect(-45.23, kpa, "-45.2 Pa", "-45.2 Pa");
  expect(99.99, kpa, "100 Pa", "+100 Pa");
  expect(100, kpa, "0.100 kPa", "+0.1 kPa");
  expect(123.4, kpa, "0.123 kPa", "+0.123 kPa");
  expect(12345, kpa, "12.35 kPa", "+12.3 kPa");
  expect(1e9, kpa, "1000000.00 kPa", "+1000000 kPa");
  expect(2.8e-6, newton, "0.000 N", "0 N");
  expect(-2.8e-6, newton, "0.000 N", "0 N");
  expect(0.00031, newton, "0.0003 N", "+0.0003 N");
  expect(0.0312, newton, "0.0312 N", "+0.0312 N");
  expect(-3, newton, "-3.000 N", "-3 N");
  expect(0.0001, share, "0.0 %", "0 %");
  expect(0.25, share, "25.0 %", "+25 %");
  EXPECT_EQ(in_kpa(45.23), "45.2 Pa");
  EXPECT_EQ(in_newtons(1.23456), "1.235 N");
  EXPECT_EQ(in_newtons(2.8e-6), "0 N");
  EXPECT_EQ(in_mm(-1e-9, 3), "0.000 mm");
  EXPECT_EQ(in_mm(dvec3(-1e-9, 0.001, -0.001), 1), "0.0, 1.0, -1.0 mm");
  EXPECT_EQ(number_in_unit(-0.001, kpa), "0.00");
  EXPECT_EQ(pair_in_unit(1e-12, 2e-12, kpa).first, "0 kPa");
  EXPECT_EQ(counted(1, "sample", "samples"), "1 sample");
  EXPECT_EQ(counted(0, "sample", "samples"), "0 samples");
  EXPECT_EQ(counted(12345, "sample", "samples"), "12 345 samples");
}

TEST(TaxelColors, EqualThoseOfOkabeAndIto) {
  const auto expect = [](int number, int red, int green, int blue) {
    const glm::vec3 color = taxel_color(number);
    EXPECT_NEAR(255 * color.x, red, 0.01) << number;
    EXPECT_NEAR(255 * color.y, green, 0.01) << number;
    EXPECT_NEAR(255 * color.z, blue, 0.01) << number;
  };
  expect(0, 230, 159, 0);   // orange
  expect(1, 86, 180, 233);  // sky blue
  expect(5, 213, 94, 0);    // vermilion
  expect(24, 230, 159, 0);  // the first colour again
}

TEST(TaxelTableRows, AreSortedByTheClickedColumn) {
  Layout layout;
  for (int id = 1; id <= 3; ++id) {
    layout.taxels.emplace_back();
    layout.taxels.back().id = id;
  }
  const std::vector<std::vector<int>> orders{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
  std::vector<double> readings(3);
  std::vector<int> samples(3);
  TableState table;
  for (std::size_t rank = 0; rank < 3; ++rank) {  // each column ascends in a different order
    const auto at = [&](std::size_t column) -> std::size_t { return static_cast<std::size_t>(orders[column][rank]); };
    const auto value = static_cast<double>(rank);
    for (int axis = 0; axis < 3; ++axis) layout.taxels[at(static_cast<std::size_t>(axis))].center[axis] = value;
    for (int axis = 0; axis < 3; ++axis) layout.taxels[at(static_cast<std::size_t>(3 + axis))].normal[axis] = value;
    layout.taxels[at(1)].radius = 1 + value;
    readings[at(2)] = value;
    samples[at(3)] = static_cast<int>(rank);
  }
  const std::vector<std::pair<TableColumn, std::size_t>> columns{
      {TableColumn::x, 0},      {TableColumn::y, 1},       {TableColumn::z, 2},
      {TableColumn::nx, 3},     {TableColumn::ny, 4},      {TableColumn::nz, 5},
      {TableColumn::radius, 1}, {TableColumn::reading, 2}, {TableColumn::samples, 3}};
  for (const auto& [column, order] : columns) {
    table.sorted = column;
    table.descending = false;
    EXPECT_EQ(table_rows(table, layout, {}, {&readings, &samples}), orders[order]) << static_cast<int>(column);
    table.descending = true;
    const std::vector<int> back(orders[order].rbegin(), orders[order].rend());
    EXPECT_EQ(table_rows(table, layout, {}, {&readings, &samples}), back) << static_cast<int>(column);
  }
}

}  // namespace
}  // namespace taxel::ui
